"""Declared parameters of a session, and checks of its fields: numbers, file names, times."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from pathlib import PurePosixPath
from types import MappingProxyType

from brdf_suite.documents.parameter import Parameter, as_whole, check_numbers, check_text, describe
from brdf_suite.errors import ValueRangeError

Rgb = tuple[float, float, float]
Point = tuple[float, float, float]
Matrix = tuple[Rgb, Rgb, Rgb]

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "camera.distance_m": Parameter("Camera distance", "m", 0.01, 100.0, 2.0, "From the axis, level"),
        "height_m": Parameter("Height", "m", -50.0, 50.0, 0.0, "Above the sphere's centre"),
        "tilt_deg": Parameter("Tilt", "°", -89.0, 89.0, 0.0, "Of the camera's axis above the horizon"),
        "focal": Parameter("Focal length", "pixels", 1.0, 1e7, 1000.0, "Of the camera"),
        "principal": Parameter("Principal point", "pixels", -1e6, 1e6, 0.0, "From the middle of pixel 0, 0"),
        "distortion": Parameter("Distortion", "", -100.0, 100.0, 0.0, "A coefficient of OpenCV's model"),
        "matrix": Parameter("Colour matrix", "", -20.0, 20.0, 0.0, "Camera channels to linear Rec. 2020"),
        "board.square_m": Parameter("Square", "m", 1e-4, 10.0, 0.02, "Side of a square of the board"),
        "sphere.radius_m": Parameter("Radius", "m", 1e-4, 10.0, 0.05, "Of the painted sphere"),
        "coordinate_m": Parameter("Position", "m", -100.0, 100.0, 0.0, "In the world of the rig"),
        "normal": Parameter("Normal", "", -1e3, 1e3, 0.0, "A vector of any length"),
        "light.distance_m": Parameter("Lamp distance", "m", 0.01, 100.0, 0.7, "From the axis, level"),
        "angle_offset_deg": Parameter("Angle offset", "°", -45.0, 45.0, 0.0, "Added to every stated angle"),
        "irradiance": Parameter(
            "Irradiance", "1/s", 1e-12, 1e12, 1.0, "At the sphere's centre, facing the lamp"
        ),
        "width_m": Parameter("Radius", "m", 0.0, 1.0, 0.0, "Of what hides the sphere from the camera"),
        "profile[][0]": Parameter("Angle off the axis", "°", 0.0, 90.0, 0.0, "Of the lamp"),
        "profile[][1]": Parameter("Relative intensity", "", 1e-6, 1e6, 1.0, "At this angle"),
        "reflectance": Parameter("Reflectance", "", 1e-4, 2.0, 0.99, "Of the white reference, π f_r"),
        "angle_deg": Parameter("Angle", "°", -360.0, 360.0, 0.0, "Of the lamp, 0 in front of the camera"),
    }
)
"""The numbers of a session, by the last part of their place where it is unique."""

MOST_EXPOSURES = 64
SECONDS = Parameter("Exposure time", "s", 1e-7, 36_000.0, 0.01, "Of a photograph")


def set_vector(owner: object, parameter: Parameter, name: str) -> None:
    """Check a field of three numbers and store it as a tuple of floats."""
    object.__setattr__(owner, name, check_numbers(getattr(owner, name), name, parameter, 3))


def check_whole(value: object, place: str, low: int, high: int) -> int:
    """Return a whole number from ``low`` to ``high``."""
    found = as_whole(value)
    if isinstance(found, bool) or not isinstance(found, int):
        raise ValueRangeError(place, f"expected a whole number, not {describe(value)}")
    if not low <= found <= high:
        raise ValueRangeError(place, f"{describe(value)} is outside the range {low} to {high}")
    return found


def set_times(owner: object) -> None:
    """Check a value's ``exposures_s`` in seconds, which must grow from one to the next; empty is allowed."""
    value, place = vars(owner)["exposures_s"], "exposures_s"
    if not isinstance(value, (tuple, list)):
        raise ValueRangeError(place, f"expected a list of times, not {describe(value)}")
    if len(value) > MOST_EXPOSURES:
        raise ValueRangeError(place, f"expected at most {MOST_EXPOSURES}, found {len(value)}")
    times = tuple(SECONDS.check(item, f"{place}[{i}]") for i, item in enumerate(value))
    for i, (before, time) in enumerate(itertools.pairwise(times), 1):
        if time <= before:
            order = "list the exposures from the shortest to the longest"
            raise ValueRangeError(f"{place}[{i}]", f"{time:g} s comes after {before:g} s; {order}")
    object.__setattr__(owner, place, times)


def set_series(owner: object, place: str = "photographs", least: int = 1, most: int = MOST_EXPOSURES) -> None:
    """Check a value's list of names of files, ``least`` to ``most``."""
    value = vars(owner)[place]
    if not isinstance(value, (tuple, list)):
        raise ValueRangeError(place, f"expected a list of names of files, not {describe(value)}")
    if not least <= len(value) <= most:
        raise ValueRangeError(place, f"expected {least} to {most} files, found {len(value)}")
    names = tuple(check_name(item, f"{place}[{i}]") for i, item in enumerate(value))
    object.__setattr__(owner, place, names)


def check_name(value: object, place: str) -> str:
    """Return the name of a file within the folder, with ``/`` between folders.

    What leads out of the folder is refused: a session that someone sends must not read other files.
    """
    name = check_text(value, place, longest=1000, lines=False, empty=False)
    path = PurePosixPath(name)
    if "\\" in name or (len(name) > 1 and name[1] == ":"):
        raise ValueRangeError(place, f"{name!r}: write folders with / between them, relative to session.json")
    if path.is_absolute() or ".." in path.parts:
        raise ValueRangeError(place, f"{name!r} lies outside the folder of the session")
    return name


def refuse_twice(files: Iterable[tuple[str, str]]) -> None:
    """Refuse a file that is named at two places, given as (place, name): one of them shows something else."""
    seen: dict[str, str] = {}
    for place, name in files:
        first = seen.setdefault(str(PurePosixPath(name)), place)
        if first != place:
            raise ValueRangeError(place, f"{name!r} is the file of {first} already")

"""Session of a folder of photographs: the rig, the exposures, and the files of each light position.

The world of the rig is right-handed, in metres: its origin lies on the axis of the turntable at the height of the
sphere's centre, y up. The camera stands at (0, height, distance) and looks along -z, tilted by ``tilt_deg`` about x.
The lamp at angle α stands at (distance sin α, height, distance cos α): 0° is in front of the camera, 180° opposite.

The unit of the photographs is the exposure in which a channel's code of half the full scale, 2^(bits - 1), counts as
0.5, above the black of a dark frame. Radiance and irradiance are in this unit per second, each channel in its own.

Values only, each checked as it is made: a bad one raises :class:`ValueRangeError` whose ``place`` names the field.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Literal, get_args

from brdf_suite.acquisition.session.values import (
    PARAMETERS,
    Matrix,
    Point,
    Rgb,
    check_name,
    check_whole,
    refuse_twice,
    set_series,
    set_times,
    set_vector,
)
from brdf_suite.documents.parameter import check_choice, check_numbers, check_text, describe, set_number
from brdf_suite.errors import ValueRangeError

ResponseKind = Literal["unknown", "linear", "srgb"]
RESPONSES: tuple[str, ...] = get_args(ResponseKind)

_MOST_BOARDS = 500
# A matrix between camera and working space keeps white; what does not is one for another purpose.
_WHITE_KEPT = 0.02
FORMAT = "brdf-suite acquisition session"
SESSION_FILE = "session.json"
MOST_POSITIONS = 3600


@dataclass(frozen=True)
class Lens:
    """A camera as OpenCV describes it: focal lengths and principal point in pixels, and the lens's distortion.

    Pixel (column 0, row 0) has its middle at (0, 0); x grows to the right and y downwards.
    """

    fx: float
    fy: float
    cx: float
    cy: float
    k1: float = 0.0
    k2: float = 0.0
    p1: float = 0.0
    p2: float = 0.0
    k3: float = 0.0

    def __post_init__(self) -> None:
        set_number(self, PARAMETERS["focal"], "fx", "fy")
        set_number(self, PARAMETERS["principal"], "cx", "cy")
        set_number(self, PARAMETERS["distortion"], "k1", "k2", "p1", "p2", "k3")


@dataclass(frozen=True)
class Board:
    """A chessboard photographed for the intrinsics: inner corners across and down, and the side of a square."""

    columns: int
    rows: int
    square_m: float
    photographs: tuple[str, ...]

    def __post_init__(self) -> None:
        for name in ("columns", "rows"):
            check_whole(getattr(self, name), name, 3, 100)
        set_number(self, PARAMETERS["board.square_m"], "square_m")
        set_series(self, most=_MOST_BOARDS)


@dataclass(frozen=True)
class SessionCamera:
    """The camera of a session: its position, and the meaning of its codes.

    Attributes
    ----------
    distance_m, height_m
        Of its centre of projection: level distance to the turntable's axis, and height above the sphere's centre.
    bit_depth
        8 to 16: codes are 0 … 2^bits - 1 as they stand in the file. Float pictures know none.
    response
        ``unknown``: the curve is recovered from the exposures; ``linear``; or ``srgb``, the curve of IEC 61966-2-1.
    tilt_deg
        Of the optical axis, positive upwards.
    to_working
        (3, 3) from the channels' reflectance to linear Rec. 2020; rows sum to 1. ``None``: the channels are taken so.
    intrinsics, board
        Known values, or photographs of a board to recover them from; with neither, the focal length follows from the
        outline of the sphere and the distance.
    """

    distance_m: float
    height_m: float = 0.0
    bit_depth: int = 12
    response: ResponseKind = "unknown"
    tilt_deg: float = 0.0
    to_working: Matrix | None = None
    intrinsics: Lens | None = None
    board: Board | None = None

    def __post_init__(self) -> None:
        set_number(self, PARAMETERS["camera.distance_m"], "distance_m")
        set_number(self, PARAMETERS["height_m"], "height_m")
        set_number(self, PARAMETERS["tilt_deg"], "tilt_deg")
        check_whole(self.bit_depth, "bit_depth", 8, 16)
        check_choice(self.response, "response", RESPONSES)
        if self.to_working is not None:
            if not isinstance(self.to_working, (tuple, list)) or len(self.to_working) != 3:
                reason = f"expected three rows of three numbers, not {describe(self.to_working)}"
                raise ValueRangeError("to_working", reason)
            places = [f"to_working[{i}]" for i in range(3)]
            rows = [
                check_numbers(row, place, PARAMETERS["matrix"], 3)
                for row, place in zip(self.to_working, places, strict=True)
            ]
            for row, place in zip(rows, places, strict=True):
                if abs(sum(row) - 1.0) > _WHITE_KEPT:
                    reason = f"the row sums to {sum(row):g}, not to 1, so that white would change"
                    raise ValueRangeError(place, reason)
            object.__setattr__(self, "to_working", tuple(rows))


@dataclass(frozen=True)
class Sphere:
    """The painted sphere; ``centre_m`` in the world where it was measured, ``None``: found from its outline."""

    radius_m: float
    centre_m: Point | None = None

    def __post_init__(self) -> None:
        set_number(self, PARAMETERS["sphere.radius_m"], "radius_m")
        if self.centre_m is not None:
            set_vector(self, PARAMETERS["coordinate_m"], "centre_m")


@dataclass(frozen=True)
class Light:
    """The lamp on the arm of the turntable, a point that aims at the origin.

    Attributes
    ----------
    distance_m, height_m
        Level distance to the axis, and height above the sphere's centre.
    irradiance_rgb
        On a surface at the origin that faces the lamp, in the photographs' unit per second; ``None``: from the white
        reference.
    profile
        (degrees off the lamp's axis, relative radiant intensity), from 0° on, linear between; ``()``: even.
    angle_offset_deg
        A known error of the turntable's zero, added to every position's angle.
    housing_radius_m, post_radius_m
        Of the lamp's housing, and of the post from the turntable up to it, where they can hide the sphere.
    """

    distance_m: float
    height_m: float = 0.0
    irradiance_rgb: Rgb | None = None
    profile: tuple[tuple[float, float], ...] = ()
    angle_offset_deg: float = 0.0
    housing_radius_m: float = 0.0
    post_radius_m: float = 0.0

    def __post_init__(self) -> None:
        set_number(self, PARAMETERS["light.distance_m"], "distance_m")
        set_number(self, PARAMETERS["height_m"], "height_m")
        set_number(self, PARAMETERS["angle_offset_deg"], "angle_offset_deg")
        set_number(self, PARAMETERS["width_m"], "housing_radius_m", "post_radius_m")
        if self.irradiance_rgb is not None:
            set_vector(self, PARAMETERS["irradiance"], "irradiance_rgb")
        if not isinstance(self.profile, (tuple, list)):
            raise ValueRangeError("profile", f"expected a list of pairs, not {describe(self.profile)}")
        pairs: list[tuple[float, float]] = []
        for i, pair in enumerate(self.profile):
            if not isinstance(pair, (tuple, list)) or len(pair) != 2:
                raise ValueRangeError(f"profile[{i}]", f"expected a pair, not {describe(pair)}")
            angle = PARAMETERS["profile[][0]"].check(pair[0], f"profile[{i}][0]")
            if pairs and angle <= pairs[-1][0]:
                raise ValueRangeError(f"profile[{i}][0]", f"{angle:g}° is not beyond the one before")
            if not pairs and angle != 0.0:
                raise ValueRangeError("profile[0][0]", f"the profile starts at 0°, not at {angle:g}°")
            pairs.append((angle, PARAMETERS["profile[][1]"].check(pair[1], f"profile[{i}][1]")))
        object.__setattr__(self, "profile", tuple(pairs))


@dataclass(frozen=True)
class WhiteReference:
    """A diffuse white of known reflectance in the sphere's place, which sets the scale of all samples.

    Attributes
    ----------
    photographs, exposures_s
        One file for each exposure, shortest first; no times: those of the session.
    region
        (left, top, width, height) in pixels that show nothing but the white.
    reflectance
        π f_r of each channel; a Lambertian surface is assumed.
    angle_deg
        The lamp's position.
    centre_m, normal
        Of the white's surface where the region shows it.
    """

    photographs: tuple[str, ...]
    region: tuple[int, int, int, int]
    reflectance: Rgb = (0.99, 0.99, 0.99)
    angle_deg: float = 0.0
    centre_m: Point = (0.0, 0.0, 0.0)
    normal: Point = (0.0, 0.0, 1.0)
    exposures_s: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        set_series(self)
        if not isinstance(self.region, (tuple, list)) or len(self.region) != 4:
            raise ValueRangeError("region", f"expected left, top, width, height, not {describe(self.region)}")
        lowest = (0, 0, 1, 1)
        region = tuple(check_whole(v, f"region[{i}]", lowest[i], 65_535) for i, v in enumerate(self.region))
        object.__setattr__(self, "region", region)
        set_vector(self, PARAMETERS["reflectance"], "reflectance")
        set_number(self, PARAMETERS["angle_deg"], "angle_deg")
        set_vector(self, PARAMETERS["coordinate_m"], "centre_m")
        set_vector(self, PARAMETERS["normal"], "normal")
        if math.hypot(*self.normal) < 1e-9:
            raise ValueRangeError("normal", "a vector of length 0 has no direction")
        set_times(self)


@dataclass(frozen=True)
class FlatField:
    """Photographs of an evenly lit white screen that fills the picture; no times: those of the session."""

    photographs: tuple[str, ...]
    exposures_s: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        set_series(self)
        set_times(self)


@dataclass(frozen=True)
class Position:
    """One position of the lamp: its angle on the turntable and a file for each exposure, shortest first.

    ``mask`` names a picture whose white pixels may be used, for what hides the sphere at this position alone.
    """

    angle_deg: float
    photographs: tuple[str, ...]
    mask: str | None = None

    def __post_init__(self) -> None:
        set_number(self, PARAMETERS["angle_deg"], "angle_deg")
        set_series(self)
        if self.mask is not None:
            check_name(self.mask, "mask")


@dataclass(frozen=True)
class Session:
    """A folder of photographs as ``session.json`` describes it. Names of files are relative to the folder.

    Attributes
    ----------
    exposures_s
        Seconds, from the shortest to the longest; every position has one photograph for each.
    positions
        In order of their angles.
    dark
        One photograph for each exposure with the lamp off, or none.
    mask
        A picture whose white pixels may be used, at all positions.
    """

    name: str
    camera: SessionCamera
    sphere: Sphere
    light: Light
    exposures_s: tuple[float, ...]
    positions: tuple[Position, ...]
    white: WhiteReference | None = None
    dark: tuple[str, ...] = ()
    flat_field: FlatField | None = None
    mask: str | None = None
    notes: str = ""
    date: str = ""

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=200, lines=False, empty=False)
        check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)
        check_text(self.date, "date", longest=100, lines=False, empty=True)
        set_times(self)
        if not self.exposures_s:
            raise ValueRangeError("exposures_s", "the list is empty")
        set_series(self, "dark", 0)
        if self.mask is not None:
            check_name(self.mask, "mask")
        self._check_positions()
        self._check_counts()
        if self.camera.distance_m <= self.sphere.radius_m:
            raise ValueRangeError("camera.distance_m", "the camera would stand inside the sphere")
        if math.hypot(self.light.distance_m, self.light.height_m) <= self.sphere.radius_m:
            raise ValueRangeError("light.distance_m", "the lamp would stand inside the sphere")
        refuse_twice(self.files())

    def _check_positions(self) -> None:
        is_list = isinstance(self.positions, (tuple, list))
        if not is_list or not all(isinstance(item, Position) for item in self.positions):
            reason = f"expected a list of positions, not {describe(self.positions)}"
            raise ValueRangeError("positions", reason)
        object.__setattr__(self, "positions", tuple(self.positions))
        if not 1 <= len(self.positions) <= MOST_POSITIONS:
            raise ValueRangeError("positions", f"expected 1 to {MOST_POSITIONS}, found {len(self.positions)}")
        for i, (before, here) in enumerate(itertools.pairwise(p.angle_deg for p in self.positions), 1):
            if here <= before:
                reason = f"{here:g}° comes after {before:g}°; list the positions in order of their angles"
                raise ValueRangeError(f"positions[{i}].angle_deg", reason)

    def _check_counts(self) -> None:
        """Check that each series has as many photographs as exposures."""
        count = len(self.exposures_s)
        series = [(f"positions[{i}].photographs", p.photographs, count) for i, p in enumerate(self.positions)]
        if self.dark:
            series.append(("dark", self.dark, count))
        for name, other in (("white", self.white), ("flat_field", self.flat_field)):
            if other is not None:
                series.append((f"{name}.photographs", other.photographs, len(other.exposures_s) or count))
        for place, files, wanted in series:
            if len(files) != wanted:
                reason = f"there are {len(files)} photographs for {wanted} exposures; expected one for each"
                raise ValueRangeError(place, reason)

    def light_m(self, position: int | float) -> Point:
        """Return where the lamp stands: at the position of this index (an int), or at an angle in degrees (a float)."""
        degrees = self.positions[position].angle_deg if isinstance(position, int) else position
        angle = math.radians(degrees + self.light.angle_offset_deg)
        distance = self.light.distance_m
        return (distance * math.sin(angle), self.light.height_m, distance * math.cos(angle))

    def files(self) -> tuple[tuple[str, str], ...]:
        """Return (place, name) of every file that the session names, positions first."""
        named = [
            (f"positions[{i}].photographs[{k}]", file)
            for i, position in enumerate(self.positions)
            for k, file in enumerate(position.photographs)
        ]
        named += [
            (f"positions[{i}].mask", p.mask) for i, p in enumerate(self.positions) if p.mask is not None
        ]
        named += [(f"dark[{k}]", file) for k, file in enumerate(self.dark)]
        calibrations = {"white": self.white, "flat_field": self.flat_field, "camera.board": self.camera.board}
        for place, part in calibrations.items():
            if part is not None:
                named += [(f"{place}.photographs[{k}]", file) for k, file in enumerate(part.photographs)]
        if self.mask is not None:
            named.append(("mask", self.mask))
        return tuple(named)

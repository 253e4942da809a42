"""Studio document: a room or a plain backdrop with lamps; and a sky by its parameters.

Both are kept in ``.brdfstudio`` JSON files, with the field ``kind`` for the type, and become light in
:mod:`brdf_suite.lighting.procedural`. Lengths are metres from the middle of the scene, where the surface stands and
from where the light is seen: x to the right, y up, z towards the viewer's front.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from brdf_suite.documents.atomic import encode, with_lists, write_atomically
from brdf_suite.documents.parameter import (
    Parameter,
    check_choice,
    check_flags,
    check_numbers,
    check_text,
    describe,
    set_number,
    set_numbers,
)
from brdf_suite.documents.reading import VERSIONS, FieldReader, fill, open_envelope, read_json
from brdf_suite.errors import PathLike, ValueRangeError
from brdf_suite.regular_files import within_memory

Shape = Literal["box", "strip", "ring"]
SHAPES: tuple[str, ...] = get_args(Shape)
Unit = Literal["kcd/m2", "relative"]
UNITS: tuple[str, ...] = get_args(Unit)
SkyModel = Literal["hosek_wilkie", "preetham", "overcast"]
SKY_MODELS: tuple[str, ...] = get_args(SkyModel)

MOST_LAMPS = 64
_NEAREST_M = 0.1
Point = tuple[float, float, float]

PARAMETERS: Mapping[str, Parameter] = {
    "size": Parameter("Size", "m", 0.5, 100.0, 4.0, "Of the room, from wall to wall"),
    "eye_height_m": Parameter("Eye height", "m", 0.01, 99.0, 0.9, "Of the middle of the scene"),
    "albedo": Parameter("Albedo", "", 0.0, 0.95, 0.4, "Share of the light that is given back"),
    "position_m": Parameter("Position", "m", -100.0, 100.0, 0.0, "Of the lamp's middle"),
    "facing": Parameter("Facing", "", -1e3, 1e3, 0.0, "Where the lamp shines, a vector of any length"),
    "size_m": Parameter("Size", "m", 0.005, 50.0, 1.0, "Both sides; outer diameter and width of a ring"),
    "roll_deg": Parameter("Roll", "°", -360.0, 360.0, 0.0, "About the direction in which the lamp shines"),
    "luminance": Parameter("Luminance", "", 0.0, 1e6, 5.0, "In the unit of the studio"),
    "colour_temperature_k": Parameter("Colour", "K", 1000.0, 25000.0, 6504.0, "Of the lamp's white"),
    "softness_m": Parameter("Softness", "m", 1e-4, 10.0, 0.06, "Over which the lamp's edge fades in"),
    "turbidity": Parameter("Turbidity", "", 1.7, 10.0, 3.0, "Haze: 2 very clear, 3 clear, 6 hazy"),
    "sun_elevation_deg": Parameter("Elevation", "°", 1.0, 89.9, 40.0, "Of the sun above the horizon"),
    "sun_azimuth_deg": Parameter("Azimuth", "°", -360.0, 360.0, 60.0, "Of the sun, from +z towards +x"),
    "ground_albedo": Parameter("Ground", "", 0.0, 1.0, 0.2, "Share of the light that the ground gives back"),
}


def _vector(owner: object, name: str, count: int) -> None:
    object.__setattr__(owner, name, check_numbers(getattr(owner, name), name, PARAMETERS[name], count))


@dataclass(frozen=True)
class BoothRoom:
    """A closed room, its middle at x = z = 0, its floor ``eye_height_m`` below the middle of the scene."""

    width_m: float = 9.0
    length_m: float = 14.0
    height_m: float = 4.2
    eye_height_m: float = 0.9
    floor_albedo: float = 0.26
    wall_albedo: float = 0.43
    ceiling_albedo: float = 0.30

    def __post_init__(self) -> None:
        set_number(self, PARAMETERS["size"], "width_m", "length_m", "height_m")
        set_number(self, PARAMETERS["albedo"], "floor_albedo", "wall_albedo", "ceiling_albedo")
        set_numbers(self, PARAMETERS, "eye_height_m")
        if self.eye_height_m >= self.height_m:
            raise ValueRangeError("eye_height_m", f"must lie below the ceiling, {self.height_m:g} m")

    def holds(self, position: Point) -> bool:
        """Return whether a point lies within the room, walls included."""
        x, y, z = position
        upright = -self.eye_height_m <= y <= self.height_m - self.eye_height_m
        return abs(x) <= 0.5 * self.width_m and upright and abs(z) <= 0.5 * self.length_m


@dataclass(frozen=True)
class Backdrop:
    """A uniform backdrop behind the lamps; 0 is a black void. ``None`` K: neutral, D65."""

    luminance: float = 0.1
    colour_temperature_k: float | None = None

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "luminance")
        if self.colour_temperature_k is not None:
            set_numbers(self, PARAMETERS, "colour_temperature_k")


@dataclass(frozen=True)
class StudioLamp:
    """A one-sided area lamp of a studio.

    Attributes
    ----------
    shape
        ``box``: a rectangle, brightest in the middle, 70 % in its corners; ``strip``: even, with round ends;
        ``ring``: even.
    position_m
        Of its middle.
    size_m
        Width and height of a box, length and width of a strip, outer diameter and width of the band of a ring.
    facing
        Where it shines; ``None``: towards the middle of the scene.
    roll_deg
        Turns it about that direction; at 0 its first side is level, or along x where it faces straight up or down.
    luminance
        In its middle, in the studio's unit.
    colour_temperature_k
        Planck's below 4,000 K, CIE daylight from there on; ``None``: neutral, D65.
    softness_m
        Width of its edge, inwards.
    """

    shape: Shape
    position_m: Point
    size_m: tuple[float, float]
    facing: Point | None = None
    roll_deg: float = 0.0
    luminance: float = 5.0
    colour_temperature_k: float | None = None
    softness_m: float = 0.06

    def __post_init__(self) -> None:
        check_choice(self.shape, "shape", SHAPES)
        _vector(self, "position_m", 3)
        _vector(self, "size_m", 2)
        set_numbers(self, PARAMETERS, "roll_deg", "luminance", "softness_m")
        if self.colour_temperature_k is not None:
            set_numbers(self, PARAMETERS, "colour_temperature_k")
        if self.facing is not None:
            _vector(self, "facing", 3)
            if sum(value * value for value in self.facing) < 1e-12:
                raise ValueRangeError("facing", "a vector of length 0 has no direction")
        if sum(value * value for value in self.position_m) < _NEAREST_M**2:
            raise ValueRangeError(
                "position_m", f"must be {_NEAREST_M} m or more from the middle of the scene"
            )
        first, second = self.size_m
        if self.shape == "strip" and second > first:
            raise ValueRangeError("size_m", "a strip is at least as long as wide: length first, then width")
        if self.shape == "ring" and second > 0.5 * first:
            raise ValueRangeError("size_m", "a ring's band is at most half as wide as its outer diameter")


@dataclass(frozen=True)
class Studio:
    """Lamps in a room or before a plain backdrop. Exactly one of ``room`` and ``backdrop`` is given.

    ``unit`` says what the luminances are: ``kcd/m2``, or ``relative`` where only their ratios count. The picture is
    exposed for a white card either way.
    """

    name: str
    lamps: tuple[StudioLamp, ...]
    room: BoothRoom | None = None
    backdrop: Backdrop | None = None
    unit: Unit = "kcd/m2"

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=200, lines=False, empty=False)
        check_choice(self.unit, "unit", UNITS)
        if (self.room is None) == (self.backdrop is None):
            raise ValueRangeError("room", 'expected either "room" or "backdrop", and only one of them')
        if not isinstance(self.lamps, tuple) or not all(isinstance(lamp, StudioLamp) for lamp in self.lamps):
            raise ValueRangeError("lamps", f"expected a list of lamps, not {describe(self.lamps)}")
        if len(self.lamps) > MOST_LAMPS:
            raise ValueRangeError("lamps", f"{len(self.lamps)} lamps are more than the {MOST_LAMPS} allowed")
        for i, lamp in enumerate(self.lamps):
            if self.room is not None and not self.room.holds(lamp.position_m):
                raise ValueRangeError(f"lamps[{i}].position_m", "lies outside of the room")
        shining = any(lamp.luminance > 0.0 for lamp in self.lamps)
        if not shining and (self.backdrop is None or self.backdrop.luminance == 0.0):
            raise ValueRangeError(
                "lamps", "nothing gives light: expected a lamp or a backdrop of luminance above 0"
            )


@dataclass(frozen=True)
class Sky:
    """A sky over a plain, even ground.

    Attributes
    ----------
    model
        ``hosek_wilkie`` (2012), ``preetham`` (1999), or ``overcast`` (CIE; knows neither haze nor sun).
    turbidity
        1.7 to 10; Preetham's model holds from 2 to about 6 and is refused outside 1.9 … 10.
    sun_elevation_deg, sun_azimuth_deg
        Where the sun is; the azimuth from +z towards +x.
    ground_albedo
        Of the ground, which the Hosek-Wilkie sky answers to as well.
    sun_disc
        Whether the sun itself is in the picture, 0.53° across and darker towards its limb.
    """

    name: str
    model: SkyModel = "hosek_wilkie"
    turbidity: float = PARAMETERS["turbidity"].default
    sun_elevation_deg: float = PARAMETERS["sun_elevation_deg"].default
    sun_azimuth_deg: float = PARAMETERS["sun_azimuth_deg"].default
    ground_albedo: float = PARAMETERS["ground_albedo"].default
    sun_disc: bool = True

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=200, lines=False, empty=False)
        check_choice(self.model, "model", SKY_MODELS)
        set_numbers(self, PARAMETERS, "turbidity", "sun_elevation_deg", "sun_azimuth_deg", "ground_albedo")
        if self.model == "preetham" and self.turbidity < 1.9:
            raise ValueRangeError("turbidity", "Preetham's model holds from 1.9 on; take hosek_wilkie below")
        check_flags(self, "sun_disc")


STUDIO_ENDING = ".brdfstudio"
LightDocument = Studio | Sky


@within_memory
def load_light(path: PathLike) -> LightDocument:
    """Read a ``.brdfstudio`` file; raise :class:`DocumentError` with the place, or :class:`FileError`."""
    return light_from_json(read_json(path), path)


def save_light(light: LightDocument, path: PathLike) -> None:
    """Write a ``.brdfstudio`` file, whole or not at all; raise :class:`FileError` where that fails."""
    write_atomically(path, encode(light_to_json(light)))


def light_to_json(light: LightDocument) -> dict[str, object]:
    """Return the JSON object of a studio or a sky; :func:`light_from_json` is its inverse."""
    fields = dataclasses.asdict(light, dict_factory=with_lists)
    kind = "sky" if isinstance(light, Sky) else "studio"
    if kind == "studio":
        order = ("name", "unit", "room", "backdrop", "lamps")
        fields = {name: fields[name] for name in order if fields[name] is not None}
    return {"format": "brdfstudio", "version": VERSIONS["brdfstudio"], "kind": kind, **fields}


def light_from_json(value: object, path: PathLike = "the message") -> LightDocument:
    """Return the studio or sky in a JSON value; ``path`` is what error messages call its origin.

    Raises :class:`DocumentError`: a field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    """
    reader = open_envelope(value, "brdfstudio", path)
    kind = reader.take("kind")
    if kind == "sky":
        return fill(reader, Sky, required=("name",))
    if kind != "studio":
        reader.fail('the kinds known to this version are "studio" and "sky"', "kind")
    name = reader.take("name")
    lamps = tuple(
        fill(item, StudioLamp, required=("shape", "position_m", "size_m"))
        for item in reader.take_objects("lamps")
    )
    room, backdrop = (reader.take_or(part, None) for part in ("room", "backdrop"))
    taken = {
        "name": name,
        "lamps": lamps,
        "room": None if room is None else fill(FieldReader(room, path, "room"), BoothRoom),
        "backdrop": None if backdrop is None else fill(FieldReader(backdrop, path, "backdrop"), Backdrop),
    }
    return fill(reader, Studio, taken=taken)

"""The parts of a view beside its camera: light colour, lamps, sparkle, surface, relief, two-tone, comparison.

Each is a frozen value that checks itself; a :class:`~brdf_suite.documents.view.View` holds them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath, PureWindowsPath
from typing import Literal, TypeAlias, get_args

from brdf_suite.documents.parameter import (
    Parameter,
    check_choice,
    check_choices,
    check_flags,
    check_items,
    check_numbers,
    check_text,
    describe,
    set_numbers,
)
from brdf_suite.errors import ValueRangeError

Illuminant = Literal["environment", "D65", "D50", "A", "TL84", "CWF", "LED"]
ILLUMINANTS: tuple[str, ...] = get_args(Illuminant)
LampKind = Literal["point", "directional"]
LAMP_KINDS: tuple[str, ...] = get_args(LampKind)
SparkleMode = Literal["off", "texture", "glints"]
SPARKLE_MODES: tuple[str, ...] = get_args(SparkleMode)
LengthUnit = Literal["file", "m", "cm", "mm", "in"]
LENGTH_UNITS: tuple[str, ...] = get_args(LengthUnit)
UpAxis = Literal["file", "y", "z"]
UP_AXES: tuple[UpAxis, ...] = get_args(UpAxis)
NormalsMode = Literal["file", "smooth", "flat"]
NORMALS_MODES: tuple[str, ...] = get_args(NormalsMode)
MaskProjection = Literal["uv", "side", "front", "top"]
MASK_PROJECTIONS: tuple[str, ...] = get_args(MaskProjection)
CompareMode = Literal["off", "side", "swipe", "blink", "difference"]
COMPARE_MODES: tuple[str, ...] = get_args(CompareMode)
CompareBasis = Literal["light", "picture"]
COMPARE_BASES: tuple[str, ...] = get_args(CompareBasis)
SecondPaint: TypeAlias = Literal["second_paint"]
SECOND_PAINT: SecondPaint = "second_paint"
Material: TypeAlias = Literal[
    "paint",
    SecondPaint,
    "glass",
    "lens",
    "rubber",
    "chrome",
    "lamp",
    "tail_lamp",
    "trim",
    "cavity",
    "gap",
    "neutral",
]
"""What a part of a mesh is made of. ``second_paint`` is the view's second paint, and the paint where it has none;
``trim`` matt black plastic; ``gap`` a dark shut line between panels; ``neutral`` everything else."""
MATERIALS: tuple[Material, ...] = get_args(Material)
TRANSMITTANCE: Mapping[str, float] = {"glass": 0.6, "lens": 0.92}
"""Of materials that are seen through: which share passes of the light that a sheet does not mirror."""
PANE_IOR: Mapping[str, float] = {"glass": 1.52, "lens": 1.59}
"""Their index of refraction: a sheet mirrors R(θ) = 2F/(1 + F), and passes its transmittance times 1 - R(θ), whether it
is looked through or light comes through it."""

MOST_LAMPS = 8

PARAMETERS: Mapping[str, Parameter] = {
    "lamp.position": Parameter("Position", "m", -1e4, 1e4, 0.0, "Where a point lamp is, y up"),
    "lamp.azimuth_deg": Parameter("Azimuth", "°", -3600.0, 3600.0, 30.0, "Around the y axis, 0 on +z"),
    "lamp.elevation_deg": Parameter("Elevation", "°", -90.0, 90.0, 45.0, "Above the horizontal plane"),
    "lamp.strength": Parameter(
        "Strength",
        "",
        0.0,
        1e6,
        1.0,
        "Illuminance over π, in the units of the environment: a white surface that faces the lamp, "
        "at 1 m from a point lamp, gets this radiance",
    ),
    "lamp.temperature_k": Parameter(
        "Colour temperature", "K", 1000.0, 25000.0, 6500.0, "Of the lamp's light, on the locus of daylight"
    ),
    "lamp.diameter": Parameter(
        "Diameter", "m", 0.0, 100.0, 0.0, "Of a point lamp, a ball; 0: a point, whose shadows are sharp"
    ),
    "lamp.angle_deg": Parameter(
        "Angle",
        "°",
        0.0,
        60.0,
        0.0,
        "Across the disc of a directional lamp, the sun's is 0.53; 0: sharp shadows",
    ),
    "lens.f_number": Parameter(
        "Aperture", "", 0.0, 128.0, 0.0, "Focal length over diameter of the lens's opening; 0: all is sharp"
    ),
    "lens.focus_distance": Parameter(
        "Focus", "m", 1e-3, 1e6, 1.0, "From the camera to the plane that is sharp"
    ),
    "lens.turn_deg": Parameter(
        "Turn", "°", -360.0, 360.0, 0.0, "By which the object turns while the shutter is open"
    ),
    "light_colour.brightness": Parameter(
        "Brightness", "×", 0.0, 16.0, 1.0, "Factor on the environment's light; 0: the lamps alone"
    ),
    "sparkle.light_count": Parameter(
        "Lights", "", 1.0, 16.0, 8.0, "The brightest lights of the environment, in which flakes glint"
    ),
    "sparkle.strength": Parameter(
        "Strength", "×", 0.0, 8.0, 1.0, "Factor on the light of single flakes; 1: as density and size say"
    ),
    "surface.scale": Parameter("Scale", "", 1e-4, 1e4, 1.0, "Factor on all lengths of the mesh"),
    "surface.tessellation_mm": Parameter(
        "Fineness",
        "mm",
        1e-3,
        100.0,
        0.2,
        "Largest distance of a triangle from the CAD surface that it stands for",
    ),
    "relief.normal_strength": Parameter("Strength", "", 0.0, 4.0, 1.0, "Factor on the normal map's slopes"),
    "relief.normal_width_mm": Parameter("Width", "mm", 0.1, 1e5, 100.0, "What one tile of the map covers"),
    "relief.orange_peel": Parameter(
        "Orange peel", "°", 0.0, 5.0, 0.0, "Root mean square slope of the coat's waviness"
    ),
    "relief.orange_peel_mm": Parameter(
        "Wavelength", "mm", 0.2, 50.0, 4.0, "Typical distance from crest to crest of the orange peel"
    ),
    "two_tone.mask_width_mm": Parameter("Width", "mm", 0.1, 1e5, 1000.0, "What one tile of the mask covers"),
    "compare.divider": Parameter("Divider", "", 0.0, 1.0, 0.5, "Share of the width that shows the first"),
    "compare.rate_hz": Parameter("Rate", "/s", 0.2, 10.0, 1.5, "How often a second a blink changes over"),
    "compare.scale_delta_e": Parameter(
        "Scale to", "ΔE00", 0.1, 100.0, 5.0, "The colour difference at the end of the colour scale"
    ),
}


@dataclass(frozen=True)
class LightColour:
    """The illuminant assumed for the environment's white, and chromatic adaptation to it.

    ``environment`` leaves the light as it is; ``TL84`` is CIE F11, ``CWF`` F2, ``LED`` LED-B3. Not adapted, the
    light's tint is seen; adapted, white stays white, and a paint without a spectrum looks as it does under D65, for
    it can show no metamerism. ``brightness`` is a factor on the environment's light: at 0 the lamps are alone.
    """

    illuminant: Illuminant = "environment"
    adapted: bool = True
    brightness: float = 1.0

    def __post_init__(self) -> None:
        check_choice(self.illuminant, "illuminant", ILLUMINANTS)
        check_flags(self, "adapted")
        set_numbers(self, PARAMETERS, "brightness", group="light_colour.")


@dataclass(frozen=True)
class Lamp:
    """A point or directional light beside the environment: ``point`` at ``position`` (metres), or ``directional``.

    A point lamp is a ball of a ``diameter``, a directional one a disc of an angle in the sky: both are even, and send
    as much light as without extent.
    """

    kind: LampKind = "point"
    position: tuple[float, float, float] = (1.0, 2.0, 1.0)
    azimuth_deg: float = PARAMETERS["lamp.azimuth_deg"].default
    elevation_deg: float = PARAMETERS["lamp.elevation_deg"].default
    strength: float = PARAMETERS["lamp.strength"].default
    temperature_k: float = PARAMETERS["lamp.temperature_k"].default
    diameter: float = PARAMETERS["lamp.diameter"].default
    angle_deg: float = PARAMETERS["lamp.angle_deg"].default

    def __post_init__(self) -> None:
        check_choice(self.kind, "kind", LAMP_KINDS)
        position = check_numbers(self.position, "position", PARAMETERS["lamp.position"], 3)
        object.__setattr__(self, "position", position)
        numbers = ("azimuth_deg", "elevation_deg", "strength", "temperature_k", "diameter", "angle_deg")
        set_numbers(self, PARAMETERS, *numbers, group="lamp.")


@dataclass(frozen=True)
class Lens:
    """What makes a picture in a file blurred: the opening of the lens, and the object's turn during the exposure.

    ``f_number`` is the focal length over the diameter of the opening, 0 a pinhole. ``focus_distance`` is from the
    camera to the sharp plane, along the axis, metres; None: to the object's nearest point in the middle of the picture.
    ``turn_deg`` is counter-clockwise seen from above, the middle of the exposure being the view itself.
    """

    f_number: float = 0.0
    focus_distance: float | None = None
    turn_deg: float = 0.0

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "f_number", "turn_deg", group="lens.")
        if self.focus_distance is not None:
            set_numbers(self, PARAMETERS, "focus_distance", group="lens.")

    @property
    def blurs(self) -> bool:
        """Whether a picture is other than a sharp one."""
        return self.f_number > 0.0 or self.turn_deg != 0.0


@dataclass(frozen=True)
class Sparkle:
    """Drawing of flakes: the mode, the number of the environment's lights, and the strength.

    At ``strength`` 1 single flakes send what their density and size give; the mean light of the base stays the same.
    """

    mode: SparkleMode = "glints"
    light_count: int = int(PARAMETERS["sparkle.light_count"].default)
    strength: float = PARAMETERS["sparkle.strength"].default

    def __post_init__(self) -> None:
        check_choice(self.mode, "mode", SPARKLE_MODES)
        count = PARAMETERS["sparkle.light_count"].check(self.light_count, "light_count")
        if count != int(count):
            raise ValueRangeError("light_count", f"expected a whole number, not {count:g}")
        object.__setattr__(self, "light_count", int(count))
        set_numbers(self, PARAMETERS, "strength", group="sparkle.")


@dataclass(frozen=True)
class PartMaterial:
    """A material assigned to a part of the mesh instead of its own."""

    part: str
    material: Material

    def __post_init__(self) -> None:
        check_text(self.part, "part", longest=1000, lines=False, empty=False)
        check_choice(self.material, "material", MATERIALS)


@dataclass(frozen=True)
class SurfaceLook:
    """Import options of the mesh, and its baked occlusion.

    ``unit`` is the length unit of the file, ``file``: as it says, metres where it does not; ``up`` the axis that points
    up in it, ``file``: as it says or seems to stand. ``tessellation_mm`` is how near triangles come to the surfaces of
    a CAD file. ``recentre`` puts the middle of its box over the origin and its lowest point on the ground.
    """

    unit: LengthUnit = "file"
    scale: float = PARAMETERS["surface.scale"].default
    recentre: bool = False
    flip_normals: bool = False
    normals: NormalsMode = "file"
    materials: tuple[PartMaterial, ...] = ()
    occlusion: bool = True
    ground: bool = False
    up: UpAxis = "file"
    tessellation_mm: float = PARAMETERS["surface.tessellation_mm"].default

    def __post_init__(self) -> None:
        check_choices(self, unit=LENGTH_UNITS, up=UP_AXES, normals=NORMALS_MODES)
        check_flags(self, "recentre", "flip_normals", "occlusion", "ground")
        set_numbers(self, PARAMETERS, "scale", "tessellation_mm", group="surface.")
        object.__setattr__(self, "materials", check_items(self.materials, "materials", PartMaterial, 10_000))
        if len(self.chosen) != len(self.materials):
            raise ValueRangeError("materials", "a part is named twice")

    @property
    def chosen(self) -> dict[str, str]:
        """The materials that take the place of the mesh's own, by part."""
        return {item.part: item.material for item in self.materials}

    @property
    def wears_second(self) -> bool:
        """Whether a part is given the second paint."""
        return any(item.material == SECOND_PAINT for item in self.materials)


@dataclass(frozen=True)
class Relief:
    """Relief of the surface: a tiled normal map (an absolute path), and the coat's orange peel.

    ``tangent_map`` is an image of directions in the surface, tiled with the normal map: along it lies the grain of
    anisotropic factored paints. Red and green are its parts along u and v, from -1 to 1.
    """

    normal_map: str | None = None
    normal_strength: float = PARAMETERS["relief.normal_strength"].default
    normal_width_mm: float = PARAMETERS["relief.normal_width_mm"].default
    orange_peel: float = PARAMETERS["relief.orange_peel"].default
    orange_peel_mm: float = PARAMETERS["relief.orange_peel_mm"].default
    tangent_map: str | None = None

    def __post_init__(self) -> None:
        check_path(self.normal_map, "normal_map")
        check_path(self.tangent_map, "tangent_map")
        numbers = ("normal_strength", "normal_width_mm", "orange_peel", "orange_peel_mm")
        set_numbers(self, PARAMETERS, *numbers, group="relief.")


@dataclass(frozen=True)
class TwoTone:
    """A second paint where the mask is white, and on parts that are given it as their material.

    Without a ``paint`` there is one paint. The mask is an image, by path; None: no paint is divided by one.

    ``projection``: tiles of ``mask_width_mm`` over the texture coordinates (``uv``), or the image once over the box
    around the mesh, seen from the side (+x), the front (+z) or the top.
    """

    paint: str | None = None
    mask: str | None = None
    mask_width_mm: float = PARAMETERS["two_tone.mask_width_mm"].default
    projection: MaskProjection = "uv"

    def __post_init__(self) -> None:
        _check_paint(self.paint, "paint")
        check_path(self.mask, "mask")
        set_numbers(self, PARAMETERS, "mask_width_mm", group="two_tone.")
        check_choice(self.projection, "projection", MASK_PROJECTIONS)


@dataclass(frozen=True)
class Compare:
    """A second paint (a shipped name or an absolute path), and the way it is compared with the first.

    The path may be a picture's (EXR or PNG) instead. ``basis`` says what a difference is taken of: the ``light``
    that leaves the surface, exposed, where a white of radiance 1 has L* = 100; or the ``picture``, after the tone
    curve.
    """

    mode: CompareMode = "off"
    paint: str | None = None
    divider: float = PARAMETERS["compare.divider"].default
    rate_hz: float = PARAMETERS["compare.rate_hz"].default
    scale_delta_e: float = PARAMETERS["compare.scale_delta_e"].default
    basis: CompareBasis = "light"

    def __post_init__(self) -> None:
        check_choices(self, mode=COMPARE_MODES, basis=COMPARE_BASES)
        _check_paint(self.paint, "paint")
        set_numbers(self, PARAMETERS, "divider", "rate_hz", "scale_delta_e", group="compare.")


def check_path(value: object, place: str) -> None:
    """Raise :class:`ValueRangeError` where ``value`` is neither None nor an absolute path."""
    if value is None:
        return
    text = check_text(value, place, longest=4096, lines=False, empty=False)
    # A file written on another system is still valid here; opening it will say that it is missing.
    if not (PurePosixPath(text).is_absolute() or PureWindowsPath(text).is_absolute()):
        raise ValueRangeError(place, f"expected an absolute path, not {describe(value)}")


def _check_paint(value: object, place: str) -> None:
    if value is not None:
        check_text(value, place, longest=4096, lines=False, empty=False)

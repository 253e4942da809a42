"""View document: camera, environment, surface and tone curve, as a frozen value."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import PurePosixPath, PureWindowsPath
from typing import Literal, get_args

from brdf_suite.documents.parameter import (
    Parameter,
    check_choices,
    check_flags,
    check_items,
    check_numbers,
    check_text,
    describe,
    set_numbers,
)
from brdf_suite.documents.view_settings import (
    MOST_LAMPS,
    Compare,
    Lamp,
    Lens,
    LightColour,
    Relief,
    Sparkle,
    SurfaceLook,
    TwoTone,
)
from brdf_suite.errors import ValueRangeError

ToneCurve = Literal["faithful", "neutral", "characteristic", "aces", "agx", "linear"]
TONE_CURVES: tuple[str, ...] = get_args(ToneCurve)
MarkStyle = Literal["zebra", "colour"]
MARK_STYLES: tuple[str, ...] = get_args(MarkStyle)
Background = Literal["environment", "blurred", "grey", "colour"]
BACKGROUNDS: tuple[str, ...] = get_args(Background)
FresnelMode = Literal["off", "raised", "multi_angle"]
FRESNEL_MODES: tuple[str, ...] = get_args(FresnelMode)
LookUp = Literal["shifted", "paper"]
LOOK_UPS: tuple[str, ...] = get_args(LookUp)
ExposureMode = Literal["locked", "automatic"]
EXPOSURE_MODES: tuple[str, ...] = get_args(ExposureMode)
GlareMode = Literal["off", "eye"]
GLARE_MODES: tuple[str, ...] = get_args(GlareMode)
LampShading = Literal["each", "ball"]
LAMP_SHADINGS: tuple[str, ...] = get_args(LampShading)

ImageLayout = Literal[
    "latlong",
    "horizontal_cross",
    "vertical_cross",
    "horizontal_strip",
    "vertical_strip",
    "exr_cube",
    "angular",
    "mirror_ball",
    "dome",
]
"""A layout that an environment's image can have."""
ENVIRONMENT_LAYOUTS: tuple[str, ...] = ("auto", *get_args(ImageLayout))
"""How an environment's image can be laid out; ``auto``: from the file's header or the image's shape."""

SENSOR_WIDTH_MM = 36.0
"""The width of the picture that ``focal_length_mm`` refers to: a full-frame camera."""

PARAMETERS: Mapping[str, Parameter] = {
    "camera.azimuth_deg": Parameter("Azimuth", "°", -3600.0, 3600.0, 35.0, "Around the y axis, 0 on +z"),
    "camera.elevation_deg": Parameter("Elevation", "°", -90.0, 90.0, 7.0, "Above the horizontal plane"),
    "camera.distance": Parameter("Distance", "m", 1e-4, 1e6, 1.0, "From the target to the camera"),
    "camera.target": Parameter("Target", "m", -1e6, 1e6, 0.0, "The point in the middle of the picture"),
    "camera.focal_length_mm": Parameter("Focal length", "mm", 8.0, 1200.0, 50.0, "On a 36 mm sensor"),
    "rotation_deg": Parameter(
        "Rotation", "°", -3600.0, 3600.0, 0.0, "Turns the light counter-clockwise, seen from above"
    ),
    "turntable_deg_s": Parameter(
        "Turntable", "°/s", -360.0, 360.0, 24.0, "Speed of the turntable, counter-clockwise seen from above"
    ),
    "exposure_ev": Parameter("Exposure", "EV", -24.0, 24.0, 0.0, "Each step doubles the light"),
}

_ENCODED = Parameter("Colour", "", 0.0, 1.0, 0.5, "Encoded sRGB")
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_\-]{0,99}\Z")


@dataclass(frozen=True)
class Camera:
    """A camera that orbits ``target`` (metres); ``distance`` or ``target`` None: frame the object."""

    azimuth_deg: float = 35.0
    elevation_deg: float = 7.0
    distance: float | None = None
    target: tuple[float, float, float] | None = None
    focal_length_mm: float = 50.0

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "azimuth_deg", "elevation_deg", "focal_length_mm", group="camera.")
        if self.distance is not None:
            set_numbers(self, PARAMETERS, "distance", group="camera.")
        if self.target is not None:
            target = check_numbers(self.target, "target", PARAMETERS["camera.target"], 3)
            object.__setattr__(self, "target", target)


@dataclass(frozen=True)
class View:
    """A scene without its paint: camera, light, surface and display settings.

    ``environment`` and ``surface`` are the name of a packaged one (``booth``, ``speed_form``) or the
    absolute path of a file. Whether it exists is found out where it is opened. ``environment_layout`` says how that
    file's image is laid out, one of :data:`ENVIRONMENT_LAYOUTS`. ``rotation_deg`` turns the light counter-clockwise
    seen from above, ``light_colour`` says of which illuminant it is, and ``lamps`` are added to it.

    ``surface_look``, ``relief`` and ``two_tone`` change the surface, ``sparkle`` how flakes are drawn; ``compare`` has
    a second paint beside the first. ``background`` is what is seen behind, ``tone_curve`` how light becomes a picture,
    and ``turntable_deg_s`` how fast a window turns the object, degrees a second.

    ``fresnel``: the weights as fitted, sharp lobes raised by F(θ)/F(θ_fit), or weights fitted at several incidences.
    ``look_up``: lobes looked up along the mirror direction as in the paper, or shifted towards the normal.
    ``exposure_ev`` counts from the automatic exposure where ``exposure_mode`` is ``automatic``. ``background_colour``
    is encoded sRGB. ``clipping_marks`` and ``gamut_marks`` mark what the screen cannot show, too bright
    or too colourful; by ``mark_style``: ``zebra`` stripes or each in a ``colour``. ``lamp_shading``: lamps on factored
    paints one by one at each place, or all at once by a picture of a ball in their light. ``glare``: light above white
    is spread as an ``eye`` scatters it (:mod:`brdf_suite.appearance.glare`), or not; readings, linear files and marks
    are without. ``lens``: blur of pictures in files; a window shows all sharp.

    Raises :class:`ValueRangeError` where a number or a word is none of those allowed; ``place`` names the field.

    >>> import brdf_suite as bs
    >>> bs.View(environment="booth", exposure_ev=1.0).surface
    'speed_form'
    """

    camera: Camera = field(default_factory=Camera)
    environment: str = "photo_studio"
    surface: str = "speed_form"
    rotation_deg: float = 0.0
    exposure_ev: float = 0.0
    tone_curve: ToneCurve = "faithful"
    background: Background = "environment"
    fresnel: FresnelMode = "raised"
    environment_layout: str = "auto"
    look_up: LookUp = "shifted"
    exposure_mode: ExposureMode = "locked"
    background_colour: tuple[float, float, float] = (0.46, 0.46, 0.46)
    clipping_marks: bool = False
    gamut_marks: bool = False
    mark_style: MarkStyle = "zebra"
    light_colour: LightColour = field(default_factory=LightColour)
    lamps: tuple[Lamp, ...] = ()
    sparkle: Sparkle = field(default_factory=Sparkle)
    surface_look: SurfaceLook = field(default_factory=SurfaceLook)
    relief: Relief = field(default_factory=Relief)
    two_tone: TwoTone = field(default_factory=TwoTone)
    compare: Compare = field(default_factory=Compare)
    turntable_deg_s: float = 24.0
    lamp_shading: LampShading = "each"
    glare: GlareMode = "off"
    lens: Lens = field(default_factory=Lens)

    def __post_init__(self) -> None:
        for name, kind in PARTS.items():
            if not isinstance(getattr(self, name), kind):
                words = name.replace("_", " ")
                raise ValueRangeError(name, f"expected a {words}, not {describe(getattr(self, name))}")
        for name in ("environment", "surface"):
            value = getattr(self, name)
            text = check_text(value, name, longest=4096, lines=False, empty=False)
            # A file written on another system is still valid here; opening it will say that it is missing.
            absolute = PurePosixPath(text).is_absolute() or PureWindowsPath(text).is_absolute()
            if not absolute and not _NAME.match(text):
                raise ValueRangeError(
                    name, f"expected the name of a packaged one or an absolute path, not {describe(value)}"
                )
        set_numbers(self, PARAMETERS, "rotation_deg", "exposure_ev", "turntable_deg_s")
        check_choices(
            self,
            tone_curve=TONE_CURVES,
            background=BACKGROUNDS,
            environment_layout=ENVIRONMENT_LAYOUTS,
            fresnel=FRESNEL_MODES,
            look_up=LOOK_UPS,
            mark_style=MARK_STYLES,
            exposure_mode=EXPOSURE_MODES,
            lamp_shading=LAMP_SHADINGS,
            glare=GLARE_MODES,
        )
        check_flags(self, "clipping_marks", "gamut_marks")
        colour = check_numbers(self.background_colour, "background_colour", _ENCODED, 3)
        object.__setattr__(self, "background_colour", colour)
        object.__setattr__(self, "lamps", check_items(self.lamps, "lamps", Lamp, MOST_LAMPS))


PARTS: Mapping[str, type] = {
    "camera": Camera,
    "light_colour": LightColour,
    "sparkle": Sparkle,
    "surface_look": SurfaceLook,
    "relief": Relief,
    "two_tone": TwoTone,
    "compare": Compare,
    "lens": Lens,
}
"""The fields of a view that are values with fields of their own."""

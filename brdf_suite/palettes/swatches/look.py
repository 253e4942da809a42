"""How the pictures of a palette look, the key by which one is known again, and those of colours without a form.

No OpenGL and no solver are imported here: a program asks for keys before it draws anything.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from typing import Literal, TypeAlias, cast, get_args

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, lab_to_working, srgb_encode
from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.appearance.light.matrix import light_matrix
from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import PARAMETERS, Paint
from brdf_suite.documents.parameter import check_choice
from brdf_suite.documents.store import AnyPaint
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import ILLUMINANTS, LightColour, SurfaceLook
from brdf_suite.errors import ValueRangeError
from brdf_suite.files.bounded_reading import file_stamp
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.protocol import Reflectance

Form = Literal["sphere", "panel", "speed_form", "flop_strip", "chips"]
FORMS: tuple[str, ...] = get_args(Form)
RENDERED: tuple[str, ...] = ("sphere", "panel", "speed_form")
"""The forms that the renderer draws; the others are the colours themselves."""

SMALLEST, LARGEST = 16, 512
MOST_ANGLES = 16
GROUND = (0.46, 0.46, 0.46)
"""The mid grey against which paint is judged, L* 50, encoded sRGB."""

Content: TypeAlias = Paint | CookTorrancePaint | FactoredPaint | FlatColour

_DRAWING_VERSION = 2
"""To be raised where the fit, the ramp or the flat forms give other pictures; shaders are marked by themselves."""
_SHADERS = Path(__file__).resolve().parents[2] / "realtime" / "shaders"
_UNSEEN = frozenset({"name", "notes", "source", "texture"})


@dataclass(frozen=True)
class SwatchLook:
    """What every picture of a palette shows.

    Attributes
    ----------
    form
        ``sphere``, ``panel`` and ``speed_form`` are drawn by the renderer, as is a mesh by the absolute path of its
        file. ``flop_strip`` runs from 15° at the left to 110° at the right, light at 45°; ``chips`` has one band for
        each of ``angles_deg``, from the left.
    environment
        The light, by packaged name or absolute path of a file.
    size
        Width and height, pixels, 16 to 512.
    angles_deg
        Aspecular angles of the chips.
    light_colour
        What the light's white is taken for; it tints every form.
    """

    form: str = "sphere"
    environment: str = "booth"
    size: int = 96
    angles_deg: tuple[float, ...] = (15.0, 45.0, 110.0)
    light_colour: LightColour = field(default_factory=LightColour)

    def __post_init__(self) -> None:
        if not self.is_mesh:
            check_choice(self.form, "form", FORMS)
        if isinstance(self.size, bool) or not isinstance(self.size, int):
            raise ValueRangeError("size", f"a whole number of pixels is wanted, not {self.size!r}")
        if not SMALLEST <= self.size <= LARGEST:
            raise ValueRangeError("size", f"{SMALLEST} to {LARGEST} pixels are drawn, not {self.size}")
        if not 1 <= len(self.angles_deg) <= MOST_ANGLES:
            raise ValueRangeError("angles_deg", f"1 to {MOST_ANGLES} angles are wanted")
        angles = tuple(
            PARAMETERS["aspecular_deg"].check(angle, f"angles_deg[{index}]")
            for index, angle in enumerate(self.angles_deg)
        )
        if any(abs(45.0 - angle) >= 90.0 for angle in angles):
            raise ValueRangeError("angles_deg", "with the light at 45°, angles lie above -45° and below 135°")
        object.__setattr__(self, "angles_deg", angles)
        self.view()

    @property
    def is_mesh(self) -> bool:
        """Whether the form is the mesh of a file."""
        return Path(self.form).is_absolute()

    @property
    def is_rendered(self) -> bool:
        """Whether the renderer draws this form."""
        return self.is_mesh or self.form in RENDERED

    def view(self) -> View:
        """Return the view that is drawn. Its exposure is locked: a darker paint shall look darker."""
        return View(
            environment=self.environment,
            surface=self.form if self.is_rendered else "sphere",
            # A sphere occludes nothing of itself; baking it would take a third of the time of the first picture, and
            # that of a mesh any time.
            surface_look=SurfaceLook(occlusion=self.form != "sphere" and not self.is_mesh),
            background="colour",
            background_colour=GROUND,
            light_colour=self.light_colour,
        )

    def to_json(self) -> dict[str, object]:
        """Return it as plain values; :meth:`from_json` is the inverse."""
        return {
            "form": self.form,
            "environment": self.environment,
            "size": self.size,
            "angles_deg": list(self.angles_deg),
            "illuminant": self.light_colour.illuminant,
            "adapted": self.light_colour.adapted,
        }

    @staticmethod
    def from_json(value: Mapping[str, object]) -> SwatchLook:
        """Return the look in plain values; :class:`ValueRangeError` names what is wrong."""
        angles = value.get("angles_deg", (15.0, 45.0, 110.0))
        form, environment, size = value.get("form"), value.get("environment"), value.get("size")
        illuminant = check_choice(value.get("illuminant", "environment"), "illuminant", ILLUMINANTS)
        if not isinstance(angles, (list, tuple)) or not isinstance(size, int):
            raise ValueRangeError("look", "a size and a list of angles are wanted")
        light = LightColour(illuminant, value.get("adapted", True) is True)  # type: ignore[arg-type]  # checked
        return SwatchLook(form, environment, size, tuple(angles), light)  # type: ignore[arg-type]  # it checks them

    @cached_property
    def _mark(self) -> bytes:
        """What of the look a picture depends on; a file of light counts as it was when the look was made."""
        parts: list[object] = [self.form, self.size, self.light_colour.illuminant, self.light_colour.adapted]
        if self.is_rendered:
            parts += [self.environment, file_stamp(self.environment), _shaders()]
            parts += [file_stamp(self.form)] if self.is_mesh else []
        elif self.form == "chips":
            parts.append(self.angles_deg)
        return repr((_DRAWING_VERSION, *parts)).encode()


def swatch_key(content: Content, look: SwatchLook) -> str:
    """Return the same 64 digits for the same picture: of all that is seen of a paint, and not of its name."""
    paint = to_paint(content)
    seen = [(name, getattr(paint, name)) for name in paint.__dataclass_fields__ if name not in _UNSEEN]
    return hashlib.sha256(look._mark + repr((type(paint).__name__, seen)).encode()).hexdigest()


@cache
def _shaders() -> str:
    """A mark of the shaders: with others, pictures are others."""
    found = hashlib.sha256()
    for path in sorted(_SHADERS.glob("*.glsl")):
        found.update(path.name.encode() + path.read_bytes())
    return found.hexdigest()


LIGHT_DEG = 45.0
NEAREST_DEG, FARTHEST_DEG = 15.0, 110.0
_SAME_DEG = 0.5


def flat_picture(paint: AnyPaint, look: SwatchLook) -> NDArray[np.uint8]:
    """Return the picture (size, size, 3) of the look's form, ``chips`` or ``flop_strip``; colours are clipped to sRGB.

    A chip has the paint's reading at its angle, and where it has none what its reflectance gives.

    Raises :class:`UnreachableError`: a colour is wanted that only the reflectance knows, and no such paint can be.
    """
    if look.form == "chips":
        bands = _chips(paint, look.angles_deg)
        which = np.arange(look.size) * len(bands) // look.size
        row = bands[which]
    else:
        row = colours_at(
            build_reflectance(paint), np.linspace(NEAREST_DEG, FARTHEST_DEG, look.size), LIGHT_DEG
        )
    row = row @ light_matrix(look.light_colour.illuminant, look.light_colour.adapted).T
    encoded = srgb_encode(np.clip(row @ WORKING_TO_SRGB.T, 0.0, 1.0))
    codes = np.rint(255.0 * encoded).astype(np.uint8)
    return np.ascontiguousarray(np.broadcast_to(codes, (look.size, *codes.shape)))


def colours_at(
    reflectance: Reflectance, aspecular_deg: Floats, illumination_deg: float = LIGHT_DEG
) -> Floats:
    """Return reflectance factors π·f_r (n, 3), working space, at aspecular angles (n,) in the plane of the light."""
    light = illumination(np.full(len(aspecular_deg), illumination_deg))
    return np.asarray(np.pi * reflectance.eval(light, aspecular_view(illumination_deg, aspecular_deg)))


def _chips(paint: AnyPaint, angles_deg: tuple[float, ...]) -> Floats:
    """Reflectance factors (n, 3) at the angles."""
    measured = measured_labs(paint, angles_deg)
    found = np.zeros((len(angles_deg), 3))
    missing = [index for index, lab in enumerate(measured) if lab is None]
    known = [index for index, lab in enumerate(measured) if lab is not None]
    if known:
        found[known] = lab_to_working(np.array([measured[index] for index in known]))
    if missing:
        angles = np.array([angles_deg[index] for index in missing])
        found[missing] = colours_at(cast(Reflectance, build_reflectance(paint)), angles)
    return found


def measured_labs(paint: AnyPaint, angles_deg: tuple[float, ...]) -> list[tuple[float, float, float] | None]:
    """Return the paint's own L*a*b* at each aspecular angle with the light at 45°, None where it was not read."""
    found: list[tuple[float, float, float] | None] = []
    readings = paint.measurements if isinstance(paint, Paint) else ()
    for angle in angles_deg:
        near = [
            (abs(m.aspecular_deg - angle), m.lab)
            for m in readings
            if abs(m.illumination_deg - LIGHT_DEG) <= _SAME_DEG and abs(m.aspecular_deg - angle) <= _SAME_DEG
        ]
        found.append(min(near)[1] if near else None)
    return found

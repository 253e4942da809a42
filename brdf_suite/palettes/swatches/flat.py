"""Pictures of a paint without a form: bands of its colours, and the strip of its flop."""

from __future__ import annotations

from typing import cast

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, lab_to_working, srgb_encode
from brdf_suite.appearance.light.matrix import light_matrix
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.palettes.swatches.look import SwatchLook
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.protocol import Reflectance

LIGHT_DEG = 45.0
NEAREST_DEG, FARTHEST_DEG = 15.0, 110.0
_SAME_DEG = 0.5


def flat_picture(paint: AnyPaint, look: SwatchLook) -> NDArray[np.uint8]:
    """Return the picture (size, size, 3) of the look's form, ``chips`` or ``flop_strip``; colours are clipped to sRGB.

    A chip has the paint's reading at its angle, and where it has none what its reflectance gives.

    Raises
    ------
    UnreachableError
        A colour is wanted that only the reflectance knows, and no such paint can be.
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

"""Colour scale for images of colour differences.

Lightness L* rises evenly from 6 to 94 along the scale, so it is read alike without colour vision and in print; the
hue runs from blue through red to yellow, at most of the chroma that sRGB has there.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from brdf_suite.appearance.colour.colorimetry import in_srgb_gamut, lab_to_working, working_to_display
from brdf_suite.appearance.colour.spaces import lch_to_lab
from brdf_suite.arrays import Floats

STEPS = 64
"""The scale is piecewise linear between 65 colours, here and on the GPU."""

_LIGHTNESS = (6.0, 94.0)
_HUES_DEG = (285.0, 320.0, 360.0, 410.0, 455.0)
_MOST_CHROMA = 70.0
_SMOOTH = 9


@lru_cache(maxsize=1)
def scale_table() -> Floats:
    """Return (65, 3) encoded sRGB, 0…1, from no difference to the end of the scale; not to be written to."""
    along = np.linspace(0.0, 1.0, STEPS + 1)
    lightness = _LIGHTNESS[0] + (_LIGHTNESS[1] - _LIGHTNESS[0]) * along
    hue = np.interp(along, np.linspace(0.0, 1.0, len(_HUES_DEG)), _HUES_DEG)
    low, high = np.zeros(STEPS + 1), np.full(STEPS + 1, _MOST_CHROMA)
    # The largest chroma inside the gamut, by halving: 70 / 2^24 is far below a code of 8 bits.
    for _ in range(24):
        middle = 0.5 * (low + high)
        inside = in_srgb_gamut(lch_to_lab(np.stack((lightness, middle, hue), -1)))
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    # Smoothed, since the gamut's edge has corners that the eye would take for steps; never outside it.
    padded = np.pad(low, _SMOOTH // 2, mode="edge")
    smooth = np.convolve(padded, np.full(_SMOOTH, 1.0 / _SMOOTH), "valid")
    lab = lch_to_lab(np.stack((lightness, np.minimum(smooth, low), hue), -1))
    table = np.clip(working_to_display(lab_to_working(lab)), 0.0, 1.0)
    table.flags.writeable = False
    return np.asarray(table)

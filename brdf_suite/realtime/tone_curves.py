"""The display side in numpy: the tone curves, the same functions as the shaders'.

Used for pictures that are made outside the renderer (differences, thumbnails, the reference picture), so that
both are seen through the same curve; a test holds the two together on a grid.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.appearance.colorimetry import WORKING_TO_SRGB, srgb_encode
from brdf_suite.errors import ValueRangeError

Floats = NDArray[np.float64]

TONE_CURVE_NUMBERS = {"neutral": 0, "characteristic": 1, "linear": 2, "faithful": 3}
"""The numbers that tone_curve.glsl knows the curves by."""


def tone_neutral(c: ArrayLike) -> Floats:
    """Khronos PBR Neutral of exposed radiance (..., 3) ≥ 0; 0 to 1 out."""
    c = np.asarray(c, np.float64)
    x = c.min(axis=-1, keepdims=True)
    return _shoulder(c - np.where(x <= 0.08, x - x * x / 0.16, 0.04), 0.76)


def tone_faithful(c: ArrayLike) -> Floats:
    """One to one up to 0.8, then Khronos's shoulder, of exposed radiance (..., 3) ≥ 0; 0 to 1 out."""
    return _shoulder(np.asarray(c, np.float64), 0.8)


def _shoulder(c: Floats, start: float) -> Floats:
    peak = c.max(axis=-1, keepdims=True)
    bright = np.maximum(peak, start)
    room = 1.0 - start
    compressed = 1.0 - room**2 / (bright + room - start)
    g = 1.0 / (0.15 * (bright - compressed) + 1.0)
    return np.where(peak > start, compressed * (1.0 - g) + c * (compressed / bright) * g, c)


def tone_characteristic(c: ArrayLike) -> Floats:
    """A film's sigmoid in log exposure, for each channel: 0.18 stays 0.18 and contrast there is 1."""
    slope = 1.0 / 0.82
    k = 0.18 * (0.82 / 0.18) ** (1.0 / slope)
    x = (np.maximum(np.asarray(c, np.float64), 0.0) / k) ** slope
    return np.asarray(x / (1.0 + x))


def tone_curve(c: ArrayLike, kind: str) -> Floats:
    """Apply the curve of this name in :data:`TONE_CURVE_NUMBERS` to exposed radiance (..., 3)."""
    c = np.minimum(np.asarray(c, np.float64), 1e6)
    if kind == "faithful":
        return tone_faithful(c)
    if kind == "neutral":
        return tone_neutral(c)
    if kind == "characteristic":
        return tone_characteristic(c)
    if kind == "linear":
        return c
    raise ValueRangeError("tone_curve", f"one of {', '.join(TONE_CURVE_NUMBERS)} is wanted, not {kind!r}")


def display_light(radiance: ArrayLike, exposure_ev: float, kind: str) -> Floats:
    """Return linear sRGB (..., 3), clipped to 0…1, of working-space radiance (..., 3)."""
    toned = tone_curve(np.asarray(radiance, np.float64) * 2.0**exposure_ev, kind)
    return np.asarray(np.clip(toned @ WORKING_TO_SRGB.T, 0.0, 1.0))


def to_display(radiance: ArrayLike, exposure_ev: float = 0.0, kind: str = "faithful") -> NDArray[Any]:
    """Return sRGB codes (..., 3) uint8, rounded without dither.

    >>> to_display([0.0, 0.0, 0.0]).tolist(), to_display([1.0, 1.0, 1.0], kind="linear").tolist()
    ([0, 0, 0], [255, 255, 255])
    """
    encoded = srgb_encode(display_light(radiance, exposure_ev, kind))
    return np.asarray(np.rint(encoded * 255.0), np.uint8)

"""The display side in numpy: tone curves, primaries, transfer curve. The same functions as the shaders'.

Used for pictures that are made outside the renderer (differences, thumbnails, the reference picture), so that
both are seen through the same curve; a test holds the two together on a grid.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.errors import ValueRangeError

Floats = NDArray[np.float64]

TONE_CURVE_NUMBERS = {"neutral": 0, "characteristic": 1, "linear": 2}
"""The numbers that tone_curve.glsl knows the curves by."""

_D65 = (0.3127, 0.3290)
_REC2020 = ((0.708, 0.292), (0.170, 0.797), (0.131, 0.046))
_SRGB = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))


def _rgb_to_xyz(primaries: tuple[tuple[float, float], ...]) -> Floats:
    def xyz(chromaticity: tuple[float, float]) -> list[float]:
        x, y = chromaticity
        return [x / y, 1.0, (1.0 - x - y) / y]

    columns = np.array([xyz(p) for p in primaries]).T
    return np.asarray(columns * np.linalg.solve(columns, np.array(xyz(_D65))), np.float64)


WORKING_TO_SRGB: Floats = np.asarray(np.linalg.solve(_rgb_to_xyz(_SRGB), _rgb_to_xyz(_REC2020)), np.float64)
"""(3, 3): linear Rec. 2020 to linear sRGB, both D65 (ITU-R BT.2020, IEC 61966-2-1)."""


def tone_neutral(c: ArrayLike) -> Floats:
    """Khronos PBR Neutral of exposed radiance (..., 3) ≥ 0; 0 to 1 out."""
    c = np.asarray(c, np.float64)
    x = c.min(axis=-1, keepdims=True)
    c = c - np.where(x <= 0.08, x - x * x / 0.16, 0.04)
    peak = c.max(axis=-1, keepdims=True)
    bright = np.maximum(peak, 0.76)
    compressed = 1.0 - 0.0576 / (bright - 0.52)
    g = 1.0 / (0.15 * (bright - compressed) + 1.0)
    return np.where(peak > 0.76, compressed * (1.0 - g) + c * (compressed / bright) * g, c)


def tone_characteristic(c: ArrayLike) -> Floats:
    """A film's sigmoid in log exposure, for each channel: 0.18 stays 0.18 and contrast there is 1."""
    slope = 1.0 / 0.82
    k = 0.18 * (0.82 / 0.18) ** (1.0 / slope)
    x = (np.maximum(np.asarray(c, np.float64), 0.0) / k) ** slope
    return np.asarray(x / (1.0 + x))


def tone_curve(c: ArrayLike, kind: str) -> Floats:
    """Apply the curve named ``neutral``, ``characteristic`` or ``linear`` to exposed radiance (..., 3)."""
    c = np.minimum(np.asarray(c, np.float64), 1e6)
    if kind == "neutral":
        return tone_neutral(c)
    if kind == "characteristic":
        return tone_characteristic(c)
    if kind == "linear":
        return c
    raise ValueRangeError("tone_curve", f"neutral, characteristic or linear is wanted, not {kind!r}")


def srgb_encode(linear: ArrayLike) -> Floats:
    """Transfer curve of sRGB for linear values 0 to 1."""
    c = np.asarray(linear, np.float64)
    return np.where(c <= 0.0031308, 12.92 * c, 1.055 * np.maximum(c, 0.0) ** (1 / 2.4) - 0.055)


def display_light(radiance: ArrayLike, exposure_ev: float, kind: str) -> Floats:
    """Return linear sRGB (..., 3), clipped to 0…1, of working-space radiance (..., 3)."""
    toned = tone_curve(np.asarray(radiance, np.float64) * 2.0**exposure_ev, kind)
    return np.asarray(np.clip(toned @ WORKING_TO_SRGB.T, 0.0, 1.0))


def to_display(radiance: ArrayLike, exposure_ev: float = 0.0, kind: str = "neutral") -> NDArray[Any]:
    """Return sRGB codes (..., 3) uint8, rounded without dither.

    >>> to_display([0.0, 0.0, 0.0]).tolist(), to_display([1.0, 1.0, 1.0], kind="linear").tolist()
    ([0, 0, 0], [255, 255, 255])
    """
    encoded = srgb_encode(display_light(radiance, exposure_ev, kind))
    return np.asarray(np.rint(encoded * 255.0), np.uint8)

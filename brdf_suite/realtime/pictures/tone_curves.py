"""Tone curves in numpy, identical to the shaders'.

Used for pictures that are made outside the renderer (differences, thumbnails, the reference picture), so that
both are seen through the same curve; a test holds the two together on a grid.

Sources: Khronos PBR Neutral, the specification of that name (2024). ACES, the fit of Stephen Hill in MJP's
BakingLab, with its matrices derived here. AgX, Troy Sobotka's sigmoid in closed form with the primaries that
Blender and Filament use in Rec. 2020.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.appearance.colour.colorimetry import (
    WORKING_TO_SRGB,
    WORKING_TO_XYZ,
    adaptation,
    primaries_to_xyz,
    srgb_encode,
)
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

TONE_CURVE_NUMBERS = {
    "neutral": 0,
    "characteristic": 1,
    "linear": 2,
    "faithful": 3,
    "aces": 4,
    "agx": 5,
}
"""The numbers that tone_curve.glsl knows the curves by."""

_AP1_PRIMARIES = ((0.713, 0.293), (0.165, 0.830), (0.128, 0.044))
_ACES_WHITE = (0.32168, 0.33767)
_AGX_INSET = np.array(
    [
        [0.856627153315983, 0.0951212405381588, 0.0482516061458583],
        [0.137318972929847, 0.761241990602591, 0.101439036467562],
        [0.11189821299995, 0.0767994186031903, 0.811302368396859],
    ]
)
_AGX_OUTSET = np.array(
    [
        [1.1271005818144368, -0.11060664309660323, -0.016493938717834573],
        [-0.1413297634984383, 1.157823702216272, -0.016493938717834257],
        [-0.14132976349843826, -0.11060664309660294, 1.2519364065950405],
    ]
)
_AGX_STOPS_BELOW, _AGX_STOPS_ABOVE = 10.0, 6.5


def aces_matrices() -> tuple[Floats, Floats]:
    """Return the matrices (3, 3) from the working space into AP1 at 96 % saturation, and back at 93 %.

    The whites, D65 and that of ACES, are adapted by Bradford's transform, as in the ACES reference code. With Rec.
    709 in the place of the working space they are Hill's published ones.
    """
    to_xyz = primaries_to_xyz(_AP1_PRIMARIES, _ACES_WHITE)
    d65, d60 = WORKING_TO_XYZ.sum(axis=1), to_xyz.sum(axis=1)

    def saturation(share: float) -> Floats:
        return np.asarray((1.0 - share) * np.outer(np.ones(3), to_xyz[1]) + share * np.eye(3))

    into = saturation(0.96) @ np.linalg.solve(to_xyz, adaptation(d65, d60, "Bradford") @ WORKING_TO_XYZ)
    back = np.linalg.solve(WORKING_TO_XYZ, adaptation(d60, d65, "Bradford") @ to_xyz) @ saturation(0.93)
    return into, back


_ACES_INTO, _ACES_BACK = aces_matrices()


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


def tone_aces(c: ArrayLike) -> Floats:
    """ACES's reference and output transforms as Hill fitted them: 0.18 becomes 0.106, 25.7 white.

    Beyond that the fit goes on to 1.017; a saturated colour can pass 1 in a channel, or fall below 0.
    """
    v = np.asarray(c, np.float64) @ _ACES_INTO.T
    fitted = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.432951) + 0.238081)
    return np.asarray(np.maximum(fitted, 0.0) @ _ACES_BACK.T)


def tone_agx(c: ArrayLike) -> Floats:
    """AgX without a look: 10 stops below 0.18 are black and 6.5 above are white, 0.18 becomes 0.22; 0 to 1 out."""
    drawn_in = np.maximum(np.asarray(c, np.float64) @ _AGX_INSET.T, 1e-10)
    stops = _AGX_STOPS_BELOW + _AGX_STOPS_ABOVE
    x = np.clip((np.log2(drawn_in / 0.18) + _AGX_STOPS_BELOW) / stops, 0.0, 1.0)
    return np.asarray(np.clip(agx_sigmoid(x) @ _AGX_OUTSET.T, 0.0, 1.0) ** 2.2)  # the outset leaves 0 to 1


def agx_sigmoid(x: ArrayLike) -> Floats:
    """AgX's curve from 0…1, the place within its stops, to 0…1: the slope is 2 at middle grey, which goes to 0.5.

    Each side of the pivot is the hyperbola u / (1 + u^p)^(1/p), which leaves 0 with the slope 1 and goes to 1, scaled
    such that it ends at black or at white: where ``a`` is the slope times the way to the end and ``h`` the height to
    gain, the scale is s = a / ((a / h)^p - 1)^(1/p).
    """
    pivot = _AGX_STOPS_BELOW / (_AGX_STOPS_BELOW + _AGX_STOPS_ABOVE)
    x = np.asarray(x, np.float64)

    def branch(way: Floats, longest: float, power: float) -> Floats:
        a = 2.0 * longest
        scale = a / ((a / 0.5) ** power - 1.0) ** (1.0 / power)
        u = 2.0 * way / scale
        return np.asarray(scale * u / (1.0 + u**power) ** (1.0 / power))

    shoulder = branch(np.maximum(x - pivot, 0.0), 1.0 - pivot, 3.25)
    return np.asarray(0.5 + shoulder - branch(np.maximum(pivot - x, 0.0), pivot, 3.0))


def tone_curve(c: ArrayLike, kind: str) -> Floats:
    """Apply the curve of this name in :data:`TONE_CURVE_NUMBERS` to exposed radiance (..., 3)."""
    c = np.minimum(np.asarray(c, np.float64), 1e6)
    if kind not in TONE_CURVE_NUMBERS:
        raise ValueRangeError("tone_curve", f"expected one of {', '.join(TONE_CURVE_NUMBERS)}, not {kind!r}")
    curves = {
        "neutral": tone_neutral,
        "characteristic": tone_characteristic,
        "faithful": tone_faithful,
        "aces": tone_aces,
        "agx": tone_agx,
    }
    return c if kind == "linear" else curves[kind](c)


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

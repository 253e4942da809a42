"""Conversions between L*a*b*, the working space and screen codes.

The road: L*a*b* (D65, 10° observer) -> XYZ10 -> CAT16 to the D65 white of the 2° observer -> the working
space, linear RGB with the primaries of Rec. 2020 and D65 white. A reflectance factor ρ of 1 in every channel
is the perfect diffuser, L* = 100. Metallic paints pass 1, saturated ones may leave the space (a channel below
0): nothing is clipped here.

All colour arrays are (..., 3). XYZ is on the scale where the white's Y is 100.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

# A negative channel of a smaller share of the largest one is rounding, not a colour.
_ROUNDING = 1e-9

WHITE_D65_10 = np.array([94.811, 100.0, 107.304])
"""White of D65 and the 10° observer, XYZ (CIE 15, as the paint trade's instruments use it)."""

WHITE_XY = (0.3127, 0.3290)
"""Chromaticity of D65 and the 2° observer, as Rec. 709 and Rec. 2020 state it."""

REC2020_PRIMARIES = ((0.708, 0.292), (0.170, 0.797), (0.131, 0.046))
REC709_PRIMARIES = ((0.640, 0.330), (0.300, 0.600), (0.150, 0.060))
"""Chromaticities x, y of the red, green and blue primaries (ITU-R BT.2020, BT.709)."""

CAT16 = np.array(
    [
        [0.401288, 0.650173, -0.051461],
        [-0.250268, 1.204414, 0.045854],
        [-0.002079, 0.048952, 0.953127],
    ]
)
"""XYZ to the cone-like responses of CAT16 (Li et al. 2017, Comprehensive color solutions)."""

BRADFORD = np.array(
    [
        [0.8951, 0.2664, -0.1614],
        [-0.7502, 1.7135, 0.0367],
        [0.0389, -0.0685, 1.0296],
    ]
)
"""XYZ to the cone-like responses of the linearised Bradford transform (ICC profiles use it)."""

AdaptationTransform = Literal["CAT16", "Bradford"]
_TRANSFORMS: dict[str, Floats] = {"CAT16": CAT16, "Bradford": BRADFORD}


def primaries_to_xyz(
    primaries: tuple[tuple[float, float], ...], white_xy: tuple[float, float] = WHITE_XY
) -> Floats:
    """Return the matrix (3, 3) from linear RGB, 0…1, to XYZ with the white's Y = 1.

    Each primary has the direction (x/y, 1, (1-x-y)/y); their sizes are such that RGB = (1, 1, 1) gives the
    white (SMPTE RP 177).
    """
    directions = np.array([[x / y, 1.0, (1.0 - x - y) / y] for x, y in primaries]).T
    x, y = white_xy
    white = np.array([x / y, 1.0, (1.0 - x - y) / y])
    return np.asarray(directions * np.linalg.solve(directions, white), np.float64)


def adaptation(
    white_from: npt.ArrayLike, white_to: npt.ArrayLike, transform: AdaptationTransform = "CAT16"
) -> Floats:
    """Return the matrix (3, 3) of a complete adaptation between two whites, XYZ of any one scale.

    ``transform`` is CAT16 (the suite's own choice) or Bradford.
    """
    if transform not in _TRANSFORMS:
        raise ValueRangeError("transform", f"expected one of {', '.join(_TRANSFORMS)}, not {transform!r}")
    cones = _TRANSFORMS[transform]
    gains = (cones @ np.asarray(white_to, float)) / (cones @ np.asarray(white_from, float))
    return np.asarray(np.linalg.inv(cones) @ (gains[:, None] * cones), np.float64)


def rgb_to_working(primaries: tuple[tuple[float, float], ...], white_xy: tuple[float, float]) -> Floats:
    """Return the matrix (3, 3) from linear RGB of any primaries and white to the working space.

    Where the white is not D65 it is adapted by CAT16, so that RGB = (1, 1, 1) is (1, 1, 1) there too.
    """
    to_xyz = primaries_to_xyz(primaries, white_xy)
    adapted = adaptation(to_xyz.sum(axis=1), WORKING_TO_XYZ.sum(axis=1)) @ to_xyz
    return np.asarray(np.linalg.solve(WORKING_TO_XYZ, adapted), np.float64)


WORKING_TO_XYZ = primaries_to_xyz(REC2020_PRIMARIES)
"""Working space to XYZ of the 2° observer, white's Y = 1."""

WORKING_TO_SRGB: Floats = np.asarray(
    np.linalg.solve(primaries_to_xyz(REC709_PRIMARIES), WORKING_TO_XYZ), np.float64
)
"""Working space to linear RGB with the primaries of Rec. 709 (the same white: no adaptation)."""

REC709_TO_WORKING: Floats = np.asarray(np.linalg.inv(WORKING_TO_SRGB), np.float64)
"""Linear RGB with the primaries of Rec. 709 to the working space; for environments and tables."""

LUMINANCE: Floats = WORKING_TO_XYZ[1].copy()
"""Weights (3,) of the working space's channels in Y; they sum to 1."""

_WHITE_XYZ = WORKING_TO_XYZ.sum(axis=1)
_FROM_LAB_WHITE: Floats = (
    np.linalg.inv(WORKING_TO_XYZ) @ adaptation(WHITE_D65_10, 100.0 * _WHITE_XYZ) / 100.0 * WHITE_D65_10
)
RELATIVE_TO_WORKING: Floats = np.ascontiguousarray(_FROM_LAB_WHITE.T)
"""From (X/Xn, Y/Yn, Z/Zn) of the 10° white straight to the working space; transposed for row vectors."""
_WORKING_TO_RELATIVE: Floats = np.ascontiguousarray(np.linalg.inv(_FROM_LAB_WHITE).T)

# CIE 15: the cube root is replaced by a line below (6/29)³.
_EDGE = 6.0 / 29.0
_SLOPE = 3.0 * _EDGE * _EDGE
_OFFSET = 4.0 / 29.0


def _lab_to_relative(lab: npt.ArrayLike) -> Floats:
    lab = np.asarray(lab, float)
    f = np.empty(lab.shape)
    f[..., 1] = (lab[..., 0] + 16.0) / 116.0
    f[..., 0] = f[..., 1] + lab[..., 1] / 500.0
    f[..., 2] = f[..., 1] - lab[..., 2] / 200.0
    return np.where(f > _EDGE, f * f * f, _SLOPE * (f - _OFFSET))


def _relative_to_lab(relative: Floats) -> Floats:
    f = np.where(relative > _EDGE**3, np.cbrt(relative), relative / _SLOPE + _OFFSET)
    lab = np.empty(f.shape)
    lab[..., 0] = 116.0 * f[..., 1] - 16.0
    lab[..., 1] = 500.0 * (f[..., 0] - f[..., 1])
    lab[..., 2] = 200.0 * (f[..., 1] - f[..., 2])
    return lab


def lab_to_xyz(lab: npt.ArrayLike, white: npt.ArrayLike = WHITE_D65_10) -> Floats:
    """Return XYZ (..., 3), white's Y = 100, of CIE 1976 L*a*b* (CIE 15, section 8.2.1).

    >>> lab_to_xyz([100.0, 0.0, 0.0]).round(3).tolist()
    [94.811, 100.0, 107.304]
    """
    xyz: Floats = _lab_to_relative(lab) * np.asarray(white, float)
    return xyz


def xyz_to_lab(xyz: npt.ArrayLike, white: npt.ArrayLike = WHITE_D65_10) -> Floats:
    """Return CIE 1976 L*a*b* (..., 3) of XYZ on the scale where the white's Y is 100."""
    return _relative_to_lab(np.asarray(xyz, float) / np.asarray(white, float))


def lab_to_working(lab: npt.ArrayLike) -> Floats:
    """Return the reflectance factor ρ (..., 3), working space, of L*a*b* under D65 and the 10° observer.

    A channel below 0 says that the colour lies outside the working space.

    >>> lab_to_working([100.0, 0.0, 0.0]).round(12).tolist()
    [1.0, 1.0, 1.0]
    """
    rho: Floats = _lab_to_relative(lab) @ RELATIVE_TO_WORKING
    return rho


def working_to_lab(rho: npt.ArrayLike) -> Floats:
    """Return L*a*b* (..., 3), D65 and 10° observer, of a reflectance factor in the working space."""
    return _relative_to_lab(np.asarray(rho, float) @ _WORKING_TO_RELATIVE)


def srgb_encode(linear: npt.ArrayLike) -> Floats:
    """Return the sRGB transfer curve of linear values (IEC 61966-2-1); odd, so negatives stay negative."""
    linear = np.asarray(linear, float)
    size = np.abs(linear)
    curved = 1.055 * np.power(size, 1.0 / 2.4) - 0.055
    encoded: Floats = np.copysign(np.where(size <= 0.0031308, 12.92 * size, curved), linear)
    return encoded


def srgb_decode(encoded: npt.ArrayLike) -> Floats:
    """Return the linear values of sRGB-encoded ones; the inverse of :func:`srgb_encode`."""
    encoded = np.asarray(encoded, float)
    size = np.abs(encoded)
    curved = np.power((size + 0.055) / 1.055, 2.4)
    linear: Floats = np.copysign(np.where(size <= 0.04045, size / 12.92, curved), encoded)
    return linear


def working_to_display(rho: npt.ArrayLike) -> Floats:
    """Return sRGB-encoded values (..., 3) of working-space ones; not clipped."""
    return srgb_encode(np.asarray(rho, float) @ WORKING_TO_SRGB.T)


def display_to_lab(encoded: npt.ArrayLike) -> Floats:
    """Return L*a*b* (..., 3), D65 and 10° observer, of sRGB-encoded values 0…1; for colour pickers."""
    return working_to_lab(srgb_decode(encoded) @ REC709_TO_WORKING.T)


def in_srgb_gamut(lab: npt.ArrayLike, tolerance: float = 1e-6) -> npt.NDArray[np.bool_]:
    """Return whether (...) an sRGB screen can show L*a*b*; ``tolerance`` in linear light."""
    linear = lab_to_working(lab) @ WORKING_TO_SRGB.T
    return np.asarray(np.all((linear >= -tolerance) & (linear <= 1.0 + tolerance), axis=-1))


def clipping_notice(f_r: npt.ArrayLike, where: str = "") -> tuple[str, ...]:
    """Return the notice about reflectances (n, 3), 1/sr, whose negative working-space channels become 0, or nothing.

    It counts them and gives the largest difference that this makes to a colour. ``where`` says which they are, for
    the user.
    """
    given = np.asarray(f_r, np.float64)
    outside = given[given.min(axis=1) < -_ROUNDING * np.abs(given).max(axis=1)]
    if not len(outside):
        return ()
    lab, clipped = (working_to_lab(np.pi * values) for values in (outside, np.maximum(outside, 0.0)))
    return (
        f"{len(outside):,} of {len(given):,} colours{where} lie outside the working space (Rec. 2020); their negative "
        f"channel became 0, a change of at most ΔE00 {delta_e_2000(lab, clipped).max():.2f}.",
    )

"""The matrix from a file's RGB primaries to the working space (linear Rec. 2020, D65)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import (
    REC709_PRIMARIES,
    REC2020_PRIMARIES,
    WHITE_XY,
    WORKING_TO_XYZ,
    adaptation,
    primaries_to_xyz,
)

Chromaticities = tuple[float, float, float, float, float, float, float, float]
"""CIE x, y of red, green, blue and white, in this order."""


def _flat(primaries: tuple[tuple[float, float], ...]) -> Chromaticities:
    """Return three primaries and the D65 white as eight numbers."""
    (rx, ry), (gx, gy), (bx, by) = primaries
    return rx, ry, gx, gy, bx, by, *WHITE_XY


REC709: Chromaticities = _flat(REC709_PRIMARIES)
REC2020: Chromaticities = _flat(REC2020_PRIMARIES)


def rgb_to_xyz(chromaticities: Chromaticities) -> NDArray[np.float64]:
    """Return the (3, 3) matrix from linear RGB to XYZ, where RGB (1, 1, 1) is white with Y = 1.

    Raises :class:`ValueError`: the primaries are not finite, lie on a line, or do not enclose the white point.
    """
    values = np.asarray(chromaticities, dtype=np.float64).reshape(4, 2)
    if not np.isfinite(values).all() or (values[:, 1] < 1e-6).any():
        raise ValueError("chromaticities must be finite with y above 0")
    (r, g, b, white) = ((float(x), float(y)) for x, y in values)
    directions = np.array([[x / y, 1.0, (1.0 - x - y) / y] for x, y in (r, g, b)]).T
    if abs(np.linalg.det(directions)) < 1e-6:
        raise ValueError("the three primaries lie on a line")
    matrix = primaries_to_xyz((r, g, b), white)
    if (matrix[1] <= 0.0).any():
        raise ValueError("the primaries do not enclose the white point")
    return matrix


def rgb_to_working(chromaticities: Chromaticities) -> NDArray[np.float64]:
    """Return the (3, 3) matrix from linear RGB of ``chromaticities`` to linear Rec. 2020 with D65 white.

    A white point other than D65 is adapted with CAT16, so that the file's white stays white.
    """
    to_xyz = rgb_to_xyz(chromaticities)
    adapt = adaptation(to_xyz.sum(axis=1), WORKING_TO_XYZ.sum(axis=1))
    return np.asarray(np.linalg.inv(WORKING_TO_XYZ) @ adapt @ to_xyz, dtype=np.float64)

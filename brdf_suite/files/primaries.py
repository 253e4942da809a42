"""The matrix from a file's RGB primaries to the working space (linear Rec. 2020, D65)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Chromaticities = tuple[float, float, float, float, float, float, float, float]
"""CIE x, y of red, green, blue and white, in this order."""

REC709: Chromaticities = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
REC2020: Chromaticities = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)

# CAT16 (Li et al. 2017), the sharpened cone space in which white points are scaled.
_CAT16 = np.array(
    [[0.401288, 0.650173, -0.051461], [-0.250268, 1.204414, 0.045854], [-0.002079, 0.048952, 0.953127]]
)


def rgb_to_xyz(chromaticities: Chromaticities) -> NDArray[np.float64]:
    """Return the (3, 3) matrix from linear RGB to XYZ, where RGB (1, 1, 1) is white with Y = 1.

    Raises
    ------
    ValueError
        The primaries are not finite, lie on a line, or do not enclose the white point.
    """
    values = np.asarray(chromaticities, dtype=np.float64).reshape(4, 2)
    if not np.isfinite(values).all() or (values[:, 1] < 1e-6).any():
        raise ValueError("chromaticities must be finite with y above 0")
    xyz = np.stack([values[:, 0], values[:, 1], 1.0 - values.sum(axis=1)]) / values[:, 1]
    if abs(np.linalg.det(xyz[:, :3])) < 1e-6:
        raise ValueError("the three primaries lie on a line")
    gains = np.linalg.solve(xyz[:, :3], xyz[:, 3])
    if (gains <= 0.0).any():
        raise ValueError("the primaries do not enclose the white point")
    matrix: NDArray[np.float64] = xyz[:, :3] * gains
    return matrix


def rgb_to_working(chromaticities: Chromaticities) -> NDArray[np.float64]:
    """Return the (3, 3) matrix from linear RGB of ``chromaticities`` to linear Rec. 2020 with D65 white.

    A white point other than D65 is adapted with CAT16, so that the file's white stays white.
    """
    to_xyz = rgb_to_xyz(chromaticities)
    from_xyz = np.linalg.inv(rgb_to_xyz(REC2020))
    file_white = _CAT16 @ to_xyz.sum(axis=1)
    working_white = _CAT16 @ rgb_to_xyz(REC2020).sum(axis=1)
    adapt = np.linalg.inv(_CAT16) @ np.diag(working_white / file_white) @ _CAT16
    matrix: NDArray[np.float64] = from_xyz @ adapt @ to_xyz
    return matrix

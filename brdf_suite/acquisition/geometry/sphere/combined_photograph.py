"""Combination of photographs at several light positions, in which more of the sphere's outline is lit.

The radiances are added, not their logarithms: a pixel that the outline cuts keeps the share of the sphere in it.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Singles


class PhotographUnion:
    """Sum of merged photographs over light positions; add as many as are available, 6 to 40.

    Attributes
    ----------
    picture
        Mean of the three channels, summed over the positions (h, w), float32.
    unknown
        Pixels that were clipped, or left out, at some position (h, w).
    positions
        Indices of the positions in the sum.
    """

    def __init__(self, shape: tuple[int, int]) -> None:
        self.picture: Singles = np.zeros(shape, np.float32)
        self.unknown: Bools = np.zeros(shape, bool)
        self.positions: tuple[int, ...] = ()

    def add(self, k: int, radiance: npt.NDArray[np.floating], valid: Bools | None = None) -> None:
        """Add the radiance (h, w, 3) or (h, w) of position ``k``; where it is not ``valid`` (h, w), it is unknown."""
        value = radiance if radiance.ndim == 2 else radiance.mean(axis=-1)
        known = np.isfinite(value) if valid is None else np.isfinite(value) & valid
        self.picture += np.where(np.isfinite(value), value, 0.0).astype(np.float32)
        self.unknown |= ~known
        self.positions = (*self.positions, k)

"""Filling of table bins without readings.

After Günther et al. 2005, section 4.1: holes are filled with weighted sums of their neighbours. In three steps, each
for what the one before left:

1. A paint has no handedness: the bin mirrored at the plane of incidence, φd → π - φd, represents it (half-angle
   layouts; where light and view are given by polar angles, both are one bin already).
2. The bins around it along φd, weighted by a bell over their distance and by the readings in them. Near the
   highlight's centre a bin of φd is far narrower than a bin of θh: there the bell is as wide as a bin of θh is deep,
   over θh ≈ 0 the whole turn, so that the few readings in the innermost rings serve all of their bins. The bell is
   doubled where it meets no reading, up to a sixth of the range.
3. From the rim inwards, the known ones among the 26 around (:mod:`brdf_suite.reflectance.tabulated.half_angle_grid`).
"""

from __future__ import annotations

import numpy as np

from brdf_suite.acquisition.table.parameterization import Parameterization
from brdf_suite.arrays import Bools, Singles
from brdf_suite.reflectance.tabulated.half_angle_grid import PHI_REACH, fill_holes

_LEAST = 1e-3
"""Of one reading: what a bell gathers below that lies in its tail."""


def fill_table_holes(
    values: Singles, weights: Singles, parameterization: Parameterization
) -> tuple[Singles, Bools]:
    """Return values (a, b, c, 3) with holes filled, and which bins were known (a, b, c).

    ``weights`` (a, b, c) say how well each bin is known, in readings or in 1/variance; 0 is a hole. Holes where no
    direction above the horizon leads become 0, as do all where nothing is known.
    """
    known = weights > 0.0
    values = np.where(known[..., None], values, np.float32(0.0))
    trust = np.where(known, weights, np.float32(0.0))
    have = known.copy()
    if parameterization.goes_round:
        other = known[:, :, ::-1] & ~known
        values[other] = values[:, :, ::-1][other]
        trust[other] = trust[:, :, ::-1][other]
        have |= other
    _along_phi(values, trust, have, parameterization)
    fill_holes(values, ~have, parameterization.grid)
    return values, known


def _along_phi(values: Singles, trust: Singles, have: Bools, parameterization: Parameterization) -> None:
    rings, _, n = have.shape
    period = n if parameterization.goes_round else 2 * n
    for ring in range(rings):
        widest = PHI_REACH * n
        if parameterization.layout == "half-angle":
            # The depth of a bin of θh over the length of one of φd, in bins: Δθh/θh ≈ 2/(k + ½) radians.
            width = max(1.0, min(n / 2.0, 2.0 / (ring + 0.5) * n / np.pi) / 2.0)
        elif parameterization.layout == "linear":
            width = max(1.0, min(n / 2.0, 1.0 / (ring + 0.5) * n / np.pi) / 2.0)
        else:
            width = 1.0
        widest = max(widest, width)
        while True:
            lines = np.flatnonzero((~have[ring]).any(axis=1) & have[ring].any(axis=1))
            if not lines.size:
                break
            total, amount = _blurred(values[ring, lines], trust[ring, lines], width, period)
            # As many readings as one at the bell's middle, times what its tail may hold.
            enough = (
                amount > _LEAST * _bell(width, period)[0] * trust[ring, lines].max(axis=1, keepdims=True)
            ) & ~have[ring, lines]
            row, column = np.nonzero(enough)
            values[ring, lines[row], column] = total[row, column] / amount[row, column, None]
            have[ring, lines[row], column] = True
            trust[ring, lines[row], column] = 0.0
            if width >= widest:
                break
            width = min(2.0 * width, widest)


def _bell(width: float, period: int) -> Singles:
    steps = np.arange(period)
    far = np.minimum(steps, period - steps)
    bell = np.exp(-0.5 * (far / width) ** 2)
    return np.asarray(bell / bell.sum(), np.float32)


def _blurred(values: Singles, trust: Singles, width: float, period: int) -> tuple[Singles, Singles]:
    """Return Σ bell·trust·value (lines, n, 3) and Σ bell·trust (lines, n) along φd."""
    n = trust.shape[1]
    stacked = np.concatenate((values * trust[..., None], trust[..., None]), axis=2)
    if period != n:
        stacked = np.concatenate((stacked, stacked[:, ::-1]), axis=1)
    # Circulant: row k holds the bell about k.
    index = (np.arange(period)[None, :] - np.arange(n)[:, None]) % period
    matrix = _bell(width, period)[index]
    blurred = np.einsum("kp,lpc->lkc", matrix, stacked, optimize=True)
    return blurred[..., :3], blurred[..., 3]

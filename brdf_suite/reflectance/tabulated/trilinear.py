"""Trilinear look-up in a half-angle table, between the centres of its bins."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Singles
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid


def trilinear(values: Singles, grid: HalfAngleGrid, i: Floats, o: Floats) -> Singles:
    """Return (n, c) between the values (θh, θd, φd, c) for directions (3, n) above the horizon.

    Along θh and θd the first and the last centre's value is held outwards; φd goes round, and where the
    table is reciprocal the bin before the first is the last, because φd + π is the same pair swapped.
    """
    h, d, p = grid.index_of(i, o)
    rows = values.reshape(-1, values.shape[3])
    h_low, h_part = _within(h, grid.theta_h)
    d_low, d_part = _within(d, grid.theta_d)
    p -= 0.5
    floor = np.floor(p)
    p_part = (p - floor).astype(np.float32)[:, None]
    p_low = floor.astype(np.intp)
    p_low[p_low < 0] += grid.phi_d
    p_high = p_low + 1
    p_high[p_high == grid.phi_d] = 0
    start = (h_low * grid.theta_d + d_low) * grid.phi_d
    p_low += start
    p_high += start

    def along_phi(offset: int) -> Singles:
        low = rows.take(p_low + offset, axis=0)
        high = rows.take(p_high + offset, axis=0)
        high -= low
        high *= p_part
        low += high
        return low

    def along_d(offset: int) -> Singles:
        low, high = along_phi(offset), along_phi(offset + grid.phi_d)
        high -= low
        high *= d_part
        low += high
        return low

    low, high = along_d(0), along_d(grid.theta_d * grid.phi_d)
    high -= low
    high *= h_part
    low += high
    # a + t(b - a) in single precision can miss 0 from below by a rounding.
    return np.maximum(low, 0.0, out=low)


def _within(place: Floats, bins: int) -> tuple[npt.NDArray[np.intp], Singles]:
    """Return the lower of two neighbouring bins and the share of the upper one, (n,) and (n, 1)."""
    between = np.clip(place - 0.5, 0.0, bins - 1.0)
    low = np.minimum(between.astype(np.intp), bins - 2)
    return low, (between - low).astype(np.float32)[:, None]

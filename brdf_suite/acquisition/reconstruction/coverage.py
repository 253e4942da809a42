"""How much of a table was measured: shares for a plot and for a sentence."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable


def within(table: IsotropicTable, limit_deg: float = 90.0) -> np.ndarray:
    """Return (θh, θd, φd) bool: bins whose centre has light and view within ``limit_deg`` of the normal."""
    theta_h, theta_d, phi_d = table.grid.centres()
    along = np.outer(np.cos(theta_h), np.cos(theta_d)).astype(np.float32)
    across = np.outer(np.sin(theta_h), np.sin(theta_d)).astype(np.float32)
    # z of the two directions is cos θh cos θd ∓ sin θh sin θd cos φd.
    lowest = along[:, :, None] - across[:, :, None] * np.abs(np.cos(phi_d)).astype(np.float32)
    return np.asarray(lowest > max(0.0, float(np.cos(np.radians(limit_deg)))))


def covered_share(table: IsotropicTable, limit_deg: float = 90.0) -> float:
    """Return which share of those bins was measured, 0 to 1."""
    there = within(table, limit_deg)
    return float(np.count_nonzero(~np.asarray(table.holes)[there])) / max(1, int(np.count_nonzero(there)))


def coverage_map(table: IsotropicTable, limit_deg: float = 90.0) -> Floats:
    """Return (θd, θh): the share of the bins of φd that was measured, 0 to 1; NaN where none is above the horizon.

    ``limit_deg`` as in :func:`within`.
    """
    there = within(table, limit_deg)
    known = there & ~np.asarray(table.holes)
    count = there.sum(axis=2)
    share = np.where(count > 0, known.sum(axis=2) / np.maximum(count, 1), np.nan)
    return np.asarray(share.T, float)


def deviation_map(table: IsotropicTable) -> Floats:
    """Return (θd, θh): the median relative standard error over φd of what was measured; NaN where nothing was."""
    if table.coverage is None:
        return np.full(table.values.shape[1::-1], np.nan)
    found = np.full(table.values.shape[:2], np.nan)
    samples, deviation = table.coverage.samples, table.coverage.deviation
    for h, d in np.argwhere((samples > 0.0).any(axis=2)):
        found[h, d] = np.median(deviation[h, d][samples[h, d] > 0.0])
    return found.T

"""What a reconstruction gives: the table, how it came to be, and how much of it was measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np

from brdf_suite.acquisition.reconstruction.photographs import Calibration
from brdf_suite.acquisition.table.table_from_sums import ParameterizedTable
from brdf_suite.arrays import Floats
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable


@dataclass(frozen=True)
class LeftOut:
    """A position that gave no readings, and why (a sentence's clause that names the file)."""

    position: int
    reason: str


@dataclass(frozen=True, eq=False)
class Acquired:
    """A reconstructed table and how it came to be.

    Attributes
    ----------
    table
        Half-angle bins with their coverage, working space.
    positions_done, positions_failed
        Which positions gave readings, and which gave none.
    resumed
        How many of the positions were taken up from a work file.
    readings
        How many readings the table is made of.
    calibration
        Response and geometry.
    notices
        What the user should know, each a sentence.
    seconds
        Time by step: ``read`` (decoding, in the background), ``calibrate``, ``merge``, ``samples``,
        ``table`` (readings into bins), ``finish`` (means to centres, holes).
    compared
        The other layouts by name, where they were asked for.
    """

    table: IsotropicTable
    positions_done: tuple[int, ...]
    positions_failed: tuple[LeftOut, ...]
    resumed: int
    readings: int
    calibration: Calibration
    notices: tuple[str, ...] = ()
    seconds: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    compared: Mapping[str, ParameterizedTable] = field(default_factory=lambda: MappingProxyType({}))

    def to_json(self) -> dict[str, Any]:
        """Return what ``brdf-suite acquire --json`` prints."""
        coverage = self.table.coverage
        median = 0.0
        if coverage is not None and (coverage.samples > 0.0).any():
            median = float(np.median(coverage.deviation[coverage.samples > 0.0]))
        return {
            "positions": len(self.positions_done),
            "resumed": self.resumed,
            "left_out": [{"position": one.position, "reason": one.reason} for one in self.positions_failed],
            "readings": self.readings,
            "coverage": {
                "bins": int(np.count_nonzero(self.table.measured_mask())),
                "share_below_75_deg": covered_share(self.table, 75.0),
                "median_deviation": median,
            },
            "calibration": dict(self.calibration.figures),
            "notices": list(self.notices),
            "seconds": {name: round(value, 3) for name, value in self.seconds.items()},
        }


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

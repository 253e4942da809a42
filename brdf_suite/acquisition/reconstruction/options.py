"""Choices of a reconstruction, and how much of its table was measured: what is shown before and after it.

Light to import, unlike the steps between.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from brdf_suite.arrays import Bools, Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

ResponseChoice = Literal["auto", "linear"]
BINS = (90, 90, 180)


@dataclass(frozen=True, eq=False)
class AcquireOptions:
    """Choices that change the result.

    Attributes
    ----------
    grazing_deg
        Readings whose light or view is further from the normal are left out, degrees, 30 to less than 90.
    refine
        Whether highlights may correct the stated geometry.
    response
        ``auto``: as the session says, recovered where it says ``unknown``; ``linear``: the camera is linear.
    mask
        (rows, columns), True where a pixel may be used, besides the session's own masks; None: no further mask.
    positions
        Which positions of the session to use, rising; None: all.
    compare
        Whether to make the two other layouts of Figure 4 as well.
    bins
        Of the table along (θh, θd, φd); what renders elsewhere wants the usual 90 × 90 × 180.
    """

    grazing_deg: float = 80.0
    refine: bool = True
    response: ResponseChoice = "auto"
    mask: Bools | None = None
    positions: tuple[int, ...] | None = None
    compare: bool = False
    bins: tuple[int, int, int] = BINS

    def __post_init__(self) -> None:
        if not 30.0 <= self.grazing_deg < 90.0:
            raise ValueRangeError("grazing_deg", f"{self.grazing_deg:g}°; 30° to less than 90° are wanted")
        HalfAngleGrid(*self.bins)
        if self.response not in get_args(ResponseChoice):
            raise ValueRangeError("response", f"{self.response!r}; auto or linear are known")

    def to_json(self) -> dict[str, object]:
        """Return what decides the result, for the key of a work file."""
        mask = None
        if self.mask is not None:
            content = repr(self.mask.shape).encode() + np.packbits(self.mask).tobytes()
            mask = hashlib.sha256(content).hexdigest()
        chosen = {name: value for name, value in vars(self).items() if name != "positions"}
        return {**chosen, "mask": mask, "bins": list(self.bins)}


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

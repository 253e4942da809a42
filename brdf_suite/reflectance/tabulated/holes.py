"""Fill the empty bins of a half-angle table with weighted sums of their neighbours.

After Guenther, Chen, Goesele, Wald and Seidel, "Efficient Acquisition and Realistic Rendering of Car Paint" (2005),
section 4.1. Holes are filled from their rim inwards: all holes beside a known bin at once, each with the mean of its
known neighbours among the 26 around it, then those beside them, so the result hangs on no order of the bins.
A neighbour at (a, b, c) bins along (θh, θd, φd) weighs 1/(a² + b² + (c·s)²) with s below 1, for a reflectance
changes least along φd.
"""

from __future__ import annotations

from itertools import product

import numpy as np
import numpy.typing as npt

from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid

Bools = npt.NDArray[np.bool_]
Places = npt.NDArray[np.intp]

Step = tuple[int, int, int]

BIN_STEPS = (1.0, 0.2, 0.03)
"""How far one bin along (θh, θd, φd) counts."""


def fill_holes(
    values: npt.NDArray[np.float32],
    holes: Bools,
    grid: HalfAngleGrid,
    bin_steps: tuple[float, float, float] = BIN_STEPS,
) -> int:
    """Fill ``values`` (θh, θd, φd, c) in place where ``holes`` (θh, θd, φd) is set; return how many were.

    Holes that no look-up of directions above the horizon touches become 0 and count as not filled; so do
    all of them where nothing is known.
    """
    if values.shape[:3] != grid.shape or holes.shape != grid.shape or not values.flags.c_contiguous:
        raise ValueError(f"values and holes must be contiguous arrays of {grid.shape} bins")
    rows = values.reshape(-1, values.shape[3])
    rows[holes.reshape(-1)] = 0.0
    known = ~holes
    wanted = (holes & grid.reached()).reshape(-1)
    one = (-1, 0, 1)
    steps = [(step, _weight(step, bin_steps)) for step in product(one, one, one) if any(step)]
    rim = np.flatnonzero(_spread(known).reshape(-1) & wanted)
    known_row = known.reshape(-1)
    filled = 0
    while rim.size:
        around = [_neighbours(rim, step, grid) for step, _ in steps]
        total = np.zeros((rim.size, rows.shape[1]), np.float32)
        weight = np.zeros(rim.size, np.float32)
        for (_, share), (inside, place) in zip(steps, around, strict=True):
            counted = known_row.take(place)
            counted &= inside
            at = np.flatnonzero(counted)
            total[at] += np.float32(share) * rows.take(place[at], axis=0)
            weight[at] += np.float32(share)
        rows[rim] = total / weight[:, None]
        known_row[rim] = True
        filled += rim.size
        beside = np.zeros(known_row.size, np.bool_)
        for inside, place in around:
            beside[place[inside]] = True
        beside &= wanted
        beside &= ~known_row
        rim = np.flatnonzero(beside)
    return filled


def _weight(step: Step, bin_steps: tuple[float, float, float]) -> float:
    return 1.0 / sum((bins * far) ** 2 for bins, far in zip(step, bin_steps, strict=True))


def _neighbours(places: Places, step: Step, grid: HalfAngleGrid) -> tuple[Bools, Places]:
    """Return whether a step from each flat place stays in the table, and where it leads (φd goes round)."""
    line, p = np.divmod(places, grid.phi_d)
    h, d = np.divmod(line, grid.theta_d)
    h, d, p = h + step[0], d + step[1], p + step[2]
    inside = (h >= 0) & (h < grid.theta_h) & (d >= 0) & (d < grid.theta_d)
    p[p < 0] += grid.phi_d
    p[p == grid.phi_d] = 0
    return inside, np.where(inside, (h * grid.theta_d + d) * grid.phi_d + p, 0)


def _spread(known: Bools) -> Bools:
    """Return ``known`` grown by one bin in all 26 ways."""
    wide = known | np.roll(known, 1, axis=2) | np.roll(known, -1, axis=2)
    tall = wide.copy()
    tall[:, 1:] |= wide[:, :-1]
    tall[:, :-1] |= wide[:, 1:]
    deep = tall.copy()
    deep[1:] |= tall[:-1]
    deep[:-1] |= tall[1:]
    return deep

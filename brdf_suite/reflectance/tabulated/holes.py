"""Filling of a half-angle table's empty bins by weighted sums of their neighbours.

After Guenther, Chen, Goesele, Wald and Seidel, "Efficient Acquisition and Realistic Rendering of Car Paint" (2005),
section 4.1. A reflectance changes least along φd, so a hole with measured bins near it on its own line of φd gets
their mean, weighted inversely by distance. The other holes are filled from their rim inwards: all that lie beside
a known bin at once, each with the mean of its known neighbours among the 26 around it, then those beside them, so
the result hangs on no order of the bins. There a neighbour (a, b, c) bins away weighs 1/((a·s)² + (b·t)² + (c·u)²).
"""

from __future__ import annotations

from itertools import product

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Indices
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid

Step = tuple[int, int, int]

BIN_STEPS = (1.0, 0.2, 0.03)
"""How far one bin along (θh, θd, φd) counts: by trial on tabulated paints with bins taken out."""

PHI_REACH = 1.0 / 6.0
"""How far along φd the nearest measured bin may be, of the whole line (of 180°: 30°)."""


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
    known_row = known.reshape(-1)
    filled = _fill_along_phi(rows, known_row, wanted, grid)
    one = (-1, 0, 1)
    steps = [(step, _weight(step, bin_steps)) for step in product(one, one, one) if any(step)]
    rim = np.flatnonzero(_spread(known).reshape(-1) & wanted & ~known_row)
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


def _fill_along_phi(rows: npt.NDArray[np.float32], known: Bools, wanted: Bools, grid: HalfAngleGrid) -> int:
    """Fill what lies near a known bin of its line; marks it as known and returns how many were."""
    n = grid.phi_d
    known_lines, wanted_lines = known.reshape(-1, n), wanted.reshape(-1, n)
    lines = np.flatnonzero(wanted_lines.any(axis=1) & known_lines.any(axis=1))
    if not lines.size:
        return 0
    # Twice round, so that the nearest known bin on either side lies in the array.
    twice = np.tile(known_lines[lines], 2)
    place = np.arange(2 * n, dtype=np.int32)
    last = np.maximum.accumulate(np.where(twice, place, -1), axis=1)[:, n:]
    following = np.minimum.accumulate(np.where(twice, place, 3 * n)[:, ::-1], axis=1)[:, ::-1][:, :n]
    back, ahead = place[n:] - last, following - place[:n]
    near = np.minimum(back, ahead) <= max(1, int(PHI_REACH * n))
    line, p = np.nonzero(near & wanted_lines[lines])
    back, ahead = back[line, p], ahead[line, p]
    start = lines[line] * n
    share = (back / (back + ahead)).astype(np.float32)[:, None]
    before, after = rows.take(start + (p - back) % n, axis=0), rows.take(start + (p + ahead) % n, axis=0)
    rows[start + p] = before + share * (after - before)
    known[start + p] = True
    return int(p.size)


def _weight(step: Step, bin_steps: tuple[float, float, float]) -> float:
    return 1.0 / sum((bins * far) ** 2 for bins, far in zip(step, bin_steps, strict=True))


def _neighbours(places: Indices, step: Step, grid: HalfAngleGrid) -> tuple[Bools, Indices]:
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

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

from brdf_suite.arrays import Bools
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
    have, wanted = ~holes, holes & grid.reached()
    filled = _fill_along_phi(rows, have.reshape(-1), wanted.reshape(-1), grid)
    # With a margin of one bin all round, along φd a copy of the other end, a neighbour is a fixed way off.
    known, missing = np.pad(have, 1), np.pad(wanted & ~have, 1)
    table = np.pad(values, ((1, 1), (1, 1), (1, 1), (0, 0)))
    _copy_ends(known, table)
    far = np.array(known.strides)
    one = (-1, 0, 1)
    steps = [step for step in product(one, one, one) if any(step)]
    ways = [(int(far @ step), np.float32(_weight(step, bin_steps))) for step in steps]
    flat, is_known, is_missing = table.reshape(-1, rows.shape[1]), known.reshape(-1), missing.reshape(-1)
    beside = known
    for axis in range(3):
        beside = beside | np.roll(beside, 1, axis) | np.roll(beside, -1, axis)
    rim = np.flatnonzero(beside & missing)
    while rim.size:
        total = np.zeros((rim.size, rows.shape[1]), np.float32)
        weight = np.zeros(rim.size, np.float32)
        beside = np.zeros(known.shape, np.bool_)
        for way, share in ways:  # what is not known is 0
            near = rim + way
            total += share * flat.take(near, axis=0)
            weight += share * is_known.take(near)
            beside.reshape(-1)[near] = True
        flat[rim] = total / weight[:, None]
        is_known[rim], is_missing[rim] = True, False
        filled += rim.size
        _copy_ends(known, table)
        beside[:, :, 1] |= beside[:, :, -1]
        beside[:, :, -2] |= beside[:, :, 0]
        rim = np.flatnonzero(beside & missing)
    values[...] = table[1:-1, 1:-1, 1:-1]
    return filled


def _copy_ends(*tables: npt.NDArray[np.generic]) -> None:
    """Write the bins at either end of φd into the margin at the other."""
    for table in tables:
        table[:, :, 0], table[:, :, -1] = table[:, :, -2], table[:, :, 1]


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

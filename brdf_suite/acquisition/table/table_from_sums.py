"""Conversion of the accumulated sums to a table: centred means, colours, holes, coverage."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.table.sums import GEOMETRIC_ERROR, Parameterization, TableSums
from brdf_suite.arrays import AnyArray, Bools, Floats, Indices, Singles
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.blocks import in_blocks, look_up_above
from brdf_suite.reflectance.tabulated.half_angle_grid import PHI_REACH, fill_holes
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable

_LEAST = 1e-3
"""Of one reading: what a bell gathers below that lies in its tail."""
ROUNDS = 2
_MOST = 1.0
"""No value is changed by more than a factor of e: beyond that no parabola holds."""
_STEEPEST = 2.0
"""ln f per bin. A steeper neighbour is noise, or the horizon."""


@dataclass(frozen=True, eq=False)
class BinMeans:
    """Means of the readings of each bin, before holes are filled.

    ``values`` (a, b, c, 3) float32, f_r in 1/sr at the bin's centre, 0 in a hole; ``coverage`` of the same bins.
    """

    values: Singles
    coverage: Coverage
    parameterization: Parameterization

    def filled(self) -> tuple[Singles, Bools]:
        """Return the values with holes filled, and which bins were known; see :func:`fill_table_holes`."""
        trust = neighbour_weight(self.coverage.samples, self.coverage.deviation)
        return fill_table_holes(self.values, trust, self.parameterization)

    @property
    def measured(self) -> Bools:
        """Return (a, b, c): whether a bin has readings."""
        return np.asarray(self.coverage.samples > 0.0)


@dataclass(frozen=True, eq=False)
class ParameterizedTable:
    """A table in any layout of Figure 4, looked up trilinearly; for comparison, the suite renders the half-angle one.

    ``values`` (a, b, c, 3) float32, f_r in 1/sr, working space; ``holes`` (a, b, c) bool.
    """

    values: Singles
    holes: Bools
    parameterization: Parameterization

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(partial(look_up_above, self._between), wi, wo)

    def nearest(self, wi: AnyArray, wo: AnyArray) -> tuple[Singles, Bools]:
        """Return the values (n, 3) of the bins into which pairs (n, 3) fall, and whether these were measured (n,)."""
        places = self.parameterization.index_of(wi, wo).astype(np.intp)
        at = tuple(places)
        return self.values[at], ~self.holes[at]

    def _between(self, i: Floats, o: Floats) -> Singles:
        places = self.parameterization.index_of(i.T, o.T) - 0.5
        total = np.zeros((places.shape[1], 3), np.float32)
        low = np.floor(places)
        part = places - low
        for corner in range(8):
            index, share = [], np.ones(places.shape[1])
            for axis, n in enumerate(self.parameterization.shape):
                up = (corner >> axis) & 1
                at = low[axis].astype(np.intp) + up
                if axis == 2 and self.parameterization.goes_round:
                    at %= n
                index.append(np.clip(at, 0, n - 1))
                share = share * (part[axis] if up else 1.0 - part[axis])
            total += share[:, None].astype(np.float32) * self.values[tuple(index)]
        return total


def bin_means(sums: TableSums, colour: npt.ArrayLike | None = None, *, centre: bool = True) -> BinMeans:
    """Return what ``sums`` say of each bin, in the working space.

    Parameters
    ----------
    sums
        Of the readings.
    colour
        (3, 3) from the photographs' channels to linear Rec. 2020; None: they are that already. What lies outside
        it is cut at 0.
    centre
        Whether to bring the means to the bins' centres (:func:`centre_means`).
    """
    shape = sums.parameterization.shape
    rows = sums.sums
    n, w = rows[:, 0], rows[:, 1]
    there = w > 0.0
    one = np.where(there, w, 1.0)[:, None]
    means = (rows[:, 3:6] / one).astype(np.float32).reshape(*shape, 3)
    samples = np.where(there, n, 0.0).astype(np.float32).reshape(shape)
    deviation = _deviation(rows, there).reshape(shape)
    if centre:
        offsets = (rows[:, 8:11] / one).astype(np.float32).reshape(*shape, 3)
        trust = neighbour_weight(samples, deviation)
        means = centre_means(means, samples, trust, offsets, sums.parameterization)
    if colour is not None:
        matrix = np.asarray(colour, np.float32)
        if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
            raise ValueRangeError("colour", "expected a finite matrix of 3 × 3 numbers")
        means = means @ matrix.T
    np.maximum(means, 0.0, out=means)
    return BinMeans(means, Coverage(samples, deviation), sums.parameterization)


def _deviation(rows: Floats, there: Bools) -> Singles:
    """Return the standard error of each bin's mean over the mean: the larger of the photographs' noise and the spread.

    The spread of the readings is known from two or more; it holds the slope across the bin, so it errs to the safe
    side.
    """
    n, w, w2 = rows[:, 0], np.where(there, rows[:, 1], 1.0), rows[:, 2]
    y = rows[:, 3:6].sum(axis=1) / 3.0 / w
    noise = rows[:, 7] / (w * w)
    spread = np.maximum(rows[:, 6] / w - y * y, 0.0) * n / np.maximum(n - 1.0, 1.0) * w2 / (w * w)
    error = np.sqrt(np.maximum(noise, np.where(n > 1.5, spread, 0.0)))
    relative = np.where(there & (y > 0.0), error / np.where(y > 0.0, y, 1.0), 0.0)
    return np.minimum(relative, 1e6).astype(np.float32)


def half_angle_table(
    means: BinMeans,
    source: str = "",
    facts: Mapping[str, Any] | None = None,
) -> IsotropicTable:
    """Return the table of ``means`` (layout ``half-angle``) with its holes filled and its coverage kept.

    Raises
    ------
    ValueRangeError
        No bin has a reading.
    """
    if means.parameterization.layout != "half-angle":
        raise ValueError(f"a table of the suite has half-angle bins, not {means.parameterization.layout}")
    if not means.measured.any():
        raise ValueRangeError("table", "no bin has a reading; nothing was measured")
    values, known = means.filled()
    return IsotropicTable(values, ~known, True, source, facts or {}, means.coverage)


def tabulate_means(means: BinMeans) -> ParameterizedTable:
    """Return the table of ``means`` in its own layout, its holes filled."""
    values, known = means.filled()
    return ParameterizedTable(values, ~known, means.parameterization)


def neighbour_weight(samples: Singles, deviation: Singles) -> Singles:
    """Return how much a bin counts as a neighbour, by its ``deviation``; 0 in a hole."""
    # A single reading has no spread; the geometric part remains.
    return np.where(samples > 0.0, 1.0 / (deviation**2 + np.float32(GEOMETRIC_ERROR**2)), np.float32(0.0))


def fill_table_holes(
    values: Singles, weights: Singles, parameterization: Parameterization
) -> tuple[Singles, Bools]:
    """Return values (a, b, c, 3) with holes filled, and which bins were known (a, b, c).

    After Günther et al. 2005, section 4.1: holes are filled with weighted sums of their neighbours. In three steps,
    each for what the one before left:

    1. A paint has no handedness: the bin mirrored at the plane of incidence, φd → π - φd, represents it (half-angle
       layouts; where light and view are given by polar angles, both are one bin already).
    2. The bins around it along φd, weighted by a bell over their distance and by the readings in them. Near the
       highlight's centre a bin of φd is far narrower than a bin of θh: there the bell is as wide as a bin of θh is
       deep, over θh ≈ 0 the whole turn, so that the few readings in the innermost rings serve all of their bins. The
       bell is doubled where it meets no reading, up to a sixth of the range.
    3. From the rim inwards, the known ones among the 26 around
       (:func:`brdf_suite.reflectance.tabulated.half_angle_grid.fill_holes`).

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
        # The depth of a bin of θh over the length of one of φd, in bins: Δθh/θh ≈ 2/(k + ½) radians.
        depth = {"half-angle": 2.0, "linear": 1.0, "traditional": 0.0}[parameterization.layout]
        width = max(1.0, min(n / 2.0, depth / (ring + 0.5) * n / np.pi) / 2.0)
        widest = max(PHI_REACH * n, width)
        while True:
            lines = np.flatnonzero((~have[ring]).any(axis=1) & have[ring].any(axis=1))
            if not lines.size:
                break
            total, amount = _blurred(values[ring, lines], trust[ring, lines], width, period)
            # As many readings as one at the bell's middle, times what its tail may hold.
            least = _LEAST * _bell(width, period)[0] * trust[ring, lines].max(axis=1, keepdims=True)
            row, column = np.nonzero((amount > least) & ~have[ring, lines])
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


def centre_means(
    means: Singles,
    samples: Singles,
    trust: Singles,
    offsets: Singles,
    parameterization: Parameterization,
    rounds: int = ROUNDS,
) -> Singles:
    """Return values (a, b, c, 3) at the centres of the bins, for ``means`` of the same shape.

    The mean of a few readings belongs to where the readings happen to lie, and, where the reflectance bends within the
    bin as in a highlight, to no one place at all. With the logarithm of the reflectance taken as a parabola about the
    centre, slopes g and bends c along the three axes (index space), the mean of readings with mean place x and spread
    s² in each axis is

        f₀ · exp(g·x + ½ Σ c x²) · (1 + ½ Σ (g² + c) s²),

    to second order; s² is that of an even spread, 1/12, times 1 - 1/n. Slopes and bends are those of the table with its
    holes filled, since around a highlight few bins have readings: there a ring is far narrower than a pixel. Two
    rounds: the second takes its slopes from corrected values.

    ``samples`` (a, b, c) are the readings in each bin, 0 where there are none, and ``trust`` what they weigh as
    neighbours; ``offsets`` (a, b, c, 3) the readings' mean places less the bins' centres, in bins. Where there are no
    readings, the means are returned.
    """
    at = np.nonzero((samples > 0.0) & (means > 0.0).all(axis=3))
    x = offsets[at]
    spread = ((1.0 - 1.0 / samples[at]) / 12.0)[:, None]
    first = np.log(means[at])
    values = means.copy()
    for _ in range(rounds):
        whole, _known = fill_table_holes(values, trust, parameterization)
        np.log(whole, out=whole, where=whole > 0.0)
        moved, bent = np.zeros_like(first), np.zeros_like(first)
        for axis in range(3):
            slope, bend = _slope_and_bend(whole, at, axis, parameterization)
            place = x[:, axis, None]
            moved += (slope + 0.5 * bend * place) * place
            bent += 0.5 * (slope * slope + bend) * spread
        values[at] = np.exp(first - np.clip(moved + np.log1p(np.clip(bent, -0.5, 1.0)), -_MOST, _MOST))
    return values


def _slope_and_bend(
    logs: Singles, at: tuple[Indices, ...], axis: int, parameterization: Parameterization
) -> tuple[Singles, Singles]:
    """Return d/dx and d²/dx² (m, 3) of the logarithms (a, b, c, 3) along an axis at bins; one-sided at its ends."""
    last = parameterization.shape[axis] - 1
    before, after = list(at), list(at)
    before[axis], after[axis] = at[axis] - 1, at[axis] + 1
    if axis == 2 and parameterization.goes_round:
        after[axis] %= last + 1  # -1 is the last bin already
    else:
        before[axis], after[axis] = np.maximum(before[axis], 0), np.minimum(after[axis], last)
    here = logs[at]
    down, up = here - logs[tuple(before)], logs[tuple(after)] - here
    # The end of an axis is as a mirror: the single difference gives the slope and no curvature.
    ends = ((at[axis] == 0) | (at[axis] == last))[:, None] & (axis != 2 or not parameterization.goes_round)
    slope = np.where(ends, down + up, 0.5 * (down + up))
    bend = np.where(ends, 0.0, up - down)
    # A neighbour of 0 has no logarithm and is one that nothing is known of.
    lit = np.isfinite(slope) & (np.abs(slope) < 2.0 * _STEEPEST)
    held = np.clip(np.where(lit, (slope, bend), 0.0), -_STEEPEST, _STEEPEST).astype(np.float32)
    return held[0], held[1]

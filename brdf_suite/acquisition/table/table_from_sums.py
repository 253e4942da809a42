"""Conversion of the accumulated sums to a table: centred means, colours, holes, coverage."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.table.bin_centring import centre_means
from brdf_suite.acquisition.table.hole_filling import fill_table_holes
from brdf_suite.acquisition.table.parameterization import Parameterization
from brdf_suite.acquisition.table.sums import GEOMETRIC_ERROR, TableSums
from brdf_suite.arrays import Bools, Floats, Singles
from brdf_suite.errors import ValueRangeError
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.blocks import in_blocks, look_up_above
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable


@dataclass(frozen=True, eq=False)
class BinMeans:
    """Means of the readings of each bin, before holes are filled.

    ``values`` (a, b, c, 3) float32, f_r in 1/sr at the bin's centre, 0 in a hole; ``coverage`` of the same bins.
    """

    values: Singles
    coverage: Coverage
    parameterization: Parameterization

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

        def block(light: Floats, view: Floats) -> Floats:
            return look_up_above(self._between, light, view)

        return in_blocks(block, wi, wo)

    def nearest(self, wi: npt.NDArray[Any], wo: npt.NDArray[Any]) -> tuple[Singles, Bools]:
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
        Whether to bring the means to the bins' centres (:mod:`brdf_suite.acquisition.table.bin_centring`).
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
        means = centre_means(
            means, samples, neighbour_weight(samples, deviation), offsets, sums.parameterization
        )
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
    progress: Progress | None = None,
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
    report(progress, 0.0, "filling holes")
    values, known = fill_table_holes(
        means.values,
        neighbour_weight(means.coverage.samples, means.coverage.deviation),
        means.parameterization,
    )
    return IsotropicTable(values, ~known, True, source, facts or {}, means.coverage)


def tabulate_means(means: BinMeans) -> ParameterizedTable:
    """Return the table of ``means`` in its own layout, its holes filled."""
    values, known = fill_table_holes(
        means.values,
        neighbour_weight(means.coverage.samples, means.coverage.deviation),
        means.parameterization,
    )
    return ParameterizedTable(values, ~known, means.parameterization)


def neighbour_weight(samples: Singles, deviation: Singles) -> Singles:
    """Return how much a bin counts as a neighbour, by its ``deviation``; 0 in a hole."""
    # A single reading has no spread; the geometric part remains.
    return np.where(samples > 0.0, 1.0 / (deviation**2 + np.float32(GEOMETRIC_ERROR**2)), np.float32(0.0))

"""HiGHS model for all parts and channels of a fit, kept between edits.

The L1 program ``min Σ|A x - b|, x ≥ 0`` (rows already weighted) is given to the solver as its dual::

    max bᵀy   with   Aᵀy ≤ 0,  -1 ≤ y ≤ 1

because then an edit of the target changes costs only, never the matrix, its bounds or its structure; factors
on the weights of single samples take the place of the 1. The simplex resumes from the last basis: every
column has two bounds, so that a reduced cost whose sign an edit turned is set right by a flip. (The primal
simplex was 15 % faster and stopped without an answer once in 600 unrelated targets.) The weights x are minus
the row duals. The parts and channels are blocks on the diagonal of one model, so that an edit is one call.

Costs are handed over multiplied by :data:`COST_SCALE`: the solver's tolerance on x is absolute, and its
smallest is too coarse for targets of size 1 (docs/method/fit.md).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.program import PartProgram

#: Feasibility tolerances of the scaled program, tighter than the solver's 1e-7.
TOLERANCE = 1e-9
#: What costs are multiplied by: of 9,600 random programs 31 missed their optimum by more than 1e-7 without it, and
#: none with it; at 100,000 the solver lost its way in two.
COST_SCALE = 1_000.0
#: More iterations than any program needs: the solver's own "no limit".
NO_ITERATION_LIMIT = 2**31 - 1


class SolverOutcome(Enum):
    """Status of a solver run."""

    OPTIMAL = "optimal"
    STOPPED = "stopped"  # time or iterations ran out; the next run resumes from the basis
    LOST = "lost"  # the solver gave up; its basis has been thrown away


@dataclass(frozen=True, eq=False)
class BlockSolution:
    """Solution of the solver: per part scaled columns ≥ 0 ``(m, channels)`` and duals y ``(n, channels)``."""

    solutions: tuple[Floats, ...]
    duals: tuple[Floats, ...]


class BlockSolver:
    """A persistent model over ``parts`` × ``channels``; not thread-safe.

    ``careful``: with presolve and perturbation, as the solver comes. It takes longer, cannot resume a run that was
    stopped, and finds its way where the fast settings lose it.
    """

    def __init__(self, parts: Sequence[PartProgram], channels: int = 3, *, careful: bool = False) -> None:
        # Deferred: 17 ms beside numpy, more from a cold disk, on the start-up path of programs that may not fit.
        import highspy

        self._parts = tuple(parts)
        self._channels = channels
        self._optimal_status = highspy.HighsModelStatus.kOptimal
        limits = highspy.HighsModelStatus.kTimeLimit, highspy.HighsModelStatus.kIterationLimit
        self._stopped_statuses = limits
        self._error_status = highspy.HighsStatus.kError
        self._highs: Any = highspy.Highs()
        options = {
            "output_flag": False,
            "log_to_console": False,
            "solver": "simplex",
            "threads": 1,
            "parallel": "off",
            "simplex_strategy": 1,  # dual: boxed columns flip instead of pivoting, and it hardly ever loses its way
            "primal_feasibility_tolerance": TOLERANCE,
            "dual_feasibility_tolerance": TOLERANCE,
        }
        fast = {
            "presolve": "off",
            "simplex_scale_strategy": 0,  # the programs come scaled
            "primal_simplex_bound_perturbation_multiplier": 0.0,
            "dual_simplex_cost_perturbation_multiplier": 0.0,
        }
        for name, value in (options if careful else options | fast).items():
            self._check(self._highs.setOptionValue(name, value), f"option {name}")
        self._check(self._highs.passModel(self._model(highspy)), "model")
        self._columns = np.arange(self._column_count, dtype=np.int32)
        self._costs = np.zeros(self._column_count)
        # Where each part's targets go among the costs, as (channels, n).
        cuts = np.split(self._costs, np.cumsum([part.shape[0] * channels for part in self._parts[:-1]]))
        self._cost_places = [cut.reshape(channels, -1) for cut in cuts]
        self._bounded_by_factors = False
        self._iteration_limit: int | None = None

    def _model(self, highspy: Any) -> Any:
        """Build the block-diagonal dual: per channel a column for each sample, a row for each lobe column."""
        starts, rows, values = [0], [], []
        row_offset = 0
        for part in self._parts:
            samples, unknowns = part.shape
            for _ in range(self._channels):
                for j in range(samples):
                    used = np.flatnonzero(part.matrix[j])
                    rows.append(used + row_offset)
                    values.append(part.matrix[j, used])
                    starts.append(starts[-1] + used.size)
                row_offset += unknowns
        self._column_count = len(starts) - 1
        self._row_count = row_offset
        #: Number of matrix entries that are not zero, all blocks together.
        self.entry_count = starts[-1]
        model = highspy.HighsLp()
        model.num_col_ = self._column_count
        model.num_row_ = self._row_count
        model.sense_ = highspy.ObjSense.kMinimize
        model.col_cost_ = np.zeros(self._column_count)
        model.col_lower_ = np.full(self._column_count, -1.0)
        model.col_upper_ = np.full(self._column_count, 1.0)
        model.row_lower_ = np.full(self._row_count, -highspy.kHighsInf)
        model.row_upper_ = np.zeros(self._row_count)
        model.a_matrix_.format_ = highspy.MatrixFormat.kColwise
        model.a_matrix_.num_col_ = self._column_count
        model.a_matrix_.num_row_ = self._row_count
        model.a_matrix_.start_ = np.array(starts, dtype=np.int32)
        model.a_matrix_.index_ = np.concatenate(rows).astype(np.int32)
        model.a_matrix_.value_ = np.concatenate(values)
        return model

    def _check(self, status: Any, what: str) -> None:
        if status == self._error_status:
            raise FittingError(f"The linear-programming solver refused its {what}.")

    def load(self, targets: Sequence[Floats], factors: Sequence[Floats] | None = None) -> None:
        """Take new ``targets``, one ``(n, channels)`` of weighted rows per part, sizes near 1.

        ``factors``, of the same shapes and > 0, multiply the weights of single samples; 1 where left out.
        """
        for place, target in zip(self._cost_places, targets, strict=True):
            np.multiply(target.T, -COST_SCALE, out=place)
        self._check(self._highs.changeColsCost(self._column_count, self._columns, self._costs), "costs")
        if factors is not None or self._bounded_by_factors:
            bounds = np.ones(self._column_count)
            if factors is not None:
                bounds = np.concatenate([factor.T.ravel() for factor in factors])
            status = self._highs.changeColsBounds(self._column_count, self._columns, -bounds, bounds)
            self._check(status, "bounds")
            self._bounded_by_factors = factors is not None

    def run(self, budget_s: float, iterations: int = NO_ITERATION_LIMIT) -> SolverOutcome:
        """Continue from the last basis for ``budget_s`` seconds or ``iterations``, whichever ends first.

        The solver looks at the clock only now and then and may return late, most of all at its start: a
        program of 384,000 entries was 5 ms late. The interpreter's lock is released meanwhile.
        """
        highs = self._highs
        # The solver's limit counts the time of all runs of a model together; iterations are of this run.
        highs.setOptionValue("time_limit", highs.getRunTime() + max(budget_s, 0.0))
        if iterations != self._iteration_limit:
            highs.setOptionValue("simplex_iteration_limit", iterations)
            self._iteration_limit = iterations
        failed = highs.run() == self._error_status
        status = highs.getModelStatus()
        if not failed and status == self._optimal_status:
            return SolverOutcome.OPTIMAL
        if not failed and status in self._stopped_statuses:
            return SolverOutcome.STOPPED
        return SolverOutcome.LOST

    def forget(self) -> None:
        """Discard the basis, as after a failed run: the next run starts from scratch."""
        self._highs.clearSolver()

    @property
    def iterations(self) -> int:
        """Simplex iterations of the last run."""
        return int(self._highs.getInfoValue("simplex_iteration_count")[1])

    def solution(self) -> BlockSolution:
        """Return what the solver holds, clamped to ≥ 0; before an optimum it may be poor, or all zeros."""
        held = self._highs.getSolution()
        weights = self._array(held.row_dual, self._row_count) * (-1.0 / COST_SCALE)
        # Anything that the tolerance let below zero becomes 0.
        return BlockSolution(
            self._split(np.maximum(weights, 0.0), 1),
            self._split(self._array(held.col_value, self._column_count), 0),
        )

    @staticmethod
    def _array(values: Sequence[float], count: int) -> Floats:
        """Return the solver's list as an array; zeros for what it does not hold, or not as a number."""
        if len(values) != count:
            return np.zeros(count)
        array = np.array(values, dtype=np.float64)
        if not math.isfinite(array.sum()):  # of a broken run
            array[~np.isfinite(array)] = 0.0
        return array

    def _split(self, array: Floats, axis: int) -> tuple[Floats, ...]:
        """Cut ``array`` into ``(size, channels)`` per part."""
        sizes = [part.shape[axis] * self._channels for part in self._parts]
        cuts = np.split(array, np.cumsum(sizes[:-1]))
        return tuple(cut.reshape(self._channels, -1).T for cut in cuts)

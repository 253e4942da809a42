"""One HiGHS model for all parts and channels of a fit, kept between edits.

The L1 program ``min Σ|A x - b|, x ≥ 0`` (rows already weighted) is given to the solver as its dual::

    max bᵀy   with   Aᵀy ≤ 0,  -1 ≤ y ≤ 1

because then an edit of the target changes costs only, never the matrix, its bounds or its structure. The
simplex goes on from the last basis: every column has two bounds, so that a reduced cost whose sign an edit
turned is set right by a flip. (The primal simplex was 15 % faster and stopped without an answer once in 600
unrelated targets.) The weights x are minus the row duals. The parts and channels are blocks on the diagonal
of one model, so that an edit is one call.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.program import PartProgram

FloatArray = NDArray[np.float64]

#: Feasibility tolerances of the scaled program, tighter than the solver's 1e-7: targets are scaled to 1.
TOLERANCE = 1e-9


@dataclass(frozen=True, eq=False)
class BlockSolution:
    """What the solver left: per part ``solutions`` ``(m, channels)`` of scaled columns ≥ 0."""

    solutions: tuple[FloatArray, ...]
    optimal: bool
    iterations: int


class BlockSolver:
    """A kept model over ``parts`` × ``channels``; not safe to call from two threads at once."""

    def __init__(self, parts: Sequence[PartProgram], channels: int = 3) -> None:
        # Deferred: 17 ms beside numpy, more from a cold disk, on the start-up path of programs that may not fit.
        import highspy

        self._parts = tuple(parts)
        self._channels = channels
        self._optimal_status = highspy.HighsModelStatus.kOptimal
        self._limit_status = highspy.HighsModelStatus.kTimeLimit
        self._error_status = highspy.HighsStatus.kError
        self._highs: Any = highspy.Highs()
        for name, value in {
            "output_flag": False,
            "log_to_console": False,
            "presolve": "off",
            "solver": "simplex",
            "threads": 1,
            "parallel": "off",
            "simplex_strategy": 1,  # dual: boxed columns flip instead of pivoting, and it never lost its way
            "simplex_scale_strategy": 0,  # the programs come scaled
            "primal_simplex_bound_perturbation_multiplier": 0.0,
            "dual_simplex_cost_perturbation_multiplier": 0.0,
            "primal_feasibility_tolerance": TOLERANCE,
            "dual_feasibility_tolerance": TOLERANCE,
        }.items():
            self._check(self._highs.setOptionValue(name, value), f"option {name}")
        self._check(self._highs.passModel(self._model(highspy)), "model")
        self._columns = np.arange(self._column_count, dtype=np.int32)

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

    def solve(self, targets: Sequence[FloatArray], budget_s: float) -> BlockSolution:
        """Solve for ``targets``, one ``(n, channels)`` of weighted rows per part, sizes near 1.

        ``budget_s`` is given to the solver as its own limit; it looks at the clock only now and then and may
        return some milliseconds late. ``optimal`` is False where it stopped early; the solutions are then
        what the simplex held, clamped to ≥ 0, and may be poor.
        """
        highs = self._highs
        costs = np.concatenate([(-target.T).ravel() for target in targets])
        self._check(highs.changeColsCost(self._column_count, self._columns, costs), "costs")
        # The solver's limit counts the time of all runs of a model together.
        highs.setOptionValue("time_limit", highs.getRunTime() + max(budget_s, 0.0))
        status = highs.run()
        optimal = status != self._error_status and highs.getModelStatus() == self._optimal_status
        iterations = int(highs.getInfo().simplex_iteration_count)
        solutions = self._split(highs.getSolution().row_dual)
        if not optimal and highs.getModelStatus() != self._limit_status:
            # It lost its way rather than its time: the basis is no start for the next edit.
            highs.clearSolver()
        return BlockSolution(solutions, optimal, iterations)

    def _split(self, row_dual: Sequence[float]) -> tuple[FloatArray, ...]:
        """Turn row duals into non-negative columns per part; a solver without an answer gives zeros."""
        duals = np.zeros(self._row_count)
        if len(row_dual) == self._row_count:
            duals = -np.asarray(row_dual, dtype=np.float64)
        # Anything the tolerance let below zero, and a not-a-number of a broken run, becomes 0.
        duals = np.where(np.isfinite(duals) & (duals > 0.0), duals, 0.0)
        parts = []
        start = 0
        for part in self._parts:
            size = part.shape[1] * self._channels
            parts.append(duals[start : start + size].reshape(self._channels, part.shape[1]).T)
            start += size
        return tuple(parts)

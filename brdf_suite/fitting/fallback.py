"""Feasible answers in bounded time, for when the time limit comes before the optimum.

Two candidates per channel: the last accepted weights rescaled to the new target, and non-negative least
squares by coordinate descent on a kept Gram matrix. Both are non-negative by construction; the caller takes
the one with the least L1 error.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.fitting.program import PartProgram

FloatArray = NDArray[np.float64]

#: Sweeps of the descent: enough to come near the least-squares optimum from the last weights.
SWEEPS = 20


class FallbackSolver:
    """Feasible answers for one part; keeps ``AᵀA`` of the scaled matrix A ``(n, m)``."""

    def __init__(self, program: PartProgram) -> None:
        self._program = program
        self._gram: FloatArray = program.matrix.T @ program.matrix
        diagonal = np.diagonal(self._gram).copy()
        self._inverse_diagonal: FloatArray = np.where(
            diagonal > 0.0, 1.0 / np.where(diagonal > 0.0, diagonal, 1.0), 0.0
        )

    def rescaled(self, last: FloatArray, target: FloatArray) -> FloatArray:
        """Return ``last`` (m, channels) times one factor ≥ 0 per channel, best for ``target`` (n, channels).

        Best in the L1 sense: the weighted median of the ratios target / prediction.
        """
        prediction = self._program.matrix @ last
        factors = [_weighted_median_ratio(target[:, k], prediction[:, k]) for k in range(target.shape[1])]
        result: FloatArray = last * np.array(factors)
        return result

    def least_squares(self, start: FloatArray, target: FloatArray, sweeps: int = SWEEPS) -> FloatArray:
        """Return columns ≥ 0 ``(m, channels)`` after ``sweeps`` of coordinate descent from ``start``."""
        gram, inverse = self._gram, self._inverse_diagonal
        solution = np.maximum(start, 0.0)
        gradient = gram @ solution - self._program.matrix.T @ target
        for _ in range(sweeps):
            for i in range(gram.shape[0]):
                moved = np.maximum(solution[i] - gradient[i] * inverse[i], 0.0)
                step = moved - solution[i]
                if step.any():
                    gradient += gram[:, i, None] * step
                    solution[i] = moved
        return solution


def _weighted_median_ratio(target: FloatArray, prediction: FloatArray) -> float:
    """Return the ``s ≥ 0`` that minimizes ``Σ|s·prediction - target|``; 0 where nothing is predicted."""
    used = prediction > 0.0
    if not used.any():
        return 0.0
    ratios = target[used] / prediction[used]
    order = np.argsort(ratios)
    cumulative = np.cumsum(prediction[used][order])
    middle = np.searchsorted(cumulative, 0.5 * cumulative[-1])
    return float(max(ratios[order][middle], 0.0))

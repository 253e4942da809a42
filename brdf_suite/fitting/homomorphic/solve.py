"""Least-squares solution of a factorization's linear system, directly or iteratively.

Two ways to the same minimum of |W(Ax - f)|² + λ²|Lx|²:

- *direct*: the normal equations, dense, and their Cholesky factor. One factor serves every channel. The unknowns are
  few (2·32² or 2·64²) beside the samples, and every texel of q meets nearly every one of p, so that nothing would be
  gained by a sparse factor.
- *iterative*: LSMR (Fong and Saunders 2011) on the sparse matrix, which is never multiplied out. Of scipy's iterative
  solvers it is the one for rectangular systems whose residual falls monotonically, so that stopping early is safe; QMR,
  which the paper used, wants a square matrix, and so the normal equations with their squared condition.

What no sample and no smoothness decides (a constant may move from one map to another) goes to the answer nearest to the
initial guess, in both ways.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from scipy import linalg, sparse
from scipy.sparse.linalg import LinearOperator, lsmr

from brdf_suite.arrays import Floats
from brdf_suite.progress import Progress, report, subrange

Solver = Literal["auto", "direct", "iterative"]
Way = Literal["direct", "iterative"]

MOST_DIRECT_UNKNOWNS = 8192
"""Beyond it the dense normal equations (half a gigabyte) take more memory than is reasonable."""
MOST_ITERATIONS = 400
_TOLERANCE = 1e-4
_RIDGE = 1e-7
"""Of the mean diagonal of the normal equations: it decides what nothing else does, and moves the rest by as little."""
_ROWS_A_BLOCK = 200_000
_ROWS_WRITTEN_OUT = 512


def way_for(solver: Solver, unknowns: int) -> Way:
    """Return how a system of so many unknowns is solved: as asked, or directly where its normal equations are small."""
    if solver != "auto":
        return solver
    return "direct" if unknowns <= MOST_DIRECT_UNKNOWNS else "iterative"


def solve(
    matrix: sparse.csr_array,
    smoothing: sparse.csr_array,
    smooth: float,
    wanted: Floats,
    weights: Floats | None,
    start: Floats,
    way: Way,
    progress: Progress | None = None,
) -> Floats:
    """Return the unknowns (n, channels).

    Parameters
    ----------
    matrix, smoothing
        A (samples, n) and L (rows, n); ``smooth`` is λ of equation 17, at least 0.
    wanted
        The logarithms (samples, channels), ``weights`` (samples,) of the rows (equation 19) or None.
    start
        The initial guess (n, channels).
    """
    if weights is not None:
        matrix = sparse.csr_array(sparse.diags_array(weights.astype(np.float32)) @ matrix)
        wanted = wanted * weights[:, None]
    if way == "direct":
        return _direct(matrix, smoothing, smooth, wanted, start, progress)
    return _iterative(matrix, smoothing, smooth, wanted, start, progress)


def _direct(
    matrix: sparse.csr_array,
    smoothing: sparse.csr_array,
    smooth: float,
    wanted: Floats,
    start: Floats,
    progress: Progress | None,
) -> Floats:
    count = matrix.shape[1]
    normal = np.zeros((count, count))
    right = np.zeros_like(start)
    rows = matrix.shape[0]
    for first in range(0, rows, _ROWS_A_BLOCK):
        report(progress, 0.6 * first / rows, "normal equations")
        block = matrix[first : first + _ROWS_A_BLOCK].astype(
            np.float64
        )  # of squares, single precision keeps too little
        squares = sparse.csr_array(block.T @ block)
        # A few rows at a time: written out as a whole it would be another matrix of that size.
        for row in range(0, count, _ROWS_WRITTEN_OUT):
            normal[row : row + _ROWS_WRITTEN_OUT] += squares[row : row + _ROWS_WRITTEN_OUT].toarray()
        right += block.T @ (wanted[first : first + _ROWS_A_BLOCK] - block @ start)
    laplacian = smoothing.astype(np.float64)
    penalty = sparse.csr_array((smooth * smooth) * (laplacian.T @ laplacian))
    for row in range(0, count, _ROWS_WRITTEN_OUT):
        normal[row : row + _ROWS_WRITTEN_OUT] += penalty[row : row + _ROWS_WRITTEN_OUT].toarray()
    right -= penalty @ start
    diagonal = np.einsum("ii->i", normal)
    diagonal += _RIDGE * max(float(diagonal.mean()), 1e-30)
    report(progress, 0.6, "Cholesky factor")
    # Symmetric, so that by columns, as the factor wants it, it is its own transpose.
    factor = linalg.cho_factor(normal.T, lower=True, overwrite_a=True, check_finite=False)
    return np.asarray(start + linalg.cho_solve(factor, right, check_finite=False))


def _iterative(
    matrix: sparse.csr_array,
    smoothing: sparse.csr_array,
    smooth: float,
    wanted: Floats,
    start: Floats,
    progress: Progress | None,
) -> Floats:
    rows, count = matrix.shape
    transposed = sparse.csr_array(matrix.T)  # in rows of its own: twice as fast to multiply
    below = smoothing * np.float32(smooth)

    def forwards(x: Floats) -> Floats:
        single = x.astype(np.float32).ravel()
        return np.concatenate((matrix @ single, below @ single)).astype(np.float64)

    def back(y: Floats) -> Floats:
        single = y.astype(np.float32).ravel()
        return np.asarray(transposed @ single[:rows] + below.T @ single[rows:], np.float64)

    more = smoothing.shape[0]
    system = LinearOperator((rows + more, count), matvec=forwards, rmatvec=back, dtype=np.float64)
    found = np.empty_like(start)
    for channel in range(start.shape[1]):
        step = subrange(progress, channel / start.shape[1], (channel + 1) / start.shape[1])
        report(step, 0.0, "least squares by iteration")
        right = np.concatenate((wanted[:, channel], np.zeros(more)))
        guess = start[:, channel]
        answer = lsmr(
            system, right, atol=_TOLERANCE, btol=_TOLERANCE, conlim=0.0, maxiter=MOST_ITERATIONS, x0=guess
        )
        found[:, channel] = answer[0]
    return found

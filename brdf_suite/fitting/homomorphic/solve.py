"""Linear system of a factorization, and its least-squares solution, directly or iteratively.

The unknowns are the logarithms of all maps, one after the other, row by row (McCool, Ang and Ahmad 2001, equation 15).
A row of a sample holds the bilinear weights of the texels that its factors read (equation 14); where two factors
read one texel, their weights are summed.

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

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy import linalg, sparse
from scipy.sparse.linalg import LinearOperator, lsmr

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_words import LEAST_SIZE, MOST_SIZE, Factor
from brdf_suite.geometry.parabolic import bilinear
from brdf_suite.progress import Progress, report, subrange

FLATNESS = 0.5
"""Of the differences beside the Laplacian: a slope at the rim of the samples is carried on for 1/FLATNESS texels."""
MOST_DIRECT_UNKNOWNS = 8192
"""Beyond it the dense normal equations (half a gigabyte) take more memory than is reasonable."""
MOST_ITERATIONS = 400
_TOLERANCE = 1e-4
_RIDGE = 1e-7
"""Of the mean diagonal of the normal equations: it decides what nothing else does, and moves the rest by as little."""
_ROWS_A_BLOCK = 200_000
_ROWS_WRITTEN_OUT = 512


@dataclass(frozen=True)
class MapLayout:
    """Index ranges of the maps among the unknowns.

    ``shapes``: map name to (n,) or (n, n); ``starts``: to its first unknown; ``count``: of all unknowns.
    """

    factors: tuple[Factor, ...]
    shapes: Mapping[str, tuple[int, ...]]
    starts: Mapping[str, int]
    count: int

    @classmethod
    def of(cls, factors: Sequence[Factor], resolution: int) -> MapLayout:
        """Lay out maps of ``resolution`` texels along each axis, or of as many as a factor asks for."""
        if not LEAST_SIZE <= resolution <= MOST_SIZE:
            reason = f"expected {LEAST_SIZE} to {MOST_SIZE} texels, not {resolution}"
            raise ValueRangeError("resolution", reason)
        shapes: dict[str, tuple[int, ...]] = {}
        starts: dict[str, int] = {}
        count = 0
        for factor in factors:
            if factor.name not in shapes:
                size = resolution if factor.size is None else factor.size
                shapes[factor.name] = (size,) * factor.projection.axes
                starts[factor.name] = count
                count += size**factor.projection.axes
        return cls(tuple(factors), shapes, starts, count)

    def maps(self, unknowns: Floats) -> dict[str, Floats]:
        """Return each map of ``unknowns`` (count, channels) as (n, channels) or (n, n, channels)."""
        channels = unknowns.shape[1]
        found = {}
        for name, shape in self.shapes.items():
            start = self.starts[name]
            found[name] = unknowns[start : start + int(np.prod(shape))].reshape(*shape, channels)
        return found

    def unknowns(self, maps: Mapping[str, Floats]) -> Floats:
        """Return the unknowns (count, channels) of maps: what :meth:`maps` takes apart."""
        return np.concatenate([maps[name].reshape(-1, maps[name].shape[-1]) for name in self.shapes])


def constraints(layout: MapLayout, wi: Floats, wo: Floats) -> sparse.csr_array:
    """Return the matrix A (samples, unknowns) of equation 16, float32, coincident coefficients summed."""
    texels, weights = [], []
    for factor in layout.factors:
        index, weight = bilinear(factor.projection.places(wi, wo), layout.shapes[factor.name])
        texels.append(index + np.int32(layout.starts[factor.name]))
        weights.append(weight)
    columns, values = np.concatenate(texels, axis=1), np.concatenate(weights, axis=1)
    rows = np.arange(len(wi) + 1, dtype=np.int32) * np.int32(columns.shape[1])
    found = sparse.csr_array((values.ravel(), columns.ravel(), rows), shape=(len(wi), layout.count))
    found.sum_duplicates()
    return found


def smoothness(layout: MapLayout) -> sparse.csr_array:
    """Return the Laplacian of every texel of every map (unknowns, unknowns), float32: the masks of Figure 3.

    A texel less its neighbours, as many as there are: 4 inside of a map of two axes, 3 on its edges, 2 in its corners.
    """
    blocks: list[sparse.csr_array] = []
    for shape in layout.shapes.values():
        size = shape[0]
        beside = sparse.diags_array(np.ones(size - 1), offsets=1, shape=(size, size))
        neighbours = sparse.csr_array(beside + beside.T)
        line = sparse.csr_array(sparse.diags_array(neighbours.sum(axis=1)) - neighbours)
        one = sparse.csr_array(sparse.eye_array(size))
        plane = line if len(shape) == 1 else sparse.kron(line, one) + sparse.kron(one, line)
        blocks.append(sparse.csr_array(plane))
    return sparse.csr_array(sparse.block_diag(blocks, format="csr").astype(np.float32))


def regularization(layout: MapLayout) -> sparse.csr_array:
    """Return what keeps the maps smooth (rows, unknowns), float32: the Laplacian, and less of it the first differences.

    The Laplacian alone carries the slope at the rim of the samples on and on: where a gap is ten texels wide, a trend
    of the last two is exponentiated ten times over. With the differences a gap ends flat.
    """
    blocks: list[sparse.csr_array] = []
    for shape in layout.shapes.values():
        size = shape[0]
        step = sparse.csr_array(sparse.eye_array(size - 1, size, k=1) - sparse.eye_array(size - 1, size))
        one = sparse.csr_array(sparse.eye_array(size))
        both = (step,) if len(shape) == 1 else (sparse.kron(step, one), sparse.kron(one, step))
        blocks.append(sparse.csr_array(sparse.vstack(both)))
    differences = FLATNESS * sparse.csr_array(sparse.block_diag(blocks, format="csr"))
    return sparse.csr_array(sparse.vstack((smoothness(layout), differences)).astype(np.float32))


Solver = Literal["auto", "direct", "iterative"]
Way = Literal["direct", "iterative"]


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
    solver = _direct if way == "direct" else _iterative
    return solver(matrix, smoothing, smooth, wanted, start, progress)


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
        # Of squares, single precision keeps too little.
        block = matrix[first : first + _ROWS_A_BLOCK].astype(np.float64)
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

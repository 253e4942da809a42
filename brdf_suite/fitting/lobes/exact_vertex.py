"""Refinement of a solver's answer to the exact vertex, where rounding is visible.

The solver stops within its tolerances, and what it holds is then up to 1e-11 of the target away from the vertex.
That is nothing unless the lobes reach the target exactly, and the error that is left *is* that distance. The
vertex has its own equations: the samples whose dual lies between its bounds are met exactly by the columns that
are in use. Solving them once more, with a correction for the rounding of the first time, gives the optimum to
double precision.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.program import PartProgram

#: A gap between an answer's error and its dual bound that is worth a refinement, relative to the error.
GAP = 1e-8
#: Errors below this share of the target are rounding; gaps are compared with it at least.
SMALLEST_ERROR = 1e-6
#: A column is in use above this share of the largest; a dual is between its bounds this far from them.
IN_USE = 1e-10
BETWEEN = 1e-7


def refine_vertex(
    program: PartProgram,
    solution: Floats,
    dual: Floats,
    target: Floats,
    factors: Floats | None = None,
) -> tuple[Floats, Floats]:
    """Return the solution ``(m, channels)`` ≥ 0 and its L1 errors ``(channels,)``, refined where it pays.

    ``dual`` ``(n, channels)`` are the solver's y, ``target`` has a size near 1, ``factors`` multiply the
    weights. A channel whose error is within 1e-8 of the bound ``bᵀy`` is returned as it is; another only
    where its refinement is better.
    """
    errors = program.residual_l1(solution, target, factors)
    bound = np.einsum("jk,jk->k", target, dual)
    # Three numbers each: plain ones are compared sooner than arrays.
    doubtful = [
        k
        for k, (error, least) in enumerate(zip(errors.tolist(), bound.tolist(), strict=True))
        if error - least > GAP * max(error, SMALLEST_ERROR)
    ]
    if not doubtful:
        return solution, errors
    solution = solution.copy()
    for k in doubtful:
        limit = 1.0 if factors is None else factors[:, k]
        met = np.abs(dual[:, k]) < (1.0 - BETWEEN) * limit
        column = _vertex(program.matrix, solution[:, k], met, target[:, k])
        weights = None if factors is None else factors[:, k : k + 1]
        error = program.residual_l1(column[:, None], target[:, k : k + 1], weights)[0]
        if error < errors[k]:
            solution[:, k], errors[k] = column, error
    return solution, errors


def _vertex(matrix: Floats, solution: Floats, met: NDArray[np.bool_], target: Floats) -> Floats:
    used = solution > IN_USE * solution.max(initial=0.0)
    result = np.zeros_like(solution)
    if not (used.any() and met.any()):
        return result
    system = matrix[np.ix_(met, used)]
    found = solution[used]
    for _ in range(2):
        rest = target[met] - system @ found
        found = found + np.linalg.lstsq(system, rest, rcond=None)[0]
    result[used] = np.maximum(found, 0.0)
    return result

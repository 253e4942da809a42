"""Refinement of a solver's answer to the exact vertex, where rounding is visible.

The solver stops within its tolerances, and what it holds is then up to 1e-11 of the target away from the vertex.
That is nothing unless the lobes reach the target exactly, and the error that is left *is* that distance. The
vertex has its own equations: the samples whose dual lies between its bounds are met exactly by the columns that
are in use. Solving them once more, with a correction for the rounding of the first time, gives the optimum to
double precision.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.highs_model import BlockSolution
from brdf_suite.fitting.lobes.program import PartProgram

#: A gap between an answer's error and its dual bound that is worth a refinement, relative to the error.
GAP = 1e-8
#: Errors below this share of the target are rounding; gaps are compared with it at least.
SMALLEST_ERROR = 1e-6
#: A column is in use above this share of the largest; a dual is between its bounds this far from them.
IN_USE = 1e-10
BETWEEN = 1e-7
#: A system whose inverse is larger than this would answer with rounding.
LARGEST_INVERSE = 1e7
#: Parts of more columns are left to the simplex: to invert their systems takes as long as its few steps.
MOST_COLUMNS = 64
#: Duals further from feasible than this prove too little; the solver itself allows more.
FEASIBLE = 1e-11


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


class KeptVertex:
    """Weights as a linear map of the target, and the duals that prove them; for weights without factors.

    At a vertex the samples whose dual lies between its bounds are met exactly by the columns in use, so that weights
    are a fixed linear map of the target. The duals do not depend on the target at all: for a new target, as after a
    small edit, they are still feasible, and weights that are not negative and whose error equals ``bᵀy`` are optimal,
    by duality. That is two small products: a fit of 68 µs in a drag instead of 150, of which the simplex took 45 to
    find that there was nothing to do.
    """

    def __init__(self, parts: Sequence[PartProgram], maps: Sequence[Floats], held: BlockSolution) -> None:
        self._matrices = [part.matrix for part in parts]
        self._maps = maps  # per part (channels, m, n)
        self._duals = [np.ascontiguousarray(dual.T) for dual in held.duals]  # (channels, n)

    def answer(self, targets: Sequence[Floats]) -> tuple[list[Floats], list[Floats]] | None:
        """Return solutions ``(m, channels)`` ≥ 0 and errors ``(channels,)`` per part; None if not optimal."""
        solutions, errors = [], []
        for matrix, kept, dual, target in zip(self._matrices, self._maps, self._duals, targets, strict=True):
            columns = target.T
            solution = np.maximum((kept @ columns[:, :, None])[:, :, 0], 0.0)
            error = np.abs(solution @ matrix.T - columns).sum(axis=1)
            bound = np.einsum("kj,kj->k", dual, columns)
            for most, least in zip(error.tolist(), bound.tolist(), strict=True):
                # Written so that a not-a-number is no proof.
                if not most - least <= GAP * max(most, SMALLEST_ERROR):
                    return None
            solutions.append(solution.T)
            errors.append(error)
        return solutions, errors


def kept_vertex(parts: Sequence[PartProgram], held: BlockSolution) -> KeptVertex | None:
    """Return the vertex that the solver ``held`` at an optimum; None where it is not a plain one.

    A vertex where more samples are met than columns are in use, or fewer, is no square system: the optimum is
    then degenerate, and left to the simplex.
    """
    if any(part.shape[1] > MOST_COLUMNS for part in parts):
        return None
    maps = []
    for part, solution, dual in zip(parts, held.solutions, held.duals, strict=True):
        if (part.matrix.T @ dual).max() > FEASIBLE:
            return None
        rows, unknowns = part.shape
        channels = solution.shape[1]
        kept = np.zeros((channels, unknowns, rows))
        for k in range(channels):
            used = solution[:, k] > IN_USE * solution[:, k].max(initial=0.0)
            met = np.abs(dual[:, k]) < 1.0 - BETWEEN
            if used.sum() != met.sum():
                return None
            if not used.any():
                continue
            system = part.matrix[np.ix_(met, used)]
            try:
                inverse = np.linalg.inv(system)
            except np.linalg.LinAlgError:
                return None
            if not np.abs(inverse).max() <= LARGEST_INVERSE:
                return None
            kept[np.ix_(np.array([k]), used, met)] = inverse
        maps.append(kept)
    return KeptVertex(parts, maps, held)

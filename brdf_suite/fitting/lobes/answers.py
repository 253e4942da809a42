"""Scaled targets of the limited solver, and its answers: weights and their errors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.exact_vertex import refine_vertex
from brdf_suite.fitting.lobes.highs_model import BlockSolution
from brdf_suite.fitting.lobes.program import PartProgram

if TYPE_CHECKING:  # 3 ms with the logging that it loads, on the start-up path of programs that may not fit
    from concurrent.futures import Future


OPTIMUM = "optimum"


@dataclass(frozen=True, eq=False)
class LimitedSolution:
    """Weights for every part and channel, and the status of each.

    ``solutions``: per part ``(m, channels)`` ≥ 0, of scaled columns, for the targets that were given;
    ``objectives``: per part ``(channels,)`` the L1 error, and ``relative`` it over that of no weights at all (0 for
    a target of zeros); ``methods``: per part and channel "optimum",
    "simplex" (what it held when it was stopped), "rescaled", "least squares" or "zero"; ``optimal``: all are
    optima. ``exact`` gets the optimum, or what was made of it, once it is found in the background: ``None``
    where nothing is to be found, cancelled where a newer request came first.
    """

    solutions: tuple[Floats, ...]
    objectives: tuple[Floats, ...]
    relative: tuple[Floats, ...]
    methods: tuple[tuple[str, ...], ...]
    optimal: bool
    iterations: int
    exact: Future[Any] | None = field(default=None, repr=False)


@dataclass(frozen=True, eq=False)
class NormalizedTargets:
    """Targets normalized per part and channel, their scale factors, and factors on the weights."""

    targets: tuple[Floats, ...]
    sizes: tuple[Floats, ...]
    factors: tuple[Floats, ...] | None
    has_zeros: bool

    def factors_of(self, part: int) -> Floats | None:
        """Return the factors of one part, or ``None``."""
        return None if self.factors is None else self.factors[part]


def normalize_targets(
    parts: Sequence[PartProgram],
    channels: int,
    targets: Sequence[Floats],
    factors: Sequence[Floats] | None,
) -> NormalizedTargets:
    """Scale weighted ``targets``, one ``(n, channels)`` per part, each channel to a size Σ|b| of 1.

    The program is linear in its target: what is found is scaled back, so that the solver's absolute tolerances
    are relative ones. A channel of zeros stays zeros.

    Raises
    ------
    FittingError
        A shape that does not fit, a target that is not finite or whose sum is not, a factor that is not a
        positive finite number.
    """
    for what, arrays in (("targets", targets), ("factors", factors)):
        if arrays is None:
            continue
        shapes = [np.shape(array) for array in arrays]
        wanted = [(part.shape[0], channels) for part in parts]
        if shapes != wanted:
            raise FittingError(f"The {what} of a fit have shapes {shapes}, not {wanted}.")
    sizes = tuple(np.abs(target).sum(axis=0) for target in targets)
    sums = np.concatenate(sizes).tolist()
    if not all(0.0 <= size < math.inf for size in sums):
        raise FittingError(
            "The target of a fit is not finite, or so large that its sum is not; scale it down."
        )
    if factors is not None and not all((np.isfinite(f) & (f > 0.0)).all() for f in factors):
        raise FittingError("A factor on a sample's weight is not a positive finite number.")
    has_zeros = 0.0 in sums
    whole = [np.where(s > 0.0, s, 1.0) for s in sizes] if has_zeros else sizes
    scaled = tuple(t / s for t, s in zip(targets, whole, strict=True))
    return NormalizedTargets(scaled, sizes, None if factors is None else tuple(factors), has_zeros)


def optimal_answer(
    parts: Sequence[PartProgram], held: BlockSolution, request: NormalizedTargets, iterations: int
) -> tuple[LimitedSolution, tuple[Floats, ...]]:
    """Return the answer of a solver that has come to its end, and the solutions of size 1 for the next start."""
    kept, errors = [], []
    for k, part in enumerate(parts):
        found = (held.solutions[k], held.duals[k], request.targets[k])
        solution, error = refine_vertex(part, *found, request.factors_of(k))
        kept.append(solution)
        errors.append(error)
    return optimum(request, kept, errors, iterations)


def optimum(
    request: NormalizedTargets, solutions: Sequence[Floats], errors: Sequence[Floats], iterations: int
) -> tuple[LimitedSolution, tuple[Floats, ...]]:
    """Return optimal ``solutions`` of size 1 as an answer, and themselves for the next start."""
    if request.has_zeros:  # against a channel of zeros the solver's rounding is not small
        lit = [size > 0.0 for size in request.sizes]
        solutions = [np.where(on, x, 0.0) for on, x in zip(lit, solutions, strict=True)]
        errors = [np.where(on, e, 0.0) for on, e in zip(lit, errors, strict=True)]
    names = tuple((OPTIMUM,) * target.shape[1] for target in request.targets)
    return rescale_solutions(request, solutions, errors, names, True, iterations), tuple(solutions)


def rescale_solutions(
    request: NormalizedTargets,
    solutions: Sequence[Floats],
    errors: Sequence[Floats],
    methods: tuple[tuple[str, ...], ...],
    optimal: bool,
    iterations: int,
) -> LimitedSolution:
    """Return solutions and errors of targets of size 1 as those of the targets that were given."""
    relative = tuple(errors)
    if request.factors is not None:
        wholes = [(f * np.abs(t)).sum(axis=0) for f, t in zip(request.factors, request.targets, strict=True)]
        relative = tuple(e / np.where(w > 0.0, w, 1.0) for e, w in zip(errors, wholes, strict=True))
    return LimitedSolution(
        tuple(x * size for x, size in zip(solutions, request.sizes, strict=True)),
        tuple(e * size for e, size in zip(errors, request.sizes, strict=True)),
        relative,
        methods,
        optimal,
        iterations,
    )

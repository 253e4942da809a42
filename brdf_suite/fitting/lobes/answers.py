"""One request to the limited solver and what comes back: scaled targets in, weights and their errors out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.program import PartProgram
from brdf_suite.fitting.lobes.refine import refined
from brdf_suite.fitting.lobes.solver import BlockSolution

if TYPE_CHECKING:  # 3 ms with the logging that it loads, on the start-up path of programs that may not fit
    from concurrent.futures import Future

FloatArray = NDArray[np.float64]

OPTIMUM = "optimum"


@dataclass(frozen=True, eq=False)
class LimitedSolution:
    """Weights for every part and channel, and how they came about.

    ``solutions``: per part ``(m, channels)`` ≥ 0, of scaled columns, for the targets that were given;
    ``objectives``: per part ``(channels,)`` the L1 error; ``methods``: per part and channel "optimum",
    "simplex" (what it held when it was stopped), "rescaled", "least squares" or "zero"; ``optimal``: all are
    optima. ``exact`` gets the optimum, or what was made of it, once it is found in the background: ``None``
    where nothing is to be found, cancelled where a newer request came first.
    """

    solutions: tuple[FloatArray, ...]
    objectives: tuple[FloatArray, ...]
    methods: tuple[tuple[str, ...], ...]
    optimal: bool
    iterations: int
    exact: Future[Any] | None = field(default=None, repr=False)


@dataclass(frozen=True, eq=False)
class Request:
    """Targets of a size of 1 per part and channel, what they were divided by, and factors on the weights."""

    targets: tuple[FloatArray, ...]
    sizes: tuple[FloatArray, ...]
    factors: tuple[FloatArray, ...] | None

    def factors_of(self, part: int) -> FloatArray | None:
        """Return the factors of one part, or ``None``."""
        return None if self.factors is None else self.factors[part]


def request_of(
    parts: Sequence[PartProgram],
    channels: int,
    targets: Sequence[FloatArray],
    factors: Sequence[FloatArray] | None,
) -> Request:
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
    if not all(np.isfinite(size).all() for size in sizes):
        raise FittingError(
            "The target of a fit is not finite, or so large that its sum is not; scale it down."
        )
    if factors is not None and not all((np.isfinite(f) & (f > 0.0)).all() for f in factors):
        raise FittingError("A factor on a sample's weight is not a positive finite number.")
    scaled = tuple(t / np.where(s > 0.0, s, 1.0) for t, s in zip(targets, sizes, strict=True))
    return Request(scaled, sizes, None if factors is None else tuple(factors))


def optimal_answer(
    parts: Sequence[PartProgram], held: BlockSolution, request: Request, iterations: int
) -> tuple[LimitedSolution, tuple[FloatArray, ...]]:
    """Return the answer of a solver that has come to its end, and the solutions of size 1 for the next start."""
    kept, errors = [], []
    for k, part in enumerate(parts):
        solution, error = refined(
            part, held.solutions[k], held.duals[k], request.targets[k], request.factors_of(k)
        )
        # Against a channel of zeros the solver's rounding is not small.
        empty = request.sizes[k] == 0.0
        kept.append(np.where(empty, 0.0, solution))
        errors.append(np.where(empty, 0.0, error))
    names = tuple((OPTIMUM,) * target.shape[1] for target in request.targets)
    return scaled_back(request, kept, errors, names, True, iterations), tuple(kept)


def scaled_back(
    request: Request,
    solutions: Sequence[FloatArray],
    errors: Sequence[FloatArray],
    methods: tuple[tuple[str, ...], ...],
    optimal: bool,
    iterations: int,
) -> LimitedSolution:
    """Return solutions and errors of targets of size 1 as those of the targets that were given."""
    return LimitedSolution(
        tuple(x * size for x, size in zip(solutions, request.sizes, strict=True)),
        tuple(e * size for e, size in zip(errors, request.sizes, strict=True)),
        methods,
        optimal,
        iterations,
    )

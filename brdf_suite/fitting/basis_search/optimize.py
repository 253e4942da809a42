"""Optimization of a basis from one start: Levenberg-Marquardt under rising p-weights, then equation 4 itself.

Least squares of the errors raised to p/2 minimize their p-norm, which goes from the mean (p = 2) towards the maximum
(p = 16): a smooth path to the paper's ``max + mean``, which has kinks everywhere. Equation 4 alone decides what is
kept: of all bases that the steps pass through, only one with a lower value replaces the best.

Nothing here looks at a clock or at random numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from brdf_suite.arrays import Floats
from brdf_suite.fitting.basis_search.error import equation_4

ErrorFunction = Callable[[Floats], Floats]

#: Exponents a search may use. 1 is the diffuse lobe; at 116,000 the prefilter's bandlimit of 2,048 ends.
SMALLEST_EXPONENT, LARGEST_EXPONENT = 1.0, 116_000.0
LOG_ENDS = (float(np.log(SMALLEST_EXPONENT)), float(np.log(LARGEST_EXPONENT)))
#: The norms of the stages, and the most steps in one stage (the slopes of a step take one evaluation a lobe).
NORMS = (2.0, 4.0, 8.0, 16.0)
STAGE_STEPS = 8
#: Step in log exponent for slopes: above the kinks of the linear programs, below the distance of lobes.
SLOPE_STEP = 0.01
#: What a log exponent outside its ends is charged, per unit.
OUTSIDE = 10.0
#: The polish: first and last step in log exponent, and the most evaluations per lobe.
POLISH_STEPS = (0.2, 0.005)
POLISH_EVALUATIONS_PER_LOBE = 40
#: Neighbours keep at least this ratio, less 1, when they are put in order for the last time.
LEAST_GAP = 1e-3
DIGITS = 5


@dataclass(frozen=True, eq=False)
class Optimum:
    """The best basis of one start: ascending exponents, equation 4's value, evaluations of the errors it took."""

    exponents: tuple[float, ...]
    value: float
    evaluations: int


class _Best:
    """Counts evaluations and keeps the point of the lowest equation 4."""

    def __init__(self, errors: ErrorFunction, watch: Callable[[], None] | None) -> None:
        self._errors = errors
        self._watch = watch
        self.evaluations = 0
        self.value = np.inf
        self.point: Floats = np.empty(0)

    def errors(self, point: Floats) -> Floats:
        """Return the errors at log exponents ``(m,)``, clipped to their ends."""
        if self._watch is not None:
            self._watch()
        inside = np.clip(point, *LOG_ENDS)
        self.evaluations += 1
        errors = self._errors(np.exp(np.sort(inside)))
        value = equation_4(errors)
        if value < self.value:
            self.value, self.point = value, np.sort(inside)
        return errors


def optimize(
    errors: ErrorFunction, start: Sequence[float], watch: Callable[[], None] | None = None
) -> Optimum:
    """Return the best basis that is reached from the exponents ``start``.

    Parameters
    ----------
    errors
        From ascending exponents ``(m,)`` to errors ``(paints,)``, paints ≥ m; the same bits for the same input.
    start
        Exponents, in any order, clipped to the ends.
    watch
        Called before each evaluation; it ends the search by raising.
    """
    best = _Best(errors, watch)
    best.errors(np.log(np.asarray(start, dtype=np.float64)))
    for norm in NORMS:
        _least_squares(best, norm)
    _polish(best)
    return _rounded(best)


def _least_squares(best: _Best, norm: float) -> None:
    """Go downhill in the ``norm``-norm of the errors from the best point."""

    scale = float(best.errors(best.point).max()) or 1.0
    memory: dict[bytes, Floats] = {}

    def residuals(point: Floats) -> Floats:
        key = point.tobytes()
        if key not in memory:
            outside = OUTSIDE * (point - np.clip(point, *LOG_ENDS))
            memory[key] = np.concatenate([(best.errors(point) / scale) ** (0.5 * norm), outside])
        return memory[key]

    def slopes(point: Floats) -> Floats:
        here = residuals(point)
        columns = []
        for k in range(point.size):
            # Inwards at the upper end, where a step up would be clipped and seen as no change.
            step = -SLOPE_STEP if point[k] + SLOPE_STEP > LOG_ENDS[1] else SLOPE_STEP
            moved = point.copy()
            moved[k] += step
            columns.append((residuals(moved) - here) / step)
        return np.stack(columns, axis=1)

    least_squares(
        residuals, best.point.copy(), jac=slopes, method="lm", max_nfev=STAGE_STEPS, xtol=1e-4, ftol=1e-5
    )


def _polish(best: _Best) -> None:
    """Lower equation 4 itself by trying steps along directions that were good before (Powell's idea, no slopes)."""
    count = best.point.size
    budget = best.evaluations + POLISH_EVALUATIONS_PER_LOBE * count
    step, last = POLISH_STEPS
    directions = list(np.eye(count))
    while step >= last and best.evaluations < budget:
        before_value, before = best.value, best.point
        for direction in list(directions):
            for sign in (1.0, -1.0):
                here, value = best.point, best.value
                best.errors(here + sign * step * direction)
                # Go on as long as it pays, twice as far each time.
                reach = 2.0 * step
                while best.value < value and best.evaluations < budget:
                    value = best.value
                    best.errors(here + sign * reach * direction)
                    reach *= 2.0
                if best.point is not here:
                    break
        moved = best.point - before
        length = float(np.abs(moved).max())
        if best.value < before_value and length > 0.0:
            # All the moves of a round as one: the diagonal of a valley.
            directions = [*np.eye(count), moved / length]
        if best.value > before_value * (1.0 - 1e-4):
            step *= 0.5


def _rounded(best: _Best) -> Optimum:
    """Return the best point as exponents of few digits, apart from each other, with the value that they have."""
    exponents: list[float] = []
    for value in np.exp(best.point):
        lowest = exponents[-1] * (1.0 + LEAST_GAP) if exponents else SMALLEST_EXPONENT
        exponents.append(float(f"{max(float(value), lowest):.{DIGITS}g}"))
    top = LARGEST_EXPONENT
    for k in range(len(exponents) - 1, -1, -1):
        exponents[k] = min(exponents[k], top)
        top = exponents[k] / (1.0 + LEAST_GAP)
    final = _Best(best._errors, None)
    final.errors(np.log(np.array(exponents)))
    return Optimum(tuple(exponents), final.value, best.evaluations + 1)

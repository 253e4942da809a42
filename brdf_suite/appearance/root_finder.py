"""Scalar root finder for the solvers on the edit path.

Plain floats: for three channels this is many times faster than arrays, and scipy's optimizers would cost
their import when a program starts.
"""

from __future__ import annotations

from collections.abc import Callable


def bracketed_root(
    function: Callable[[float], float],
    low: float,
    high: float,
    *,
    tolerance: float = 1e-12,
    at_low: float | None = None,
    at_high: float | None = None,
) -> float:
    """Return x in [low, high] with f(x) = 0 to ``tolerance`` (in x); f must change its sign between them.

    Chandrupatla's method (Advances in Engineering Software 28, 1997, 145): inverse quadratic interpolation
    where it is safe, bisection otherwise. ``at_low`` and ``at_high`` are f there where already known.

    Raises
    ------
    ValueError
        f has the same sign at both ends.
    """
    a, b = low, high
    fa = function(a) if at_low is None else at_low
    fb = function(b) if at_high is None else at_high
    if fa == 0.0:
        return a
    if fb == 0.0:
        return b
    if (fa > 0.0) == (fb > 0.0):
        raise ValueError(f"no sign change between {low} and {high}: {fa} and {fb}")
    step = 0.5
    # Bisection alone would be done after about 50 steps; twice that is a bound, not a guess.
    for _ in range(120):
        x = a + step * (b - a)
        fx = function(x)
        if (fx > 0.0) == (fa > 0.0):
            c, fc = a, fa
        else:
            c, fc = b, fb
            b, fb = a, fa
        a, fa = x, fx
        best, f_best = (a, fa) if abs(fa) < abs(fb) else (b, fb)
        width = abs(b - a)
        if f_best == 0.0 or width <= 2.0 * tolerance:
            return best
        xi = (a - b) / (c - b)
        phi = (fa - fb) / (fc - fb)
        if phi * phi < xi and (1.0 - phi) ** 2 < 1.0 - xi:
            step = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        else:
            step = 0.5
        margin = tolerance / width
        step = min(1.0 - margin, max(margin, step))
    return best

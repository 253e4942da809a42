"""Search from one start: bounded Levenberg-Marquardt, reweighted for the sum of |log(fit/measured)|.

scipy's ``trf`` (Branch, Coleman and Li 1999) is used: Levenberg-Marquardt's step in a trust region, which is scaled by
the distance to the bounds, so that m and r stay within what is plausible - Ψ of equation 3 is then 0 all along, and no
K has to be chosen. MINPACK's ``lm`` knows no bounds; ``dogbox`` is not made for Jacobians without full rank,
and ours has none where two lobes meet or one has no weight.

|x| has no derivative at 0, so a smoothed one takes its place (:class:`Cost`), first with a wide δ, which is least
squares near the answer, then with narrow ones. Each step solves the weighted squares that touch it from above.

The solver never sees the n rows. Its steps depend on the cost C, the gradient g and the curvature H = Σ w JᵀJ alone,
and a problem of p + 1 rows has the same: with H = V S² Vᵀ, the matrix S Vᵀ above a row of zeros, and the residuals
S⁻¹ Vᵀ g above √(2C - |S⁻¹ Vᵀ g|²). So a step costs a product of matrices instead of a decomposition of n rows.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.optimize import least_squares

from brdf_suite.arrays import Floats
from brdf_suite.fitting.cook_torrance.model import LobeModel, Terms, Vector
from brdf_suite.fitting.cook_torrance.samples import LobeSamples
from brdf_suite.fitting.cook_torrance.settings import Loss

COARSE: tuple[float, ...] = (0.5,)
FINE: tuple[float, ...] = (0.1, 0.01)
"""δ of the smoothed |x|, natural logarithm: 0.01 is 1 %."""
# Cauchy's cost keeps 95 % of the efficiency of least squares where its width is so many standard deviations.
_CAUCHY = 2.385
# The normal distribution's median of |x| over its standard deviation.
_MEDIAN = 0.6745
_LEAST_SCALE = 1e-4
_TOLERANCE = 1e-6
_NO_SLOPE = 1e-14
# A direction whose curvature is so much smaller than the largest one, after scaling, is rounding.
_RANK = 1e-13
_BLOCK = 1500


@dataclass(frozen=True)
class Cost:
    """A loss function of width ``delta`` > 0 in natural logarithms, for iteratively reweighted least squares.

    For x = log(fit/measured) and the width δ, the cost is c with c(x) = x²/2 near 0, and the weight is c'(x)/x. The
    parabola that touches c at x and has this curvature lies above c everywhere, so that a step that lowers it lowers c.

    - ``linear``: x²/2.
    - ``smooth``: δ²(√(1 + (x/δ)²) - 1), for small δ δ|x|: the paper's |x|, with a derivative at 0.
    - ``cauchy``: δ²/2 log(1 + (x/δ)²), whose pull fades for outliers.
    """

    kind: Literal["linear", "smooth", "cauchy"]
    delta: float = 1.0

    def __call__(self, x: Floats) -> tuple[Floats, Floats]:
        """Return the cost and the weight of residuals, of their shape."""
        if self.kind == "linear":
            return 0.5 * x * x, np.ones_like(x)
        square = self.delta * self.delta
        z = x * x / square
        if self.kind == "smooth":
            root = np.sqrt(1.0 + z)
            # z / (1 + root) is root - 1 without its cancellation.
            return square * z / (1.0 + root), 1.0 / root
        return 0.5 * square * np.log1p(z), 1.0 / (1.0 + z)


Tick = Callable[[], None]


@dataclass(frozen=True, eq=False)
class FitProblem:
    """Samples, their terms and the model fitted to them."""

    model: LobeModel
    samples: LobeSamples
    terms: Terms

    @classmethod
    def of(cls, model: LobeModel, samples: LobeSamples) -> FitProblem:
        """Return the problem of these samples."""
        return cls(model, samples, Terms.of(samples.wi, samples.wo))

    def residuals(self, x: Vector) -> Floats:
        """Return log(fit/measured) (3, n), unweighted; 0 where nothing is known."""
        logs = self.model.logs(x, self.terms, False, self.samples.added)[0]
        return np.where(self.samples.known, logs - self.samples.logs, 0.0)

    @property
    def counted(self) -> float:
        """How many values (of one channel) there are, by their weights."""
        return float((self.samples.known * self.samples.weights).sum())

    def energy(self, x: Vector) -> float:
        """Return the mean of |log(fit/measured)| by the weights: equation 2 of the paper over its number of terms."""
        return float((np.abs(self.residuals(x)) * self.samples.weights).sum()) / self.counted

    def objective(self, x: Vector, cost: Cost) -> float:
        """Return the mean of ``cost`` by the weights."""
        return float((cost(self.residuals(x))[0] * self.samples.weights).sum()) / self.counted

    def reduced(self, x: Vector, cost: Cost) -> tuple[Floats, Floats]:
        """Return residuals (p + 1,) and a Jacobian (p + 1, p) with the cost, gradient and curvature of all."""
        logs, slopes = self.model.logs(x, self.terms, added=self.samples.added)
        assert slopes is not None
        residuals = logs - self.samples.logs
        counted = np.where(self.samples.known, self.samples.weights, 0.0)
        costs, weights = cost(residuals)
        weights *= counted
        curvature, gradient = np.zeros((self.model.size, self.model.size)), np.zeros(self.model.size)
        for channel in range(3):
            at = self.model.columns(channel)
            squares, product = products(slopes[channel], weights[channel], residuals[channel])
            curvature[np.ix_(at, at)] += squares
            gradient[at] += product
        # Columns of one length: a weight of 1e-6 and a slope may then stand in one matrix.
        length = np.sqrt(np.maximum(np.diag(curvature), 1e-300))
        squares, vectors = np.linalg.eigh(curvature / np.outer(length, length))
        squares = np.maximum(squares, _RANK * max(float(squares[-1]), 1e-300))
        roots = np.sqrt(squares)
        top = (vectors.T @ (gradient / length)) / roots
        rest = 2.0 * float((costs * counted).sum()) - float(top @ top)
        jacobian = np.vstack(((roots[:, None] * vectors.T) * length, np.zeros(self.model.size)))
        return np.append(top, np.sqrt(max(rest, 0.0))), jacobian


def products(slopes: Floats, weights: Floats, residuals: Floats) -> tuple[Floats, Floats]:
    """Return Σ w JJᵀ (q, q) and Σ w J x (q,) of ``slopes`` (q, n), in blocks too small for threads.

    Waking them takes longer than the product, and where the cores are busy it takes many times as long.
    """
    curvature, gradient = np.zeros((len(slopes), len(slopes))), np.zeros(len(slopes))
    for start in range(0, len(weights), _BLOCK):
        block = slice(start, start + _BLOCK)
        part = slopes[:, block]
        heavy = weights[block] * part
        curvature += heavy @ part.T
        gradient += heavy @ residuals[block]
    return curvature, gradient


def search(
    problem: FitProblem,
    x: Vector,
    loss: Loss,
    deltas: tuple[float, ...],
    steps: int,
    tick: Tick | None = None,
    held: int | None = None,
) -> Vector:
    """Return where the search from ``x`` ends, after at most ``steps`` evaluations for each δ.

    ``tick`` is called at each evaluation; what it raises ends the search. The parameter ``held`` stays as it is.
    """
    x = problem.model.revived(x, problem.samples.channels)
    if loss == "l2":
        return _minimize(problem, x, Cost("linear"), steps * len(deltas), tick, held)
    for delta in deltas:
        x = _minimize(problem, x, Cost("smooth", delta), steps, tick, held)
    if loss == "robust":
        x = _minimize(problem, x, Cost("cauchy", robust_width(problem, x)), steps, tick, held)
    return x


def final_cost(problem: FitProblem, x: Vector, loss: Loss) -> Cost:
    """Return the cost with which a search for ``loss`` ends."""
    if loss == "l2":
        return Cost("linear")
    return Cost("smooth", FINE[-1]) if loss == "l1" else Cost("cauchy", robust_width(problem, x))


def robust_width(problem: FitProblem, x: Vector) -> float:
    """Return the width beyond which a residual counts as an outlier, by their median size, which no outlier moves."""
    spread = float(np.median(np.abs(problem.residuals(x)[problem.samples.known]))) / _MEDIAN
    return _CAUCHY * max(spread, _LEAST_SCALE)


def _minimize(
    problem: FitProblem, x: Vector, cost: Cost, steps: int, tick: Tick | None, held: int | None = None
) -> Vector:
    # What has no weight has no slope either, and would wander.
    moved = problem.model.searched(x, problem.samples.channels)
    moved = moved[moved != held] if held is not None else moved
    if not moved.size:
        return x
    low, high = (bound[moved] for bound in problem.model.bounds())
    kept: list[tuple[bytes, Floats, Floats]] = []

    def whole(at: Vector) -> Vector:
        y = x.copy()
        y[moved] = at
        return y

    def both(at: Vector) -> tuple[Floats, Floats]:
        # The solver asks for the Jacobian where it has just asked for the residuals.
        key = at.tobytes()
        if not kept or kept[0][0] != key:
            if tick is not None:
                tick()
            few, slopes = problem.reduced(whole(at), cost)
            kept[:] = [(key, few, slopes[:, moved])]
        return kept[0][1], kept[0][2]

    def residuals(at: Vector) -> Floats:
        return both(at)[0]

    def jacobian(at: Vector) -> Floats:
        return both(at)[1]

    # The method wants a start strictly inside.
    width = high - low
    found = least_squares(
        residuals,
        np.clip(x[moved], low + 1e-6 * width, high - 1e-6 * width),
        jac=jacobian,
        bounds=(low, high),
        method="trf",
        x_scale="jac",
        max_nfev=steps,
        xtol=_TOLERANCE,
        ftol=_TOLERANCE,
        gtol=_NO_SLOPE,
    )
    return whole(np.asarray(found.x, np.float64))

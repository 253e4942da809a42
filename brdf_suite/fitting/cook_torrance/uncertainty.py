"""Uncertainty of the fitted parameters: standard errors from the Jacobian at the solution.

The answer of an estimator with influence ψ (the derivative of its cost) spreads as A⁻¹ B A⁻¹, A = Σ w ψ' JᵀJ and
B = Σ (Σ w ψ J)ᵀ(Σ w ψ J), where the inner sums run over the channels of one sample: what is wrong with a sample is
wrong in all its channels alike, and they are not taken for three measurements (White 1980, by clusters). For |x|, ψ' is
2 f(0), twice the density of the residuals at 0, which is estimated with a kernel as wide as half of their median size.

They state the random spread of the samples that the solver saw; where the model itself is wrong, neighbouring
residuals agree, and the standard errors are too small.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.fitting.cook_torrance.losses import Cost
from brdf_suite.fitting.cook_torrance.model import LobeModel, Vector
from brdf_suite.fitting.cook_torrance.solve import FitProblem, products

_LEAST_WIDTH = 1e-6
# A combination of parameters so much less determined than the best one counts as undetermined.
_RANK = 1e-12
_AT_BOUND = 1e-5


@dataclass(frozen=True, eq=False)
class StandardErrors:
    """Standard errors of kd (3,), ks (N, 3), m (N,) and r (N,); NaN where undetermined or at a bound."""

    kd: Floats
    ks: Floats
    m: Floats
    r: Floats
    correlation_ks_r: Floats
    """(N,) of log ks (mean over channels) and r: near -1 where only their product is known."""


def standard_errors(problem: FitProblem, x: Vector, cost: Cost) -> StandardErrors:
    """Return the standard errors of the answer ``x`` of a search with ``cost``."""
    model = problem.model
    logs, slopes = model.logs(x, problem.terms, added=problem.samples.added)
    assert slopes is not None
    known, weights = problem.samples.known, problem.samples.weights
    residuals = np.where(known, logs - problem.samples.logs, 0.0)
    counted = np.where(known, weights, 0.0)
    psi, curvature = _influence(residuals, known, cost)
    a = np.zeros((model.size, model.size))
    scores = np.zeros((model.size, psi.shape[1]))
    for channel in range(3):
        at = model.columns(channel)
        a[np.ix_(at, at)] += products(slopes[channel], (counted * curvature)[channel], psi[channel])[0]
        scores[at] += slopes[channel] * (counted * psi)[channel]
    b = products(scores, np.ones(psi.shape[1]), psi[0])[0]
    low, high = model.bounds()
    width = high - low
    free = (x > low + _AT_BOUND * width) & (x < high - _AT_BOUND * width) & (np.diag(a) > 0.0)
    covariance = np.full((model.size, model.size), np.nan)
    still = np.ones(model.size, np.bool_)
    still[model.searched(x, problem.samples.channels)] = False
    free &= ~still
    if free.any():
        covariance[np.ix_(free, free)] = _sandwich(a[np.ix_(free, free)], b[np.ix_(free, free)])
    return _of_values(model, x, covariance)


def _influence(residuals: Floats, known: np.ndarray, cost: Cost) -> tuple[Floats, Floats]:
    """Return ψ and what represents ψ', (3, n) each."""
    if cost.kind == "linear":
        return residuals, np.ones_like(residuals)
    if cost.kind == "cauchy":
        z = (residuals / cost.delta) ** 2
        return residuals / (1.0 + z), (1.0 - z) / (1.0 + z) ** 2
    width = max(0.5 * float(np.median(np.abs(residuals[known]))), _LEAST_WIDTH)
    density = float(np.mean((1.0 + (residuals[known] / width) ** 2) ** -1.5)) / width
    return np.sign(residuals), np.full_like(residuals, density)


def _sandwich(a: Floats, b: Floats) -> Floats:
    """Return A⁻¹ B A⁻¹, NaN for what A does not determine."""
    length = np.sqrt(np.diag(a))
    squares, vectors = np.linalg.eigh(a / np.outer(length, length))
    known = squares > _RANK * max(float(squares[-1]), 1e-300)
    inverse = (vectors[:, known] / squares[known]) @ vectors[:, known].T / np.outer(length, length)
    found = np.asarray(inverse @ b @ inverse)
    # Parameters with a component in an undetermined direction are undetermined.
    lost = (vectors[:, ~known] ** 2).sum(axis=1) > 1e-6
    found[lost, :] = np.nan
    found[:, lost] = np.nan
    return found


def _of_values(model: LobeModel, x: Vector, covariance: Floats) -> StandardErrors:
    kd, ks, m, r = model.values(x)
    spread = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    out_ks, out_m = np.full_like(ks, np.nan), np.full_like(m, np.nan)
    out_r, together = np.full_like(r, np.nan), np.full_like(r, np.nan)
    for lobe in range(model.lobes):
        place = model.m_at(lobe)
        e = float(x[place + 1])
        # -d log r/de; log ks = log a - log r.
        rise = 4.0 / max(1.0 - e * e, 1e-12)
        out_m[lobe] = m[lobe] * spread[place]
        out_r[lobe] = r[lobe] * rise * spread[place + 1]
        by_e = covariance[place + 1, place + 1]
        correlations = []
        for channel, at in enumerate(range(*model.weights_at(lobe).indices(model.size))):
            cross = covariance[at, place + 1]
            variance = covariance[at, at] + rise * rise * by_e + 2.0 * rise * cross
            if not np.isfinite(variance):
                # r at its bound, as 1 often is, is taken as known.
                variance = covariance[at, at]
            out_ks[lobe, channel] = ks[lobe, channel] * np.sqrt(max(variance, 0.0))
            # r falls with e.
            bottom = np.sqrt(max(variance * by_e, 1e-300))
            correlations.append(-(cross + rise * by_e) / bottom)
        if correlations:
            together[lobe] = np.mean(correlations)
    return StandardErrors(kd * spread[:3], out_ks, out_m, out_r, together)

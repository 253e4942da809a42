"""How far the parameters of a fit may move within the noise: the misfit's profile over each, and other minima.

Two vectors x and y differ in misfit by D = Σ w (c(y) - c(x)), c the cost of a residual. How much of that is chance
follows from the same differences summed over regions of the samples, within which errors agree: their standard
deviation s, times the root of their number (Vuong 1989, by clusters). A minimum with D ≤ 1.96 s cannot be
distinguished from the answer. Along a profile, where one parameter is held and the others are fitted again, D grows
with the square of the distance and s with the distance; D ≤ 1.96 s/2 there gives the 95 % interval of the covariance
where the misfit is a parabola, and the right one where it is not.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from brdf_suite.arrays import Floats, Indices
from brdf_suite.fitting.cook_torrance.model import LobeModel, Terms, Vector
from brdf_suite.fitting.cook_torrance.result import Alternative, Profile, StandardErrors, sums_by_region
from brdf_suite.fitting.cook_torrance.settings import Loss
from brdf_suite.fitting.cook_torrance.solve import FINE, Cost, FitProblem, search

SIGMAS = 1.96
"""Standard errors on each side of a stated 95 % interval."""
_FACTORS = (1.0, 2.0, 4.0, 8.0, 16.0)
_STEPS = 25
_LONGEST_STEP = 1.0
_LOWER = 1e-5
# Minima nearer than this in r, or in log m, are the same one.
_SAME_R, _SAME_LOG_M = 0.03, 0.05
_MOST_ALTERNATIVES = 5
# A parameter at its bound is stated without an error, unless another answer moves it by more than this share.
_MOVED = 0.05
_HERMITE = ((0.0, 2.0 / 3.0), (-math.sqrt(3.0), 1.0 / 6.0), (math.sqrt(3.0), 1.0 / 6.0))
"""Places, in standard deviations, and weights of the mean over a normal distribution, exact to the fifth power."""


@dataclass(frozen=True, eq=False)
class Noise:
    """What chance does to the difference in misfit between ``best`` and other answers of one problem."""

    problem: FitProblem
    best: Vector
    cost: Cost

    def ratio(self, x: Vector) -> float:
        """Return D/(1.96 s): at most 1 where ``x`` cannot be distinguished from the best answer; negative if better."""
        sums = sums_by_region((self._costs(x) - self._best_costs)[None], self._regions)[0]
        spread = float(np.sqrt(len(sums)) * sums.std(ddof=1)) if len(sums) > 1 else 0.0
        difference = float(sums.sum())
        return difference / (SIGMAS * spread) if spread > 0.0 else (0.0 if difference <= 0.0 else np.inf)

    def _costs(self, x: Vector) -> Floats:
        """Return the cost (n,) of each sample, over its channels, by its weight."""
        samples = self.problem.samples
        counted = np.where(samples.known, samples.weights, 0.0)
        return np.asarray((counted * self.cost(self.problem.residuals(x))[0]).sum(axis=0))

    @cached_property
    def _best_costs(self) -> Floats:
        return self._costs(self.best)

    @cached_property
    def _regions(self) -> Indices:
        return self.problem.samples.regions


def profiles_of(
    noise: Noise, covariance: Floats, loss: Loss, tick: Callable[[], None] | None = None
) -> tuple[tuple[Profile, ...], Vector | None]:
    """Return the profile over each parameter that has a variance, and a vector with less misfit if one is met."""
    found: list[Profile] = []
    for parameter in np.flatnonzero(np.isfinite(np.diag(covariance))).tolist():
        step = min(SIGMAS * float(np.sqrt(covariance[parameter, parameter])), _LONGEST_STEP)
        if step <= 0.0:
            continue
        rows = [(float(noise.best[parameter]), noise.problem.energy(noise.best))]
        ends = []
        for side in (-step, step):
            end, better = _one_side(noise, parameter, side, loss, rows, tick)
            if better is not None:
                return tuple(found), better
            ends += [] if end is None else [end]
        values, energies = (np.array(column) for column in zip(*sorted(rows), strict=True))
        found.append(Profile(parameter, values, energies, tuple(ends)))
    return tuple(found), None


def _one_side(
    noise: Noise,
    parameter: int,
    step: float,
    loss: Loss,
    rows: list[tuple[float, float]],
    tick: Callable[[], None] | None,
) -> tuple[Vector | None, Vector | None]:
    """Follow the profile to where the noise ends; return the vector there, or one of less misfit than the best."""
    low, high = (float(bound[parameter]) for bound in noise.problem.model.bounds())
    before, before_ratio, end = noise.best, 0.0, None
    for factor in _FACTORS:
        x = before.copy()
        x[parameter] = min(max(noise.best[parameter] + factor * step, low), high)
        x = search(noise.problem, x, loss, FINE[-1:], _STEPS, tick, parameter)
        ratio, energy = 2.0 * noise.ratio(x), noise.problem.energy(x)
        rows.append((float(x[parameter]), energy))
        if energy < noise.problem.energy(noise.best) * (1.0 - _LOWER) and ratio < 0.0:
            return None, search(noise.problem, x, loss, FINE, 2 * _STEPS, tick)
        if ratio > 1.0:
            # D/s grows evenly: where it is 1 lies between.
            share = (1.0 - before_ratio) / (ratio - before_ratio)
            return (None if end is None else before + share * (x - before)), None
        before, before_ratio, end = x, max(ratio, 0.0), x
        if x[parameter] in (low, high):
            break
    return end, None


def blurred_once_more(
    problem: FitProblem, best: Vector, loss: Loss, tick: Callable[[], None] | None = None
) -> tuple[Vector, ...]:
    """Return the answer for data that the instrument's pixels blur a second time, and its mirror image about the best.

    The first blur is in the data; what the second one does to the answer is what the first one did to it, and so the
    mirror image is nearer to the truth (simulation-extrapolation, Cook and Stefanski 1994). None for an instrument
    without pixels.
    """
    samples, model = problem.samples, problem.model
    if samples.instrument.pixel_rad <= 0.0:
        return ()
    tilt = samples.instrument.tilt_rad(samples)[:, None]
    plain = np.exp(model.logs(best, problem.terms, False, samples.added)[0])
    blurred = np.zeros_like(plain)
    for (one, share), (other, part) in itertools.product(_HERMITE, repeat=2):
        axis = np.array((one, other, 0.0))
        wi, wo = (w + tilt * np.cross(axis, w) for w in (samples.wi, samples.wo))
        wi, wo = (w / np.linalg.norm(w, axis=1)[:, None] for w in (wi, wo))
        blurred += share * part * np.exp(model.logs(best, Terms.of(wi, wo), False, samples.added)[0])
    change = np.where(samples.known, np.log(blurred / plain), 0.0)
    twice = FitProblem(model, replace(samples, logs=samples.logs + change), problem.terms)
    x = search(twice, best, loss, FINE, 2 * _STEPS, tick)
    return x, np.clip(2.0 * best - x, *model.bounds())


def alternatives_of(noise: Noise, minima: Sequence[Vector]) -> tuple[Alternative, ...]:
    """Return those of other minima that the noise does not distinguish from the best answer, the best first."""
    model, kept = noise.problem.model, [noise.best]
    found: list[Alternative] = []
    for x in sorted((model.sorted(y) for y in minima), key=noise.problem.energy):
        if len(found) == _MOST_ALTERNATIVES:
            break
        alike = [model.dead(x, lobe) == model.dead(noise.best, lobe) for lobe in range(model.lobes)]
        if not all(alike) or any(_same(model, x, y) for y in kept) or noise.ratio(x) > 1.0:
            continue
        kept.append(x)
        found.append(Alternative(*model.values(x), noise.problem.energy(x)))
    return tuple(found)


def _same(model: LobeModel, x: Vector, y: Vector) -> bool:
    (_, _, m, r), (_, _, other_m, other_r) = model.values(x), model.values(y)
    near = np.abs(r - other_r) < _SAME_R
    return bool((near & (np.abs(np.log(m / other_m)) < _SAME_LOG_M)).all())


def widened(
    errors: StandardErrors,
    model: LobeModel,
    best: Vector,
    profiles: Sequence[Profile],
    alternatives: Sequence[Alternative],
    blurred: Sequence[Vector] = (),
) -> StandardErrors:
    """Return the standard errors such that 1.96 of them reach every end of the profiles and every alternative.

    What a second blur changes is added as a standard error of its own (:func:`blurred_once_more`).
    """
    names = ("kd", "ks", "m", "r")
    values = dict(zip(names, model.values(best), strict=True))
    others = [dict(zip(names, model.values(end), strict=True)) for one in profiles for end in one.ends]
    others += [{name: getattr(one, name) for name in names} for one in alternatives]
    wide = {name: np.array(getattr(errors, name)) for name in names}
    for other in others:
        for name in names:
            away = np.abs(other[name] - values[name])
            stated = np.isfinite(wide[name]) | (away > _MOVED * values[name])
            wide[name] = np.where(stated, np.fmax(wide[name], away / SIGMAS), wide[name])
    if blurred:
        both = [dict(zip(names, model.values(x), strict=True)) for x in blurred]
        for name in names:
            away = np.max([np.abs(other[name] - values[name]) for other in both], axis=0)
            stated = np.isfinite(wide[name]) | (away > _MOVED * values[name])
            wide[name] = np.where(stated, np.hypot(np.nan_to_num(wide[name]), away), wide[name])
    return replace(errors, **wide)

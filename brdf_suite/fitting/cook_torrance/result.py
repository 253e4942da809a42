"""Result of a fit of lobes: parameters and their errors, a reflectance, and a paint."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field
from functools import cached_property

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Floats, Indices, triple
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.errors import FittingError
from brdf_suite.fitting.cook_torrance.model import LobeModel, Terms, Vector
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.fitting.cook_torrance.solve import Cost, FitProblem, products
from brdf_suite.reflectance.blocks import in_blocks

_LEAST_WIDTH = 1e-6
# A combination of parameters so much less determined than the best one counts as undetermined.
_RANK = 1e-12
_AT_BOUND = 1e-5
# Relative standard errors above this are reported.
_POORLY_DETERMINED = 0.5


@dataclass(frozen=True, eq=False)
class StandardErrors:
    """Standard errors of kd (3,), ks (N, 3), m (N,) and r (N,); NaN where undetermined or at a bound."""

    kd: Floats
    ks: Floats
    m: Floats
    r: Floats
    correlation_ks_r: Floats
    """(N,) of log ks (mean over channels) and r: near -1 where only their product is known."""


def covariance_of(problem: FitProblem, x: Vector, cost: Cost) -> Floats:
    """Return the covariance (p, p) of the answer ``x`` of a search with ``cost``; NaN where undetermined or at a bound.

    The answer of an estimator with influence ψ (the derivative of its cost) spreads as A⁻¹ B A⁻¹, A = Σ w ψ' JᵀJ and
    B = Σ (Σ w ψ J)ᵀ(Σ w ψ J), where the inner sums run over the channels of one sample: what is wrong with a sample is
    wrong in all its channels alike, and they are not taken for three measurements (White 1980, by clusters). For |x|,
    ψ' is 2 f(0), twice the density of the residuals at 0, estimated with a kernel as wide as half of their median size.

    Where the model, or the instrument, errs, neighbouring residuals agree too. So B is formed a second time with inner
    sums over the regions of the samples, and a parameter has the larger of the two spreads. What the instrument is
    known to err by, alike within a region, is added: A⁻¹ Σ (Σ w ψ' J δ)ᵀ(Σ w ψ' J δ) A⁻¹ for its relative error δ.
    """
    model = problem.model
    logs, slopes = model.logs(x, problem.terms, added=problem.samples.added)
    assert slopes is not None
    known, weights = problem.samples.known, problem.samples.weights
    residuals = np.where(known, logs - problem.samples.logs, 0.0)
    counted = np.where(known, weights, 0.0)
    psi, curvature = _influence(residuals, known, cost)
    a = np.zeros((model.size, model.size))
    scores, leverage = np.zeros((2, model.size, psi.shape[1]))
    for channel in range(3):
        at = model.columns(channel)
        a[np.ix_(at, at)] += products(slopes[channel], (counted * curvature)[channel], psi[channel])[0]
        scores[at] += slopes[channel] * (counted * psi)[channel]
        leverage[at] += slopes[channel] * (counted * curvature)[channel]
    low, high = model.bounds()
    width = high - low
    free = (x > low + _AT_BOUND * width) & (x < high - _AT_BOUND * width) & (np.diag(a) > 0.0)
    covariance = np.full((model.size, model.size), np.nan)
    still = np.ones(model.size, np.bool_)
    still[model.searched(x, problem.samples.channels)] = False
    free &= ~still
    if free.any():
        inner, scores = a[np.ix_(free, free)], scores[free]
        found = _sandwich(inner, products(scores, np.ones(psi.shape[1]), psi[0])[0])
        by_region = sums_by_region(scores, problem.samples.regions)
        regions = by_region.shape[1]
        if regions > 1:
            apart = np.diag(_sandwich(inner, by_region @ by_region.T * (regions / (regions - 1))))
            single = np.diag(found)
            wider = np.divide(apart, single, out=np.ones_like(single), where=single > 0.0)
            wider = np.sqrt(np.fmax(wider, 1.0))
            found *= np.outer(wider, wider)
        error = problem.samples.instrument.relative_error
        if error > 0.0:
            moved = error * sums_by_region(leverage[free], problem.samples.regions)
            found += _sandwich(inner, moved @ moved.T)
        covariance[np.ix_(free, free)] = found
    return covariance


def sums_by_region(values: Floats, regions: Indices) -> Floats:
    """Return the sums (k, regions) of ``values`` (k, n) over the samples of each region."""
    count = int(regions.max()) + 1
    return np.stack([np.bincount(regions, row, count) for row in values])


def _influence(residuals: Floats, known: Bools, cost: Cost) -> tuple[Floats, Floats]:
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


def standard_errors(model: LobeModel, x: Vector, covariance: Floats) -> StandardErrors:
    """Return the standard errors of the values of ``x`` from the covariance (p, p) of its logarithms and 1/n."""
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


@dataclass(frozen=True, eq=False)
class Profile:
    """The misfit where one parameter is held, and all others are fitted again.

    ``parameter``: its number in the vector of :mod:`brdf_suite.fitting.cook_torrance.model`; ``values`` (k,) rising, in
    the vector's terms; ``energies`` (k,): the mean misfit there. ``ends``: the vectors at both ends of what the noise
    leaves possible, where they lie beyond the covariance's.
    """

    parameter: int
    values: Floats
    energies: Floats
    ends: tuple[Vector, ...]


@dataclass(frozen=True, eq=False)
class Alternative:
    """Another minimum of the misfit that the noise does not distinguish from the answer; fields as of the fit."""

    kd: Floats
    ks: Floats
    m: Floats
    r: Floats
    energy_mean: float

    def to_json(self) -> dict[str, object]:
        """Return the parameters and the misfit as plain values."""
        count = range(len(self.m))
        lobes = [{name: _plain(getattr(self, name)[lobe]) for name in ("ks", "m", "r")} for lobe in count]
        return {"kd": _plain(self.kd), "lobes": lobes, "energy_mean": self.energy_mean}


@dataclass(frozen=True, eq=False)
class CookTorranceFit:
    """Lobes fitted to samples; a reflectance itself, reciprocal and never negative.

    ``dropped`` are the lobes that the samples did not ask for: their weight is 0. ``kd`` (3,) is the diffuse
    reflectance, ``ks`` (N, 3) the weights of the lobes, the sharp one last (a clearcoat has ¼), ``m`` (N,) their slopes
    (α of GGX), and ``r`` (N,) their Fresnel reflectances along the normal. ``standard_errors`` cover ``profiles`` and
    ``alternatives``: 1.96 of them on both sides are the stated 95 % interval.
    """

    model: LobeModel
    vector: Vector
    settings: Settings
    standard_errors: StandardErrors
    problem: FitProblem
    dropped: tuple[int, ...] = ()
    profiles: tuple[Profile, ...] = ()
    alternatives: tuple[Alternative, ...] = ()
    kd: Floats = field(init=False)
    ks: Floats = field(init=False)
    m: Floats = field(init=False)
    r: Floats = field(init=False)

    def __post_init__(self) -> None:
        for name, values in zip(("kd", "ks", "m", "r"), self.model.values(self.vector), strict=True):
            object.__setattr__(self, name, values)

    @cached_property
    def energy_mean(self) -> float:
        """Mean of |log(fit/measured)| over the values that the solver saw: equation 2 over its number of terms."""
        return self.problem.energy(self.vector)

    @property
    def energy(self) -> float:
        """Equation 2 of Günther et al. 2005 itself, a sum; Ψ is 0, since every parameter is plausible."""
        return self.energy_mean * self.problem.counted

    @cached_property
    def log_rms(self) -> float:
        """RMS of log(fit/measured) over the values that the solver saw, by their weights."""
        squares = self.problem.residuals(self.vector) ** 2 * self.problem.samples.weights
        return math.sqrt(float(squares.sum()) / self.problem.counted)

    @property
    def samples(self) -> int:
        """How many samples the solver saw."""
        return len(self.problem.samples)

    @property
    def left_out(self) -> int:
        """How many samples could not be used."""
        return self.problem.samples.left_out

    @property
    def notices(self) -> tuple[str, ...]:
        """Notices for the user."""
        notices = []
        used = self.problem.samples
        if used.left_out:
            notices.append(
                f"{used.left_out:,} samples are left out: black, not finite, not weighted, or seen at more than "
                f"{self.settings.grazing_deg:g}° from the normal."
            )
        if used.black and not used.floor.share:
            notices.append(f"{used.black:,} values of 0 or less have no logarithm and are left out.")
        elif used.black:
            notices.append(
                f"{100.0 * used.black_share:.1f} % of the values are 0 or less: colours outside of the working space, "
                f"or noise. To all, and to the fit, {100.0 * used.floor.share:g} % of the sample's brightest channel "
                f"and {used.floor.dark:.2g} /sr are added before the logarithm."
            )
        for channel, name in enumerate(("red", "green", "blue")):
            if not used.channels[channel]:
                notices.append(f"There is nothing in the {name} channel; its weights are 0.")
        if self.dropped:
            left, count = self.model.lobes - len(self.dropped), len(self.dropped)
            does = {0: "No lobe does", 1: "One lobe does"}.get(left, f"{left} lobes do")
            has = "the first has" if count == 1 else f"the first {count} have"
            notices.append(f"{does} as well as {self.model.lobes}; {has} no weight.")
        for lobe in range(self.model.lobes):
            if lobe in self.dropped:
                continue
            error = float(self.standard_errors.r[lobe])
            if not math.isfinite(error) and self.r[lobe] < 0.999:
                notices.append(
                    f"The Fresnel reflectance of lobe {lobe + 1} is not determined by these samples."
                )
            elif math.isfinite(error) and error > _POORLY_DETERMINED * float(self.r[lobe]):
                known = f"r is {self.r[lobe]:.2g} ± {error:.1g}"
                notices.append(f"Of lobe {lobe + 1} only ks times r is known: {known}.")
        for other in self.alternatives:
            lobe = int(np.argmax(np.abs(other.r - self.r)))
            notices.append(
                f"Another answer fits as well within the noise: for lobe {lobe + 1} it has m {other.m[lobe]:.2g} and "
                f"r {other.r[lobe]:.2g} instead of {self.m[lobe]:.2g} and {self.r[lobe]:.2g}. The stated uncertainties "
                "cover both."
            )
        return tuple(notices)

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(lambda light, view: np.asarray(self._parts(light, view).sum(axis=0)), wi, wo)

    def parts(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return (1 + N, ..., 3): f_r of the diffuse part and of each lobe, which sum to :meth:`eval`."""
        light, view = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        found = self._parts(light.reshape(-1, 3), view.reshape(-1, 3))
        return found.reshape(len(found), *light.shape)

    def _parts(self, light: Floats, view: Floats) -> Floats:
        above = (light[:, 2] > 0.0) & (view[:, 2] > 0.0)
        found = np.zeros((1 + self.model.lobes, len(light), 3))
        if above.any():
            terms = Terms.of(light[above], view[above])
            found[:, above] = self.model.parts(self.vector, terms).transpose(0, 2, 1)
        # What stands at the least weight is 0 here too.
        found[0] *= self.kd > 0.0
        found[1:] *= self.ks[:, None, :] > 0.0
        return found

    def paint(self, name: str, source: str = "", notes: str = "") -> CookTorrancePaint:
        """Return the lobes, but for those without weight, as a paint that every program opens.

        Raises
        ------
        FittingError
            The lobes are not of Cook and Torrance's kind, for which alone there are documents.
        ValueRangeError
            The data reflect so much that a parameter leaves a paint's range.
        """
        if self.model.name != "cook-torrance":
            advice = "fit cook-torrance, or write a table"
            raise FittingError(f"Lobes of the model {self.model.name} cannot be saved as a paint; {advice}.")
        lobes = tuple(
            CookTorranceLobe(triple(ks), float(m), float(r))
            for number, (ks, m, r) in enumerate(zip(self.ks, self.m, self.r, strict=True))
            if number not in self.dropped
        )
        return CookTorrancePaint(name, triple(self.kd), lobes, notes=notes, source=source)

    def to_json(self) -> dict[str, object]:
        """Return everything as plain values; undetermined values are null."""
        errors = self.standard_errors
        columns = {
            "ks": self.ks,
            "ks_standard_error": errors.ks,
            "m": self.m,
            "m_standard_error": errors.m,
            "r": self.r,
            "r_standard_error": errors.r,
            "correlation_ks_r": errors.correlation_ks_r,
        }
        count = range(self.model.lobes)
        lobes = [{name: _plain(column[lobe]) for name, column in columns.items()} for lobe in count]
        return {
            "model": self.model.name,
            "settings": asdict(self.settings),
            "kd": self.kd.tolist(),
            "kd_standard_error": _plain(errors.kd),
            "lobes": lobes,
            "energy": self.energy,
            "energy_mean": self.energy_mean,
            "log_rms": self.log_rms,
            "samples": self.samples,
            "left_out": self.left_out,
            "lobes_without_weight": len(self.dropped),
            "alternatives": [other.to_json() for other in self.alternatives],
            "profiles": [
                {"parameter": name, "values": values.tolist(), "energies_mean": one.energies.tolist()}
                for one in self.profiles
                for name, values in [self.model.named(one.parameter, one.values)]
            ],
            "notices": list(self.notices),
        }


def _plain(values: npt.ArrayLike) -> object:
    """Return numbers as JSON data; None for non-finite ones."""
    array = np.asarray(values, np.float64)
    if array.ndim == 0:
        return float(array) if math.isfinite(float(array)) else None
    return [_plain(one) for one in array]

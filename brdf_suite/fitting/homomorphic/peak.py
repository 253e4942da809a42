"""Separation of the specular peak: a factorization of the truncated body, and the peak as its own product.

Logarithms discount a peak, and smoothness wears it down (McCool, Ang and Ahmad 2001, sections 3.1.1 and 4.2). So values
are clamped before they are factored, and what was cut off is added again: f_r = α Π maps + s(h) F(ω·h).

Where to cut is not a level: a metallic paint's body is a hundred times brighter near the mirror direction than aside,
and is still a product. What is cut is what stands out over a product, by a factor: the body is fitted, clamped at so
many times itself, and fitted again, until the peak has no say in it.

s is fitted as any factor. F starts from a formula, since a measured peak is met by a handful of samples, most of them
at one incidence each, and a free map over ω·h runs away between and beyond them. Of four formulas (none, Fresnel's,
Fresnel's over ω·h and over (ω·h)², the last being microfacets with the shadowing of Kelemen and Szirmay-Kalos 2001) the
nearest is taken, and a stiff map then bends it as far as the samples insist.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.fitting.homomorphic.factorization import Factorization
from brdf_suite.fitting.homomorphic.product_fit import (
    DEFAULT_RESOLUTION,
    DEFAULT_SMOOTHNESS,
    FactorizationResult,
    factorize,
)
from brdf_suite.fitting.homomorphic.samples import FactorizationSamples
from brdf_suite.geometry import warps
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, PROJECTIONS, Factor, parse_factors
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.progress import Progress, report, subrange

PeakForm = Literal["radial", "map"]
PEAK_FORMS: tuple[str, ...] = get_args(PeakForm)
"""``radial``: s over the root of the half vector's radius, fine at the normal; ``map``: s over the hemisphere."""
PEAK_BIAS = 1e-2
"""Over the mean of the clamped values, which no peak raises."""
MEASURED_SMOOTHNESS = 4.0
"""λ for scattered measurements: with less, maps ring at the angles that the instrument stood at."""
DEFAULT_CUT = 3.0
"""Values beyond so many times the body are peak."""
RADIAL_TEXELS, FRESNEL_TEXELS = 64, 32
INDEX = 1.5
_LEAST_COSINE = 0.1
"""Of ω·h in F, which has no bound at grazing; 84°."""
_ROUNDS = 3
_TRUSTED = 0.7
"""Of the logarithm, how far below the body a sample may lie and keep half its weight."""
_MOST_IN_ROUNDS = 20_000
_FIRST_QUANTILE = 0.9
_PEAK_WITHIN_DEG = 30.0
"""Of the half vector from the normal: where half the light (by both cosines) of what stands out is, if it is a peak."""
_STANDS_OUT = 2.0
"""Times the body: what weighs fully in the fit of the peak."""
_BESIDE_WEIGHT = 0.1
_FLOOR_NEAR, _FLOOR_FAR = 0.05, 5e-4
"""Of the body: what the peak is taken for where nothing stands out, near the normal and beyond the peak's reach."""
_REACH_SHARE, _REACH_MARGIN, _LEAST_REACH_DEG = 0.995, 1.5, 2.0
_LEAST_LEFT = 0.3
"""Of a clamped value: what the body keeps where the peak takes more than all."""
_SMOOTHNESS, _STIFFNESS = 1.0, 30.0
"""λ of s, and of the map that bends F."""
_PEAK_FIT_BIAS = 1e-12
"""The rest is over 0 everywhere, and its dark end is wanted dark."""


@dataclass(frozen=True, eq=False)
class FactorizationWithPeak:
    """f_r = ``product`` + ``peak``, in 1/sr; ``peak`` is s(h) F(ω·h), or ``None`` without a peak."""

    product: Factorization
    peak: Factorization | None

    @property
    def reciprocal(self) -> bool:
        """Whether exchanging light and view changes nothing: the half vector does not."""
        return self.product.reciprocal

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        body = self.product.eval(wi, wo)
        return body if self.peak is None else body + self.peak.eval(wi, wo)


def factorize_with_peak(
    samples: FactorizationSamples,
    *,
    cut: float = DEFAULT_CUT,
    form: PeakForm = "radial",
    factors: str | tuple[Factor, ...] = DEFAULT_FACTORS,
    resolution: int = DEFAULT_RESOLUTION,
    smooth: float = DEFAULT_SMOOTHNESS,
    bias: float = PEAK_BIAS,
    weights: npt.ArrayLike | None = None,
    progress: Progress | None = None,
) -> tuple[FactorizationWithPeak, FactorizationResult]:
    """Factor ``samples`` clamped at ``cut`` times (over 1) the body itself, and the clamped remainder.

    All channels of a sample are cut by one factor, so that what is left keeps its colour. Other arguments as of
    :func:`~brdf_suite.fitting.homomorphic.product_fit.factorize`; ``bias`` is over the mean of what is left.

    Raises
    ------
    ValueRangeError, FittingError
        As :func:`~brdf_suite.fitting.homomorphic.product_fit.factorize`; or ``cut`` or ``form`` is not as above.
    """
    if not cut > 1.0:
        raise ValueRangeError("cut", f"expected more than 1 time the body, not {cut:g}")
    if form not in PEAK_FORMS:
        raise ValueRangeError("peak", f"expected one of {', '.join(PEAK_FORMS)}, not {form!r}")
    chosen = parse_factors(factors) if isinstance(factors, str) else factors
    body = partial(
        factorize, factors=chosen, resolution=resolution, smooth=smooth, bias=bias, keep_mean=False
    )
    share = np.ones(len(samples)) if weights is None else np.asarray(weights, np.float64)
    good = np.isfinite(samples.values).all(axis=1)
    good &= np.isfinite(samples.wi).all(axis=1) & np.isfinite(samples.wo).all(axis=1)
    good &= (samples.wi[:, 2] > 0.0) & (samples.wo[:, 2] > 0.0)
    kept = samples.part(good)
    kept = replace(kept, values=np.maximum(kept.values, 0.0))
    if not len(kept) or share.shape != good.shape:
        # Let the one place that says what is wrong with samples say it.
        body(samples.wi, samples.wo, samples.values, weights=weights)
    share = share[good]
    few, few_share = kept, share
    if len(kept) > _MOST_IN_ROUNDS:
        drawn = np.random.default_rng(len(kept)).permutation(len(kept))[:_MOST_IN_ROUNDS]
        few, few_share = kept.part(drawn), share[drawn]
    grey = _grey(few.values)
    # Of those that reflect at all: where few do, the quantile of all would leave nothing.
    lit = grey[grey > 0.0]
    clamped = _clamped(few.values, float(np.quantile(lit, _FIRST_QUANTILE)) if lit.size else 0.0)
    rough = body(few.wi, few.wo, clamped, weights=few_share).product
    for number in range(_ROUNDS - 1):
        held = _grey(rough.eval(few.wi, few.wo))
        clamped = _clamped(few.values, cut * held)
        step = subrange(progress, 0.1 * number, 0.1 * (number + 1))
        trusted = few_share * _trust(few, held, bias)
        rough = body(few.wi, few.wo, clamped, weights=trusted, progress=step).product
    texels = RADIAL_TEXELS if form == "radial" else resolution
    s = Factor("s", PROJECTIONS["sqrt|h|" if form == "radial" else "h"], texels)
    first = _peak(few, few_share, rough, s, cut, fresnel_maps(), subrange(progress, 0.2, 0.3))
    held = _grey(rough.eval(kept.wi, kept.wo))
    clamped = _clamped(kept.values, cut * held)
    left, seen = clamped, share * _trust(kept, held, bias)
    if first is not None:
        added = first.product.eval(kept.wi, kept.wo)
        left = np.clip(kept.values - added, _LEAST_LEFT * clamped, clamped)
        # Under the peak the body is a small difference of large numbers: there it is inferred from its neighbourhood.
        seen = seen * held / np.maximum(held + _grey(added), 1e-300)
    found = body(kept.wi, kept.wo, left, weights=seen, progress=subrange(progress, 0.3, 0.8))
    peak = None
    if first is not None:
        last = _peak(kept, share, found.product, s, cut, (first.formula,), subrange(progress, 0.8, 1.0))
        peak = (last or first).product
    raised = int((samples.values[good] < 0.0).any(axis=1).sum())
    result = replace(found, left_out=len(samples) - found.used, raised=raised)
    return FactorizationWithPeak(found.product, peak), result


@dataclass(frozen=True, eq=False)
class _Peak:
    """A peak, the formula (n, 3) of its F, and its mean squared distance from the rest, of logarithms."""

    product: Factorization
    formula: Floats
    miss: float


def _grey(values: Floats) -> Floats:
    return np.asarray(values @ LUMINANCE)


def _trust(samples: FactorizationSamples, held: Floats, bias: float) -> Floats:
    """Return weights (n,) of samples beside a product of luminance ``held`` (n,): less of what lies far below it.

    An instrument that misses the surface at grazing reads 0, or a tenth of what it should. A few of those bend a map
    over the angle of incidence by orders of magnitude, and with it all that it gives beyond the last sample.
    """
    floor = bias * float(held.mean()) + 1e-300
    below = np.minimum(np.log((_grey(samples.values) + floor) / (held + floor)), 0.0)
    return np.asarray(1.0 / (1.0 + (below / _TRUSTED) ** 2))


def _clamped(values: Floats, limit: npt.ArrayLike) -> Floats:
    """Cut all channels of each value by one factor to a luminance of at most ``limit``."""
    share = np.minimum(1.0, np.asarray(limit) / np.maximum(_grey(values), 1e-300))
    return np.asarray(values * share[:, None])


def fresnel_maps() -> tuple[Floats, ...]:
    """Return log F (n, 3) over ω·h of each formula, 0 at the normal: 1, Fresnel's, that over ω·h and over (ω·h)²."""
    cosine = np.maximum((np.arange(FRESNEL_TEXELS) + 0.5) / FRESNEL_TEXELS, _LEAST_COSINE)
    rise = np.log(fresnel_dielectric(cosine, INDEX) / fresnel_dielectric(1.0, INDEX))
    greys = (np.zeros_like(rise), rise, rise - np.log(cosine), rise - 2.0 * np.log(cosine))
    return tuple(np.repeat(np.asarray(grey, np.float64)[:, None], 3, axis=1) for grey in greys)


def _peak(
    samples: FactorizationSamples,
    weights: Floats,
    product: Factorization,
    s: Factor,
    cut: float,
    formulas: tuple[Floats, ...],
    progress: Progress | None = None,
) -> _Peak | None:
    """Return what stands out over ``product``, or None where nothing does.

    Where nothing stands out the peak is taken for a small share of the body: near the normal for one that no noise can
    be distinguished from, beyond the peak's reach for next to nothing.
    """
    body = product.eval(samples.wi, samples.wo)
    over = _grey(samples.values) - _STANDS_OUT * _grey(body)
    out = over > 0.0
    if not (_grey(samples.values) > cut * _grey(body)).any():
        return None
    tilt = np.degrees(np.arccos(np.clip(warps.half_vector(samples.wi, samples.wo)[:, 2], -1.0, 1.0)))
    light = np.maximum(over, 0.0) * samples.wi[:, 2] * samples.wo[:, 2]
    if float(light[tilt < _PEAK_WITHIN_DEG].sum()) < 0.5 * float(light.sum()):
        return None
    order = np.argsort(tilt)
    held = np.cumsum(np.maximum(over[order], 0.0))
    last = tilt[order][min(int(np.searchsorted(held, _REACH_SHARE * held[-1])), len(order) - 1)]
    near = tilt < max(_REACH_MARGIN * float(last), _LEAST_REACH_DEG)
    rest = np.maximum(samples.values - body, np.where(near, _FLOOR_NEAR, _FLOOR_FAR)[:, None] * body)
    share = weights * np.where(out & near, 1.0, _BESIDE_WEIGHT)
    standing = weights * (out & near)
    found = []
    for number, formula in enumerate(formulas):
        report(progress, number / len(formulas), "peak")
        found.append(_against(samples, rest, share, standing, s, formula))
    return min(found, key=lambda one: one.miss)


def _against(
    samples: FactorizationSamples, rest: Floats, weights: Floats, standing: Floats, s: Factor, formula: Floats
) -> _Peak:
    """Return s(h) F(ω·h), F from the logarithms (n, 3) of a formula.

    ``weights`` (n,) are of all samples, ``standing`` of those that stand out alone.
    """
    f = Factor("f", PROJECTIONS["w.h"], FRESNEL_TEXELS)
    given = Factorization((f,), {"f": formula}, np.ones(3)).eval(samples.wi, samples.wo)
    parts = []
    fit = partial(factorize, samples.wi, samples.wo, bias=_PEAK_FIT_BIAS, keep_mean=False)
    for factor, smooth, share in ((s, _SMOOTHNESS, weights), (f, _STIFFNESS, standing)):
        one = fit(rest / given, factors=(factor,), smooth=smooth, weights=share).product
        given = given * one.eval(samples.wi, samples.wo)
        parts.append(one)
    miss = float(np.average(np.log(rest / given) ** 2, axis=0, weights=standing**2).mean())
    logs = {"s": parts[0].logs["s"], "f": formula + parts[1].logs["f"]}
    return _Peak(Factorization((s, f), logs, parts[0].alpha * parts[1].alpha), formula, miss)

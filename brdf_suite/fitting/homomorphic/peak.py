"""The specular part apart: a factorization of what is left when the peak is cut off, and the peak as a map of its own.

Logarithms discount a peak, and smoothness wears it down (McCool, Ang and Ahmad 2001, sections 3.1.1 and 4.2). So
values are clamped before they are factored, and what was cut off is kept as a sum: f_r = α Π maps + s(h), s over the
half vector and not negative.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.errors import ValueRangeError
from brdf_suite.fitting.homomorphic.constraints import Layout, constraints, smoothness
from brdf_suite.fitting.homomorphic.factorization import Factorization
from brdf_suite.fitting.homomorphic.factorize import (
    BIAS,
    DEFAULT_RESOLUTION,
    DEFAULT_SMOOTHNESS,
    Factorized,
    factorize,
)
from brdf_suite.fitting.homomorphic.samples import Samples
from brdf_suite.fitting.homomorphic.solve import solve
from brdf_suite.geometry.directions import Floats
from brdf_suite.geometry.factor_projections import PROJECTIONS
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, Factor, parse_factors
from brdf_suite.geometry.map_look_up import bilinear
from brdf_suite.progress import Progress, part
from brdf_suite.reflectance.blocks import in_blocks

DEFAULT_CUT = 4.0
"""Values beyond so many times the median of their channel are peak."""
_PEAK_SMOOTHNESS = 0.02


@dataclass(frozen=True, eq=False)
class WithPeak:
    """f_r = the product + ``peak`` (n, n, 3) at the half vector, in 1/sr, a parabolic map, not negative."""

    product: Factorization
    peak: Floats

    @property
    def reciprocal(self) -> bool:
        """Whether exchanging light and view changes nothing: the half vector does not."""
        return self.product.reciprocal

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        texels, weights = bilinear(PROJECTIONS["h"].places(wi, wo), self.peak.shape[:2])
        added = np.einsum("kc,kcj->kj", weights, self.peak.reshape(-1, 3)[texels])
        above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
        return np.asarray(self.product.eval(wi, wo) + np.where(above[:, None], added, 0.0))


def factorize_with_peak(
    samples: Samples,
    *,
    cut: float = DEFAULT_CUT,
    factors: str | tuple[Factor, ...] = DEFAULT_FACTORS,
    resolution: int = DEFAULT_RESOLUTION,
    smooth: float = DEFAULT_SMOOTHNESS,
    bias: float = BIAS,
    progress: Progress | None = None,
) -> tuple[WithPeak, Factorized]:
    """Factor ``samples`` cut off at ``cut`` medians (over 1), and fit what the cut took.

    The rest is fitted by its absolute error times √(cosθi cosθo). All channels of a sample are cut by one factor, so
    that what is left keeps its colour.

    Raises
    ------
    ValueRangeError, FittingError
        As :func:`~brdf_suite.fitting.homomorphic.factorize.factorize`; or ``cut`` is not over 1.
    """
    if not cut > 1.0:
        raise ValueRangeError("cut", f"more than 1 median is wanted, not {cut:g}")
    chosen = parse_factors(factors) if isinstance(factors, str) else factors
    good = np.isfinite(samples.values).all(axis=1) & (samples.wi[:, 2] > 0.0) & (samples.wo[:, 2] > 0.0)
    kept = samples.part(good)
    values = np.maximum(kept.values, 0.0)
    size = values.mean(axis=1)
    limit = cut * float(np.median(size)) if len(size) else 0.0
    share = np.minimum(1.0, limit / np.maximum(size, 1e-300)) if limit > 0.0 else np.ones(len(size))
    clamped = values * share[:, None]
    found = factorize(
        kept.wi,
        kept.wo,
        clamped,
        factors=chosen,
        resolution=resolution,
        smooth=smooth,
        bias=bias,
        progress=part(progress, 0.0, 0.7),
    )
    rest = np.where(share[:, None] < 1.0, values - found.product.eval(kept.wi, kept.wo), 0.0)
    layout = Layout.of((Factor("peak", PROJECTIONS["h"]),), resolution)
    matrix = constraints(layout, kept.wi, kept.wo)
    unknowns = solve(
        matrix,
        smoothness(layout),
        _PEAK_SMOOTHNESS,
        rest,
        np.sqrt(kept.wi[:, 2] * kept.wo[:, 2]),
        np.zeros((layout.count, 3)),
        "direct",
        part(progress, 0.7, 1.0),
    )
    # Where the product alone is too bright the sum would want a negative peak; light has none.
    peak = np.maximum(layout.maps(unknowns)["peak"], 0.0)
    return WithPeak(found.product, peak), found

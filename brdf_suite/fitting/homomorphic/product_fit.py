"""Homomorphic factorization: the product of positive maps with the least relative error at samples.

McCool, Ang and Ahmad 2001. Samples are put through the logarithm (equation 6); the sum of the maps' logarithms is
fitted to them by least squares, with the maps' Laplacian for what the samples leave open (equation 17); the exponential
gives positive maps. The least squares are of the logarithm, and so of the relative error.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy import sparse

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError, ValueRangeError
from brdf_suite.fitting.homomorphic.factorization import Factorization, normalize_maps
from brdf_suite.fitting.homomorphic.solve import (
    MapLayout,
    Solver,
    constraints,
    regularization,
    solve,
    way_for,
)
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, Factor, parse_factors
from brdf_suite.progress import Progress, report, subrange

BIAS = 1e-5
"""ε of equation 6, as the paper has it: for values without noise."""
DEFAULT_RESOLUTION = 32
DEFAULT_SMOOTHNESS = 0.1
MOST_SMOOTHNESS = 1e6
_COARSEST = 8


@dataclass(frozen=True, eq=False)
class FactorizationResult:
    """Result of a factorization.

    ``product``: the maps. ``mean_correction`` (3,): what α was multiplied by so that the approximation reflects as
    much over the samples as they do; 1 where it was not asked for. ``used``: samples that took part, ``left_out``:
    those that were not finite, or below the horizon; ``raised``: negative ones that were taken for 0. ``solver``: the
    way that was taken.
    """

    product: Factorization
    mean_correction: Floats
    used: int
    left_out: int
    raised: int
    solver: str


def factorize(
    wi: npt.ArrayLike,
    wo: npt.ArrayLike,
    values: npt.ArrayLike,
    *,
    factors: str | tuple[Factor, ...] = DEFAULT_FACTORS,
    resolution: int = DEFAULT_RESOLUTION,
    smooth: float = DEFAULT_SMOOTHNESS,
    bias: float = BIAS,
    weights: npt.ArrayLike | None = None,
    keep_mean: bool = True,
    solver: Solver = "auto",
    progress: Progress | None = None,
) -> FactorizationResult:
    """Factor samples of a reflectance.

    Parameters
    ----------
    wi, wo
        Unit directions (n, 3) to light and view; samples below the horizon are left out.
    values
        f_r (n, 3) in 1/sr, linear working space; what is not finite is left out, what is negative taken for 0.
    factors
        As of :func:`~brdf_suite.geometry.factor_words.parse_factors`.
    resolution
        Texels along each axis of every map, 2 to 512.
    smooth
        λ of equation 17, beside rows of samples of weight 1; more is smoother. At least 0.
    bias
        ε of equation 6, over 0, at most 1: what is added to each value, over their mean. It represents an error of
        measurement: values far below it are taken as good as dark.
    weights
        (n,) of the samples' rows (equation 19), finite, not negative; None: all 1.
    keep_mean
        Whether α is corrected so that the mean of f_r cosθi cosθo over the samples is kept: for even samples the energy
        (section 3.1.1).

    Raises
    ------
    FittingError
        No sample is left, or all are 0 in a channel: there is nothing to fit.
    ValueRangeError
        Shapes, resolution, smoothness, weights or factors are not as above.
    """
    if not (np.isfinite(smooth) and 0.0 <= smooth <= MOST_SMOOTHNESS):
        raise ValueRangeError("smoothness", f"expected 0 to {MOST_SMOOTHNESS:g}, not {smooth:g}")
    if not 0.0 < bias <= 1.0:
        raise ValueRangeError("bias", f"expected more than 0 and at most 1, not {bias:g}")
    chosen = parse_factors(factors) if isinstance(factors, str) else factors
    samples = _checked(wi, wo, values, weights)
    scale = samples.values.mean(axis=0)
    lit = scale > 0.0
    if not lit.any():
        raise FittingError("Every sample is 0: there is nothing to factor.")
    # A channel without light has nothing to say about its maps: flat ones, and an α that is as good as none.
    scale = np.where(lit, scale, bias * scale.max())
    wanted = np.log((samples.values + bias * scale) / scale)

    unknowns = MapLayout.of(chosen, resolution).count
    # Directly found, the answer needs no guess; by iteration it is found sooner from that of a coarser map.
    way = way_for(solver, unknowns)
    sizes = [resolution]
    while way == "iterative" and sizes[0] % 2 == 0 and sizes[0] // 2 >= _COARSEST:
        sizes.insert(0, sizes[0] // 2)
    logs: Mapping[str, Floats] = {}
    for number, size in enumerate(sizes):
        step = subrange(progress, 0.95 * number / len(sizes), 0.95 * (number + 1) / len(sizes))
        layout = MapLayout.of(chosen, size)
        matrix = constraints(layout, samples.wi, samples.wo)
        if number == 0:
            start = average_samples(matrix, layout, wanted)
        else:
            larger = {name: enlarge_map(log, layout.shapes[name]) for name, log in logs.items()}
            start = layout.unknowns(larger)
        found = solve(matrix, regularization(layout), smooth, wanted, samples.weights, start, way, step)
        if not np.isfinite(found).all():
            raise FittingError("The factorization has no finite answer; more smoothness may help.")
        logs = layout.maps(found)
    product = normalize_maps(chosen, logs, scale)
    correction = np.ones(3)
    if keep_mean:
        report(progress, 0.95, "mean")
        product, correction = correct_mean(product, samples.wi, samples.wo, samples.values, samples.weights)
    return FactorizationResult(
        product, correction, len(samples.values), samples.left_out, samples.raised, way
    )


@dataclass(frozen=True, eq=False)
class _Samples:
    wi: Floats
    wo: Floats
    values: Floats
    weights: Floats | None
    left_out: int
    raised: int


def _checked(
    wi: npt.ArrayLike, wo: npt.ArrayLike, values: npt.ArrayLike, weights: npt.ArrayLike | None
) -> _Samples:
    light, view, given = (np.asarray(array, np.float64) for array in (wi, wo, values))
    if given.ndim != 2 or given.shape[1] != 3 or light.shape != given.shape or view.shape != given.shape:
        reason = f"expected (n, 3) each, not {light.shape}, {view.shape}, {given.shape}"
        raise ValueRangeError("samples", reason)
    keep = np.isfinite(given).all(axis=1) & np.isfinite(light).all(axis=1) & np.isfinite(view).all(axis=1)
    keep &= (light[:, 2] > 0.0) & (view[:, 2] > 0.0)
    share = None
    if weights is not None:
        share = np.asarray(weights, np.float64)
        if share.shape != keep.shape or not np.isfinite(share).all() or (share < 0.0).any():
            raise ValueRangeError("weights", "expected one finite number a sample, not negative")
        keep &= share > 0.0
        share = share[keep]
    if not keep.any():
        raise FittingError("No sample is finite and above the horizon: there is nothing to factor.")
    given = given[keep]
    raised = int((given < 0.0).any(axis=1).sum())
    return _Samples(light[keep], view[keep], np.maximum(given, 0.0), share, int((~keep).sum()), raised)


def correct_mean(
    product: Factorization, wi: Floats, wo: Floats, values: Floats, weights: Floats | None = None
) -> tuple[Factorization, Floats]:
    """Return ``product`` with α such that it reflects as much over samples as their ``values``, and by what factor.

    What is compared is the mean of f_r cosθi cosθo, in each channel: with both cosines, since a reflectance may be
    without bounds at grazing angles, where it sends little. Samples that are not finite do not count.
    """
    keep = np.isfinite(values).all(axis=1) & (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
    share = wi[keep, 2] * wo[keep, 2]
    if weights is not None:
        share = share * weights[keep] ** 2
    approximate = product.eval(wi[keep], wo[keep])
    wanted, found = (np.average(array, axis=0, weights=share) for array in (values[keep], approximate))
    correction = np.where(found > 0.0, wanted / np.where(found > 0.0, found, 1.0), 1.0)
    correction = np.where(correction > 0.0, correction, 1.0)
    return Factorization(product.factors, product.logs, product.alpha * correction), correction


def average_samples(matrix: sparse.csr_array, layout: MapLayout, wanted: Floats) -> Floats:
    """Return unknowns (n, channels): means of the logarithms ``wanted`` (samples, channels), shared by the factors.

    A texel takes the mean of its samples, by their bilinear weights, over the number of factors; one without a sample
    takes the mean of all.
    """
    mass = np.asarray(matrix.sum(axis=0)).ravel()
    everywhere = wanted.mean(axis=0)
    held = (matrix.T @ wanted) / np.maximum(mass, 1e-12)[:, None]
    means = np.where(mass[:, None] > 1e-9, held, everywhere)
    return np.asarray(means / len(layout.factors))


def enlarge_map(values: Floats, shape: tuple[int, ...]) -> Floats:
    """Return a map (n, channels) or (n, n, channels) interpolated to ``shape`` texels, centres over the same square."""
    for axis, size in enumerate(shape):
        old = values.shape[axis]
        at = np.clip((np.arange(size) + 0.5) * old / size - 0.5, 0.0, old - 1.0)
        low = np.minimum(at.astype(np.int64), max(old - 2, 0))
        share = (at - low).reshape([-1 if axis == i else 1 for i in range(values.ndim)])
        upper = np.minimum(low + 1, old - 1)
        values = np.take(values, low, axis=axis) * (1.0 - share) + np.take(values, upper, axis=axis) * share
    return values

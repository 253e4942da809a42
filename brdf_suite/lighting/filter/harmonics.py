"""Spherical harmonic analysis and synthesis on rings, float64, in plain numpy.

A function on rings ``θ_j`` is first Fourier-transformed along each ring; what remains, for each order m, is a
sum over degrees with the associated Legendre functions

    ``F_m(θ_j) = Σ_l a_lm P̄_lm(cosθ_j)``    and    ``a_lm = 2π Σ_j w_j P̄_lm(cosθ_j) F_m(θ_j)``.

P̄ is never stored whole. Rings are taken in blocks of ``_RINGS``; for one block, ``k = l - m`` runs upwards
for all orders at once, ``_STEPS`` values at a time, and each lot is one batch of matrix products. With
``a_l = √((4l²-1)/(l²-m²))`` the recurrence is ``P̄_l = a_l·x·P̄_(l-1) - (a_l/a_(l-1))·P̄_(l-2)``. Taking
``P̄_l = c_l·p_l`` with ``c_l = c_(l-1)·a_l/2`` leaves one product less per value:

    ``p_l = 2x·p_(l-1) - 4/a_(l-1)²·p_(l-2)``,

and the c_l, which need no ring, go to the coefficients. P̄_mm = N_m sin^m θ is formed in logarithms and
scaled by ``e^_LIFT``, so that bandlimits up to about 2,000 stay above the smallest double. Parity in k halves
the rings: rings north and south of the equator enter as sum (even k) and difference (odd k).
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Complexes, Floats
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.progress import Progress, report

MAX_BANDLIMIT = 2048
_RINGS = 32
_STEPS = 16
_LIFT = 300.0
_MAX_WORKERS = 8
_Item = TypeVar("_Item")


def worker_count() -> int:
    """Return how many threads the transforms share: the processors this process may use, at most 8."""
    usable = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return max(1, min(_MAX_WORKERS, usable))


def legendre_starts(bandlimit: int) -> Floats:
    """Return log N_m (bandlimit+1,), where P̄_mm = N_m sin^m θ."""
    m = np.arange(1, bandlimit + 1, dtype=np.float64)
    growth = np.concatenate([[0.0], np.cumsum(0.5 * np.log1p(0.5 / m))])
    return np.asarray(growth - 0.5 * np.log(4.0 * np.pi), dtype=np.float64)


class LegendreScale:
    """Constants of the recurrence for one bandlimit: log N_m, β_km and the factors c_km."""

    def __init__(self, bandlimit: int) -> None:
        if not 0 <= bandlimit <= MAX_BANDLIMIT:
            raise ValueError(f"the bandlimit must be 0…{MAX_BANDLIMIT}, not {bandlimit}")
        self.bandlimit = bandlimit
        m = np.arange(bandlimit + 1, dtype=np.float64)
        self.log_start = legendre_starts(bandlimit)
        k = m[:, None]
        previous = m[None, :] + k - 1.0  # the degree l - 1, over (k, m)
        with np.errstate(divide="ignore", invalid="ignore"):
            self.beta: Floats = (previous**2 - m**2) / (previous**2 - 0.25)
            degree = previous + 1.0
            log_half_a = 0.5 * np.log((degree**2 - 0.25) / (degree**2 - m**2))
        log_half_a[0] = 0.0
        log_c = np.cumsum(log_half_a, axis=0)
        log_c[k + m > bandlimit] = -np.inf
        self.factors: Floats = np.exp(log_c)  # (k, m); 0 beyond the bandlimit


def _lots(scale: LegendreScale, cosines: Floats, orders: int) -> Iterator[tuple[int, int, Floats]]:
    """Yield (first k, number of orders, p (orders, _STEPS, rings)) from k = 0 to the bandlimit."""
    limit = scale.bandlimit
    rings = cosines.size
    lot = np.zeros((orders, _STEPS, rings))
    spare = np.empty((orders, rings))
    twice = 2.0 * cosines
    sine_log = 0.5 * np.log1p(-cosines * cosines)
    m = np.arange(orders)[:, None]
    start = np.exp(np.maximum(scale.log_start[:orders, None] + m * sine_log + _LIFT, -745.0))
    last, before = start, np.zeros((orders, rings))
    for first in range(0, limit + 1, _STEPS):
        count = min(orders, limit - first + 1)
        for step in range(min(_STEPS, limit - first + 1)):
            k = first + step
            now = lot[:count, step]
            if k == 0:
                now[...] = start
            else:
                product = spare[:count]
                np.multiply(last[:count], twice, out=now)
                np.multiply(before[:count], scale.beta[k, :count, None], out=product)
                now -= product
            before, last = last, lot[:, step]
        yield first, count, lot[:count]
        # The next lot overwrites the place of the last two values of this one.
        before, last = before[:count].copy(), last[:count].copy()


def _orders_on(cosines: Floats, bandlimit: int) -> int:
    """Return how many orders matter on these rings: P̄_lm is negligible where m is far beyond l·sinθ."""
    reach = bandlimit * float(np.sqrt(1.0 - np.min(np.abs(cosines)) ** 2))
    margin = 24.0 + 6.0 * bandlimit ** (1.0 / 3.0)
    return min(bandlimit, int(np.ceil(reach + margin))) + 1


def run_all(
    pool: ThreadPoolExecutor,
    work: Callable[[_Item], None],
    items: Iterable[_Item],
    progress: Progress | None = None,
    what: str = "",
) -> None:
    """Run ``work`` on every item in the pool (numpy frees the lock); report and cancel between them."""
    futures = [pool.submit(work, item) for item in items]
    try:
        for done, future in enumerate(futures):
            future.result()
            report(progress, (done + 1) / len(futures), what)
    except BaseException:
        for future in futures:
            future.cancel()
        raise


def analyse(
    orders: Complexes, weights: Floats, cosines: Floats, bandlimit: int, progress: Progress | None = None
) -> Complexes:
    """Return coefficients (bandlimit+1 (m), bandlimit+1 (k = l-m), channels) of functions on symmetric rings.

    Parameters
    ----------
    orders
        F_m (rings, bandlimit+1, channels): mean over each ring of ``f·e^(-imφ)``.
    weights
        Quadrature weights (rings,) in cosθ; they sum to 2.
    cosines
        cosθ (rings,), descending and symmetric about 0.
    """
    rings, _, channels = orders.shape
    half = (rings + 1) // 2
    weighted = orders * (2.0 * np.pi * weights)[:, None, None]
    north, south = weighted[:half], weighted[::-1][:half]
    if rings % 2:
        middle = np.ones(half)
        middle[-1] = 0.5  # the equator is its own mirror image
        north, south = north * middle[:, None, None], south * middle[:, None, None]
    # (parity, m, ring, channel as re/im pairs)
    both = np.empty((2, orders.shape[1], half, channels), np.complex128)
    np.add(north, south, out=both[0].transpose(1, 0, 2))
    np.subtract(north, south, out=both[1].transpose(1, 0, 2))
    pairs = both.view(np.float64)
    del weighted, north, south
    scale = LegendreScale(bandlimit)
    starts = range(0, half, _RINGS)
    sums = [np.zeros((bandlimit + 1, bandlimit + 1, 2 * channels)) for _ in range(worker_count())]
    free = list(range(len(sums)))

    def work(block: int) -> None:
        mine = free.pop()
        total = sums[mine]
        rows = slice(starts[block], min(starts[block] + _RINGS, half))
        count = _orders_on(cosines[rows], bandlimit)
        for first, used, lot in _lots(scale, cosines[rows], count):
            for parity in (0, 1):
                target = total[:used, first + parity : first + _STEPS : 2]
                values = np.matmul(lot[:, parity::2], pairs[parity, :used, rows])
                target += values[:, : target.shape[1]]
        free.append(mine)

    with ThreadPoolExecutor(worker_count()) as pool:
        run_all(pool, work, range(len(starts)), progress, "analysing the environment")
    result: Floats = np.sum(sums, axis=0)
    result *= (scale.factors.T * np.exp(-_LIFT))[:, :, None]
    coefficients: Complexes = result.view(np.complex128)
    return coefficients


def synthesise(coefficients: Complexes, cosines: Floats, progress: Progress | None = None) -> Complexes:
    """Return F_m (m, rings, channels) of coefficients (m, k, channels) on rings as in :func:`analyse`."""
    bandlimit = coefficients.shape[0] - 1
    channels = coefficients.shape[2]
    rings = cosines.size
    half = (rings + 1) // 2
    scale = LegendreScale(bandlimit)
    scaled = coefficients * (scale.factors.T * np.exp(-_LIFT))[:, :, None]
    # (m, channel as re/im pairs, k)
    rows_of = np.ascontiguousarray(np.ascontiguousarray(scaled).view(np.float64).transpose(0, 2, 1))
    result = np.zeros((bandlimit + 1, rings, channels), dtype=np.complex128)
    starts = range(0, half, _RINGS)

    def work(block: int) -> None:
        north = np.arange(starts[block], min(starts[block] + _RINGS, half))
        count = _orders_on(cosines[north], bandlimit)
        sums = np.zeros((2, count, 2 * channels, north.size))
        for first, used, lot in _lots(scale, cosines[north], count):
            for parity in (0, 1):
                part = rows_of[:used, :, first + parity : first + _STEPS : 2]
                if part.shape[2]:
                    sums[parity, :used] += np.matmul(part, lot[:, parity::2][:, : part.shape[2]])
        for rows, values in ((rings - 1 - north, sums[0] - sums[1]), (north, sums[0] + sums[1])):
            pairs = np.ascontiguousarray(values.transpose(0, 2, 1))
            result[:count, rows] = pairs.view(np.complex128)

    with ThreadPoolExecutor(worker_count()) as pool:
        run_all(pool, work, range(len(starts)), progress, "filtering")
    return result


SIGMAS = 6.0
"""Bandlimit in units of √n: right to 1e-5 of the sky beside a sun 10⁵ times as bright."""

COAT_IOR = 1.5
"""Of coats that light crosses. Between n = 1.4 and 1.7 the shape of T over its value at 45° hardly differs."""
MIN_BANDLIMIT = 32
BROAD_BANDLIMIT = 255
"""Bandlimit of lobes with a slow tail (small n), and the most that the first, broad pass needs."""


def lobe_coefficients(exponent: float, bandlimit: int) -> NDArray[np.float64]:
    """Return k_l, l = 0…bandlimit, of the unit-gain cosine lobe ``(n+1)/(2π)·max(0, cosδ)^n``.

    It is zonal, so convolving with it multiplies every coefficient of degree l by ``k_l``, the lobe's Legendre
    coefficient ``(n+1)·∫₀¹ x^n P_l(x) dx``. Integrating by parts with the recurrence of P_l gives ``k_0 = 1,
    k_1 = (n+1)/(n+2), k_l = k_(l-2)·(n-l+2)/(n+l+1)`` for any real n > -1.


    >>> lobe_coefficients(1.0, 2)
    array([1.        , 0.66666667, 0.25      ])
    """
    k = np.empty(bandlimit + 1)
    for start, first in ((0, 1.0), (1, (exponent + 1.0) / (exponent + 2.0))):
        degrees = np.arange(start + 2, bandlimit + 1, 2)
        ratios = (exponent - degrees + 2.0) / (exponent + degrees + 1.0)
        if start <= bandlimit:
            k[start::2] = first * np.concatenate([[1.0], np.cumprod(ratios)])
    return k


def lobe_bandlimit(exponent: float, tolerance: float = 1e-6) -> int:
    """Return the degree above which the lobe of an exponent is left out.

    6√n for sharp lobes. For small n the lobe has a kink at its rim, and its coefficients fall only like
    l^-(n+1.5): then the smallest degree whose whole tail, ``Σ (2l+1)/4π·|k_l|``, is below ``tolerance`` of
    the lobe's peak ``(n+1)/2π``, at most ``BROAD_BANDLIMIT``.
    """
    sharp = max(MIN_BANDLIMIT, int(np.ceil(SIGMAS * np.sqrt(exponent))))
    if sharp >= BROAD_BANDLIMIT:
        return sharp
    degrees = np.arange(4 * BROAD_BANDLIMIT)
    terms = (2.0 * degrees + 1.0) / (4.0 * np.pi) * np.abs(lobe_coefficients(exponent, degrees.size - 1))
    tail = np.cumsum(terms[::-1])[::-1]
    below = np.nonzero(tail[1:] <= tolerance * (exponent + 1.0) / (2.0 * np.pi))[0]
    by_tail = int(below[0]) if below.size else BROAD_BANDLIMIT
    return min(max(sharp, by_tail), BROAD_BANDLIMIT)


def largest_exponent(rings: int) -> float:
    """Return the largest exponent that a map of so many rings can be filtered with: √n = rings / 4.3.

    A sharper lobe lies between the rings: Fejér's rule no longer integrates it, and a constant environment
    would come out 1.6 % wrong at four times this exponent. The environment itself is then the better lobe
    map. The transforms end at a bandlimit of 2,048, which no exponent above 116,508 keeps within.
    """
    return min(float((rings / 4.3) ** 2), (MAX_BANDLIMIT / SIGMAS) ** 2)


def lobe_tail(exponent: float, bandlimit: int) -> tuple[Floats, Floats]:
    """Return angles (n,) 0…π and, at each, the unit-gain lobe minus its sum up to ``bandlimit``."""

    def lobe(cosine: Floats) -> Floats:
        return (exponent + 1.0) / (2.0 * np.pi) * cosine**exponent

    return _tail(lobe, lobe_coefficients(exponent, bandlimit))


def coat_crossing(cosine: Floats) -> Floats:
    """Return T over T(45°) at cosines (...) of a coat of the index :data:`COAT_IOR`."""
    at_fit = 1.0 - float(fresnel_dielectric(math.cos(math.pi / 4.0), COAT_IOR))
    return np.asarray((1.0 - fresnel_dielectric(cosine, COAT_IOR)) / at_fit)


@lru_cache(maxsize=1)
def coated_coefficients(bandlimit: int) -> Floats:
    """Return k_l, l = 0…bandlimit, of ``max(0, cosδ)·T(δ)``, scaled to unit gain: of diffuse light through a coat."""
    cosine, weights = _half_sphere()
    values = weights * cosine * coat_crossing(cosine)
    k = np.polynomial.legendre.legvander(cosine, bandlimit).T @ values
    return np.asarray(k / k[0])


@lru_cache(maxsize=1)
def coated_tail(bandlimit: int) -> tuple[Floats, Floats]:
    """Return what :func:`lobe_tail` does, of diffuse light through a coat."""
    cosine, weights = _half_sphere()
    gain = 2.0 * np.pi * float(weights @ (cosine * coat_crossing(cosine)))
    return _tail(lambda c: c * coat_crossing(c) / gain, coated_coefficients(bandlimit))


def _half_sphere() -> tuple[Floats, Floats]:
    """Return cosines (n,) 0 to 1 and the weights of their quadrature."""
    x, weights = np.polynomial.legendre.leggauss(4 * BROAD_BANDLIMIT)
    return 0.5 * (x + 1.0), 0.5 * weights


def _tail(kernel: Callable[[Floats], Floats], coefficients: Floats) -> tuple[Floats, Floats]:
    """Return angles (n,) 0…π and what a kernel (of cosines ≥ 0) is there above its sum of Legendre coefficients."""
    angles = np.linspace(0.0, np.pi, 24 * len(coefficients))
    cosine = np.cos(angles)
    terms = coefficients * (2.0 * np.arange(len(coefficients)) + 1.0) / (4.0 * np.pi)
    whole = kernel(np.maximum(cosine, 0.0))
    return angles, whole - np.polynomial.legendre.legval(cosine, terms)

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

import os
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from brdf_suite.arrays import Complexes, Floats
from brdf_suite.progress import Progress, report

MAX_BANDLIMIT = 2048
_RINGS = 32
_STEPS = 16
_LIFT = 300.0
_MAX_WORKERS = 8


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


def _run(work: Callable[[int], None], blocks: int, progress: Progress | None, what: str) -> None:
    """Run ``work`` on every block on a few threads (numpy frees the lock); report and cancel between them."""
    with ThreadPoolExecutor(worker_count()) as pool:
        futures = [pool.submit(work, block) for block in range(blocks)]
        try:
            for done, future in enumerate(futures):
                future.result()
                report(progress, (done + 1) / blocks, what)
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

    _run(work, len(starts), progress, "analysing the environment")
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

    _run(work, len(starts), progress, "filtering")
    return result

"""Compiled Legendre sums of :mod:`brdf_suite.lighting.filter.harmonics`: the same recurrence, vectorised ring by ring.

Imported by :mod:`brdf_suite.lighting.filter.kernels.compilation` alone. Rings come as blocks in pairs, north and
south of the equator, **from the equator outwards**: those that an order m does not reach stand at the end, and every
inner loop runs from 0, which is what the compiler's vectoriser wants. Values that a double cannot hold start at 0
and stay there; arithmetic on denormal numbers would be six times as slow.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.compilation import Array, compiled

_LIFT = 400.0


@compiled
def order_start(m: int, limit: int) -> int:
    """Return where the coefficients of an order begin: one order after the other, degrees m … limit of each."""
    return m * (2 * limit + 3 - m) // 2


@compiled
def _reached(m: int, limit: int, cosine: Array) -> int:
    """Return how many rings, from the equator on, order m matters on: P̄_lm is nothing where m ≫ l·sinθ."""
    low = (m - 24.0 - 6.0 * limit ** (1.0 / 3.0)) / max(limit, 1)
    count: int = cosine.size
    while count > 0 and low > 0.0 and 1.0 - cosine[count - 1] ** 2 < low * low:
        count -= 1
    return count


@compiled
def _start(m: int, count: int, log_start: Array, sine_log: Array, twice: Array, last: Array) -> None:
    """Put p of k = 0 and 1 into ``last``."""
    for r in range(count):
        exponent = log_start[m] + _LIFT + m * sine_log[r]
        value = math.exp(exponent) if exponent > -_LIFT else 0.0
        last[0, r] = value
        last[1, r] = value * twice[r]


@compiled
def _advance(count: int, m: int, k: int, twice: Array, last: Array, values: Array, row: int) -> None:
    """Put p of k … k+3 into four rows of ``values`` and those of k+4, k+5 into ``last``."""
    square = float(m) * m
    d = m + k + 1.0
    beta_2 = (d * d - square) / (d * d - 0.25)
    d += 1.0
    beta_3 = (d * d - square) / (d * d - 0.25)
    d += 1.0
    beta_4 = (d * d - square) / (d * d - 0.25)
    d += 1.0
    beta_5 = (d * d - square) / (d * d - 0.25)
    p = values[row : row + 4]
    for r in range(count):
        x = twice[r]
        p_0 = last[0, r]
        p_1 = last[1, r]
        p_2 = x * p_1 - beta_2 * p_0
        p_3 = x * p_2 - beta_3 * p_1
        p_4 = x * p_3 - beta_4 * p_2
        p[0, r] = p_0
        p[1, r] = p_1
        p[2, r] = p_2
        p[3, r] = p_3
        last[0, r] = p_4
        last[1, r] = x * p_4 - beta_5 * p_3


@compiled
def _factors(m: int, limit: int, steps: int, factors: Array) -> None:
    """Fill c_km of k = 0 … with the lift taken out; 0 beyond the bandlimit, up to a whole number of steps."""
    square = float(m) * m
    value = math.exp(-_LIFT)
    for k in range(steps * (1 + (limit - m) // steps)):
        if k > 0:
            d = float(m + k)
            value *= math.sqrt((d * d - 0.25) / (d * d - square))
        factors[k] = value if m + k <= limit else 0.0


@compiled
def _collect(count: int, p: Array, parity: int, light: Array, row: Array, k: int, factors: Array) -> None:
    """Add the sums over rings of two degrees, k + parity and k + parity + 2, to a row of coefficients."""
    a_0 = a_1 = a_2 = a_3 = a_4 = a_5 = 0.0
    b_0 = b_1 = b_2 = b_3 = b_4 = b_5 = 0.0
    f = light[6 * parity : 6 * parity + 6]
    for r in range(count):
        a = p[parity, r]
        b = p[parity + 2, r]
        a_0 += a * f[0, r]
        a_1 += a * f[1, r]
        a_2 += a * f[2, r]
        a_3 += a * f[3, r]
        a_4 += a * f[4, r]
        a_5 += a * f[5, r]
        b_0 += b * f[0, r]
        b_1 += b * f[1, r]
        b_2 += b * f[2, r]
        b_3 += b * f[3, r]
        b_4 += b * f[4, r]
        b_5 += b * f[5, r]
    at = k + parity
    if at < row.shape[0] and factors[at] > 0.0:
        c = factors[at]
        row[at, 0] += a_0 * c
        row[at, 1] += a_1 * c
        row[at, 2] += a_2 * c
        row[at, 3] += a_3 * c
        row[at, 4] += a_4 * c
        row[at, 5] += a_5 * c
    at += 2
    if at < row.shape[0] and factors[at] > 0.0:
        c = factors[at]
        row[at, 0] += b_0 * c
        row[at, 1] += b_1 * c
        row[at, 2] += b_2 * c
        row[at, 3] += b_3 * c
        row[at, 4] += b_4 * c
        row[at, 5] += b_5 * c


@compiled
def analyse_rings(
    spectrum: Array,
    weights: Array,
    cosine: Array,
    columns: int,
    first_angle: float,
    log_start: Array,
    first: int,
    end: int,
    limit: int,
    result: Array,
) -> None:
    """Add what a block of ring pairs gives to the coefficients of orders ``first`` … ``end - 1``.

    Parameters
    ----------
    spectrum
        (3, 2, rings, ≥ columns//2+1) complex: means over the rings of ``f·e^(-imφ)``, φ counted from the first
        column; [:, 0] north, [:, 1] south, from the equator outwards.
    weights, cosine
        (rings,) quadrature weights times 2π, and cosθ ≥ 0, descending angles from the equator.
    first_angle
        φ of the first column.
    limit, result
        The bandlimit, and ((limit+1)·(limit+2)/2, 6): three channels as pairs of real and imaginary part, for
        each order m the limit - m + 1 degrees from m on (:func:`order_start`).
    """
    rings = cosine.size
    light = np.empty((12, rings))
    p = np.empty((4, rings))
    last = np.empty((2, rings))
    factors = np.empty(limit + 5)
    twice = 2.0 * cosine
    sine_log = 0.5 * np.log1p(-cosine * cosine)
    for m in range(first, min(end, limit + 1)):
        count = _reached(m, limit, cosine)
        if count == 0:
            continue
        # Orders above half the columns repeat, as those of points do.
        folded = m % columns
        sign = 1.0
        if folded > columns // 2:
            folded = columns - folded
            sign = -1.0
        turn = math.cos(m * first_angle)
        turned = -math.sin(m * first_angle)
        for c in range(3):
            for r in range(count):
                north = spectrum[c, 0, r, folded]
                south = spectrum[c, 1, r, folded]
                even = (north.real + south.real) * weights[r]
                even_i = sign * (north.imag + south.imag) * weights[r]
                odd = (north.real - south.real) * weights[r]
                odd_i = sign * (north.imag - south.imag) * weights[r]
                light[2 * c, r] = even * turn - even_i * turned
                light[2 * c + 1, r] = even * turned + even_i * turn
                light[6 + 2 * c, r] = odd * turn - odd_i * turned
                light[7 + 2 * c, r] = odd * turned + odd_i * turn
        _start(m, count, log_start, sine_log, twice, last)
        _factors(m, limit, 4, factors)
        row = result[order_start(m, limit) : order_start(m + 1, limit)]
        for k in range(0, limit - m + 1, 4):
            _advance(count, m, k, twice, last, p, 0)
            _collect(count, p, 0, light, row, k, factors)
            _collect(count, p, 1, light, row, k, factors)


@compiled
def _spread(count: int, p: Array, parity: int, sums: Array, terms: Array) -> None:
    """Add four degrees of one parity, times their coefficients (8, 6), to the sums (12, rings)."""
    s = sums[6 * parity : 6 * parity + 6]
    for i in range(0, 6, 2):
        t_0 = terms[parity, i]
        t_2 = terms[parity + 2, i]
        t_4 = terms[parity + 4, i]
        t_6 = terms[parity + 6, i]
        u_0 = terms[parity, i + 1]
        u_2 = terms[parity + 2, i + 1]
        u_4 = terms[parity + 4, i + 1]
        u_6 = terms[parity + 6, i + 1]
        for r in range(count):
            p_0 = p[parity, r]
            p_2 = p[parity + 2, r]
            p_4 = p[parity + 4, r]
            p_6 = p[parity + 6, r]
            s[i, r] += t_0 * p_0 + t_2 * p_2 + t_4 * p_4 + t_6 * p_6
            s[i + 1, r] += u_0 * p_0 + u_2 * p_2 + u_4 * p_4 + u_6 * p_6


@compiled
def synthesise_rings(
    coefficients: Array,
    analysed: int,
    gains: Array,
    cosine: Array,
    from_equator: int,
    log_start: Array,
    first: int,
    end: int,
    orders: Array,
) -> None:
    """Fill F_m of orders ``first`` … ``end - 1`` on a block of ring pairs.

    Parameters
    ----------
    coefficients, analysed
        What :func:`analyse_rings` leaves, and the bandlimit there, at least that of ``gains``.
    gains
        (bandlimit+1,): what each degree is multiplied by.
    cosine
        (block,) cosθ from the equator outwards; ``from_equator`` rings lie between the equator and the first.
    orders
        (2, rings, 3, ≥ (end - first)/2, 2) in the usual order from north to south, an even number of rings; [0]
        are the orders first, first + 2, … and [1] those between.
    """
    limit = gains.size - 1
    rings = cosine.size
    half = orders.shape[1] // 2
    sums = np.empty((12, rings))
    p = np.empty((8, rings))
    last = np.empty((2, rings))
    terms = np.empty((8, 6))
    factors = np.empty(limit + 9)
    twice = 2.0 * cosine
    sine_log = 0.5 * np.log1p(-cosine * cosine)
    for m in range(first, min(end, limit + 1)):
        count = _reached(m, limit, cosine)
        sums[...] = 0.0
        _start(m, count, log_start, sine_log, twice, last)
        _factors(m, limit, 8, factors)
        row = coefficients[order_start(m, analysed) : order_start(m + 1, analysed)]
        if count > 0:
            for k in range(0, limit - m + 1, 8):
                _advance(count, m, k, twice, last, p, 0)
                _advance(count, m, k + 4, twice, last, p, 4)
                for step in range(8):
                    degree = m + k + step
                    for i in range(6):
                        terms[step, i] = 0.0
                        if degree <= limit:
                            terms[step, i] = row[k + step, i] * gains[degree] * factors[k + step]
                _spread(count, p, 0, sums, terms)
                _spread(count, p, 1, sums, terms)
        parity = (m - first) % 2
        place = (m - first) // 2
        for c in range(3):
            for r in range(rings):
                north = half - 1 - from_equator - r
                south = half + from_equator + r
                for i in range(2):
                    even = sums[2 * c + i, r]
                    odd = sums[6 + 2 * c + i, r]
                    orders[parity, north, c, place, i] = even + odd
                    orders[parity, south, c, place, i] = even - odd

"""Compiled sums over all pixels for the recovery of a camera response.

Robertson's energy over pixels j and exposures i is Σ w(y_ij)·(g(y_ij) - t_i x_j)². For a given g the best radiance is
x_j = Σ_i w t g / Σ_i w t². With g = g⁰·(1 + Bθ), B a row of four B-splines for each code, and x_j eliminated, it is
a quadratic form in θ, whose least value solves Σ_ij w g B·(g(1 + Bθ) - t_i x_j(θ)) = 0. Here w, g and B before the
bracket are read off noisy codes that stand within it too: their product does not average to nothing, and the curve
comes out bent where noise is a tenth of the signal. So before the bracket stands the exposure that the *other*
exposures of the pixel predict: an instrument, whose noise is independent. Then noise within averages out.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.compilation import Array, compiled

# Of the information on a pixel, at least this share must come from the other exposures.
_OTHERS = 1e-3


@compiled
def _predict(
    codes: Array, times: Array, curve: Array, weight: Array, predicted: Array, certainty: Array
) -> None:
    """Predict each exposure of one pixel from the others: t_i·x in ``predicted``, 1/variance in ``certainty`` (n,)."""
    exposures = times.shape[0]
    sum_tt = 0.0
    sum_tg = 0.0
    for i in range(exposures):
        w = weight[codes[i]]
        sum_tt += w * times[i] * times[i]
        sum_tg += w * times[i] * curve[codes[i]]
    for i in range(exposures):
        w = weight[codes[i]]
        rest = sum_tt - w * times[i] * times[i]
        predicted[i] = 0.0
        certainty[i] = 0.0
        if rest > _OTHERS * sum_tt:
            predicted[i] = times[i] * (sum_tg - w * times[i] * curve[codes[i]]) / rest
            certainty[i] = rest / (times[i] * times[i])


@compiled
def add_equations(
    codes: Array,
    times: Array,
    curve: Array,
    weight: Array,
    spline: Array,
    grid: Array,
    least: float,
    sums: Array,
) -> None:
    """Add pixels ``codes`` (p, n) to the equations ``sums`` (k, k) θ = (k,) of a step g → g·(1 + Bθ).

    ``curve`` and ``weight`` (codes,) are g and one over its variance, ``spline`` the first (codes,) of four splines at
    a code and their values (codes, 4). ``grid``: low, step, and at exposures exp(low + k·step) the weights, the first
    splines and their values. A prediction takes part where it is at least ``least`` times its own standard deviation.
    """
    first, basis = spline
    low, step, grid_weight, grid_first, grid_basis = grid
    matrix, right = sums
    count, exposures = codes.shape
    size = right.shape[0]
    time_row = np.zeros(size)
    mixed = np.zeros(size)
    predicted = np.zeros(exposures)
    certainty = np.zeros(exposures)
    places = np.zeros(exposures, np.int64)
    for p in range(count):
        _predict(codes[p], times, curve, weight, predicted, certainty)
        sum_tt = 0.0
        sum_tg = 0.0
        used = 0
        start, end = size, 0
        first_row, end_row = size, 0
        for i in range(exposures):
            places[i] = -1
            x = predicted[i]
            y = codes[p, i]
            if x > 0.0 and x * x * certainty[i] > least * least:
                k = math.floor((math.log(x) - low) / step + 0.5)
                if 0 <= k < grid_weight.shape[0] and grid_weight[k] > 0.0:
                    places[i] = k
                    w = grid_weight[k]
                    sum_tt += w * times[i] * times[i]
                    sum_tg += w * times[i] * curve[y]
                    start, end = min(start, first[y]), max(end, first[y] + 4)
                    first_row, end_row = min(first_row, grid_first[k]), max(end_row, grid_first[k] + 4)
                    used += 1
        if used < 2:
            continue
        for a in range(start, end):
            mixed[a] = 0.0
        for a in range(first_row, end_row):
            time_row[a] = 0.0
        radiance = sum_tg / sum_tt
        for i in range(exposures):
            k = places[i]
            if k >= 0:
                y = codes[p, i]
                w = grid_weight[k]
                error = curve[y] - times[i] * radiance
                row, column = grid_first[k], first[y]
                for a in range(4):
                    part = w * predicted[i] * grid_basis[k, a]
                    right[row + a] -= part * error
                    time_row[row + a] += part * times[i]
                    mixed[column + a] += w * times[i] * curve[y] * basis[y, a]
                    for b in range(4):
                        matrix[row + a, column + b] += part * curve[y] * basis[y, b]
        for a in range(first_row, end_row):
            scaled = time_row[a] / sum_tt
            for b in range(start, end):
                matrix[a, b] -= scaled * mixed[b]


@compiled
def add_noise(
    codes: Array,
    times: Array,
    curve: Array,
    weight: Array,
    highest: int,
    low: float,
    step: float,
    sums: Array,
) -> None:
    """Add the squared deviations of exposures from their prediction to ``sums`` (bins, 2).

    A bin holds the predictions whose logarithm lies from ``low + k·step`` on; a row is the sum of squares, and that
    of the squares expected for a variance of 1 of one exposure. Above the code ``highest`` all is clipped.
    """
    count, exposures = codes.shape
    bins = sums.shape[0]
    predicted = np.zeros(exposures)
    certainty = np.zeros(exposures)
    for p in range(count):
        _predict(codes[p], times, curve, weight, predicted, certainty)
        for i in range(exposures):
            x = predicted[i]
            y = codes[p, i]
            if x > 0.0 and y <= highest:
                k = math.floor((math.log(x) - low) / step)
                # Where the others say no more than this exposure itself, their own error would be measured.
                if 0 <= k < bins and certainty[i] > weight[y]:
                    error = curve[y] - x
                    sums[k, 0] += error * error
                    sums[k, 1] += 1.0 + (weight[y] / certainty[i] if weight[y] > 0.0 else 0.0)


@compiled
def add_times(codes: Array, curve: Array, weight: Array, sums: Array) -> None:
    """Add to ``sums`` (n - 1, 3) count, Σ d and Σ d² of d = ln g(y of the next exposure) - ln g(y)."""
    count, exposures = codes.shape
    for p in range(count):
        for i in range(exposures - 1):
            a, b = codes[p, i], codes[p, i + 1]
            if weight[a] > 0.0 and weight[b] > 0.0 and curve[a] > 0.0 and curve[b] > 0.0:
                d = math.log(curve[b] / curve[a])
                sums[i, 0] += 1.0
                sums[i, 1] += d
                sums[i, 2] += d * d


@compiled
def add_start(
    codes: Array, log_times: Array, weight: Array, first: Array, basis: Array, matrix: Array, right: Array
) -> None:
    """Add pixels ``codes`` (p, n) to the sums of Σ w(y_ij)·(ln g(y_ij) - ln t_i - ln x_j)² with ln g = Bθ.

    This energy (Debevec and Malik 1997) needs no g to start from. ``matrix`` gets its upper half.
    """
    count, exposures = codes.shape
    size = right.shape[0]
    mixed = np.zeros(size)
    for p in range(count):
        sum_w = 0.0
        sum_t = 0.0
        low, high, used = size, 0, 0
        for i in range(exposures):
            y = codes[p, i]
            w = weight[y]
            if w > 0.0:
                sum_w += w
                sum_t += w * log_times[i]
                low = min(low, first[y])
                high = max(high, first[y] + 4)
                used += 1
        if used < 2:
            continue
        for a in range(low, high):
            mixed[a] = 0.0
        for i in range(exposures):
            y = codes[p, i]
            w = weight[y]
            if w > 0.0:
                at = first[y]
                for a in range(4):
                    part = w * basis[y, a]
                    right[at + a] += part * log_times[i]
                    mixed[at + a] += part
                    for b in range(a, 4):
                        matrix[at + a, at + b] += part * basis[y, b]
        for a in range(low, high):
            scaled = mixed[a] / sum_w
            right[a] -= scaled * sum_t
            for b in range(a, high):
                matrix[a, b] -= scaled * mixed[b]

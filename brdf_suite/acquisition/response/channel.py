"""Noise and response of one channel, by Gauss-Newton steps on Robertson's energy with all radiances eliminated."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import nnls

from brdf_suite.acquisition.response import kernels
from brdf_suite.acquisition.response.response import MIDDLE_EXPOSURE, Response, linear_response, middle_code
from brdf_suite.acquisition.response.samples import ResponseSamples
from brdf_suite.arrays import Bools, Codes, Floats, Integers
from brdf_suite.errors import AcquisitionError
from brdf_suite.progress import Progress, report

OTHERS_SIGNAL = 10.0
"""A pixel's exposures predict another one where they are at least so many times their noise."""

_BINS = 40
_LOWEST_EXPOSURE = 1e-4
_LARGEST_EXPOSURE = 2.0
_BIN_PIXELS = 100.0
_SMALLEST_VARIANCE = 1e-12
_TIMES_SIGNAL = 30.0
_BEYOND = 1.05
_DEGREE = 3
KNOTS = 16
_STEPS = 20
_ORDER = 3
# The first steps are smoother, so that they do not stray from a start that is far off.
_RELAX, _RELAXED = 4.0, 3
_CLOSE = 5e-5
_LONGEST = 0.7
_LOW_SHARE = 0.002
_BELL = 16.0
_LEAST_SIGNAL = 2.0
_TOP_DEVIATIONS = 4.0
_GRID_LOW = -16.0
_GRID_STEP = 0.008
_GRID = 2200


def exposure_variance(curve: Floats, read: float, shot: float) -> Floats:
    """Return (codes,) the variance of the exposure of each code: read² + shot·X, and that of rounding."""
    step = np.gradient(curve)
    variance = read * read + shot * np.maximum(curve, 0.0) + step * step / 12.0
    return np.asarray(np.maximum(variance, _SMALLEST_VARIANCE))


def estimate_noise(
    codes: Codes,
    times: Floats,
    curve: Floats,
    inside: Bools,
    before: tuple[float, float] | None,
) -> tuple[float, float]:
    """Return (read, shot) of the variance of exposures about their prediction, less that of rounding."""
    if before is None:
        step = np.gradient(curve)
        variance = np.maximum(4.0 * step * step, _SMALLEST_VARIANCE)
        used = inside
    else:
        variance = exposure_variance(curve, *before)
        used = inside & (curve > OTHERS_SIGNAL * np.sqrt(variance))
    sums = np.zeros((_BINS, 2))
    low = np.log(_LOWEST_EXPOSURE)
    width = (np.log(_LARGEST_EXPOSURE) - low) / _BINS
    highest = int(np.flatnonzero(inside)[-1])
    kernels.add_noise(codes, times, curve, np.where(used, 1.0 / variance, 0.0), highest, low, width, sums)
    full = sums[:, 1] > _BIN_PIXELS
    exposure = np.exp(low + width * (np.arange(_BINS) + 0.5))[full]
    seen = sums[full, 0] / sums[full, 1]
    # Nearer to black and to saturation than this, the codes' ends cut the noise off.
    free = (exposure > 3.0 * np.sqrt(seen)) & (exposure + 4.0 * np.sqrt(seen) < curve[highest])
    exposure, seen = exposure[free], seen[free]
    if len(seen) < 3:
        raise AcquisitionError("Too few codes are covered by the photographs to measure their noise.")
    rounding = np.interp(exposure, curve, np.gradient(curve) ** 2 / 12.0)
    target = np.maximum(seen - rounding, 0.05 * seen)
    both, _ = nnls(np.stack((np.ones_like(exposure), exposure), axis=1) / seen[:, None], target / seen)
    return float(np.sqrt(max(both[0], _SMALLEST_VARIANCE))), float(max(both[1], _SMALLEST_VARIANCE))


def time_residuals(samples: ResponseSamples, response: Response) -> Floats:
    """Return ln(time shown / time stated) of each exposure, median 0."""
    sums = np.zeros((len(samples.times) - 1, 3))
    codes = np.arange(1 << samples.bit_depth)
    for c in range(response.channels):
        curve = response.exposure[c]
        variance = exposure_variance(curve, float(response.read[c]), float(response.shot[c]))
        used = (curve > _TIMES_SIGNAL * np.sqrt(variance)) & (codes <= response.highest[c])
        kernels.add_times(samples.codes(c), curve, used.astype(float), sums)
    steps = np.divide(
        sums[:, 1], sums[:, 0], out=np.log(samples.times[1:] / samples.times[:-1]), where=sums[:, 0] > 0
    )
    shown = np.concatenate(([0.0], np.cumsum(steps))) - np.log(samples.times / samples.times[0])
    return np.asarray(shown - np.median(shown))


@dataclass(frozen=True, eq=False)
class CurveBasis:
    """Response curve model: cubic B-splines over the codes ``low`` … ``high`` of one channel, finer towards both ends.

    ln g is a spline in u = ln(q) - ln(1.05 - q), q being the share of the code above black: straight for power laws
    near black, with room for a shoulder near full scale. Robertson's table of one free value for each code needs every
    code to be seen often, and in a series of exposures with one common ratio it cannot be determined at all: with g,
    g·p(ln g) is as good where p has that ratio's logarithm as its period. A smooth curve has no such ripples, so
    smoothness fixes them.

    ``first`` (codes,) int64 is the first of the four splines at a code, ``values`` (codes, 4) their values,
    both held outside; ``count`` is how many splines there are.
    """

    low: int
    high: int
    first: Integers
    values: Floats
    count: int

    def logarithm(self, coefficients: Floats) -> Floats:
        """Return the spline (codes,), held outside low … high."""
        at = self.first[:, None] + np.arange(_DEGREE + 1)
        return np.asarray(np.sum(self.values * coefficients[at], axis=1))


def curve_basis(bit_depth: int, black: float, low: int, high: int, knots: int) -> CurveBasis:
    """Return ``knots + 3`` splines on evenly spaced knots in u between two codes above black."""
    share = (np.clip(np.arange(1 << bit_depth), low, high) - black) / ((1 << bit_depth) - 1 - black)
    u = np.log(share) - np.log(_BEYOND - share)
    at = (u - u[0]) / (u[-1] - u[0]) * knots
    interval = np.minimum(at.astype(np.int64), knots - 1)
    t = at - interval
    values = np.stack(((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3), axis=1)
    return CurveBasis(low, high, interval, values / 6.0, knots + _DEGREE)


def whole_table(basis: CurveBasis, exposure: Floats, black: float) -> Floats:
    """Return ``exposure`` (codes,) continued beyond the basis: by a power law to black, and straight at the top.

    The power is the curve's own slope near its low end, held to 0.3 … 4; below black the same, negative.
    """
    table = exposure.copy()
    codes = np.arange(len(table), dtype=float)
    low, high = basis.low, basis.high
    near = min(high, max(low + 2, int(low + 0.5 * (low - black))))
    power = np.log(exposure[near] / exposure[low]) / np.log((near - black) / (low - black))
    power = float(np.clip(power, 0.3, 4.0))
    away = (codes[:low] - black) / (low - black)
    table[:low] = exposure[low] * np.sign(away) * np.abs(away) ** power
    run = max(2, (high - low) // 50)
    slope = (exposure[high] - exposure[high - run]) / run
    table[high + 1 :] = exposure[high] + slope * (codes[high + 1 :] - high)
    return np.asarray(np.maximum.accumulate(table))


@dataclass(frozen=True, eq=False)
class Channel:
    """Response of one channel: exposures (codes,), noise, deviation from a line, lowest code, steps taken."""

    curve: Floats
    read: float
    shot: float
    linear_rms: float
    low: int
    steps: int


def known_channel(codes: Codes, samples: ResponseSamples, black: float, high: int, curve: Floats) -> Channel:
    """Measure the noise of a channel whose curve is known."""
    low, inside = _measurable(samples.bit_depth, black, high)
    first = estimate_noise(codes, samples.times, curve, inside, None)
    read, shot = estimate_noise(codes, samples.times, curve, inside, first)
    return Channel(curve, read, shot, 0.0, low, 0)


def fit_channel(
    codes: Codes,
    samples: ResponseSamples,
    black: float,
    high: int,
    smoothness: float,
    progress: Progress | None,
) -> Channel:
    """Return the curve that ``codes`` (p, n) show, ``black`` and ``high`` being those of no light and of saturation.

    The first start needs no curve (:func:`brdf_suite.acquisition.response.kernels.add_start`); then each
    step measures the noise under the curve so far, and solves the equations that follow from it.
    """
    size = 1 << samples.bit_depth
    low, inside = _measurable(samples.bit_depth, black, high)
    basis = curve_basis(samples.bit_depth, black, low, high, KNOTS)
    middle = middle_code(samples.bit_depth)
    line = linear_response(samples.bit_depth, 1, black).exposure[0]
    gauge = np.zeros(basis.count)
    gauge[basis.first[middle] + np.arange(4)] = basis.values[middle]
    rough = np.diff(np.eye(basis.count), _ORDER, axis=0)
    roughness = rough.T @ rough * smoothness
    matrix, right = np.zeros((basis.count, basis.count)), np.zeros(basis.count)
    share = (np.arange(size) - black) / (size - 1 - black)
    bell = np.where(inside, np.exp(-_BELL * (share - 0.5) ** 2), 0.0)
    kernels.add_start(codes, np.log(samples.times), bell, basis.first, basis.values, matrix, right)
    matrix += np.triu(matrix, 1).T
    theta = _solved(matrix, right, _RELAX**_RELAXED * roughness, np.zeros(basis.count), gauge)
    read, shot = -1.0, -1.0
    steps = 0
    for steps in range(1, _STEPS + 1):
        report(progress, steps / _STEPS, "response of the camera")
        curve = _curve(basis, theta, black, middle)
        read, shot = estimate_noise(codes, samples.times, curve, inside, None if read < 0.0 else (read, shot))
        variance = exposure_variance(curve, read, shot)
        weight = np.where(inside & (curve > OTHERS_SIGNAL * np.sqrt(variance)), 1.0 / variance, 0.0)
        matrix[:], right[:] = 0.0, 0.0
        places, usable = _instruments(curve, variance, high)
        spline = (basis.first, basis.values)
        grid = (_GRID_LOW, _GRID_STEP, usable, basis.first[places], basis.values[places])
        sums = (matrix, right)
        kernels.add_equations(codes, samples.times, curve, weight, spline, grid, OTHERS_SIGNAL, sums)
        more = max(1.0, _RELAX ** (_RELAXED - steps))
        change = _solved(matrix, right, more * roughness, theta, gauge)
        theta = theta + np.clip(change, -_LONGEST, _LONGEST)
        if np.abs(change @ matrix @ change) < _CLOSE**2 * np.trace(matrix) and steps > _RELAXED:
            break
    curve = _curve(basis, theta, black, middle)
    read, shot = estimate_noise(codes, samples.times, curve, inside, (read, shot))
    measured = inside & (curve > 2.0 * _LEAST_SIGNAL * np.sqrt(exposure_variance(curve, read, shot)))
    apart = np.log(curve[measured] / line[measured])
    apart -= apart.mean()
    return Channel(curve, read, shot, float(np.sqrt(np.mean(apart**2))), low, steps)


def _measurable(bit_depth: int, black: float, high: int) -> tuple[int, Bools]:
    """Return the lowest code distinguishable from black, and (codes,) which lie between it and ``high``."""
    size = 1 << bit_depth
    low = int(np.ceil(black + max(2.0, _LOW_SHARE * size)))
    codes = np.arange(size)
    return low, (codes >= low) & (codes <= high)


def _solved(matrix: Floats, right: Floats, roughness: Floats, theta: Floats, gauge: Floats) -> Floats:
    """Return the step that minimizes the quadratic form and the roughness of ``theta + step``, gauge held."""
    smooth = roughness * (np.trace(matrix) / len(right))
    size = len(right)
    system = np.zeros((size + 1, size + 1))
    system[:size, :size] = matrix + smooth
    system[size, :size] = system[:size, size] = gauge
    return np.asarray(np.linalg.lstsq(system, np.append(right - smooth @ theta, 0.0), rcond=None)[0][:size])


def _curve(basis: CurveBasis, theta: Floats, black: float, middle: int) -> Floats:
    """Return the exposures of all codes, never falling, at the gauge."""
    exposure = np.zeros(len(basis.first))
    run = slice(basis.low, basis.high + 1)
    exposure[run] = np.maximum.accumulate(np.exp(basis.logarithm(theta)[run]))
    exposure = whole_table(basis, exposure, black)
    return np.asarray(exposure * (MIDDLE_EXPOSURE / exposure[middle]))


def _instruments(curve: Floats, variance: Floats, high: int) -> tuple[Integers, Floats]:
    """Return the code and the weight of each predicted exposure of the grid."""
    exposure = np.exp(_GRID_LOW + _GRID_STEP * np.arange(_GRID))
    code = np.minimum(np.searchsorted(curve, exposure), len(curve) - 1)
    deviation = np.sqrt(variance[code])
    signal = exposure / deviation
    weight = np.clip(signal / _LEAST_SIGNAL - 1.0, 0.0, 1.0) / variance[code]
    # Predicted so far below saturation, that noise does not reach it.
    weight *= np.clip((curve[high] - exposure) / deviation / _TOP_DEVIATIONS, 0.0, 1.0)
    return code, np.asarray(weight)

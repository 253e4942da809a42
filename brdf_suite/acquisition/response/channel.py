"""Response of one channel by Gauss-Newton steps on Robertson's energy, with all radiances eliminated."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.response import kernels as compiled_response
from brdf_suite.acquisition.response.curve import CurveBasis, curve_basis, whole_table
from brdf_suite.acquisition.response.noise import OTHERS_SIGNAL, estimate_noise, exposure_variance
from brdf_suite.acquisition.response.response import MIDDLE_EXPOSURE, linear_response, middle_code
from brdf_suite.acquisition.response.samples import ResponseSamples
from brdf_suite.arrays import Floats
from brdf_suite.progress import Progress, report

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


@dataclass(frozen=True, eq=False)
class Channel:
    """Response of one channel: exposures (codes,), noise, deviation from a line, lowest code, steps taken."""

    curve: Floats
    read: float
    shot: float
    linear_rms: float
    low: int
    steps: int


def known_channel(
    codes: npt.NDArray[np.uint16], samples: ResponseSamples, black: float, high: int, curve: Floats
) -> Channel:
    """Measure the noise of a channel whose curve is known."""
    low, inside = _measurable(samples.bit_depth, black, high)
    first = estimate_noise(codes, samples.times, curve, inside, None)
    read, shot = estimate_noise(codes, samples.times, curve, inside, first)
    return Channel(curve, read, shot, 0.0, low, 0)


def fit_channel(
    codes: npt.NDArray[np.uint16],
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
    compiled_response.add_start(codes, np.log(samples.times), bell, basis.first, basis.values, matrix, right)
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
        compiled_response.add_equations(
            codes,
            samples.times,
            curve,
            weight,
            basis.first,
            basis.values,
            _GRID_LOW,
            _GRID_STEP,
            usable,
            basis.first[places],
            basis.values[places],
            OTHERS_SIGNAL,
            matrix,
            right,
        )
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


def _measurable(bit_depth: int, black: float, high: int) -> tuple[int, npt.NDArray[np.bool_]]:
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


def _instruments(curve: Floats, variance: Floats, high: int) -> tuple[npt.NDArray[np.int64], Floats]:
    """Return the code and the weight of each predicted exposure of the grid."""
    exposure = np.exp(_GRID_LOW + _GRID_STEP * np.arange(_GRID))
    code = np.minimum(np.searchsorted(curve, exposure), len(curve) - 1)
    deviation = np.sqrt(variance[code])
    signal = exposure / deviation
    weight = np.clip(signal / _LEAST_SIGNAL - 1.0, 0.0, 1.0) / variance[code]
    # Predicted so far below saturation, that noise does not reach it.
    weight *= np.clip((curve[high] - exposure) / deviation / _TOP_DEVIATIONS, 0.0, 1.0)
    return code, np.asarray(weight)

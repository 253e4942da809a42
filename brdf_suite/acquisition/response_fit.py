"""Recover the response of a camera from series of exposures, by Robertson's energy over all pixels.

The energy Σ w(y_ij)·(g(y_ij) - t_i x_j)² weighs each code by one over the variance of its exposure, which is measured
from the photographs themselves. Robertson, Borman and Stevenson (2003) minimize it by turns, one free value for each
code; here g is a smooth curve (:mod:`.response_curve`) and the radiances x_j are eliminated, so that Gauss-Newton
steps take both at once. OpenCV's ``CalibrateRobertson`` takes 8 bits only, and its free values are noisy where codes
are rare; docs/acquisition.md has the figures of both.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.response import (
    MIDDLE_EXPOSURE,
    Response,
    linear_response,
    middle_code,
)
from brdf_suite.acquisition.response_curve import CurveBasis, curve_basis, whole_table
from brdf_suite.acquisition.response_samples import ResponseSamples
from brdf_suite.errors import AcquisitionError
from brdf_suite.progress import Progress, part, report

Floats = npt.NDArray[np.float64]

KNOTS = 16
SMOOTHNESS = 1e-3
"""Weight of the third differences of ln g, over that of the photographs, where exposures differ by a factor of 1.65."""

LINEAR_RMS = 0.01
"""A curve nearer to a straight line than this, RMS of the logarithm, is taken as the line."""

_STEPS = 20
_ORDER = 3
# The first steps are smoother, so that they do not stray from a start that is far off.
_RELAX, _RELAXED = 4.0, 3
_USUAL_GAP = 0.5
_SMOOTHEST = 0.3
_CLOSE = 5e-5
_LONGEST = 0.7
_TIMES_SIGNAL = 30.0
_FEWEST = 300
_LOW_SHARE = 0.002
_BELL = 16.0
_OTHERS_SIGNAL = 10.0
_LEAST_SIGNAL = 2.0
_TOP_DEVIATIONS = 4.0
_GRID_LOW = -16.0
_GRID_STEP = 0.008
_GRID = 2200
_BINS = 40
_LOWEST_EXPOSURE = 1e-4
_LARGEST_EXPOSURE = 2.0
_BIN_PIXELS = 100.0
_SMALLEST_VARIANCE = 1e-12


@dataclass(frozen=True, eq=False)
class ResponseFit:
    """A recovered response and how well it explains the photographs.

    Attributes
    ----------
    response
        What was recovered.
    linear_rms
        (channels,) RMS distance of the curve from a straight line, in the logarithm of the exposure.
    time_residuals
        (n,) logarithm of the exposure time that the photographs show, over the one stated; the median is 0.
    pixels
        (channels,) how many pixels took part.
    iterations
        Gauss-Newton steps of the slowest channel.
    """

    response: Response
    linear_rms: Floats
    time_residuals: Floats
    pixels: npt.NDArray[np.int64]
    iterations: int


@dataclass(frozen=True, eq=False)
class _Channel:
    curve: Floats
    read: float
    shot: float
    linear_rms: float
    low: int
    steps: int


def calibrate_response(
    samples: ResponseSamples,
    black: npt.ArrayLike | None = None,
    *,
    linear: bool = False,
    smoothness: float | None = None,
    progress: Progress | None = None,
) -> ResponseFit:
    """Return the response that explains the photographs.

    Parameters
    ----------
    samples
        Pixels of some positions, spread over the arc so that all codes are seen.
    black
        (channels,) codes without light, from dark frames; ``None``: from the darkest pixels.
    linear
        The camera is known to be linear: only the noise is measured.
    smoothness
        Weight of the third differences of ln g, relative to that of the photographs; ``None``: as the gaps between the
        times of exposure ask.

    Raises
    ------
    AcquisitionError
        Too few pixels have two usable exposures.
    """
    dark = (
        samples.black() if black is None else np.broadcast_to(np.asarray(black, float), (samples.channels,))
    )
    highest = samples.highest()
    smoothness = needed_smoothness(samples.times) if smoothness is None else smoothness
    found = []
    for c in range(samples.channels):
        step = part(progress, c / samples.channels, (c + 1) / samples.channels)
        codes = samples.codes(c)
        if len(codes) < _FEWEST:
            raise AcquisitionError(
                f"Channel {c} has only {len(codes)} pixels with two exposures that are neither black nor clipped;"
                " the response of the camera cannot be recovered from them."
            )
        found.append(_fit_channel(codes, samples, float(dark[c]), int(highest[c]), linear, smoothness, step))
    straight = linear or all(each.linear_rms <= LINEAR_RMS for each in found)
    if straight and not linear:
        found = [
            _fit_channel(samples.codes(c), samples, float(dark[c]), int(highest[c]), True, smoothness, None)
            for c in range(samples.channels)
        ]
    response = Response(
        samples.bit_depth,
        np.stack([each.curve for each in found]),
        dark,
        np.array([each.low for each in found]),
        highest,
        np.array([each.read for each in found]),
        np.array([each.shot for each in found]),
        straight,
    )
    return ResponseFit(
        response,
        np.array([each.linear_rms for each in found]),
        _time_residuals(samples, response),
        np.array([len(samples.codes(c)) for c in range(samples.channels)]),
        max(each.steps for each in found),
    )


def needed_smoothness(times: Floats) -> float:
    """Return the smoothness for a series of times.

    What exposures of a common ratio cannot tell are ripples of ln g whose period is the logarithm of that ratio. The
    wider it is, the less rough is a ripple, and the more smoothness it takes to rule it out; three exposures with a
    factor of 7 between them give the curve to 0.4 % so, and to 10 % with the smoothness that suits sixteen.
    """
    gap = float(np.max(np.diff(np.log(times))))
    return min(_SMOOTHEST, SMOOTHNESS * max(1.0, (gap / _USUAL_GAP) ** 3))


def _fit_channel(
    codes: npt.NDArray[np.uint16],
    samples: ResponseSamples,
    black: float,
    high: int,
    linear: bool,
    smoothness: float,
    progress: Progress | None,
) -> _Channel:
    from brdf_suite.acquisition import compiled_response  # numba takes half a second to import

    size = 1 << samples.bit_depth
    low = int(np.ceil(black + max(2.0, _LOW_SHARE * size)))
    y = np.arange(size)
    inside = (y >= low) & (y <= high)
    basis = curve_basis(samples.bit_depth, black, low, high, KNOTS)
    middle = middle_code(samples.bit_depth)
    line = linear_response(samples.bit_depth, 1, black).exposure[0]
    if linear:
        read, shot = _noise(codes, samples.times, line, inside, None)
        return _Channel(line, read, shot, 0.0, low, 0)
    gauge = np.zeros(basis.count)
    gauge[basis.first[middle] + np.arange(4)] = basis.values[middle]
    rough = np.diff(np.eye(basis.count), _ORDER, axis=0)
    roughness = rough.T @ rough * smoothness
    matrix, right = np.zeros((basis.count, basis.count)), np.zeros(basis.count)
    share = (y - black) / (size - 1 - black)
    bell = np.where(inside, np.exp(-_BELL * (share - 0.5) ** 2), 0.0)
    compiled_response.add_start(codes, np.log(samples.times), bell, basis.first, basis.values, matrix, right)
    matrix += np.triu(matrix, 1).T
    theta = _solved(matrix, right, _RELAX**_RELAXED * roughness, np.zeros(basis.count), gauge)
    read, shot = -1.0, -1.0
    steps = 0
    for steps in range(1, _STEPS + 1):
        report(progress, steps / _STEPS, "response of the camera")
        curve = _curve(basis, theta, black, middle)
        read, shot = _noise(codes, samples.times, curve, inside, None if read < 0.0 else (read, shot))
        variance = _variance(curve, read, shot)
        weight = np.where(inside & (curve > _OTHERS_SIGNAL * np.sqrt(variance)), 1.0 / variance, 0.0)
        matrix[:], right[:] = 0.0, 0.0
        places, told = _instruments(curve, variance, high)
        compiled_response.add_equations(
            codes,
            samples.times,
            curve,
            weight,
            basis.first,
            basis.values,
            _GRID_LOW,
            _GRID_STEP,
            told,
            basis.first[places],
            basis.values[places],
            _OTHERS_SIGNAL,
            matrix,
            right,
        )
        more = max(1.0, _RELAX ** (_RELAXED - steps))
        change = _solved(matrix, right, more * roughness, theta, gauge)
        theta = theta + np.clip(change, -_LONGEST, _LONGEST)
        if np.abs(change @ matrix @ change) < _CLOSE**2 * np.trace(matrix) and steps > _RELAXED:
            break
    curve = _curve(basis, theta, black, middle)
    read, shot = _noise(codes, samples.times, curve, inside, (read, shot))
    measured = inside & (curve > 2.0 * _LEAST_SIGNAL * np.sqrt(_variance(curve, read, shot)))
    apart = np.log(curve[measured] / line[measured])
    apart -= apart.mean()
    return _Channel(curve, read, shot, float(np.sqrt(np.mean(apart**2))), low, steps)


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


def _variance(curve: Floats, read: float, shot: float) -> Floats:
    step = np.gradient(curve)
    return np.asarray(
        np.maximum(read * read + shot * np.maximum(curve, 0.0) + step * step / 12.0, _SMALLEST_VARIANCE)
    )


def _noise(
    codes: npt.NDArray[np.uint16],
    times: Floats,
    curve: Floats,
    inside: npt.NDArray[np.bool_],
    before: tuple[float, float] | None,
) -> tuple[float, float]:
    """Return (read, shot) of the variance of exposures about their prediction, less that of rounding."""
    from scipy.optimize import nnls  # a sixth of a second to import

    from brdf_suite.acquisition import compiled_response

    if before is None:
        step = np.gradient(curve)
        variance = np.maximum(4.0 * step * step, _SMALLEST_VARIANCE)
        used = inside
    else:
        variance = _variance(curve, *before)
        used = inside & (curve > _OTHERS_SIGNAL * np.sqrt(variance))
    sums = np.zeros((_BINS, 2))
    low = np.log(_LOWEST_EXPOSURE)
    width = (np.log(_LARGEST_EXPOSURE) - low) / _BINS
    highest = int(np.flatnonzero(inside)[-1])
    compiled_response.add_noise(
        codes, times, curve, np.where(used, 1.0 / variance, 0.0), highest, low, width, sums
    )
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


def _time_residuals(samples: ResponseSamples, response: Response) -> Floats:
    """Return ln(time shown / time stated) of each exposure, median 0."""
    from brdf_suite.acquisition import compiled_response

    sums = np.zeros((len(samples.times) - 1, 3))
    codes = np.arange(1 << samples.bit_depth)
    for c in range(response.channels):
        curve = response.exposure[c]
        variance = _variance(curve, float(response.read[c]), float(response.shot[c]))
        used = (curve > _TIMES_SIGNAL * np.sqrt(variance)) & (codes <= response.highest[c])
        compiled_response.add_times(samples.codes(c), curve, used.astype(float), sums)
    steps = np.divide(
        sums[:, 1], sums[:, 0], out=np.log(samples.times[1:] / samples.times[:-1]), where=sums[:, 0] > 0
    )
    shown = np.concatenate(([0.0], np.cumsum(steps))) - np.log(samples.times / samples.times[0])
    return np.asarray(shown - np.median(shown))

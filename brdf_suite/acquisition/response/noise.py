"""Estimation of camera noise and exposure times from exposure series with a known response curve."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.optimize import nnls

from brdf_suite.acquisition.response import kernels as compiled_response
from brdf_suite.acquisition.response.response import Response
from brdf_suite.acquisition.response.samples import ResponseSamples
from brdf_suite.arrays import Floats
from brdf_suite.errors import AcquisitionError

OTHERS_SIGNAL = 10.0
"""A pixel's exposures predict another one where they are at least so many times their noise."""

_BINS = 40
_LOWEST_EXPOSURE = 1e-4
_LARGEST_EXPOSURE = 2.0
_BIN_PIXELS = 100.0
_SMALLEST_VARIANCE = 1e-12
_TIMES_SIGNAL = 30.0


def exposure_variance(curve: Floats, read: float, shot: float) -> Floats:
    """Return (codes,) the variance of the exposure of each code: read² + shot·X, and that of rounding."""
    step = np.gradient(curve)
    return np.asarray(
        np.maximum(read * read + shot * np.maximum(curve, 0.0) + step * step / 12.0, _SMALLEST_VARIANCE)
    )


def estimate_noise(
    codes: npt.NDArray[np.uint16],
    times: Floats,
    curve: Floats,
    inside: npt.NDArray[np.bool_],
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


def time_residuals(samples: ResponseSamples, response: Response) -> Floats:
    """Return ln(time shown / time stated) of each exposure, median 0."""
    sums = np.zeros((len(samples.times) - 1, 3))
    codes = np.arange(1 << samples.bit_depth)
    for c in range(response.channels):
        curve = response.exposure[c]
        variance = exposure_variance(curve, float(response.read[c]), float(response.shot[c]))
        used = (curve > _TIMES_SIGNAL * np.sqrt(variance)) & (codes <= response.highest[c])
        compiled_response.add_times(samples.codes(c), curve, used.astype(float), sums)
    steps = np.divide(
        sums[:, 1], sums[:, 0], out=np.log(samples.times[1:] / samples.times[:-1]), where=sums[:, 0] > 0
    )
    shown = np.concatenate(([0.0], np.cumsum(steps))) - np.log(samples.times / samples.times[0])
    return np.asarray(shown - np.median(shown))

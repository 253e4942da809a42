"""Maps of the sensor: its dark frame and its flat field, freed of the noise of the photographs they come from.

A map is applied to every photograph, so its own noise is a pattern that no averaging removes. So of the dark frame, a
signal without light that is an offset and a current that grows with exposure time, a straight line in time is fitted
for each pixel over all photographs; and what is left of noise is taken out by shrinkage (Wiener 1949): differences
between neighbours are kept by the share of them that noise does not explain.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.ndimage import gaussian_filter, median_filter

from brdf_suite.acquisition.radiance.merge import DARK, GOOD, Dark, MergedRadiance
from brdf_suite.acquisition.response.response import Response
from brdf_suite.arrays import Bools, Codes, Floats, Singles
from brdf_suite.errors import AcquisitionError, ValueRangeError

_CUT_OFF = 0.25
_SIGMA_PX = 8.0
_OUTLYING = 6.0
_TO_DEVIATION = 1.4826
_SMOOTH_SHARE = 0.01
_CENTRE_SHARE = 0.05
_LEAST = 0.02


def shrunk(plane: Floats, noise_variance: float, sigma_px: float) -> tuple[Floats, Bools]:
    """Return ``smooth + k·(plane - smooth)``, and where a value stands out so far that it is kept as it is.

    ``plane`` (h, w); ``noise_variance`` is that of one value; smooth is a Gaussian's mean of ``sigma_px``; k, 0…1, is
    one less the noise over the variance about the smooth plane.

    >>> shrunk(np.full((4, 5), 2.0), 1.0, 1.0)[0].mean()
    np.float64(2.0)
    """
    # The median of 5 × 5 neighbours is not moved by one hot pixel.
    edge = min(2, min(plane.shape) - 1)
    inner = (slice(edge, plane.shape[0] + edge), slice(edge, plane.shape[1] + edge))
    rough = plane - median_filter(np.pad(plane, edge, mode="reflect", reflect_type="odd"), 5)[inner]
    spread = _TO_DEVIATION * float(np.median(np.abs(rough - np.median(rough))))
    limit = _OUTLYING * max(spread, float(np.sqrt(noise_variance)))
    standing_out = np.abs(rough - np.median(rough)) > limit
    usual = np.where(standing_out, plane - rough, plane)
    # A straight continuation at the borders: reflection or repetition would flatten what rises there.
    edge = min(int(4.0 * sigma_px + 0.5), min(plane.shape) - 1)
    padded = np.pad(usual, edge, mode="reflect", reflect_type="odd")
    smooth = gaussian_filter(padded, sigma_px)[edge : padded.shape[0] - edge, edge : padded.shape[1] - edge]
    apart = usual - smooth
    seen = float(np.mean(apart[~standing_out] ** 2)) if not standing_out.all() else 0.0
    kept = min(1.0, max(0.0, 1.0 - noise_variance / seen)) if seen > 0.0 else 0.0
    return np.where(standing_out, plane, smooth + kept * apart), standing_out


def black_codes(stack: Codes) -> Floats:
    """Return (channels,) the code without light of dark photographs (n, h, w, channels), shortest exposure first.

    It is the mean of the shortest, without the hundredth of pixels at either end; 0 where the noise is cut off at
    code 0, as the mean of what is left lies above black.
    """
    codes = np.sort(np.asarray(stack[0]).reshape(-1, stack.shape[3]), axis=0)
    cut = len(codes) // 100
    mean = codes[cut : len(codes) - cut].mean(axis=0)
    return np.where(np.mean(codes == 0, axis=0) > _CUT_OFF, 0.0, mean)


def dark_model(stack: Codes, exposures_s: npt.ArrayLike, response: Response) -> Dark:
    """Fit the offset and the current of each pixel to dark photographs (n, h, w, channels), by least squares.

    Both are freed of noise by :func:`shrunk`. With fewer than three
    photographs all is offset; of a channel whose noise is cut off at code 0 only hot pixels are detected.

    Raises
    ------
    ValueRangeError
        The photographs do not fit the times or the response.
    """
    times = np.asarray(exposures_s, float)
    if stack.ndim != 4 or times.shape != stack.shape[:1] or stack.shape[3] != response.channels:
        raise ValueRangeError("dark", f"the shape {stack.shape} does not fit {times.size} exposure times")
    count = len(times)
    away = times - times.mean()
    spread = float(np.sum(away**2))
    offset = np.empty(stack.shape[1:], np.float32)
    rate = np.empty(stack.shape[1:], np.float32)
    hot = np.zeros(stack.shape[1:3], bool)
    for c in range(response.channels):
        mean, square, slope = (np.zeros(stack.shape[1:3]) for _ in range(3))
        for i in range(count):
            seen = response.exposure[c][stack[i, ..., c]]
            mean += seen / count
            square += seen * seen
            slope += seen * away[i]
        if spread > 0.0 and count > 2:
            left = np.maximum(square - count * mean**2 - slope**2 / spread, 0.0) / (count - 2)
            noise = float(np.mean(left))
            current, standing_out = shrunk(slope / spread, noise / spread, _SIGMA_PX)
            hot |= standing_out & (current > 0.0)
        else:
            noise = float(response.read[c]) ** 2
            current = np.zeros_like(mean)
        rate[..., c] = current
        offset[..., c] = shrunk(mean - current * times.mean(), noise / count, _SIGMA_PX)[0]
        if float(np.mean(stack[..., c] == 0)) > _CUT_OFF:
            # What is left of noise that is cut off at code 0 has a mean, which lit pixels do not have.
            rate[..., c] = np.where(hot, current, 0.0)
            offset[..., c] = 0.0
    return Dark(offset, rate, hot)


def flat_field(merged: MergedRadiance) -> Singles:
    """Return (h, w, channels) the flat field, 1 at the picture's centre, from photographs of an evenly lit screen.

    Raises
    ------
    AcquisitionError
        More than a hundredth of the picture is clipped or dark, or the screen is not even in the least.
    """
    seen = merged.radiance.astype(np.float64)
    bad = (merged.state != GOOD) | (seen <= 0.0)
    share = float(bad.mean())
    if share > 0.01:
        what = "dark" if np.mean(merged.state == DARK) > 0.5 * share else "clipped or dark"
        raise AcquisitionError(
            f"The flat field is {what} in {100.0 * share:.0f} % of its pixels; the screen must fill the picture,"
            " with an exposure that is neither."
        )
    height, width, channels = seen.shape
    sigma = max(1.0, _SMOOTH_SHARE * max(height, width))
    answer = np.empty_like(seen)
    for c in range(channels):
        level = float(np.median(seen[..., c]))
        plane = np.where(bad[..., c], level, seen[..., c]) / level
        noise = float(np.mean(merged.variance[..., c][~bad[..., c]])) / level**2
        answer[..., c] = shrunk(plane, noise, sigma)[0]
        answer[..., c] /= answer[_middle(height), _middle(width), c].mean()
    if float(answer.min()) < _LEAST:
        reason = "the screen does not fill it evenly"
        raise AcquisitionError(f"The flat field falls to nothing within the picture; {reason}.")
    return answer.astype(np.float32)


def _middle(size: int) -> slice:
    half = max(1, int(0.5 * _CENTRE_SHARE * size))
    return slice(max(0, size // 2 - half), min(size, size // 2 + half + size % 2))

"""Dark frame: the camera's signal without light, as an offset and a current that grows with exposure time.

One dark photograph for each exposure, subtracted as it is, would stamp its own noise on every position of the lamp. So
a straight line in time is fitted for each pixel over all of them, and what is left of noise in it is taken out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.radiance.noise_shrinking import shrunk
from brdf_suite.acquisition.response.response import Response
from brdf_suite.arrays import Singles
from brdf_suite.errors import ValueRangeError

_CUT_OFF = 0.25
_SIGMA_PX = 8.0


@dataclass(frozen=True, eq=False)
class Dark:
    """Exposure without light: ``offset + rate·t``.

    Attributes
    ----------
    offset
        (h, w, channels) float32, exposure.
    rate
        (h, w, channels) float32, exposure per second.
    hot
        (h, w) whether a pixel's current stands out far from that of its neighbours.
    """

    offset: Singles
    rate: Singles
    hot: npt.NDArray[np.bool_]

    def cropped(self, rows: slice, columns: slice) -> Dark:
        """Return the dark frame of a part of the picture."""
        part = (rows, columns)
        return Dark(
            np.ascontiguousarray(self.offset[part]),
            np.ascontiguousarray(self.rate[part]),
            np.ascontiguousarray(self.hot[part]),
        )


def black_codes(stack: npt.NDArray[np.uint8] | npt.NDArray[np.uint16]) -> npt.NDArray[np.float64]:
    """Return (channels,) the code without light of dark photographs (n, h, w, channels), shortest exposure first.

    It is the mean of the shortest, without the hundredth of pixels at either end; 0 where the noise is cut off at
    code 0, as the mean of what is left lies above black.
    """
    codes = np.sort(np.asarray(stack[0]).reshape(-1, stack.shape[3]), axis=0)
    cut = len(codes) // 100
    mean = codes[cut : len(codes) - cut].mean(axis=0)
    return np.where(np.mean(codes == 0, axis=0) > _CUT_OFF, 0.0, mean)


def dark_model(
    stack: npt.NDArray[np.uint8] | npt.NDArray[np.uint16], exposures_s: npt.ArrayLike, response: Response
) -> Dark:
    """Fit the offset and the current of each pixel to dark photographs (n, h, w, channels), by least squares.

    Both are freed of noise as :mod:`brdf_suite.acquisition.radiance.noise_shrinking` has it. With fewer than three
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

"""The dark frame: what the camera sees without light, as an offset and as a current that grows with time.

One dark photograph for each exposure, subtracted as it is, would stamp its own noise on every position of the lamp. A
straight line in time, fitted for each pixel over all of them, has a fraction of it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.response import Response
from brdf_suite.errors import ValueRangeError

Floats32 = npt.NDArray[np.float32]

_HOT_DEVIATIONS = 30.0
_CUT_OFF = 0.25
_SPREAD_TO_DEVIATION = 1.4826


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
        (h, w) whether a pixel's current stands out far from that of others, so that it is better left out.
    """

    offset: Floats32
    rate: Floats32
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

    With a single photograph all is taken as current, or as offset where the response's black is not 0.

    Raises
    ------
    ValueRangeError
        The photographs do not fit the times or the response.
    """
    times = np.asarray(exposures_s, float)
    if stack.ndim != 4 or times.shape != stack.shape[:1] or stack.shape[3] != response.channels:
        raise ValueRangeError("dark", f"the shape {stack.shape} does not fit {times.size} exposure times")
    mean = times.mean()
    spread = float(np.sum((times - mean) ** 2))
    total = np.zeros(stack.shape[1:])
    slope = np.zeros(stack.shape[1:])
    for i, time in enumerate(times):
        seen = np.stack([response.exposure[c][stack[i, ..., c]] for c in range(response.channels)], axis=-1)
        total += seen / len(times)
        slope += seen * (time - mean)
    rate = np.maximum(slope / spread, 0.0) if spread > 0.0 else np.zeros_like(slope)
    offset = total - rate * mean
    middle = np.median(rate, axis=(0, 1))
    away = _SPREAD_TO_DEVIATION * np.median(np.abs(rate - middle), axis=(0, 1))
    # Of a camera without current nearly all rates are noise about 0, cut at 0.
    noise = response.read / np.sqrt(max(spread, 1e-30))
    hot = np.any(rate > middle + _HOT_DEVIATIONS * np.maximum(away, noise), axis=-1)
    return Dark(offset.astype(np.float32), rate.astype(np.float32), hot)

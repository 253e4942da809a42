"""Merge a series of exposures into radiances, with the variance of each and what is clipped or black.

The radiance of a pixel is Σ w z / Σ w over its exposures, z = (g(code) - dark) / t, with w one over the variance of z:
the estimate of least variance (Granados et al. 2010, "Optimal HDR reconstruction with linear digital cameras"). The
variance is that of a first guess of the radiance, not that of each code: weights that follow the noise bend the mean.
Of exposures near saturation, those are taken whose *predicted* exposure stays three standard deviations below it.
"""

from __future__ import annotations

import math
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import cast

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.response.response import Response
from brdf_suite.arrays import Bools, Codes, Floats, Singles
from brdf_suite.compilation import Array, compiled
from brdf_suite.errors import ValueRangeError

OUTSIDE, GOOD, DARK, CLIPPED = 0, 1, 2, 3
"""States of a pixel: not in the mask; measured; below its noise in all exposures; clipped in all exposures."""

_DARK_SIGNAL = 3.0
# Squared: how many standard deviations a predicted exposure must stay below saturation.
_ROOM = 9.0
_CLEAR = 225.0  # squared: how many times its noise an exposure must be to inform the exposure times
_EVERY = 5  # of the pixels are used for the exposure times: a logarithm takes longer than all else
_ROWS = 32
# Float pictures carry no information on their noise: assume a thousandth of the signal.
_FLOAT_NOISE = 1e-3
_FEWEST_PAIRS = 20


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
    hot: Bools

    def cropped(self, rows: slice, columns: slice) -> Dark:
        """Return the dark frame of a part of the picture."""
        offset, rate, hot = self.offset[rows, columns], self.rate[rows, columns], self.hot[rows, columns]
        return Dark(np.ascontiguousarray(offset), np.ascontiguousarray(rate), np.ascontiguousarray(hot))


@dataclass(frozen=True, eq=False)
class MergedRadiance:
    """Merged radiances of one position of the lamp.

    Attributes
    ----------
    radiance
        (h, w, channels) float32, the photographs' unit per second; may be negative by noise where it is dark; a lower
        bound where ``state`` is ``CLIPPED``.
    variance
        (h, w, channels) float32, of the radiance, by noise and rounding.
    state
        (h, w, channels) uint8: ``OUTSIDE`` 0, ``GOOD`` 1, ``DARK`` 2, ``CLIPPED`` 3.
    time_ratios
        (n - 1,) logarithm of the ratio that pixels show between an exposure and the next; not a number where too few
        pixels see both.
    falling_share
        (n - 1,) the share of these pixels that is darker in the longer exposure.
    clipped_share, dark_share
        (n,) of the pixels within the mask, over all channels, for each exposure.
    """

    radiance: Singles
    variance: Singles
    state: npt.NDArray[np.uint8]
    time_ratios: Floats
    falling_share: Floats
    clipped_share: Floats
    dark_share: Floats

    @property
    def saturated(self) -> Bools:
        """Return (h, w) where any channel is clipped in all exposures."""
        return np.asarray(np.any(self.state == CLIPPED, axis=-1))

    @property
    def good(self) -> Bools:
        """Return (h, w) where every channel is measured, be it as dark."""
        return np.asarray(np.all((self.state == GOOD) | (self.state == DARK), axis=-1))


def merge(
    stack: Codes | Singles,
    exposures_s: npt.ArrayLike,
    response: Response | None = None,
    *,
    dark: Dark | None = None,
    flat: Singles | None = None,
    mask: npt.ArrayLike | None = None,
    threads: int | None = None,
) -> MergedRadiance:
    """Return the radiances that a series of photographs shows.

    Parameters
    ----------
    stack
        (n, h, w, channels) codes, or radiance times seconds as float; the shortest exposure first.
    exposures_s
        (n,) seconds.
    response
        Of the camera; ``None`` for float pictures, which are linear and nowhere clipped.
    dark
        The dark frame, of the size of the pictures.
    flat
        (h, w, channels) the flat field: what the camera sees of an even 1.
    mask
        (h, w) True where pixels are wanted.
    threads
        How many work at once; by default as many as there are cores, 4 at most. The answer does not depend on it.

    Raises
    ------
    ValueRangeError
        Shapes do not fit, a code is beyond the response's bits, or a float is not finite.
    """
    times = np.asarray(exposures_s, float)
    if stack.ndim != 4 or times.shape != stack.shape[:1] or not np.all(times > 0.0):
        raise ValueRangeError("stack", f"the shape {stack.shape} does not fit {times.size} exposure times")
    _, height, width, channels = stack.shape
    allowed = np.ones((1, 1), bool) if mask is None else np.ascontiguousarray(mask, bool)
    gain = np.ones((1, 1, channels), np.float32) if flat is None else np.ascontiguousarray(flat, np.float32)
    if mask is not None:
        _fits("mask", allowed, (height, width))
    if flat is not None:
        _fits("flat", gain, (height, width, channels))
    if np.issubdtype(stack.dtype, np.floating):
        floats = np.asarray(stack, np.float32)
        return _merge_floats(floats, times, gain, np.broadcast_to(allowed, (height, width)))
    if response is None:
        raise ValueRangeError("response", "photographs of whole codes need the response of their camera")
    if response.channels != channels:
        raise ValueRangeError("response", f"it has {response.channels} channels, the photographs {channels}")
    if dark is not None:
        _fits("dark", dark.offset, (height, width, channels))
    if stack.dtype not in (np.uint8, np.uint16):
        raise ValueRangeError("stack", f"expected codes of 8 or 16 bits or floats, not {stack.dtype}")
    codes = cast(Codes, np.ascontiguousarray(stack))
    return _merge_codes(codes, times, response, dark, gain, allowed, threads)


def _merge_codes(
    stack: Codes,
    times: Floats,
    response: Response,
    dark: Dark | None,
    gain: Singles,
    allowed: Bools,
    threads: int | None,
) -> MergedRadiance:
    count, height, width, channels = stack.shape
    size = 1 << response.bit_depth
    if response.bit_depth < 8 * stack.itemsize and int(stack.max(initial=0)) >= size:
        raise ValueRangeError("stack", f"it holds codes above the {size - 1} of {response.bit_depth} bits")
    # Each an array of its own: the variance may be dropped while the radiance is kept.
    shape = (height, width, channels)
    made = (np.empty(shape, np.float32), np.empty(shape, np.float32), np.empty(shape, np.uint8))
    starts = range(0, height, _ROWS)
    pairs = np.zeros((len(starts), count - 1, 3))
    clipped = np.zeros((len(starts), count), np.int64)
    unlit = np.zeros((len(starts), count + 1), np.int64)
    noise = (response.rounding_variance(), response.read, response.shot)
    camera = (*(part.astype(np.float32) for part in (response.exposure, *noise)), response.highest)
    nothing = np.zeros((1, 1, channels), np.float32)
    offset, rate = (nothing, nothing) if dark is None else (dark.offset, dark.rate)
    times = times.astype(np.float32)

    def rows(k: int) -> None:
        end = min(height, starts[k] + _ROWS)
        sums = (pairs[k], clipped[k], unlit[k])
        merge_rows(stack, times, camera, (offset, rate, gain, allowed), starts[k], end, made, sums)

    # The kernel holds no lock of the interpreter, so that threads share the rows.
    with ThreadPoolExecutor(threads or min(4, os.cpu_count() or 1)) as pool:
        list(pool.map(rows, range(len(starts))))
    every = pairs.sum(axis=0)
    known = every[:, 0] >= _FEWEST_PAIRS
    amount = np.where(known, every[:, 0], 1.0)
    pixels = max(1, int(unlit[:, count].sum()))
    return MergedRadiance(
        *made,
        np.where(known, every[:, 1] / amount, np.nan),
        np.where(known, every[:, 2] / amount, 0.0),
        clipped.sum(axis=0) / pixels,
        unlit[:, :count].sum(axis=0) / pixels,
    )


def _merge_floats(stack: Singles, times: Floats, gain: Singles, allowed: Bools) -> MergedRadiance:
    """Return the mean of float pictures weighted by exposure time; they have no detectable clipping."""
    if not np.all(np.isfinite(stack)):
        place = np.argwhere(~np.isfinite(stack))[0]
        reason = f"exposure {place[0] + 1} is not a number at column {place[2]}, row {place[1]}"
        raise ValueRangeError("stack", reason)
    value = np.tensordot(np.ones(len(times), np.float32), stack, 1) / np.float32(times.sum()) / gain
    value = np.where(allowed[..., None], value, np.float32(0.0))
    none = np.zeros(len(times))
    return MergedRadiance(
        value,
        np.asarray((_FLOAT_NOISE * value) ** 2, np.float32),
        np.where(allowed[..., None], np.uint8(GOOD), np.uint8(OUTSIDE)) * np.ones(value.shape, np.uint8),
        np.full(len(times) - 1, np.nan),
        np.zeros(len(times) - 1),
        none,
        none,
    )


def _fits(name: str, array: npt.NDArray[np.generic], shape: tuple[int, ...]) -> None:
    if array.shape != shape:
        raise ValueRangeError(name, f"the shape is {array.shape}, the pictures' is {shape}")


@compiled
def merge_rows(
    stack: Array, times: Array, camera: Array, maps: Array, first: int, end: int, made: Array, sums: Array
) -> None:
    """Merge rows ``first`` … ``end - 1`` of ``stack`` (n, h, w, channels) of codes, row by row to stay in cache.

    ``camera``: exposure and variance by rounding of a code (channels, codes); of each channel the standard deviation
    of reading, the variance over exposure, and the last code that is not clipped. ``maps``: offset and rate of the
    dark frame and the flat field (1 or h, 1 or w, channels), and what may be used (1 or h, 1 or w). ``made`` is
    filled: radiance, variance and state (h, w, channels). ``sums`` are added to, for these rows: (n - 1, 3) of the
    logarithm of the ratio of exposures next to each other (count, sum, how many fell), (n,) clipped and (n + 1,) dark
    pixels of each exposure, and in the last place all.
    """
    table, rounding, read, shot, highest = camera
    offset, rate, flat, mask = maps
    radiance, variance, state = made
    pairs, clipped, dark = sums
    exposures, _, width, channels = stack.shape
    sum_z = np.zeros((width, channels), np.float32)
    sum_t = np.zeros((width, channels), np.float32)
    sum_w = np.zeros((width, channels), np.float32)
    sum_wz = np.zeros((width, channels), np.float32)
    columns = np.zeros(width, np.int64)
    for row in range(first, end):
        dark_row = row if offset.shape[0] > 1 else 0
        flat_row = row if flat.shape[0] > 1 else 0
        mask_row = row if mask.shape[0] > 1 else 0
        used = 0
        for x in range(width):
            if mask[mask_row, x if mask.shape[1] > 1 else 0]:
                columns[used] = x
                used += 1
        for x in range(width):
            for c in range(channels):
                sum_z[x, c] = sum_t[x, c] = sum_w[x, c] = sum_wz[x, c] = 0.0
                radiance[row, x, c] = 0.0
                variance[row, x, c] = 0.0
                state[row, x, c] = OUTSIDE
        # What all exposures that are not clipped say together: a first guess, free of the noise of weights.
        for i in range(exposures):
            t = times[i]
            for c in range(channels):
                black = _DARK_SIGNAL * read[c]
                limit = highest[c]
                above = 0
                below = 0
                for k in range(used):
                    x = columns[k]
                    y = stack[i, row, x, c]
                    if y <= limit:
                        z = table[c, y] - offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                        sum_z[x, c] += z
                        sum_t[x, c] += t
                        below += z < black
                    else:
                        above += 1
                clipped[i] += above
                dark[i] += below
        dark[exposures] += used * channels
        for k in range(used):
            for c in range(channels):
                x = columns[k]
                if sum_t[x, c] > 0.0:
                    sum_z[x, c] /= sum_t[x, c]
        # Weights from the guess, not from each code: a code that noise made small would weigh more, and bend the mean.
        for i in range(exposures):
            t = times[i]
            for c in range(channels):
                limit = highest[c]
                square = read[c] * read[c]
                for k in range(used):
                    x = columns[k]
                    y = stack[i, row, x, c]
                    if y <= limit:
                        expected = max(t * sum_z[x, c], np.float32(0.0))
                        noise = square + shot[c] * expected + rounding[c, y]
                        # Predicted within its noise of saturation, only the low ones of such codes would be taken.
                        room = table[c, limit] - expected
                        if room > 0.0 and room * room > _ROOM * noise:
                            z = table[c, y] - offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                            weight = t / noise
                            sum_w[x, c] += weight * t
                            sum_wz[x, c] += weight * z
        for k in range(used):
            x = columns[k]
            for c in range(channels):
                if sum_w[x, c] > 0.0:
                    value = sum_wz[x, c] / sum_w[x, c]
                    spread = np.float32(1.0) / sum_w[x, c]
                    state[row, x, c] = GOOD
                else:
                    # The shortest exposure is within its noise of saturation, or clipped as all are.
                    y = stack[0, row, x, c]
                    z = table[c, y] - offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                    value = z / times[0]
                    noise = read[c] * read[c] + shot[c] * max(z, np.float32(0.0)) + rounding[c, y]
                    spread = noise / (times[0] * times[0])
                    state[row, x, c] = GOOD if y <= highest[c] else CLIPPED
                value -= rate[dark_row, x if rate.shape[1] > 1 else 0, c]
                if state[row, x, c] == GOOD and value < _DARK_SIGNAL * math.sqrt(spread):
                    state[row, x, c] = DARK
                gain = flat[flat_row, x if flat.shape[1] > 1 else 0, c]
                radiance[row, x, c] = value / gain
                variance[row, x, c] = spread / (gain * gain)
        for k in range(row % _EVERY, used, _EVERY):
            x = columns[k]
            for c in range(channels):
                black = offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                _add_pairs(stack[:, row, x, c], c, camera, black, pairs)


@compiled
def _add_pairs(codes: Array, c: int, camera: Array, offset: float, pairs: Array) -> None:
    table, rounding, read, shot, highest = camera
    before = -1.0
    for i in range(len(codes)):
        y = codes[i]
        z = table[c, y] - offset
        noise = read[c] * read[c] + shot[c] * max(z, 0.0) + rounding[c, y]
        clear = y <= highest[c] and z > 0.0 and z * z > _CLEAR * noise
        if clear and before > 0.0:
            pairs[i - 1, 0] += 1.0
            pairs[i - 1, 1] += math.log(z / before)
            if z < before:
                pairs[i - 1, 2] += 1.0
        before = z if clear else -1.0

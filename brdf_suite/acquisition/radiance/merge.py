"""Merge a series of exposures into radiances, with the variance of each and what is clipped or black.

The radiance of a pixel is Σ w z / Σ w over its exposures, z = (g(code) - dark) / t, with w one over the variance of z:
the estimate of least variance (Granados et al. 2010, "Optimal HDR reconstruction with linear digital cameras"). The
variance is that of a first guess of the radiance, not that of each code: weights that follow the noise bend the mean.
Of exposures near saturation, those are taken whose *predicted* exposure stays three standard deviations below it.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import cast

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.radiance import merge_kernels as compiled_merge
from brdf_suite.acquisition.radiance.dark_frame import Dark
from brdf_suite.acquisition.response.response import Response
from brdf_suite.arrays import Codes, Floats, Singles
from brdf_suite.errors import ValueRangeError

OUTSIDE, GOOD, DARK, CLIPPED = 0, 1, 2, 3
"""States of a pixel: not in the mask; measured; below its noise in all exposures; clipped in all exposures."""

_DARK_SIGNAL = 3.0
_ROWS = 32
# Float pictures carry no information on their noise: assume a thousandth of the signal.
_FLOAT_NOISE = 1e-3
_FEWEST_PAIRS = 20


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
    def saturated(self) -> npt.NDArray[np.bool_]:
        """Return (h, w) where any channel is clipped in all exposures."""
        return np.asarray(np.any(self.state == CLIPPED, axis=-1))

    @property
    def good(self) -> npt.NDArray[np.bool_]:
        """Return (h, w) where every channel is measured, be it as dark."""
        return np.asarray(np.all((self.state == GOOD) | (self.state == DARK), axis=-1))

    @property
    def certainty(self) -> Singles:
        """Return (h, w, channels) one over the variance, 0 where clipped or outside."""
        usable = (self.state == GOOD) | (self.state == DARK)
        answer = np.zeros_like(self.variance)
        np.divide(1.0, self.variance, out=answer, where=usable & (self.variance > 0.0))
        return answer


def merge(
    stack: Codes | Singles,
    exposures_s: npt.ArrayLike,
    response: Response | None = None,
    *,
    dark: Dark | None = None,
    flat: npt.NDArray[np.float32] | None = None,
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
    _fits("mask", allowed, (height, width), mask is not None)
    _fits("flat", gain, (height, width, channels), flat is not None)
    if np.issubdtype(stack.dtype, np.floating):
        return _merge_floats(
            np.asarray(stack, np.float32), times, gain, np.broadcast_to(allowed, (height, width))
        )
    if response is None:
        raise ValueRangeError("response", "photographs of whole codes need the response of their camera")
    if response.channels != channels:
        raise ValueRangeError("response", f"it has {response.channels} channels, the photographs {channels}")
    nothing = np.zeros((1, 1, channels), np.float32)
    offset = nothing if dark is None else dark.offset
    rate = nothing if dark is None else dark.rate
    _fits("dark", offset, (height, width, channels), dark is not None)
    if stack.dtype not in (np.uint8, np.uint16):
        raise ValueRangeError("stack", f"expected codes of 8 or 16 bits or floats, not {stack.dtype}")
    codes = cast(Codes, np.ascontiguousarray(stack))
    return _merge_codes(codes, times, response, offset, rate, gain, allowed, threads)


def _merge_codes(
    stack: Codes,
    times: Floats,
    response: Response,
    offset: Singles,
    rate: Singles,
    gain: Singles,
    allowed: npt.NDArray[np.bool_],
    threads: int | None,
) -> MergedRadiance:
    count, height, width, channels = stack.shape
    size = 1 << response.bit_depth
    if response.bit_depth < 8 * stack.itemsize and int(stack.max(initial=0)) >= size:
        raise ValueRangeError("stack", f"it holds codes above the {size - 1} of {response.bit_depth} bits")
    radiance = np.empty((height, width, channels), np.float32)
    variance = np.empty_like(radiance)
    state = np.empty((height, width, channels), np.uint8)
    starts = range(0, height, _ROWS)
    pairs = np.zeros((len(starts), count - 1, 3))
    clipped = np.zeros((len(starts), count), np.int64)
    dark = np.zeros((len(starts), count + 1), np.int64)
    table = response.exposure.astype(np.float32)
    rounding = response.rounding_variance().astype(np.float32)
    top = response.exposure[np.arange(channels), response.highest].astype(np.float32)

    def rows(k: int) -> None:
        compiled_merge.merge_rows(
            stack,
            times.astype(np.float32),
            table,
            rounding,
            response.read.astype(np.float32),
            response.shot.astype(np.float32),
            response.highest,
            top,
            offset,
            rate,
            gain,
            allowed,
            starts[k],
            min(height, starts[k] + _ROWS),
            _DARK_SIGNAL,
            radiance,
            variance,
            state,
            pairs[k],
            clipped[k],
            dark[k],
        )

    _each(rows, len(starts), threads)
    every = pairs.sum(axis=0)
    known = every[:, 0] >= _FEWEST_PAIRS
    amount = np.where(known, every[:, 0], 1.0)
    pixels = max(1, int(dark[:, count].sum()))
    return MergedRadiance(
        radiance,
        variance,
        state,
        np.where(known, every[:, 1] / amount, np.nan),
        np.where(known, every[:, 2] / amount, 0.0),
        clipped.sum(axis=0) / pixels,
        dark[:, :count].sum(axis=0) / pixels,
    )


def _each(work: Callable[[int], None], count: int, threads: int | None) -> None:
    """Call ``work`` for 0 … count - 1: the kernel holds no lock of the interpreter, so that threads share the rows."""
    if threads is None:
        threads = min(4, os.cpu_count() or 1)
    if threads <= 1 or count <= 1:
        for k in range(count):
            work(k)
        return
    with ThreadPoolExecutor(threads) as pool:
        for _ in pool.map(work, range(count)):
            pass


def _merge_floats(
    stack: Singles, times: Floats, gain: Singles, allowed: npt.NDArray[np.bool_]
) -> MergedRadiance:
    """Return the mean of float pictures weighted by exposure time; they have no detectable clipping."""
    if not np.all(np.isfinite(stack)):
        place = np.argwhere(~np.isfinite(stack))[0]
        raise ValueRangeError(
            "stack", f"exposure {place[0] + 1} is not a number at column {place[2]}, row {place[1]}"
        )
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


def _fits(name: str, array: npt.NDArray[np.generic], shape: tuple[int, ...], given: bool) -> None:
    if given and array.shape != shape:
        raise ValueRangeError(name, f"the shape is {array.shape}, the pictures' is {shape}")

"""Selection of the pixels for the recovery of a response: all usable ones, thinned evenly over brightness.

A position of the lamp shows mostly felt and dark paint; a highlight that informs the short exposures has few pixels.
So pixels are kept by how many of their exposures are clipped, as many of each kind. The thinning takes the same pixels
each time.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.response.response import check_bit_depth, default_highest
from brdf_suite.arrays import Codes, Floats, Integers
from brdf_suite.errors import AcquisitionError, ValueRangeError

PIXELS = 240_000
"""Kept for each channel; 120,000 gave the same curve to 0.001 in the logarithm of the exposure."""

_LOWEST_SHARE = 0.002
_UNLIT_SHARE = 0.03
_SEED = 20051


class ResponseSamples:
    """Codes of pixels under all exposures, gathered position by position.

    Parameters
    ----------
    exposures_s
        (n,) seconds, n of 2 or more, growing.
    bit_depth
        Of the codes, 8 to 16.
    channels
        How many channels the photographs have.
    """

    def __init__(self, exposures_s: npt.ArrayLike, bit_depth: int, channels: int = 3) -> None:
        check_bit_depth(bit_depth)
        self.times = np.asarray(exposures_s, float)
        if self.times.ndim != 1 or len(self.times) < 2 or not np.all(self.times > 0.0):
            raise ValueRangeError("exposures_s", "expected two or more exposure times greater than 0")
        if np.any(np.diff(self.times) <= 0.0):
            raise ValueRangeError("exposures_s", "list the exposures from the shortest to the longest")
        self.bit_depth = bit_depth
        self.channels = channels
        self.largest = np.zeros(channels, np.int64)
        self.seen = np.zeros(channels, np.int64)
        self._kept: list[list[npt.NDArray[np.uint16]]] = [
            [np.empty((0, len(self.times)), np.uint16) for _ in self.times] for _ in range(channels)
        ]
        self._unlit = np.zeros((channels, 1 << bit_depth), np.int64)
        self._top = np.zeros((channels, 1 << bit_depth), np.int64)
        self._random = np.random.default_rng(_SEED)

    def add(self, stack: Codes, mask: npt.ArrayLike | None = None) -> None:
        """Add the photographs of one position: (n, h, w, channels) codes, shortest exposure first.

        ``mask`` (h, w) is True where pixels may be used.
        """
        if stack.ndim != 4 or stack.shape[0] != len(self.times) or stack.shape[3] != self.channels:
            reason = f"the shape is {stack.shape}, not ({len(self.times)}, h, w, {self.channels})"
            raise ValueRangeError("stack", reason)
        if stack.dtype not in (np.uint8, np.uint16):
            raise ValueRangeError("stack", f"expected codes, not {stack.dtype}")
        chosen = None if mask is None else np.flatnonzero(np.asarray(mask, bool))
        for c in range(self.channels):
            codes = stack[..., c].reshape(len(self.times), -1)
            self._add_channel(c, codes if chosen is None else codes[:, chosen])

    def codes(self, channel: int) -> npt.NDArray[np.uint16]:
        """Return the kept pixels of a channel, (p, n)."""
        return np.ascontiguousarray(np.concatenate(self._kept[channel]))

    def black(self) -> Floats:
        """Return (channels,) the code without light: the median of the shortest exposure where the longest is dark.

        Where no pixel is so dark it is 0.
        """
        found = np.zeros(self.channels)
        for c in range(self.channels):
            total = np.cumsum(self._unlit[c])
            if total[-1] > 0:
                found[c] = float(np.searchsorted(total, 0.5 * total[-1]))
        return found

    def highest(self) -> Integers:
        """Return (channels,) the last code below saturation, whose own level is where the largest codes pile up."""
        found = np.empty(self.channels, np.int64)
        for c in range(self.channels):
            found[c] = default_highest(self.bit_depth)
            top = int(self.largest[c])
            below = default_highest(self.bit_depth, top) if top > 8 else 0
            width = top - below
            if top > 8 and below > width:
                piled = int(self._top[c, below + 1 : top + 1].sum())
                before = int(self._top[c, below - width + 1 : below + 1].sum())
                if piled > 4 * before + 16:
                    found[c] = below
        return found

    def _add_channel(self, c: int, codes: Codes) -> None:
        full = (1 << self.bit_depth) - 1
        if codes.size == 0:
            return
        largest = int(codes.max())
        if largest > full:
            bits = f"the {full} of {self.bit_depth} bits"
            raise AcquisitionError(f"A photograph holds the code {largest}, above {bits}.")
        self.largest[c] = max(self.largest[c], largest)
        self._top[c] += np.bincount(codes[-1], minlength=full + 1)
        dark = codes[-1] < _UNLIT_SHARE * full
        self._unlit[c] += np.bincount(codes[0, dark], minlength=full + 1)
        clipped = (codes > default_highest(self.bit_depth)).sum(axis=0)
        lowest = self.black()[c] + max(2.0, _LOWEST_SHARE * full)
        usable = ((codes >= lowest) & (codes <= default_highest(self.bit_depth))).sum(axis=0) >= 2
        self.seen[c] += int(np.count_nonzero(usable))
        most = max(1, PIXELS // len(self.times))
        for kind in np.unique(clipped[usable]):
            found = np.flatnonzero(usable & (clipped == kind))
            if len(found) > most:
                found = np.sort(self._random.choice(found, most, replace=False))
            kept = np.concatenate((self._kept[c][kind], codes[:, found].T.astype(np.uint16)))
            if len(kept) > most:
                kept = kept[np.sort(self._random.choice(len(kept), most, replace=False))]
            self._kept[c][kind] = kept


def spread(positions: Sequence[int] | int, most: int = 8) -> list[int]:
    """Return at most ``most`` positions, evenly spread over those given (or over so many)."""
    every = list(range(positions)) if isinstance(positions, int) else list(positions)
    if len(every) <= most:
        return every
    return [every[round(k * (len(every) - 1) / (most - 1))] for k in range(most)]

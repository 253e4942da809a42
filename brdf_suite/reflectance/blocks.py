"""Blockwise, multithreaded evaluation of many direction pairs, sized for the processor's cache.

numpy writes every intermediate to memory; over a million pairs that costs more than the arithmetic. In blocks
the intermediates stay in the cache, and numpy lets other threads run while it computes.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats

BLOCK = 16_384
"""Pairs a block: intermediates of 128 kB each."""

_MOST_THREADS = 4


def in_blocks(
    evaluate: Callable[[Floats, Floats], Floats], wi: npt.ArrayLike, wo: npt.ArrayLike, block: int = BLOCK
) -> Floats:
    """Return ``evaluate(wi, wo)`` (..., 3) for broadcast (..., 3) directions, block by block.

    ``evaluate`` gets (n, 3) arrays and returns (n, 3); it must treat each pair on its own.
    """
    wi, wo = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
    shape = wi.shape
    light, view = wi.reshape(-1, 3), wo.reshape(-1, 3)
    count = len(light)
    if count <= block:
        return evaluate(light, view).reshape(shape)
    out = np.empty((count, 3))

    def fill(start: int) -> None:
        part = slice(start, start + block)
        out[part] = evaluate(light[part], view[part])

    threads = min(_MOST_THREADS, os.cpu_count() or 1)
    starts = range(0, count, block)
    if threads == 1:
        for start in starts:
            fill(start)
    else:
        with ThreadPoolExecutor(threads) as pool:
            # list() raises what a block raised.
            list(pool.map(fill, starts))
    return out.reshape(shape)

"""Blockwise, multithreaded evaluation of many direction pairs, sized for the processor's cache.

numpy writes every intermediate to memory; over a million pairs that costs more than the arithmetic. In blocks
the intermediates stay in the cache, and numpy lets other threads run while it computes.
"""

from __future__ import annotations

import os
from collections.abc import Callable

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
        # Only here: small calls, as on the edit path, need no threads and no import.
        from concurrent.futures import ThreadPoolExecutor

        with ThreadPoolExecutor(threads) as pool:
            # list() raises what a block raised.
            list(pool.map(fill, starts))
    return out.reshape(shape)


LookUp = Callable[[Floats, Floats], npt.NDArray[np.floating]]
"""Contiguous columns of ``wi`` and ``wo``, (3, n) each, all above the horizon -> (n, c)."""


def look_up_above(look_up: LookUp, light: Floats, view: Floats, channels: int = 3) -> Floats:
    """Return (n, channels) of ``look_up`` for directions (n, 3).

    Pairs with either direction at or below the horizon, or not a number, give 0 and are never looked up.
    """
    i, o = np.ascontiguousarray(light.T), np.ascontiguousarray(view.T)
    above = (i[2] > 0.0) & (o[2] > 0.0)
    # A sum is finite only where every term is; one test for all six columns.
    above &= np.isfinite(i.sum(axis=0) + o.sum(axis=0))
    if above.all():
        return np.asarray(look_up(i, o), np.float64)
    result = np.zeros((len(light), channels))
    if above.any():
        result[above] = look_up(np.compress(above, i, axis=1), np.compress(above, o, axis=1))
    return result

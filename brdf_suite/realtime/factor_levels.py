"""Coarser levels of a factor's map: a highlight smaller than a pixel is then a mean, and does not flicker.

A level is half as fine as the one before it, each texel the mean of the area that it covers: of the values, not of
their logarithms, since light adds up. Of a hemisphere, texels beyond the horizon, which no direction meets, are left
out.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def levels(values: NDArray[Any], *, logarithmic: bool, hemisphere: bool) -> Iterator[Floats]:
    """Yield the levels (rows, columns, 3) of a map, the map itself first, down to one texel, as OpenGL sizes them."""
    present = np.asarray(values, np.float64)
    inside = _inside(len(present)) if hemisphere else np.ones(present.shape[:2])
    while True:
        yield present
        rows, columns = present.shape[:2]
        if rows == columns == 1:
            return
        down, across = _areas(rows), _areas(columns)
        weight = down @ inside @ across.T
        kept = np.where(weight > 0.0, weight, 1.0)[..., None]
        # Around the largest value, so that no exponential is out of range.
        top = present.max(axis=(0, 1)) if logarithmic else np.zeros(3)
        light = np.exp(present - top) if logarithmic else present
        mean = np.einsum("ij,jkc,lk->ilc", down, light * inside[..., None], across) / kept
        plain = np.einsum("ij,jkc,lk->ilc", down, light, across)
        mean = np.where(weight[..., None] > 0.0, mean, plain)
        present = np.log(np.maximum(mean, 1e-35)) + top if logarithmic else mean
        inside = (weight > 0.0).astype(np.float64) if hemisphere else np.ones(weight.shape)


def _areas(size: int) -> Floats:
    """Return (size // 2, size), at least one row: the share of each texel in those of the next level; rows sum to 1."""
    fewer = max(size // 2, 1)
    edges = np.linspace(0.0, size, fewer + 1)
    low, high = edges[:-1, None], edges[1:, None]
    texel = np.arange(size)[None]
    overlap = np.clip(np.minimum(high, texel + 1.0) - np.maximum(low, texel), 0.0, None)
    return np.asarray(overlap / overlap.sum(axis=1, keepdims=True))


def _inside(size: int) -> Floats:
    """Return 1 where a texel of a parabolic map touches the disc, 0 elsewhere."""
    along = np.maximum(np.abs((2.0 * np.arange(size) + 1.0) / size - 1.0) - 1.0 / size, 0.0)
    return (np.hypot(along[:, None], along) < 1.0).astype(np.float64)

"""Levels of a factor's map, so that a highlight smaller than a pixel does not flicker, and its cube faces.

A level is half as fine as the one before it, each texel the mean of the area that it covers: of the values, not of
their logarithms, since light adds up. Of a hemisphere, texels beyond the horizon, which no direction meets, are left
out.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.geometry.parabolic import parabolic_place


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


def radial_levels(values: NDArray[Any], *, logarithmic: bool, power: float) -> Iterator[Floats]:
    """Yield the levels (1, n, 3) of a map (n, 3) along a radius, the map itself first.

    ``power``: the radius of a parabolic map is the place to this power. What such a map represents is a disc, so a
    texel is the mean over the rings that it is read for, each by its area and the texel's part in what is interpolated
    there. So the light of the whole disc stays the same from level to level; means along the radius alone would spread
    a peak over rings that are larger than it, and brighten it manifold.
    """
    level0 = np.asarray(values, np.float64)
    yield level0[None]
    size = len(level0)
    fine = (np.arange(16 * size) + 0.5) / (16 * size)
    top = level0.max(axis=0) if logarithmic else np.zeros(3)
    between = _hats(fine, size) @ level0
    light = np.exp(between - top) if logarithmic else between
    area = fine ** (2.0 * power - 1.0)
    while size > 1:
        size //= 2
        hats = _hats(fine, size) * area[:, None]
        mean = (hats.T @ light) / hats.sum(axis=0)[:, None]
        yield (np.log(np.maximum(mean, 1e-35)) + top if logarithmic else mean)[None]


def _hats(places: Floats, size: int) -> Floats:
    """Return (k, size): by how much each texel counts at places in [0, 1], linear between, held at the ends."""
    at = np.clip(places * size - 0.5, 0.0, size - 1.0)
    return np.maximum(1.0 - np.abs(at[:, None] - np.arange(size)), 0.0)


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


def cube_faces(values: NDArray[Any]) -> Floats:
    """Return the faces (6, n, n, 3) of a parabolic map (n, n, 3), in OpenGL's order, rows and columns.

    Texels are the map's, bilinear between its own, at their directions; those below the horizon take what is nearest on
    it. A face of n texels is twice as fine as the map in its middle.
    """
    size = len(values)
    directions = texel_directions(size)
    directions[..., 2] = np.maximum(directions[..., 2], 0.0)
    level = np.linalg.norm(directions, axis=-1, keepdims=True)
    s, t = parabolic_place(directions / np.where(level > 0.0, level, 1.0))
    x, y = (np.clip(0.5 * (place + 1.0) * size - 0.5, 0.0, size - 1.0) for place in (s, t))
    i, j = (np.minimum(place.astype(np.int64), max(size - 2, 0)) for place in (x, y))
    u, v = (x - i)[..., None], (y - j)[..., None]
    right, above = np.minimum(i + 1, size - 1), np.minimum(j + 1, size - 1)
    low = values[j, i] * (1.0 - u) + values[j, right] * u
    high = values[above, i] * (1.0 - u) + values[above, right] * u
    return np.asarray(low * (1.0 - v) + high * v, np.float64)

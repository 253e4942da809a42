"""Sample places of a mesh's occlusion, spread over the triangles.

Not at the vertices: a vertex often lies on an edge where bodies touch, or inside the next body, and would say
nothing of the triangles around it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Integers, Singles

_OFFSET = 2e-5
"""Rays start so far above the surface, as a share of the object's size: 0.1 mm on a car."""


@dataclass(frozen=True, eq=False)
class Places:
    """Places on triangles.

    ``triangle`` (n,) says on which, ``weights`` (n, 3) where on it (they add up to 1), ``area`` (n,) for how much
    surface each stands (m²); ``points`` are just above the surface; ``normals`` and ``planes`` are the
    interpolated and the triangle's own unit normals.
    """

    triangle: Integers
    weights: Floats
    area: Floats
    points: Singles
    normals: Singles
    planes: Singles


def spread(positions: Singles, normals: Singles, triangles: Integers, count: int) -> Places:
    """Spread about ``count`` places: half of them evenly over the area, half evenly over the triangles.

    The first half gives large triangles enough, the second leaves no fine detail without. Normals need not have
    unit length. Triangles without area get none.
    """
    corners = positions[triangles].astype(np.float64)
    doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(doubled, axis=1)
    sound = length > 0.0
    share = 0.5 * length / length.sum() + 0.5 * sound / sound.sum()
    # Systematic sampling: triangle t gets the whole numbers between the running sums before and after it.
    ends = np.floor(np.cumsum(share) * count + 0.5).astype(np.int64)
    numbers = np.diff(ends, prepend=0)
    triangle = np.repeat(np.arange(len(triangles)), numbers)
    area = _areas(length, share, count)[triangle]
    rank = np.arange(len(triangle)) - np.repeat(ends - numbers, numbers)
    weights = _inside(triangle, rank)
    points = np.einsum("nk,nkd->nd", weights, corners[triangle])
    planes = doubled[triangle] / length[triangle, None]
    smooth = np.einsum("nk,nkd->nd", weights, normals[triangles[triangle]].astype(np.float64))
    # Normals of a foreign mesh may point to the other side of its triangles; light counts on theirs.
    planes *= np.where(np.einsum("nd,nd->n", smooth, planes) < 0.0, -1.0, 1.0)[:, None]
    size = np.linalg.norm(smooth, axis=1, keepdims=True)
    smooth = np.where(size > 1e-6, smooth / np.maximum(size, 1e-6), planes)
    lift = _OFFSET * float(np.ptp(positions, axis=0).max())
    return Places(
        triangle,
        weights,
        area,
        _single(points + lift * planes),
        _single(smooth),
        _single(planes),
    )


def _areas(length: Floats, share: Floats, count: int) -> Floats:
    """Return the surface that a place on each triangle represents: its area over the number expected there."""
    return np.asarray(0.5 * length / np.maximum(share * count, 1e-30))


def _inside(triangle: Integers, rank: Integers) -> Floats:
    """Return places inside triangles: an R2 sequence for each, shifted by its number."""
    turn = triangle * 0.6180339887498949
    u = (0.5 + rank * 0.7548776662466927 + turn) % 1.0
    v = (0.5 + rank * 0.5698402909980532 + turn * 1.3247179572447460) % 1.0
    folded = u + v > 1.0
    u, v = np.where(folded, 1.0 - u, u), np.where(folded, 1.0 - v, v)
    return np.stack([1.0 - u - v, u, v], axis=1)


def _single(values: NDArray[Any]) -> Singles:
    return np.ascontiguousarray(values, np.float32)

"""Whether triangles bound a solid, so that only the sides which their winding faces can be seen from outside."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.geometry.components import connected_components

_MERGED = 1e-5
"""Vertices that lie closer than this share of the surface's extent are one."""


def is_closed_outward(positions: NDArray[np.float32], triangles: NDArray[np.integer]) -> bool:
    """Return whether every connected surface of ``triangles`` (k, 3) is closed and wound outward.

    Closed: each edge of a triangle is met by the same number of edges in the other direction. Wound outward:
    counter-clockwise seen from outside, so that the enclosed volume is positive. ``positions`` (n, 3) may hold a
    place several times, as meshes with seams do.

    >>> corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    >>> sides = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    >>> [is_closed_outward(corners, sides), is_closed_outward(corners, sides[:, ::-1])]
    [True, False]
    >>> is_closed_outward(corners, sides[1:])
    False
    """
    low = positions.min(axis=0)
    step = float((positions.max(axis=0) - low).max()) * _MERGED
    if not step > 0.0:
        return False
    grid = np.rint((positions.astype(np.float64) - low) / step).astype(np.int64)
    size = int(grid.max()) + 1  # 1e5 + 1, so that a place is one number below 2^63
    _, merged = np.unique((grid[:, 0] * size + grid[:, 1]) * size + grid[:, 2], return_inverse=True)
    corners = merged[triangles]
    count = len(positions)
    first, second = corners.ravel(), np.roll(corners, -1, axis=1).ravel()
    real = first != second
    forward, backward = (first * count + second)[real], (second * count + first)[real]
    if not np.array_equal(np.sort(forward), np.sort(backward)):
        return False
    whole, names = connected_components(count, first, second)
    a, b, c = (positions[triangles].astype(np.float64) - low).transpose(1, 0, 2)
    volumes = np.bincount(names[corners[:, 0]], np.einsum("ij,ij->i", a, np.cross(b, c)), whole)
    return bool((volumes[np.unique(names[corners[:, 0]])] > 0.0).all())

"""Rectangular grids of surface points: their triangles, normals and lengths."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats

Surface = Callable[[Floats, Floats], Floats]
"""Two parameter arrays of one shape in, points (..., 3) out."""


def smooth_step(x: Floats, start: float, end: float) -> Floats:
    """Return 0 before ``start``, 1 after ``end``, and between them the seventh-degree step.

    Its first three derivatives vanish at both ends, so what it blends keeps its curvature continuous.
    """
    t = np.clip((x - start) / (end - start), 0.0, 1.0)
    return np.asarray(t**4 * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t))))


def grid_triangles(rows: int, columns: int) -> NDArray[np.int64]:
    """Return triangles (2·(rows - 1)·(columns - 1), 3) over a row-major grid; they face row × column."""
    index = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    halves = [np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)]
    return np.concatenate([half.reshape(-1, 3) for half in halves])


def with_area(positions: Floats, triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """Leave out triangles that a pole of the grid has flattened to a line."""
    a, b, c = (positions[triangles[:, corner]] for corner in range(3))
    doubled = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return np.asarray(triangles[doubled > 1e-9 * doubled.max()])


def grid_normals(surface: Surface, first: Floats, second: Floats, step: float = 1e-5) -> Floats:
    """Return unit normals (..., 3) along ∂/∂first × ∂/∂second, by central differences of ``surface``.

    In double precision the error is about ``step``² times the third derivative: 1e-9 for the forms here.
    """
    along = surface(first + step, second) - surface(first - step, second)
    across = surface(first, second + step) - surface(first, second - step)
    normal = np.cross(along, across)
    return np.asarray(normal / np.linalg.norm(normal, axis=-1, keepdims=True))


def lengths_along(points: Floats, axis: int, start: int) -> Floats:
    """Return the signed length along a grid (rows, columns, 3) on ``axis`` from line ``start``."""
    steps = np.linalg.norm(np.diff(points, axis=axis), axis=-1)
    pad = [(0, 0), (0, 0)]
    pad[axis] = (1, 0)
    total = np.pad(np.cumsum(steps, axis=axis), pad)
    return np.asarray(total - np.take(total, [start], axis=axis))

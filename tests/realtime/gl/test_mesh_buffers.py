"""The order in which a mesh's triangles are drawn."""

from __future__ import annotations

import numpy as np

from brdf_suite.realtime.gl.mesh_buffers import in_clusters

GRID = 40


def grid():
    """Corners (n, 3) and triangles (k, 3) of a flat grid of squares, the triangles in no order."""
    y, x = np.divmod(np.arange(GRID**2), GRID)
    first = np.arange(GRID**2)[(x < GRID - 1) & (y < GRID - 1)]
    lower = np.stack([first, first + 1, first + GRID], axis=1)
    upper = np.stack([first + 1, first + GRID + 1, first + GRID], axis=1)
    triangles = np.concatenate([lower, upper]).astype(np.uint32)
    corners = np.stack([0.1 * x, 0.1 * y - 7.0, np.zeros(len(x))], axis=1).astype(np.float32)
    return corners, np.random.default_rng(3).permutation(triangles)


def fetched(triangles, batch=300):
    """How many corners are worked out when those of a batch of triangles are kept until its end."""
    return sum(len(np.unique(triangles[i : i + batch])) for i in range(0, len(triangles), batch))


def test_neighbours_follow_each_other():
    corners, mixed = grid()
    ordered = in_clusters(corners, mixed)
    assert ordered.dtype == mixed.dtype
    assert (np.unique(ordered, axis=0) == np.unique(mixed, axis=0)).all()
    assert fetched(mixed) > 3 * GRID**2
    assert fetched(ordered) < 1.4 * GRID**2


def test_a_mesh_without_extent_stays():
    corners, mixed = grid()
    assert (in_clusters(0.0 * corners, mixed) == mixed).all()
    assert (in_clusters(1e-30 * corners, mixed[:1]) == mixed[:1]).all()

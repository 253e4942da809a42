"""A ball of triangles in rings about the vertical, with exact normals: what benchmarks and tests draw."""

from __future__ import annotations

import numpy as np

from brdf_suite.realtime.values import MeshPart


def ball(
    radius: float,
    rings: int,
    *,
    name: str = "ball",
    material: str = "paint",
    centre: tuple[float, ...] = (0.0, 0.0, 0.0),
    with_uvs: bool = False,
) -> MeshPart:
    """Return a ball of ``4 rings²`` triangles; ``radius`` and ``centre`` in metres.

    ``with_uvs`` gives it texture coordinates in millimetres along its meridians and its equator.
    """
    v, u = np.meshgrid(
        np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings + 1), indexing="ij"
    )
    n = np.stack([np.sin(v) * np.sin(u), np.cos(v), np.sin(v) * np.cos(u)], -1).reshape(-1, 3)
    row = 2 * rings + 1
    i = (np.arange(rings)[:, None] * row + np.arange(row - 1)[None]).ravel()
    triangles = np.concatenate(
        [np.stack([i, i + row, i + 1], -1), np.stack([i + 1, i + row, i + row + 1], -1)]
    )
    uvs = 1e3 * radius * np.stack([u, v], -1).reshape(-1, 2) if with_uvs else None
    return MeshPart(name, material, n * radius + np.asarray(centre), n, triangles.astype(np.uint32), uvs)

"""A sphere, 20 cm across: every angle of a paint in one picture.

Six patches of equal angles (the equiangular cube), so that triangles and texture coordinates are nearly even all
over and no pole gathers them.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.surface.mesh import Mesh, PartGeometry
from meshes.forms.grid import grid_triangles

RADIUS_MM = 100.0
CELLS = 64

# Equal angles make a patch a little large; scaled so that the whole has the sphere's area.
_EQUAL_AREA = np.sqrt(8.0 / (3.0 * np.pi))

# For each patch: the directions of its right, its up and its outward axis; right × up = outward.
_FRAMES = (
    ((0, 0, -1), (0, 1, 0), (1, 0, 0)),
    ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
)


def sphere() -> Mesh:
    """Return the sphere, radius 0.1 m, standing on y = 0, one painted part; its normals are exact."""
    angle = np.linspace(-0.25 * np.pi, 0.25 * np.pi, CELLS + 1)
    right, up = (grid.reshape(-1) for grid in np.meshgrid(angle, angle, indexing="ij"))
    across = np.stack([np.tan(right), np.tan(up), np.ones_like(up)], axis=1)
    normals = np.concatenate([across @ np.array(frame, dtype=np.float64) for frame in _FRAMES])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    patch = grid_triangles(CELLS + 1, CELLS + 1)
    count = (CELLS + 1) ** 2
    triangles = np.concatenate([patch + index * count for index in range(len(_FRAMES))])
    charts = [np.stack([right + 2.0 * index, up], axis=1) for index in range(len(_FRAMES))]
    positions = (normals + np.array([0.0, 1.0, 0.0])) * RADIUS_MM / 1000.0
    uvs = np.concatenate(charts) * RADIUS_MM * _EQUAL_AREA
    part = PartGeometry("sphere", "paint", positions, normals, uvs, triangles)
    return Mesh("sphere", (part,))

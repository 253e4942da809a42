"""Import options of a mesh: scale, placement on the ground, flipped or recomputed normals."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.normals import corner_normals, face_normals, weld
from brdf_suite.surface.repair import CREASE_DEG, split_corners


def shape_mesh(mesh: Mesh, look: SurfaceLook) -> Mesh:
    """Return ``mesh`` with scale, place and normals of ``look``; the same object where nothing is to be done.

    Texture coordinates are lengths on the surface and grow with it. Where normals are made again, vertices are split at
    edges: ``smooth`` keeps those above 40°, ``flat`` all. ``flip_normals`` turns triangles and normals to the
    other side. The unit belongs to the file and is no matter of this.
    """
    parts = list(mesh.parts)
    if look.normals != "file":
        crease = CREASE_DEG if look.normals == "smooth" else 0.0
        parts = [_with_normals(part, crease) for part in parts]
    if look.flip_normals:
        parts = [replace(p, normals=-p.normals, triangles=p.triangles[:, ::-1]) for p in parts]
    if look.scale != 1.0:
        parts = [_scaled(p, look.scale) for p in parts]
    if look.recentre:
        low, high = Mesh(mesh.name, tuple(parts)).bounds()
        shift = np.array([low[0] + high[0], 2.0 * low[1], low[2] + high[2]]) / 2.0
        if np.abs(shift).max() > 1e-7 * np.abs(high - low).max():
            parts = [replace(p, positions=p.positions - shift) for p in parts]
    if all(one is other for one, other in zip(parts, mesh.parts, strict=True)):
        return mesh
    return Mesh(mesh.name, tuple(parts), mesh.notes)


def _scaled(part: PartGeometry, scale: float) -> PartGeometry:
    return replace(part, positions=_times(part.positions, scale), uvs=_times(part.uvs, scale))


def _times(values: NDArray[Any], scale: float) -> NDArray[np.float64]:
    return np.asarray(values.astype(np.float64) * scale)


def _with_normals(part: PartGeometry, crease_deg: float) -> PartGeometry:
    positions, triangles = part.positions.astype(np.float64), part.triangles.astype(np.int64)
    if crease_deg > 0.0:
        corners = corner_normals(positions, triangles, weld(positions), crease_deg)
    else:
        corners = np.repeat(face_normals(positions, triangles)[:, None, :], 3, axis=1)
    # A triangle too thin to have a normal in single precision keeps what its corners had.
    lost = np.linalg.norm(corners, axis=2) < 0.5
    corners[lost] = part.normals[triangles[lost]]
    # Some files wind triangles against their normals; made again, normals stay on the side that they were on.
    given = part.normals[triangles].sum(axis=1)
    corners *= np.where(np.einsum("kd,kd->k", corners.sum(axis=1), given) < 0.0, -1.0, 1.0)[:, None, None]
    made, indices, normals, kept = split_corners(positions, triangles, corners)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return replace(part, positions=made, normals=normals, uvs=part.uvs[kept], triangles=indices)

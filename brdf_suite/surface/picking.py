"""Picking: the first intersection of a ray with a mesh, for clicks in the picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.surface.mesh import Mesh


@dataclass(frozen=True, eq=False)
class PickHit:
    """A picked point on a mesh.

    ``part`` is its number among the mesh's parts, ``distance`` (m) the way from the ray's origin, ``position`` (3,)
    in metres, ``normal`` (3,) the interpolated unit normal as the mesh has it, ``uv`` (2,) in millimetres.
    """

    part: int
    triangle: int
    distance: float
    position: Floats
    normal: Floats
    uv: Floats


def pick(mesh: Mesh, origin: Floats, direction: Floats) -> PickHit | None:
    """Return the first place that the ray meets, from either side of the triangles; None where it meets nothing.

    All triangles of the parts whose boxes the ray crosses are tried (Möller and Trumbore 1997): a million take some
    tenths of a second, once a click, with nothing to be prepared or kept.
    """
    start, ray = np.asarray(origin, np.float64), np.asarray(direction, np.float64)
    ray = ray / np.linalg.norm(ray)
    best: tuple[float, int, int, float, float] | None = None
    for number, part in enumerate(mesh.parts):
        if not _crosses(*part.bounds(), start, ray):
            continue
        # Relative to the origin first: single precision is then spent on the object, not on where it stands.
        corners = (part.positions.astype(np.float64) - start)[part.triangles]
        a = corners[:, 0]
        one, other = corners[:, 1] - a, corners[:, 2] - a
        p = np.cross(ray, other)
        determinant = np.einsum("ij,ij->i", one, p)
        inverse = np.divide(1.0, determinant, out=np.zeros_like(determinant), where=determinant != 0.0)
        u = -np.einsum("ij,ij->i", a, p) * inverse
        q = np.cross(-a, one)
        v = (q @ ray) * inverse
        distance = np.einsum("ij,ij->i", other, q) * inverse
        met = np.flatnonzero(
            (determinant != 0.0) & (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (distance > 0.0)
        )
        if len(met):
            first = int(met[np.argmin(distance[met])])
            if best is None or distance[first] < best[0]:
                best = (float(distance[first]), number, first, float(u[first]), float(v[first]))
    if best is None:
        return None
    distance_m, number, triangle, at_one, at_other = best
    part = mesh.parts[number]
    weights = np.array([1.0 - at_one - at_other, at_one, at_other])
    index = part.triangles[triangle]
    normal = weights @ part.normals[index].astype(np.float64)
    length = float(np.linalg.norm(normal))
    normal = normal / length if length > 0.0 else np.array([0.0, 1.0, 0.0])
    uv = weights @ part.uvs[index].astype(np.float64)
    return PickHit(number, triangle, distance_m, start + distance_m * ray, normal, uv)


def _crosses(low: Floats, high: Floats, start: Floats, ray: Floats) -> bool:
    """Whether a ray meets a box, which is taken a hair larger: flat parts have boxes without volume."""
    hair = 1e-6 * float(np.abs(high - low).max() + np.abs(high).max())
    along = np.where(np.abs(ray) > 1e-12, ray, 1e-12)
    one, other = (low - hair - start) / along, (high + hair - start) / along
    near, far = np.minimum(one, other).max(), np.maximum(one, other).min()
    return bool(far >= max(near, 0.0))

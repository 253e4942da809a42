"""Texture coordinates in millimetres on the surface.

Flakes are counted per square millimetre of texture space, so what matters is that one millimetre there is one
millimetre on the surface, in both directions; seams do not show. Coordinates of a file are kept, scaled,
where they are even enough; else each triangle is projected from the side of a box that it faces, which
stretches by at most √3.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats, Integers
from brdf_suite.surface.normals import face_normals, used_numbers

MILLIMETRES = 1000.0
_EVEN = 2.0
_SHARE = 0.8


def stretch(positions: Floats, triangles: Integers, uvs: Floats) -> tuple[Floats, Floats]:
    """Return the smallest and largest length in texture space of a unit length on each triangle, (k,) each.

    The singular values of the Jacobian from the triangle's plane to texture space; units of ``uvs`` per unit
    of ``positions``.
    """
    a, b, c = (positions[triangles[:, corner]] for corner in range(3))
    along = b - a
    base = np.linalg.norm(along, axis=1)
    x_axis = along / base[:, None]
    other = c - a
    shear = np.einsum("ij,ij->i", other, x_axis)
    height = np.linalg.norm(other - shear[:, None] * x_axis, axis=1)
    uv_along = (uvs[triangles[:, 1]] - uvs[triangles[:, 0]]) / base[:, None]
    uv_up = (uvs[triangles[:, 2]] - uvs[triangles[:, 0]] - shear[:, None] * uv_along) / height[:, None]
    # Singular values of the 2×2 matrix with these columns.
    total = (uv_along**2).sum(axis=1) + (uv_up**2).sum(axis=1)
    area = np.abs(uv_along[:, 0] * uv_up[:, 1] - uv_along[:, 1] * uv_up[:, 0])
    root = np.sqrt(np.maximum(total * total - 4.0 * area * area, 0.0))
    return np.sqrt(np.maximum(total - root, 0.0) / 2.0), np.sqrt((total + root) / 2.0)


def uvs_in_millimetres(positions: Floats, triangles: Integers, uvs: Floats) -> Floats | None:
    """Return ``uvs`` scaled to millimetres, (n, 2), or ``None`` where they are too uneven to be.

    Even enough: on 80 % of the area every length is within a factor of two of the scale chosen.
    """
    if not np.isfinite(uvs).all():
        return None
    smallest, largest = stretch(positions, triangles, uvs)
    a, b, c = (positions[triangles[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    middle = np.sqrt(smallest * largest)
    order = np.argsort(middle)
    half = np.searchsorted(np.cumsum(area[order]), area.sum() / 2.0)
    scale = float(middle[order][min(int(half), len(order) - 1)])
    if scale <= 0.0 or not np.isfinite(scale):
        return None
    even = (smallest >= scale / _EVEN) & (largest <= scale * _EVEN)
    if area[even].sum() < _SHARE * area.sum():
        return None
    return np.asarray(uvs * (MILLIMETRES / scale))


def box_uvs(positions: Floats, triangles: Integers) -> tuple[Floats, Integers, Integers]:
    """Project every triangle along the axis that its normal is nearest to.

    Returns
    -------
    uvs, kept, triangles
        (m, 2) millimetres; (m,) the old vertex of each new one, since a vertex is split where its triangles
        face different sides; (k, 3) new indices.
    """
    side = np.abs(face_normals(positions, triangles)).argmax(axis=1)
    used, numbered = used_numbers(triangles * 3 + side[:, None], 3 * len(positions))
    kept, axis = used // 3, used % 3
    planes = np.array([[2, 1], [0, 2], [0, 1]])[axis]
    uvs = np.take_along_axis(positions[kept], planes, axis=1) * MILLIMETRES
    return uvs, kept, numbered

"""Normals of triangle meshes: of faces, and smooth ones that keep creases.

A corner of a face gets the mean of the faces around its vertex that can be reached without crossing a
crease, weighted by the angle that each face takes up at the vertex (Thürmer and Wüthrich 1998), so that the
result does not depend on how a flat side was cut into triangles.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats, Integers


def face_normals(positions: Floats, triangles: Integers) -> Floats:
    """Return the unit normal of each triangle, (k, 3); zero where it has no area."""
    normal = cross_columns(*edge_columns(positions, triangles))
    length = np.sqrt(np.einsum("ij,ij->j", normal, normal))
    return np.asarray(np.divide(normal, length, out=np.zeros_like(normal), where=length > 0.0).T.copy())


def edge_columns(positions: Floats, triangles: Integers) -> tuple[Floats, Floats]:
    """Return the edges of each triangle from its first corner to the second and to the third, (3, k) each.

    A row for each coordinate: products of them take a fraction of the time that they take of rows of three numbers.
    """
    columns = np.ascontiguousarray(positions.T)
    a, b, c = (columns[:, triangles[:, corner]] for corner in range(3))
    return b - a, c - a


def cross_columns(one: Floats, other: Floats) -> Floats:
    """Return the cross products (3, k) of vectors (3, k)."""
    return np.stack([one[i - 2] * other[i - 1] - one[i - 1] * other[i - 2] for i in range(3)])


def triangle_areas(positions: Floats, triangles: Integers) -> Floats:
    """Return the area (k,) of each triangle."""
    normal = cross_columns(*edge_columns(positions, triangles))
    return np.asarray(np.sqrt(np.einsum("ij,ij->j", normal, normal)) / 2.0)


def weld(positions: Floats) -> Integers:
    """Number the places of vertices, (n,): equal where positions agree to 1e-6 of the size."""
    size = float(np.ptp(positions, axis=0).max())
    step = size * 1e-6 if size > 0.0 else 1.0
    cells = np.round((positions - positions.min(axis=0)) / step).astype(np.int64)
    return np.unique(packed(cells), return_inverse=True)[1].reshape(-1)


def used_numbers(numbers: Integers, count: int) -> tuple[Integers, Integers]:
    """Return which of 0…``count`` - 1 occur in ``numbers`` (...), ascending, and the place of each among them (...).

    As ``np.unique`` with the inverse, which sorts.
    """
    occurs = np.zeros(count, np.bool_)
    occurs[numbers] = True
    return np.flatnonzero(occurs), (np.cumsum(occurs) - 1)[numbers]


def packed(cells: Integers) -> Integers:
    """Return one number (n,) for each row of three in [0, 2²¹), in their order; numpy sorts rows much more slowly."""
    return np.asarray((cells[:, 0] << 42) | (cells[:, 1] << 21) | cells[:, 2])


def corner_angles(positions: Floats, triangles: Integers) -> Floats:
    """Return the interior angles (k, 3), radians, at the corners of each triangle."""
    one, other = edge_columns(positions, triangles)
    edges = (one, other - one, -other)  # around each triangle
    normal = cross_columns(one, other)
    sine = np.sqrt(np.einsum("ij,ij->j", normal, normal))  # times both lengths, the same at each corner
    cosines = [-np.einsum("ij,ij->j", edges[corner], edges[corner - 1]) for corner in range(3)]
    return np.stack([np.arctan2(sine, cosine) for cosine in cosines], axis=1)


def smooth_edges(triangles: Integers, faces: Floats, crease_deg: float) -> tuple[Integers, Integers]:
    """Return the pairs of corners that are joined across edges below the crease angle.

    A corner's number is 3·face + corner; ``triangles`` index welded places. An edge of more than two faces
    joins them in turn.
    """
    count = len(triangles)
    start, end = triangles.reshape(-1), np.roll(triangles, -1, axis=1).reshape(-1)
    start_corner = np.arange(3 * count)
    end_corner = np.roll(start_corner.reshape(-1, 3), -1, axis=1).reshape(-1)
    forward = start < end
    low, high = np.where(forward, start, end), np.where(forward, end, start)
    low_corner = np.where(forward, start_corner, end_corner)
    high_corner = np.where(forward, end_corner, start_corner)
    edges = low * (int(high.max(initial=0)) + 1) + high  # one number for each, which sorts quickly
    order = np.argsort(edges, kind="stable")
    edges = edges[order]
    same = edges[1:] == edges[:-1]
    one, other = order[:-1][same], order[1:][same]
    cosine = np.einsum("ij,ij->i", faces[one // 3], faces[other // 3])
    joined = cosine >= np.cos(np.radians(crease_deg))
    one, other = one[joined], other[joined]
    left = np.concatenate([low_corner[one], high_corner[one]])
    right = np.concatenate([low_corner[other], high_corner[other]])
    return left, right


def corner_normals(positions: Floats, triangles: Integers, welded: Integers, crease_deg: float) -> Floats:
    """Return a unit normal for each corner of each triangle, (k, 3, 3).

    Parameters
    ----------
    positions, triangles
        (n, 3) and (k, 3); no triangle without area.
    welded
        (n,) place numbers of :func:`weld`, so that seams of texture coordinates do not show as edges.
    crease_deg
        Faces that meet at more than this angle, degrees, do not share a normal.
    """
    # Imported here: a generated mesh needs no scipy, and a program starts faster without it.
    from scipy import sparse

    faces = face_normals(positions, triangles)
    left, right = smooth_edges(welded[triangles], faces, crease_deg)
    corner_count = 3 * len(triangles)
    graph = sparse.coo_array((np.ones(len(left), np.int8), (left, right)), shape=(corner_count, corner_count))
    count, group = sparse.csgraph.connected_components(graph, directed=False)
    weight = corner_angles(positions, triangles).reshape(-1)
    summed = np.zeros((count, 3))
    for axis in range(3):
        summed[:, axis] = np.bincount(group, weight * np.repeat(faces[:, axis], 3), minlength=count)
    length = np.linalg.norm(summed, axis=1)
    corners = summed[group]
    lost = length[group] < 1e-9  # faces that cancel out keep their own normal
    corners[lost] = np.repeat(faces, 3, axis=0)[lost]
    corners /= np.linalg.norm(corners, axis=1, keepdims=True)
    return np.asarray(corners.reshape(-1, 3, 3))


def is_inside_out(positions: Floats, triangles: Integers, welded: Integers) -> bool:
    """Return whether the mesh is closed, wound one way throughout, and encloses a negative volume."""
    places = welded[triangles]
    start, end = places.reshape(-1), np.roll(places, -1, axis=1).reshape(-1)
    count = int(places.max(initial=0)) + 1
    if not np.array_equal(np.sort(start * count + end), np.sort(end * count + start)):
        return False
    columns = np.ascontiguousarray((positions - positions.mean(axis=0)).T)
    a, b, c = (columns[:, triangles[:, corner]] for corner in range(3))
    return bool(np.einsum("ij,ij->", a, cross_columns(b, c)) < 0.0)

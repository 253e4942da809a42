"""Normals of triangle meshes: of faces, and smooth ones that keep creases.

A corner of a face gets the mean of the faces around its vertex that can be reached without crossing a
crease, weighted by the angle that each face takes up at the vertex (Thürmer and Wüthrich 1998), so that the
result does not depend on how a flat side was cut into triangles.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from brdf_suite.arrays import AnyIntegers, Floats, Integers

_BLOCK = 1 << 16
"""Triangles, or rows, that are worked on at once, so that what is made on the way does not grow with the mesh."""


def blocks(count: int) -> Iterator[slice]:
    """Yield slices of consecutive rows that cover ``count`` of them."""
    for first in range(0, count, _BLOCK):
        yield slice(first, min(first + _BLOCK, count))


def index_type(largest: int) -> np.dtype[Any]:
    """Return the type of indices up to ``largest``: four bytes where they suffice, which halves what a mesh takes."""
    return np.dtype(np.int32 if largest <= np.iinfo(np.int32).max else np.int64)


def face_normals(positions: Floats, triangles: AnyIntegers) -> Floats:
    """Return the unit normal of each triangle, (k, 3); zero where it has no area."""
    normals = np.empty((len(triangles), 3))
    for block in blocks(len(triangles)):
        normal = cross_columns(*edge_columns(positions, triangles[block]))
        length = np.sqrt(np.einsum("ij,ij->j", normal, normal))
        normals[block] = np.divide(normal, length, out=np.zeros_like(normal), where=length > 0.0).T
    return normals


def edge_columns(positions: Floats, triangles: AnyIntegers) -> tuple[Floats, Floats]:
    """Return the edges of each triangle from its first corner to the second and to the third, (3, k) each.

    A row for each coordinate: products of them take a fraction of the time that they take of rows of three numbers.
    """
    a, b, c = (np.ascontiguousarray(positions.take(triangles[:, corner], axis=0).T) for corner in range(3))
    return b - a, c - a


def cross_columns(one: Floats, other: Floats) -> Floats:
    """Return the cross products (3, k) of vectors (3, k)."""
    return np.stack([one[i - 2] * other[i - 1] - one[i - 1] * other[i - 2] for i in range(3)])


def triangle_areas(positions: Floats, triangles: AnyIntegers) -> Floats:
    """Return the area (k,) of each triangle."""
    areas = np.empty(len(triangles))
    for block in blocks(len(triangles)):
        normal = cross_columns(*edge_columns(positions, triangles[block]))
        areas[block] = np.sqrt(np.einsum("ij,ij->j", normal, normal)) / 2.0
    return areas


def weld(positions: Floats) -> AnyIntegers:
    """Number the places of vertices, (n,): equal where positions agree to 1e-6 of the size."""
    count = len(positions)
    low = positions.min(axis=0)
    size = float((positions.max(axis=0) - low).max())
    step = size * 1e-6 if size > 0.0 else 1.0
    cells = np.empty(count, np.int64)
    for block in blocks(count):
        cells[block] = packed(np.round((positions[block] - low) / step).astype(np.int64))
    order = np.argsort(cells)
    cells = cells[order]
    is_new = np.ones(count, np.bool_)
    np.not_equal(cells[1:], cells[:-1], out=is_new[1:])
    del cells
    numbers = np.empty(count, index_type(count))
    numbers[order] = np.cumsum(is_new, dtype=numbers.dtype) - 1
    return numbers


def used_numbers(numbers: AnyIntegers, count: int) -> tuple[Integers, AnyIntegers]:
    """Return which of 0…``count`` - 1 occur in ``numbers`` (...), ascending, and the place of each among them (...).

    As ``np.unique`` with the inverse, which sorts.
    """
    occurs = np.zeros(count, np.bool_)
    occurs[numbers] = True
    places = np.cumsum(occurs, dtype=index_type(count))
    places -= 1
    return np.flatnonzero(occurs), places[numbers]


def packed(cells: Integers) -> Integers:
    """Return one number (n,) for each row of three in [0, 2²¹), in their order; numpy sorts rows much more slowly."""
    return np.asarray((cells[:, 0] << 42) | (cells[:, 1] << 21) | cells[:, 2])


def corner_angles(positions: Floats, triangles: AnyIntegers) -> Floats:
    """Return the interior angles (k, 3), radians, at the corners of each triangle."""
    angles = np.empty((len(triangles), 3))
    for block in blocks(len(triangles)):
        one, other = edge_columns(positions, triangles[block])
        edges = (one, other - one, -other)  # around each triangle
        normal = cross_columns(one, other)
        sine = np.sqrt(np.einsum("ij,ij->j", normal, normal))  # times both lengths, the same at each corner
        for corner in range(3):
            cosine = -np.einsum("ij,ij->j", edges[corner], edges[corner - 1])
            angles[block, corner] = np.arctan2(sine, cosine)
    return angles


def smooth_edges(triangles: AnyIntegers, faces: Floats, crease_deg: float) -> tuple[AnyIntegers, AnyIntegers]:
    """Return the pairs of corners that are joined across edges below the crease angle.

    A corner's number is 3·face + corner; ``triangles`` index welded places. An edge of more than two faces
    joins them in turn.
    """
    corner_type = index_type(3 * len(triangles))
    edges = _edge_numbers(triangles)
    order = np.argsort(edges, kind="stable").astype(corner_type)
    edges = edges[order]
    same = edges[1:] == edges[:-1]
    del edges
    one, other = order[:-1][same], order[1:][same]
    del order, same
    joined = np.empty(len(one), np.bool_)
    least = np.cos(np.radians(crease_deg))
    for block in blocks(len(one)):
        cosine = np.einsum("ij,ij->i", faces[one[block] // 3], faces[other[block] // 3])
        joined[block] = cosine >= least
    one, other = one[joined], other[joined]
    count = len(one)
    left, right = np.empty(2 * count, corner_type), np.empty(2 * count, corner_type)
    places = triangles.reshape(-1)
    for block in blocks(count):
        at_high = slice(count + block.start, count + block.stop)
        left[block], left[at_high] = _edge_ends(places, one[block])
        right[block], right[at_high] = _edge_ends(places, other[block])
    return left, right


def _edge_numbers(places: AnyIntegers) -> Integers:
    """Return a number for the edge that begins at each corner (3k,), the same in both directions."""
    # One number for each edge sorts quickly.
    count = int(places.max(initial=0)) + 1
    edges = np.empty(places.shape, np.int64)
    for block in blocks(len(places)):
        start = places[block].astype(np.int64)
        end = np.roll(start, -1, axis=1)
        edges[block] = np.minimum(start, end) * count + np.maximum(start, end)
    return edges.reshape(-1)


def _edge_ends(places: AnyIntegers, corners: AnyIntegers) -> tuple[AnyIntegers, AnyIntegers]:
    """Return the corners at the lower and at the higher place of the edges that begin at ``corners``."""
    ends = np.where(corners % 3 == 2, corners - 2, corners + 1)
    forward = places[corners] < places[ends]
    return np.where(forward, corners, ends), np.where(forward, ends, corners)


def corner_normals(
    positions: Floats, triangles: AnyIntegers, welded: AnyIntegers, crease_deg: float
) -> Floats:
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
    faces = face_normals(positions, triangles)
    count, group = _smooth_groups(welded[triangles], faces, crease_deg)
    weight = corner_angles(positions, triangles)
    groups = group.reshape(-1, 3)
    summed = np.zeros((count, 3))
    for axis in range(3):
        column = np.zeros(count)
        for block in blocks(len(triangles)):
            parts = weight[block] * faces[block, axis, None]
            np.add.at(column, groups[block].reshape(-1), parts.reshape(-1))
        summed[:, axis] = column
    del weight
    lost = np.zeros(count, np.bool_)  # faces that cancel out keep their own normal
    for block in blocks(count):
        length = np.linalg.norm(summed[block], axis=1, keepdims=True)
        lost[block] = length[:, 0] < 1e-9
        np.divide(summed[block], length, out=summed[block], where=length > 0.0)
    corners = summed[group]
    if lost.any():
        alone = np.flatnonzero(lost[group])
        own = faces[alone // 3]
        corners[alone] = own / np.linalg.norm(own, axis=1, keepdims=True)
    return np.asarray(corners.reshape(-1, 3, 3))


def _smooth_groups(places: AnyIntegers, faces: Floats, crease_deg: float) -> tuple[int, AnyIntegers]:
    """Return how many groups of joined corners there are, and the group of each corner (3k,)."""
    # Imported here: a generated mesh needs no scipy, and a program starts faster without it.
    from scipy import sparse

    left, right = smooth_edges(places, faces, crease_deg)
    corner_count = 3 * len(places)
    graph = sparse.coo_array((np.ones(len(left), np.int8), (left, right)), shape=(corner_count, corner_count))
    del left, right
    count, group = sparse.csgraph.connected_components(graph, directed=False)
    return int(count), group


def is_inside_out(positions: Floats, triangles: AnyIntegers, welded: AnyIntegers) -> bool:
    """Return whether the mesh is closed, wound one way throughout, and encloses a negative volume."""
    if not _is_closed(welded[triangles]):
        return False
    middle, volume = positions.mean(axis=0), 0.0
    for block in blocks(len(triangles)):
        a, b, c = (
            np.ascontiguousarray((positions[triangles[block, corner]] - middle).T) for corner in range(3)
        )
        volume += float(np.einsum("ij,ij->", a, cross_columns(b, c)))
    return volume < 0.0


def _is_closed(places: AnyIntegers) -> bool:
    """Return whether each edge is passed as often in one direction as in the other."""
    count = int(places.max(initial=0)) + 1
    surplus = 0
    there, back = np.empty(places.shape, np.int64), np.empty(places.shape, np.int64)
    for block in blocks(len(places)):
        start = places[block].astype(np.int64)
        end = np.roll(start, -1, axis=1)
        there[block], back[block] = start * count + end, end * count + start
        # Sums of squares, modulo 2⁶⁴, that differ need no sorting.
        one, other = there[block].view(np.uint64), back[block].view(np.uint64)
        surplus += int((one * one).sum()) - int((other * other).sum())
    if surplus % (1 << 64):
        return False
    for edges in (there, back):
        edges.reshape(-1).sort()  # in place
    return np.array_equal(there, back)

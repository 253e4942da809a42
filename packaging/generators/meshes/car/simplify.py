"""Merging of points that cuts left close together.

Several parallel cuts each cross the diagonals that the one before left, so points crowd on the curves. Short edges
are collapsed where neither a curve nor the shading would change: a point moves only along all the curves
that it lies on, only over a small angle between normals, and no triangle may turn over.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Integers
from meshes.car.nets import find_any, unique_edges

_ROUNDS = 24
_TIGHT_RADIUS = 0.15
_TIGHT_EDGE = 0.004


def merge_points(
    points: Floats,
    normals: Floats,
    triangles: Integers,
    curves: NDArray[np.bool_],
    shortest: float,
    angle_deg: float,
) -> tuple[Integers, Integers]:
    """Return the triangles (m, 3) after collapsing edges shorter than ``shortest`` (m), and which they were.

    Parameters
    ----------
    points, normals
        (n, 3); points keep their places and numbers.
    triangles
        (k, 3) of a surface without branches.
    curves
        (n, c): point i lies on curve j.
    shortest, angle_deg
        Longer edges, and edges over which the normal turns more, stay.
    """
    limit = float(np.cos(np.radians(angle_deg)))
    reach = np.full(len(points), shortest)
    reach[in_tight_bends(points, triangles, curves)] = _TIGHT_EDGE
    words = np.zeros((len(points), 8 * -(-curves.shape[1] // 64)), dtype=np.uint8)
    packed = np.packbits(curves, axis=1)
    words[:, : packed.shape[1]] = packed
    bits = words.view(np.uint64)
    kept = np.arange(len(triangles))
    # Points stay: what was found of a corner's move holds while the triangle and the target are the same.
    checked, wrong = np.full(triangles.shape, -1), np.zeros(triangles.shape, dtype=bool)
    for _ in range(_ROUNDS):
        target, rank = _candidates(points, normals, triangles, bits, reach, limit)
        if not (target >= 0).any():
            break
        target = _without_overlap(points, normals, triangles, target, rank, checked, wrong)
        if not (target >= 0).any():
            break
        moved = np.where(target >= 0, target, np.arange(len(points)))
        checked[find_any(target >= 0, triangles)] = -1
        triangles = moved[triangles]
        a, b, c = triangles.T
        alive = (a != b) & (b != c) & (c != a)
        triangles, kept, checked, wrong = triangles[alive], kept[alive], checked[alive], wrong[alive]
    return triangles, kept


def in_tight_bends(points: Floats, triangles: Integers, curves: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which points (n,) lie where a curve bends with a radius below 150 mm."""
    edge, _ = unique_edges(triangles)
    tight = np.zeros(len(points), dtype=bool)
    for column in range(curves.shape[1]):
        on_it = np.ascontiguousarray(curves[:, column])
        # "all" along an axis of two takes several times as long.
        own = edge[on_it[edge[:, 0]] & on_it[edge[:, 1]]]
        both = np.concatenate([own, own[:, ::-1]])
        both = both[np.argsort(both[:, 0], kind="stable")]
        at, first, count = np.unique(both[:, 0], return_index=True, return_counts=True)
        two = count == 2
        before, after = both[first[two], 1], both[first[two] + 1, 1]
        one, other = points[at[two]] - points[before], points[after] - points[at[two]]
        lengths = np.linalg.norm(one, axis=1), np.linalg.norm(other, axis=1)
        sine = np.linalg.norm(np.cross(one, other), axis=1) / np.maximum(lengths[0] * lengths[1], 1e-30)
        radius = 0.5 * (lengths[0] + lengths[1]) / np.maximum(sine, 1e-9)
        # Two points almost on top of each other say nothing about the bend; their neighbours do.
        bent = np.zeros(len(points), dtype=bool)
        bent[at[two]] = (radius < _TIGHT_RADIUS) & (np.minimum(*lengths) > 2e-4)
        tight |= bent
        tight[own[bent[own[:, 0]] | bent[own[:, 1]]]] = True
    return tight


def _candidates(
    points: Floats,
    normals: Floats,
    triangles: Integers,
    curves: NDArray[np.uint64],
    reach: Floats,
    limit: float,
) -> tuple[Integers, Floats]:
    """Return for each point the neighbour that it may move to (or -1), and the length of that move.

    ``curves`` (n, w) has a bit for each curve that a point lies on.
    """
    edge, edge_of_side = unique_edges(triangles)
    length = np.linalg.norm(points[edge[:, 0]] - points[edge[:, 1]], axis=1)
    short = np.flatnonzero(length < np.minimum(reach[edge[:, 0]], reach[edge[:, 1]]))
    short = short[np.einsum("ij,ij->i", normals[edge[short, 0]], normals[edge[short, 1]]) > limit]
    sides = np.bincount(edge_of_side.ravel(), minlength=len(edge))
    rim = np.zeros(len(points), dtype=bool)
    rim[edge[sides == 1].ravel()] = True
    target = np.full(len(points), -1, dtype=np.int64)
    best = np.full(len(points), np.inf)
    for one, two in ((0, 1), (1, 0)):
        u, v = edge[short, one], edge[short, two]
        allowed = ~(curves[u] & ~curves[v]).any(axis=1)
        # On a curve, the edge itself must be a piece of that curve; on the rim, an edge of the rim.
        allowed &= ~rim[u] | (sides[short] == 1)
        u, v, cost = u[allowed], v[allowed], length[short][allowed]
        order = np.argsort(-cost, kind="stable")  # the shortest is written last
        better = cost[order] < best[u[order]]
        u, v, cost = u[order][better], v[order][better], cost[order][better]
        target[u] = v
        best[u] = cost
    return target, best


def _without_overlap(
    points: Floats,
    normals: Floats,
    triangles: Integers,
    target: Integers,
    rank: Floats,
    checked: Integers,
    wrong: NDArray[np.bool_],
) -> Integers:
    """Return the targets left when moves that turn a triangle over or touch a shorter move are dropped.

    ``wrong`` (k, 3) says which corners must not move to ``checked`` (k, 3); both are brought up to date.
    """
    target = target.copy()
    order = np.argsort(np.where(target >= 0, rank, np.inf), kind="stable")
    place = np.empty(len(points), dtype=np.int64)
    place[order] = np.arange(len(points))
    bad = np.zeros(len(points), dtype=bool)
    common = np.zeros(len(points), dtype=np.int64)
    for corner in range(3):
        moving = np.flatnonzero(target[triangles[:, corner]] >= 0)
        u, p, q = (triangles[moving, (corner + next_) % 3] for next_ in range(3))
        v = target[u]
        gone = (p == v) | (q == v)
        np.add.at(common, u[gone], 1)
        new = np.flatnonzero((checked[moving, corner] != v) & ~gone)
        wrong[moving[new], corner] = _turns_over(points, normals, v[new], p[new], q[new])
        checked[moving[new], corner] = v[new]
        bad[u[wrong[moving, corner] & ~gone]] = True
    target[bad | (common > 2) | (common < 1)] = -1
    # A move claims the ring round its point; the shortest move wins.
    triangles = triangles[find_any(target >= 0, triangles)]
    own = np.where(target[triangles] >= 0, place[triangles], len(points))
    claim = np.full(len(points), len(points), dtype=np.int64)
    for corner in range(3):
        np.minimum.at(claim, triangles[:, corner], np.minimum(np.minimum(own[:, 0], own[:, 1]), own[:, 2]))
    a, b, c = claim[triangles.T]
    beaten = np.minimum(np.minimum(a, b), c)[:, None] < own
    target[triangles[beaten]] = -1
    return target


def _turns_over(points: Floats, normals: Floats, v: Integers, p: Integers, q: Integers) -> NDArray[np.bool_]:
    """Return which triangles v, p, q (each (k,)) face away from their normals, or are next to nothing."""
    facing = np.cross(points[p] - points[v], points[q] - points[v])
    size = np.linalg.norm(facing, axis=1)
    mean = normals[v] + normals[p] + normals[q]
    agree = np.einsum("ij,ij->i", facing, mean) / np.maximum(size * np.linalg.norm(mean, axis=1), 1e-30)
    one, two = (np.linalg.norm(points[end] - points[v], axis=1) for end in (p, q))
    longest = np.maximum(one, two)
    result: NDArray[np.bool_] = (agree < 0.8) | (size < 1e-7) | (size < 0.03 * longest**2)
    return result

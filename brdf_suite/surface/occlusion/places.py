"""Sample places of a mesh's occlusion, spread over the triangles.

Not at the vertices: a vertex often lies on an edge where bodies touch, or inside the next body, and would say
nothing of the triangles around it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Bools, Floats, Integers, Singles

_OFFSET = 2e-5
"""Rays start so far above the surface, as a share of the object's size: 0.1 mm on a car."""


_PIECES = {
    1: ([0, 3, 2], [3, 1, 2]),
    2: ([3, 1, 4], [0, 3, 4], [0, 4, 2]),
    3: ([0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]),
}
"""Pieces of a triangle by the number of cut edges; 0 to 2: its corners, 3 to 5: the middle of the edge after each."""


@dataclass(frozen=True, eq=False)
class Places:
    """Places on triangles.

    ``triangle`` (n,) says on which, ``weights`` (n, 3) where on it (they add up to 1), ``area`` (n,) for how much
    surface each stands (m²); ``points`` are above the surface by ``lifts`` (n, 1), metres; ``normals`` and ``planes``
    are the interpolated and the triangle's own unit normals.
    """

    triangle: Integers
    weights: Floats
    area: Floats
    points: Singles
    normals: Singles
    planes: Singles
    lifts: Singles

    def behind(self) -> tuple[Singles, Singles, Singles]:
        """Return points, normals and planes of the same places on the back."""
        return self.points - 2.0 * self.lifts * self.planes, -self.normals, -self.planes


def spread(positions: Singles, normals: Singles, triangles: Integers, count: int) -> Places:
    """Spread about ``count`` places: half of them evenly over the area, half evenly over the triangles.

    The first half gives large triangles enough, the second leaves no fine detail without. Normals need not have
    unit length. Triangles without area get none.
    """
    corners = positions[triangles].astype(np.float64)
    doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(doubled, axis=1)
    sound = length > 0.0
    share = 0.5 * length / length.sum() + 0.5 * sound / sound.sum()
    # Systematic sampling: triangle t gets the whole numbers between the running sums before and after it.
    ends = np.floor(np.cumsum(share) * count + 0.5).astype(np.int64)
    numbers = np.diff(ends, prepend=0)
    triangle = np.repeat(np.arange(len(triangles)), numbers)
    # The surface that a place on each triangle represents: its area over the number expected there.
    area = (0.5 * length / np.maximum(share * count, 1e-30))[triangle]
    rank = np.arange(len(triangle)) - np.repeat(ends - numbers, numbers)
    weights = _inside(triangle, rank)
    points = np.einsum("nk,nkd->nd", weights, corners[triangle])
    planes = doubled[triangle] / length[triangle, None]
    smooth = np.einsum("nk,nkd->nd", weights, normals[triangles[triangle]].astype(np.float64))
    # Normals of a foreign mesh may point to the other side of its triangles; light counts on theirs.
    planes *= np.where(np.einsum("nd,nd->n", smooth, planes) < 0.0, -1.0, 1.0)[:, None]
    size = np.linalg.norm(smooth, axis=1, keepdims=True)
    smooth = np.where(size > 1e-6, smooth / np.maximum(size, 1e-6), planes)
    lift = _OFFSET * float(np.ptp(positions, axis=0).max())
    above, smooth, planes = (v.astype(np.float32) for v in (points + lift * planes, smooth, planes))
    return Places(triangle, weights, area, above, smooth, planes, np.full((len(points), 1), lift, np.float32))


def _inside(triangle: Integers, rank: Integers) -> Floats:
    """Return places inside triangles: an R2 sequence for each, shifted by its number."""
    turn = triangle * 0.6180339887498949
    u = (0.5 + rank * 0.7548776662466927 + turn) % 1.0
    v = (0.5 + rank * 0.5698402909980532 + turn * 1.3247179572447460) % 1.0
    folded = u + v > 1.0
    u, v = np.where(folded, 1.0 - u, u), np.where(folded, 1.0 - v, v)
    return np.stack([1.0 - u - v, u, v], axis=1)


@dataclass(frozen=True, eq=False)
class Cut:
    """Triangles (k', 3) of a mesh after some edges were cut where three vertices do not resolve the occlusion.

    An edge is cut in all triangles along it or in none, by the places of its ends and not by their numbers, so that
    parts and seams stay closed. New corners are means of the old, and normals are *not* brought to unit length:
    interpolated across the pieces they are then what they were across the whole, and so is the unoccluded picture.

    ``parents`` (v, 2) are the two vertices between which each new one lies; the first new one has the number of
    old vertices. ``origin`` (k',) is the triangle that each was; ``whole`` (k',) whether it still is.
    """

    triangles: Integers
    parents: Integers
    origin: Integers
    whole: Bools

    def extended(self, values: NDArray[Any]) -> NDArray[Any]:
        """Return the values (n, c) of the old vertices followed by those of the new ones, of the same type."""
        if not len(self.parents):
            return values
        ends = values[self.parents]
        return np.concatenate([values, (0.5 * (ends[:, 0] + ends[:, 1])).astype(values.dtype)])


def same_positions(positions: Singles) -> Integers:
    """Number the vertices, (n,): equal where positions are the same to the bit."""
    rows = np.ascontiguousarray(positions + np.float32(0.0))  # -0 becomes 0
    bits = rows.view(np.uint32).astype(np.uint64)
    key = bits[:, 0] * np.uint64(0x9E3779B97F4A7C15)
    for axis in (1, 2):
        key = (key ^ (key >> np.uint64(31)) ^ bits[:, axis]) * np.uint64(0xBF58476D1CE4E5B9)
    return np.unique(key ^ (key >> np.uint64(29)), return_inverse=True)[1].reshape(-1)


def cut(positions: Singles, triangles: Integers, chosen: Bools) -> Cut:
    """Cut the longer edges of the ``chosen`` (k,) triangles in the middle.

    Longer are those of more than half of a triangle's longest edge.
    """
    place = same_positions(positions)
    corners = positions[triangles].astype(np.float64)
    lengths = np.linalg.norm(
        np.roll(corners, -1, axis=1) - corners, axis=2
    )  # edge i: corner i to corner i + 1
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2)
    keys = _pair(place[ends])
    wanted = chosen[:, None] & (lengths > 0.5 * lengths.max(axis=1, keepdims=True))
    marked = np.isin(keys, np.unique(keys[wanted]))

    numbers = _pair(ends)
    fresh, number = np.unique(numbers[marked], return_inverse=True)
    middle = np.full(triangles.shape, -1, np.int64)
    middle[marked] = len(positions) + number
    parents = np.stack([fresh >> np.int64(32), fresh & np.int64(0xFFFFFFFF)], axis=1)

    count = marked.sum(axis=1)
    kept = np.flatnonzero(count == 0)
    pieces, origins = [triangles[kept]], [kept]
    for number_cut, forms in _PIECES.items():
        which = np.flatnonzero(count == number_cut)
        # Turned such that the first edge is the cut one, or the last the whole one.
        cuts = marked[which]
        first = (np.argmin(cuts, axis=1) + 1) % 3 if number_cut == 2 else np.argmax(cuts, axis=1)
        turn = (first[:, None] + np.arange(3)) % 3
        points = np.hstack([np.take_along_axis(of[which], turn, axis=1) for of in (triangles, middle)])
        pieces += [points[:, form] for form in forms]
        origins += [which] * len(forms)
    whole = np.zeros(sum(len(piece) for piece in pieces), np.bool_)
    whole[: len(kept)] = True
    return Cut(np.concatenate(pieces), parents, np.concatenate(origins), whole)


def _pair(ends: Integers) -> Integers:
    low, high = ends.min(axis=-1), ends.max(axis=-1)
    return np.asarray((low << np.int64(32)) | high)

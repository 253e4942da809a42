"""Subdivision of triangles where three vertices do not resolve the occlusion.

An edge is cut in all triangles along it or in none, by the places of its ends and not by their numbers, so that
parts and seams stay closed. New corners are means of the old, and normals are *not* brought to unit length:
interpolated across the pieces they are then what they were across the whole, and so is the unoccluded picture.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Bools, Integers, Singles


@dataclass(frozen=True, eq=False)
class Cut:
    """Triangles (k', 3) of a mesh after some edges were cut.

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
    for number_cut, build in ((1, _one), (2, _two), (3, _three)):
        which = np.flatnonzero(count == number_cut)
        if not len(which):
            continue
        # Turned such that the first edge is the cut one, or the last the whole one.
        first = np.argmax(marked[which], axis=1) if number_cut == 1 else np.zeros(len(which), np.int64)
        if number_cut == 2:
            first = (np.argmin(marked[which], axis=1) + 1) % 3
        turn = (first[:, None] + np.arange(3)) % 3
        made = build(
            np.take_along_axis(triangles[which], turn, axis=1),
            np.take_along_axis(middle[which], turn, axis=1),
        )
        pieces += made
        origins += [which] * len(made)
    whole = np.zeros(sum(len(piece) for piece in pieces), np.bool_)
    whole[: len(kept)] = True
    return Cut(np.concatenate(pieces), parents, np.concatenate(origins), whole)


def _pair(ends: Integers) -> Integers:
    low, high = ends.min(axis=-1), ends.max(axis=-1)
    return np.asarray((low << np.int64(32)) | high)


def _one(t: Integers, m: Integers) -> list[Integers]:
    return [_stack(t[:, 0], m[:, 0], t[:, 2]), _stack(m[:, 0], t[:, 1], t[:, 2])]


def _two(t: Integers, m: Integers) -> list[Integers]:
    # Edges 0 (t0 t1) and 1 (t1 t2) are cut, edge 2 is whole.
    return [
        _stack(m[:, 0], t[:, 1], m[:, 1]),
        _stack(t[:, 0], m[:, 0], m[:, 1]),
        _stack(t[:, 0], m[:, 1], t[:, 2]),
    ]


def _three(t: Integers, m: Integers) -> list[Integers]:
    return [
        _stack(t[:, 0], m[:, 0], m[:, 2]),
        _stack(m[:, 0], t[:, 1], m[:, 1]),
        _stack(m[:, 2], m[:, 1], t[:, 2]),
        _stack(m[:, 0], m[:, 1], m[:, 2]),
    ]


def _stack(a: Integers, b: Integers, c: Integers) -> Integers:
    return np.stack([a, b, c], axis=1)

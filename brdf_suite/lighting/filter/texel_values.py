"""Texel values of a lobe's map, adjusted for a graphics card's bilinear look-ups.

**Between texels.** Where a map bends, the straight line between two texels errs by an eighth of the second
difference in the middle and by nothing at the texels themselves. Every texel therefore holds the value less a
sixteenth of its second differences along both sides of the face: the error is shared between the texels and the
places between them, and halved. Nothing better can be had from straight lines: the best continuous approximation of
a parabola by lines with these knots errs by a sixteenth of the second difference.

**Across edges.** A seamless look-up at the edge s = 1 takes the mean of a texel of this face, whose centre is (1 - h,
t), and of the texel with the same t of the next face; h = 1/F is half a texel. The second centre's direction is (1, t,
1 - h), so that the mean belongs to t·(1 + h/2), not t: an error of first order in h, largest near the cube's corners,
1.4 % of a lobe's peak where everything else stays below 1 %. Texels beside the edge therefore hold the value a little
nearer to the edge's middle, at t·(1 - 0.25·h): the error is shared between look-ups at the edge and at the texels'
own centres, and is below 1 % for both. The shares were found as those with the least error over lobes all about
edges and corners.

Only lobes are treated so, which are smooth; the environment itself stays as it is.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Reals
from brdf_suite.geometry.cube_map import face_coordinates
from brdf_suite.lighting.filter.face_array import FaceArray, pack_faces
from brdf_suite.lighting.filter.harmonics import worker_count
from brdf_suite.lighting.filter.kernels.compilation import loaded_kernels

_SHARE = 1.0 / 16.0  # of t times the difference of the two neighbours, which are 4h apart: 0.25·h
_CORNER_SHARE = 1.2 * _SHARE  # a corner's look-ups take the mean of three texels


def edge_changes(faces: Reals) -> Reals:
    """Return what the texels along the edges of a smooth map (6, F, F, 3), F ≥ 3, have too much.

    (6, 4, F, 3): of the columns 0 and F-1 and the rows 0 and F-1 of every face. A corner's texel lies on two of them.
    """
    position = face_coordinates(faces.shape[1])
    share = _SHARE * position
    share[[0, -1]] = _CORNER_SHARE * position[[0, -1]]
    changes = np.empty((6, 4, faces.shape[1], 3), dtype=faces.dtype)
    for face, target in zip(faces, changes, strict=True):
        for place, line in enumerate(_lines(face)):
            target[place] = share[:, None] * _neighbours(line)
    return changes


def balance_edges(faces: Reals, changes: Reals | None = None) -> None:
    """Move the light of the texels along all edges of a smooth map (6, F, F, 3), F ≥ 3, in place.

    ``changes``: see :func:`edge_changes`; None takes those of ``faces``.
    """
    for face, change in zip(faces, edge_changes(faces) if changes is None else changes, strict=True):
        for line, less in zip(_lines(face), change, strict=True):
            line -= less


def _lines(face: Reals) -> tuple[Reals, Reals, Reals, Reals]:
    return face[:, 0], face[:, -1], face[0], face[-1]


def _neighbours(line: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return the next value minus the last one along a line (F, 3), at its ends continued by a parabola."""
    difference = np.empty_like(line)
    difference[1:-1] = line[2:] - line[:-2]
    difference[0] = -3.0 * line[0] + 4.0 * line[1] - line[2]
    difference[-1] = 3.0 * line[-1] - 4.0 * line[-2] + line[-3]
    return difference


BEND_SHARE = 1.0 / 16.0
"""How much of the second differences a texel lies below its value."""


def pack_lobe(faces: Reals) -> FaceArray:
    """Pack the map (6, F, F, 3) of a lobe, F ≥ 4, for look-ups."""
    changes = edge_changes(faces)
    kernels = loaded_kernels()
    if kernels is not None and faces.dtype == np.float32:
        packed: FaceArray = kernels.pack_faces(faces, BEND_SHARE, changes)
        return packed
    values = np.empty_like(faces)

    def lower(face: int) -> None:
        np.multiply(bends(faces[face]), -BEND_SHARE, out=values[face])
        values[face] += faces[face]

    with ThreadPoolExecutor(worker_count()) as pool:
        list(pool.map(lower, range(6)))
    balance_edges(values, changes)
    return pack_faces(values)


def pack_background(faces: Reals) -> FaceArray:
    """Pack the environment itself (6, F, F, 3), F ≥ 3, as it is."""
    kernels = loaded_kernels()
    if kernels is not None and faces.dtype == np.float32:
        packed: FaceArray = kernels.pack_faces(faces, 0.0, None)
        return packed
    return pack_faces(faces)


def bends(faces: Reals) -> Reals:
    """Return the sum (..., F, F, 3) of second differences along both sides of a face; at the rim the next texel's."""
    total = np.zeros_like(faces)
    for axis in (-3, -2):
        values, sums = np.moveaxis(faces, axis, 0), np.moveaxis(total, axis, 0)
        along = values[2:] + values[:-2]
        along -= 2.0 * values[1:-1]
        sums[1:-1] += along
        sums[0] += along[0]
        sums[-1] += along[-1]
    return total

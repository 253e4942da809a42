"""Texel values of a lobe's map, adjusted for a graphics card's bilinear look-ups.

**Between texels.** Where a map bends, the straight line between two texels errs by an eighth of the second
difference in the middle and by nothing at the texels themselves. Every texel therefore holds the value less a
sixteenth of its second differences along both sides of the face: the error is shared between the texels and the
places between them, and halved. Nothing better can be had from straight lines: the best continuous approximation of
a parabola by lines with these knots errs by a sixteenth of the second difference.

**Across edges.** See :mod:`brdf_suite.lighting.filter.cube_edges`.

Only lobes are treated so, which are smooth; the environment itself stays as it is.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from brdf_suite.arrays import Reals
from brdf_suite.lighting.filter.cube_edges import balance_edges, edge_changes
from brdf_suite.lighting.filter.face_array import FaceArray, pack_faces
from brdf_suite.lighting.filter.harmonics import worker_count
from brdf_suite.lighting.filter.kernels.compilation import loaded_kernels

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

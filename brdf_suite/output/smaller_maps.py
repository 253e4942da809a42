"""An environment's maps for small pictures: a sharp lobe's map is far finer than the pixels that show it.

What is left of a map after a halving is what its next mip level would be, so a picture whose pixels ask for that level
or a coarser one is the same, at a fraction of the memory.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np

from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.prefilter import LobeMaps
from brdf_suite.pipeline.scene import PreparedEnvironment
from brdf_suite.realtime.environment.textures import MIPMAPPED_FROM

_ROWS = 32


def with_smaller_maps(prepared: PreparedEnvironment, largest_face: int) -> PreparedEnvironment:
    """Return the environment with faces of at most ``largest_face`` texels, where halving leaves mip levels."""
    made: dict[int, FaceArray] = {}

    def smaller(maps: FaceArray) -> FaceArray:
        # One map may serve several lobes, and goes to the graphics card once.
        known = id(maps.faces)
        if known not in made:
            made[known] = _halved(maps, largest_face)
        return FaceArray(made[known].faces, maps.scale)

    maps = prepared.maps
    return replace(
        prepared,
        maps=LobeMaps(
            maps.exponents,
            tuple(smaller(lobe) for lobe in maps.lobes),
            smaller(maps.diffuse),
            smaller(maps.background),
        ),
    )


def _halved(maps: FaceArray, largest_face: int) -> FaceArray:
    faces = maps.faces
    while faces.shape[1] > largest_face and faces.shape[1] % 2 == 0 and faces.shape[1] // 2 >= MIPMAPPED_FROM:
        half = faces.shape[1] // 2
        smaller = np.empty((6, half, half, 3), np.float16)
        for face, first in product(range(6), range(0, half, _ROWS)):
            # A few rows at a time: large maps shall not need much memory beside them.
            rows = faces[face, 2 * first : 2 * (first + _ROWS)].astype(np.float32)
            pairs = rows[0::2] + rows[1::2]
            smaller[face, first : first + _ROWS] = 0.25 * (pairs[:, 0::2] + pairs[:, 1::2])
        faces = smaller
    # The maps of a file share its bytes: a view of one of them would keep all.
    return FaceArray(faces if faces is not maps.faces else faces.copy(), maps.scale)

"""Cube maps as half floats with one scale, as stored in the cache and on the graphics card."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.filter.harmonics import worker_count

_HALF_CEILING = (
    50000.0  # below 65504, also where texels are raised by a few per cent for the sake of look-ups
)
_ROWS = 32


@dataclass(frozen=True, eq=False)
class FaceArray:
    """A cube map of radiance: ``faces * scale``, linear working space.

    Attributes
    ----------
    faces
        (6, F, F, 3) float16, C-contiguous, never negative, in the order +X, -X, +Y, -Y, +Z, -Z, rows as
        OpenGL takes them.
    scale
        A power of two, so that multiplying by it is exact.
    """

    faces: NDArray[np.float16]
    scale: float

    @property
    def size(self) -> int:
        """Texels along a face's side."""
        return int(self.faces.shape[1])

    def radiance(self) -> NDArray[np.float32]:
        """Return the radiance (6, F, F, 3) as float32, faces and rows in the order of :attr:`faces`.

        >>> import brdf_suite as bs, numpy as np
        >>> maps = bs.prefilter(np.ones((64, 128, 3)), [20.0])
        >>> maps.diffuse.radiance().dtype, maps.diffuse.radiance().shape[0]
        (dtype('float32'), 6)
        """
        return self.faces.astype(np.float32) * np.float32(self.scale)


def choose_scale(largest: float) -> float:
    """Return the scale for a map whose largest value is this: a power of two."""
    exponent = np.ceil(np.log2(largest / _HALF_CEILING)) if largest > 0.0 else 0.0
    return float(2.0 ** max(exponent, -100.0))


def pack_faces(radiance: NDArray[np.floating]) -> FaceArray:
    """Pack radiance (6, F, F, 3); negative values become 0.

    The scale puts the largest value between 25,000 and 50,000, so that a value 10⁹ times smaller still
    counts.
    """
    values = np.asarray(radiance)
    if values.ndim != 4 or values.shape[0] != 6 or values.shape[1] != values.shape[2] or values.shape[3] != 3:
        raise ValueError(f"radiance must have the shape (6, F, F, 3), not {values.shape}")
    with ThreadPoolExecutor(worker_count()) as pool:
        largest = max(pool.map(lambda face: float(face.max()), values))
        scale = choose_scale(largest)
        faces = np.empty(values.shape, dtype=np.float16)

        def pack(face: int) -> None:
            # A few rows at a time: large maps shall not need much memory beside them.
            for first in range(0, values.shape[1], _ROWS):
                rows = slice(first, first + _ROWS)
                scaled = np.multiply(values[face, rows], 1.0 / scale)
                np.maximum(scaled, 0.0, out=scaled)
                faces[face, rows] = scaled

        list(pool.map(pack, range(6)))
    return FaceArray(faces, scale)

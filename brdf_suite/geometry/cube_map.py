"""Cube maps in OpenGL's layout: faces +X, -X, +Y, -Y, +Z, -Z; row 0 of a face is its first uploaded row.

The world is right-handed with y up. The texel in row j, column i of a face of size F looks along the face's
axis at ``s = (2i+1)/F - 1`` and ``t = (2j+1)/F - 1`` (OpenGL 3.3 core specification, table 3.10).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# Direction = _AXIS + s·_S + t·_T for each face.
_AXIS = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64)
_S = np.array([[0, 0, -1], [0, 0, 1], [1, 0, 0], [1, 0, 0], [1, 0, 0], [-1, 0, 0]], dtype=np.float64)
_T = np.array([[0, -1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0, -1, 0], [0, -1, 0]], dtype=np.float64)


def face_coordinates(size: int) -> NDArray[np.float64]:
    """Return the texel centres (size,) of a face along one side, -1…1."""
    return (2.0 * np.arange(size) + 1.0) / size - 1.0


def texel_directions(size: int) -> NDArray[np.float64]:
    """Return the unit directions (6, size, size, 3) of all texels of a cube map.

    >>> texel_directions(1)[4, 0, 0]
    array([0., 0., 1.])
    """
    s = face_coordinates(size)
    directions = (
        _AXIS[:, None, None, :]
        + s[None, None, :, None] * _S[:, None, None, :]
        + s[None, :, None, None] * _T[:, None, None, :]
    )
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    return directions

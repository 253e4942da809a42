"""Parabolic map as a cube map, for graphics cards with fast cube look-ups: z of the surface is z of the cube."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.geometry.parabolic import parabolic_place


def cube_faces(values: NDArray[Any]) -> Floats:
    """Return the faces (6, n, n, 3) of a parabolic map (n, n, 3), in OpenGL's order, rows and columns.

    Texels are the map's, bilinear between its own, at their directions; those below the horizon take what is nearest on
    it. A face of n texels is twice as fine as the map in its middle.
    """
    size = len(values)
    directions = face_directions(size)
    directions[..., 2] = np.maximum(directions[..., 2], 0.0)
    level = np.linalg.norm(directions, axis=-1, keepdims=True)
    s, t = parabolic_place(directions / np.where(level > 0.0, level, 1.0))
    x, y = (np.clip(0.5 * (place + 1.0) * size - 0.5, 0.0, size - 1.0) for place in (s, t))
    i, j = (np.minimum(place.astype(np.int64), max(size - 2, 0)) for place in (x, y))
    u, v = (x - i)[..., None], (y - j)[..., None]
    right, above = np.minimum(i + 1, size - 1), np.minimum(j + 1, size - 1)
    low = values[j, i] * (1.0 - u) + values[j, right] * u
    high = values[above, i] * (1.0 - u) + values[above, right] * u
    return np.asarray(low * (1.0 - v) + high * v, np.float64)


def face_directions(size: int) -> Floats:
    """Return the unit directions (6, n, n, 3) of the texels of a cube map (OpenGL 3.3, table 3.10)."""
    along = (2.0 * np.arange(size) + 1.0) / size - 1.0
    s, t = np.meshgrid(along, along)
    one = np.ones_like(s)
    major = [(one, -t, -s), (-one, -t, s), (s, one, t), (s, -one, -t), (s, -t, one), (-s, -t, -one)]
    directions = np.stack([np.stack(face, axis=-1) for face in major])
    return np.asarray(directions / np.linalg.norm(directions, axis=-1, keepdims=True))

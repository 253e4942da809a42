"""Maps over directions: the parabolic map of a hemisphere, and the interpolated look-up in a map.

The parabolic map (Heidrich and Seidel 1998) has directions as places in a disc, without poles or seams.

A direction (x, y, z) lies at

    s = x / (1 + z),  t = y / (1 + z),

in the disc of radius 1, the horizon on its edge; texel (row j, column i) of n is centred on s = (2i + 1)/n - 1,
t = (2j + 1)/n - 1. On the sphere it is the stereographic projection, of dω = 4/(1 + r²)² ds dt.
"""

from __future__ import annotations

from itertools import product

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from brdf_suite.arrays import Floats


def texel_directions(size: int) -> Floats:
    """Return the directions (size, size, 3) of the texels' centres, those beyond the horizon brought to it.

    >>> texel_directions(2)[0, 0].round(3).tolist()
    [-0.667, -0.667, 0.333]
    """
    along = (2.0 * np.arange(size) + 1.0) / size - 1.0
    s, t = np.meshgrid(along, along)
    inside = 1.0 / np.maximum(np.hypot(s, t), 1.0)
    return parabolic_direction(s * inside, t * inside)


def parabolic_direction(s: npt.ArrayLike, t: npt.ArrayLike) -> Floats:
    """Return the unit directions (..., 3) at places (...) of a parabolic map; below the horizon outside of its disc."""
    s, t = np.asarray(s, float), np.asarray(t, float)
    r2 = s * s + t * t
    return np.asarray(np.stack((2.0 * s, 2.0 * t, 1.0 - r2), axis=-1) / (1.0 + r2)[..., None])


def parabolic_place(w: npt.ArrayLike) -> tuple[Floats, Floats]:
    """Return the places s, t (...) of directions (..., 3) that are not straight down."""
    w = np.asarray(w, float)
    over = np.maximum(1.0 + w[..., 2], 1e-12)
    return w[..., 0] / over, w[..., 1] / over


def bilinear(
    places: Floats, shape: tuple[int, ...], dtype: npt.DTypeLike = np.float32
) -> tuple[NDArray[np.int32], NDArray[np.floating]]:
    """Return the texels (k, 2^d) that places (k, d) in [0, 1]^d read, as flat indices, and their weights.

    The first axis of a place counts columns, the second rows, as in a picture; the outermost texels hold to the edge.
    """
    size = np.asarray(shape[::-1])
    at = np.clip(places * size - 0.5, 0.0, size - 1.0)
    low = np.minimum(at.astype(np.int32), np.asarray(size - 2, np.int32))
    share = (at - low).astype(dtype)
    texels, weights = [], []
    for corner in product((0, 1), repeat=len(shape)):
        index = np.zeros(len(places), np.int32)
        weight = np.ones(len(places), dtype)
        for axis, step in enumerate(corner):
            stride = 1 if axis == 0 else int(size[0])
            index += (low[:, axis] + np.int32(step)) * np.int32(stride)
            weight *= share[:, axis] if step else 1.0 - share[:, axis]
        texels.append(index)
        weights.append(weight)
    return np.stack(texels, axis=1), np.stack(weights, axis=1)


def look_up_map(values: NDArray[np.floating], places: Floats) -> Floats:
    """Return a map (n, c) or (n, m, c) at places (k, 1) or (k, 2) in [0, 1], (k, c), between texels linear."""
    texels, weights = bilinear(places, values.shape[:-1], np.float64)
    flat = values.reshape(-1, values.shape[-1])
    return np.asarray(np.einsum("kc,kcj->kj", weights, flat[texels]), np.float64)

"""Interpolated look-up in a map: linear over one axis, bilinear over two."""

from __future__ import annotations

from itertools import product

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from brdf_suite.arrays import Floats


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

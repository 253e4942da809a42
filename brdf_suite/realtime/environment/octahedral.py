"""Octahedral map of the sphere, as in octahedral.glsl.

A direction is scaled to the octahedron |x| + |y| + |z| = 1 and seen from above (y up); the lower half is folded out
over the square's corners. Texel centres lie on the square's edges too, so that a bilinear look-up never leaves the
texture: an edge texel is there twice, once on either side of its fold. The scale does not matter, so directions need
not be normalized.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.arrays import Floats


def to_square(direction: ArrayLike) -> Floats:
    """Return the place (..., 2) in [-1, 1]² of directions (..., 3) of any length but 0."""
    d = np.asarray(direction, np.float64)
    p = d[..., ::2] / np.abs(d).sum(axis=-1, keepdims=True)
    folded = (1.0 - np.abs(p[..., ::-1])) * np.where(p < 0.0, -1.0, 1.0)
    return np.asarray(np.where(d[..., 1:2] < 0.0, folded, p))


def from_square(place: ArrayLike) -> Floats:
    """Return the unit direction (..., 3) of a place (..., 2) in [-1, 1]²; the inverse of :func:`to_square`."""
    p = np.asarray(place, np.float64)
    y = 1.0 - np.abs(p).sum(axis=-1, keepdims=True)
    folded = (1.0 - np.abs(p[..., ::-1])) * np.where(p < 0.0, -1.0, 1.0)
    inside = np.where(y < 0.0, folded, p)
    d = np.concatenate([inside[..., :1], y, inside[..., 1:]], axis=-1)
    return np.asarray(d / np.linalg.norm(d, axis=-1, keepdims=True))

"""The parabolic map of a hemisphere (Heidrich and Seidel 1998): directions as places in a disc, without poles or seams.

A direction (x, y, z) lies at

    s = x / (1 + z),  t = y / (1 + z),

in the disc of radius 1, the horizon on its edge; texel (row j, column i) of n is centred on s = (2i + 1)/n - 1,
t = (2j + 1)/n - 1. On the sphere it is the stereographic projection, of dω = 4/(1 + r²)² ds dt.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

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

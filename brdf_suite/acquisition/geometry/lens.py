"""Pinhole camera with the lens distortion of Brown (1966), in OpenCV's parameterization.

The camera's frame has x to the right, y down and z forward, metres; a pixel's centre lies at whole numbers. With
a = x/z, b = y/z and s = a² + b²,

    a' = a (1 + k1 s + k2 s² + k3 s³) + 2 p1 a b + p2 (s + 2 a²)
    b' = b (1 + k1 s + k2 s² + k3 s³) + p1 (s + 2 b²) + 2 p2 a b

and the pixel is (fx a' + cx, fy b' + cy). Turned round, it is solved by Newton's method.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.session.session import Lens
from brdf_suite.arrays import Floats

_STEPS = 12
_CLOSE = 1e-13


def lens_pixels(lens: Lens, points: npt.ArrayLike) -> Floats:
    """Return the pixels (..., 2) in which points (..., 3) of the camera's frame, before it, are seen.

    >>> lens_pixels(Lens(1000.0, 1000.0, 320.0, 240.0), [0.1, 0.0, 1.0]).tolist()
    [420.0, 240.0]
    """
    points = np.asarray(points, float)
    plane = _distorted(lens, points[..., :2] / points[..., 2:])[0]
    return plane * (lens.fx, lens.fy) + (lens.cx, lens.cy)


def lens_rays(lens: Lens, pixels: npt.ArrayLike) -> Floats:
    """Return the directions (..., 3) of unit length, away from the camera, that pixels (..., 2) see."""
    aim = (np.asarray(pixels, float) - (lens.cx, lens.cy)) / (lens.fx, lens.fy)
    plane = aim.copy()
    if any((lens.k1, lens.k2, lens.p1, lens.p2, lens.k3)):
        for _ in range(_STEPS):
            value, (aa, ab, ba, bb) = _distorted(lens, plane)
            off_a, off_b = np.moveaxis(value - aim, -1, 0)
            step = np.stack((bb * off_a - ab * off_b, aa * off_b - ba * off_a), axis=-1)
            plane -= step / (aa * bb - ab * ba)[..., None]
            if not np.any(np.abs(step) > _CLOSE):
                break
    rays = np.concatenate((plane, np.ones((*plane.shape[:-1], 1))), axis=-1)
    return np.asarray(rays / np.linalg.norm(rays, axis=-1, keepdims=True))


def _distorted(lens: Lens, plane: Floats) -> tuple[Floats, tuple[Floats, Floats, Floats, Floats]]:
    """Return (a', b') and the derivatives ∂a'/∂a, ∂a'/∂b, ∂b'/∂a, ∂b'/∂b."""
    a, b = plane[..., 0], plane[..., 1]
    s = a * a + b * b
    radial = 1.0 + s * (lens.k1 + s * (lens.k2 + s * lens.k3))
    slope = 2.0 * (lens.k1 + s * (2.0 * lens.k2 + s * 3.0 * lens.k3))  # of the radial factor, over a or b
    moved_a = a * radial + 2.0 * lens.p1 * a * b + lens.p2 * (s + 2.0 * a * a)
    moved_b = b * radial + lens.p1 * (s + 2.0 * b * b) + 2.0 * lens.p2 * a * b
    aa = radial + a * a * slope + 2.0 * lens.p1 * b + 6.0 * lens.p2 * a
    bb = radial + b * b * slope + 6.0 * lens.p1 * b + 2.0 * lens.p2 * a
    mixed = a * b * slope + 2.0 * lens.p1 * a + 2.0 * lens.p2 * b
    return np.stack((moved_a, moved_b), axis=-1), (aa, mixed, mixed, bb)

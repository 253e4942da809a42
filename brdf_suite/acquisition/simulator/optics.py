"""Simulated camera: a pinhole with lens distortion, and its view of a sphere.

Pixel (column, row) has its middle at whole numbers. The lens distorts as OpenCV's model says: a direction (x, y, 1)
in the camera's frame (x right, y down, z into the scene) is seen at
``x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²)`` and accordingly for y, times the focal length.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from brdf_suite.acquisition.session.session import Lens
from brdf_suite.arrays import Floats

# A fixed point of a mild distortion gains two digits a step.
_UNDISTORTING_STEPS = 30
_UNDISTORTED = 1e-13


@dataclass(frozen=True, eq=False)
class SimulatedCamera:
    """A simulated camera: its position (3,) in the world, its orientation, and its lens.

    ``turn`` (3, 3) has the camera's axes in the world as rows: right, down, into the scene.
    """

    centre: Floats
    turn: Floats
    lens: Lens

    def rays(self, x: Floats, y: Floats) -> Floats:
        """Return unit directions (n, 3) in the world through pixel coordinates (n,)."""
        u, v = undistort(self.lens, (x - self.lens.cx) / self.lens.fx, (y - self.lens.cy) / self.lens.fy)
        seen = np.stack([u, v, np.ones_like(u)], axis=-1)
        seen /= lengths(seen)[:, None]
        return seen @ self.turn

    def project(self, points: Floats) -> Floats:
        """Return pixel coordinates (n, 2) of points (n, 3) of the world in front of the camera."""
        seen = (points - self.centre) @ self.turn.T
        u, v = distort(self.lens, seen[:, 0] / seen[:, 2], seen[:, 1] / seen[:, 2])
        return np.stack([self.lens.fx * u + self.lens.cx, self.lens.fy * v + self.lens.cy], axis=-1)


def lengths(vectors: Floats) -> Floats:
    """Return the lengths (n,) of vectors (n, 3); several times as fast as the general norm."""
    found: Floats = np.sqrt(np.einsum("ij,ij->i", vectors, vectors))
    return found


def tilt_camera(height: float, distance: float, tilt: float) -> tuple[Floats, Floats]:
    """Return centre and axes of a camera at (0, height, distance) that looks along -z, tilted up by radians."""
    sine, cosine = math.sin(tilt), math.cos(tilt)
    # The axis into the scene is (0, sin, -cos); right stays +x, and down is what completes a right-handed frame.
    turn = np.array([[1.0, 0.0, 0.0], [0.0, -cosine, -sine], [0.0, sine, -cosine]])
    return np.array([0.0, height, distance]), turn


def distort(lens: Lens, u: Floats, v: Floats) -> tuple[Floats, Floats]:
    """Return where an ideal image point is seen, both in focal lengths."""
    r2 = u * u + v * v
    radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3))
    moved_u = u * radial + 2.0 * lens.p1 * u * v + lens.p2 * (r2 + 2.0 * u * u)
    moved_v = v * radial + lens.p1 * (r2 + 2.0 * v * v) + 2.0 * lens.p2 * u * v
    return moved_u, moved_v


def undistort(lens: Lens, u: Floats, v: Floats) -> tuple[Floats, Floats]:
    """Return the ideal image point that is seen at (u, v): the inverse of :func:`distort`, by iteration."""
    ideal_u, ideal_v = u.copy(), v.copy()
    for _ in range(_UNDISTORTING_STEPS):
        seen_u, seen_v = distort(lens, ideal_u, ideal_v)
        off_u, off_v = u - seen_u, v - seen_v
        ideal_u += off_u
        ideal_v += off_v
        if max(np.abs(off_u).max(initial=0.0), np.abs(off_v).max(initial=0.0)) < _UNDISTORTED:
            break
    return ideal_u, ideal_v


def first_hits(origin: Floats, rays: Floats, centre: Floats, radius: float) -> Floats:
    """Return how far along unit rays (n, 3) a sphere is met first, (n,); NaN where it is missed."""
    to_centre = centre - origin
    along = rays @ to_centre
    # The distance of the ray to the centre, as a difference of vectors: that of squares would lose digits.
    off = lengths(to_centre - along[:, None] * rays)
    inside = radius * radius - off * off
    return np.where(inside > 0.0, along - np.sqrt(np.maximum(inside, 0.0)), np.nan)

"""Simulated camera: a pinhole with lens distortion, and its view of a sphere."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from brdf_suite.acquisition.geometry.lens import Lens
from brdf_suite.arrays import Floats


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
        return self.lens.rays(np.stack([x, y], axis=-1)) @ self.turn

    def project(self, points: Floats) -> Floats:
        """Return pixel coordinates (n, 2) of points (n, 3) of the world in front of the camera."""
        return self.lens.pixels((points - self.centre) @ self.turn.T)


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


def first_hits(origin: Floats, rays: Floats, centre: Floats, radius: float) -> Floats:
    """Return how far along unit rays (n, 3) a sphere is met first, (n,); NaN where it is missed."""
    to_centre = centre - origin
    along = rays @ to_centre
    # The distance of the ray to the centre, as a difference of vectors: that of squares would lose digits.
    off = lengths(to_centre - along[:, None] * rays)
    inside = radius * radius - off * off
    return np.where(inside > 0.0, along - np.sqrt(np.maximum(inside, 0.0)), np.nan)

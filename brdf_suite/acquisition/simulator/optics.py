"""Simulated camera, a pinhole with lens distortion, and its view of a sphere; the lamp, and what its arm hides.

Pixel (column, row) has its middle at whole numbers. The lens distorts as OpenCV's model says: a direction (x, y, 1)
in the camera's frame (x right, y down, z into the scene) is seen at
``x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²)`` and accordingly for y, times the focal length.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from brdf_suite.acquisition.session.session import Lens
from brdf_suite.arrays import Bools, Floats

# A fixed point of a mild distortion gains two digits a step.
_UNDISTORTING_STEPS = 30
_UNDISTORTED = 1e-13
# Of a narrow optic before a light-emitting diode: half of the intensity at about 17° off its axis.
_PROFILE_POWER = 16.0
PROFILE_STEP_DEG = 1.0
PROFILE_END_DEG = 20.0
HOUSING_RADIUS_M = 0.008
POST_RADIUS_M = 0.004


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
    return np.asarray(np.sqrt(np.einsum("ij,ij->i", vectors, vectors)))


def distort(lens: Lens, u: Floats, v: Floats) -> tuple[Floats, Floats]:
    """Return where an ideal image point is seen, both in focal lengths."""
    r2 = u * u + v * v
    radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3))
    if lens.p1 == lens.p2 == 0.0:  # as of every simulated lens
        return u * radial, v * radial
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


@dataclass(frozen=True, eq=False)
class SimulatedLamp:
    """A point light at ``place`` (3,) in the world, aimed at the origin."""

    place: Floats
    has_profile: bool

    def at(self, points: Floats) -> tuple[Floats, Floats]:
        """Return directions (n, 3) from points (n, 3) to the lamp, and the irradiance (n,) of what faces it.

        The irradiance is over that at the origin.
        """
        away = self.place - points
        distance = lengths(away)
        directions = away / distance[:, None]
        nominal = float(self.place @ self.place)
        relative = nominal / (distance * distance)
        if self.has_profile:
            relative = relative * intensity(directions @ (self.place / math.sqrt(nominal)))
        return directions, relative

    def hides(self, origin: Floats, rays: Floats, reach: Floats) -> Bools:
        """Return which rays (n, 3) meet the lamp's housing or its post before ``reach`` (n,)."""
        away = self.place - origin
        along = rays @ away
        beside = lengths(away - along[:, None] * rays)
        housing = (beside < HOUSING_RADIUS_M) & (along < reach) & (along > 0.0)
        level = np.hypot(rays[:, 0], rays[:, 2])
        # The post is met in the plan; its axis stands below the lamp.
        plan = (rays[:, 0] * away[0] + rays[:, 2] * away[2]) / (level * level)
        off = np.hypot(away[0] - plan * rays[:, 0], away[2] - plan * rays[:, 2])
        height = origin[1] + plan * rays[:, 1]
        post = (off < POST_RADIUS_M) & (height < self.place[1]) & (plan < reach) & (plan > 0.0)
        return np.asarray(housing | post)


def intensity(cosines: Floats) -> Floats:
    """Return the radiant intensity at cosines off the lamp's axis, 1 on it."""
    return np.maximum(cosines, 0.0) ** _PROFILE_POWER


def profile_table() -> tuple[tuple[float, float], ...]:
    """Return the intensity as a session states it: pairs of degrees and value."""
    degrees = np.arange(0.0, PROFILE_END_DEG + 0.5 * PROFILE_STEP_DEG, PROFILE_STEP_DEG)
    values = intensity(np.cos(np.radians(degrees)))
    return tuple((float(a), float(f"{v:.7g}")) for a, v in zip(degrees, values, strict=True))

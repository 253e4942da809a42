"""Simulated lamp: its position, the falloff of its light, and the part of the arm that occludes the sphere."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.acquisition.simulator.optics import lengths
from brdf_suite.arrays import Floats

# Of a narrow optic before a light-emitting diode: half of the intensity at about 17° off its axis.
_PROFILE_POWER = 16.0
PROFILE_STEP_DEG = 1.0
PROFILE_END_DEG = 20.0

HOUSING_RADIUS_M = 0.008
POST_RADIUS_M = 0.004


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

    def hides(self, origin: Floats, rays: Floats, reach: Floats) -> NDArray[np.bool_]:
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
        hidden: NDArray[np.bool_] = housing | post
        return hidden


def intensity(cosines: Floats) -> Floats:
    """Return the radiant intensity at cosines off the lamp's axis, 1 on it."""
    return np.maximum(cosines, 0.0) ** _PROFILE_POWER


def profile_table() -> tuple[tuple[float, float], ...]:
    """Return the intensity as a session states it: pairs of degrees and value."""
    degrees = np.arange(0.0, PROFILE_END_DEG + 0.5 * PROFILE_STEP_DEG, PROFILE_STEP_DEG)
    values = intensity(np.cos(np.radians(degrees)))
    return tuple((float(a), float(f"{v:.7g}")) for a, v in zip(degrees, values, strict=True))

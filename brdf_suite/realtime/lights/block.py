"""Uniform block of single lights for lights.glsl: the environment's brightest, then the lamps."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.appearance.light.colour_temperature import lamp_colour
from brdf_suite.appearance.light.matrix import environment_matrix
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.errors import ValueRangeError

MOST_LIGHTS = 24
"""Sixteen of the environment and eight lamps."""
BLOCK_SIZE = (1 + 2 * MOST_LIGHTS) * 16

_OF_ENVIRONMENT, _DIRECTIONAL, _POINT = 0.0, 1.0, 2.0


@dataclass(frozen=True, eq=False)
class DistantLights:
    """Directional lights of an environment, sorted by glint strength.

    Attributes
    ----------
    directions
        (l, 3) unit vectors to the lights, in the world before any turn.
    strengths
        (l, 3) irradiance on a surface that faces the light, working space, never negative.
    spreads
        (l,) standard deviation of its directions along an axis, radians.
    """

    directions: Floats
    strengths: Floats
    spreads: Floats

    def __post_init__(self) -> None:
        count = len(self.spreads)
        for name, shape in (("directions", (count, 3)), ("strengths", (count, 3)), ("spreads", (count,))):
            object.__setattr__(self, name, _checked(getattr(self, name), shape, name))


def _checked(values: ArrayLike, shape: tuple[int, ...], name: str) -> Floats:
    array = np.ascontiguousarray(values, np.float64)
    if array.shape != shape or not np.isfinite(array).all():
        raise ValueRangeError(name, f"expected finite numbers of the shape {shape}, not {array.shape}")
    if name != "directions" and (array < 0).any():
        raise ValueRangeError(name, "must not be negative")
    return array


NO_LIGHTS = DistantLights(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0))


def light_block(view: View, environment: DistantLights = NO_LIGHTS) -> bytes:
    """Return the block, :data:`BLOCK_SIZE` bytes: the environment's lights, turned with it, and the view's lamps."""
    block = np.zeros((1 + 2 * MOST_LIGHTS, 4), np.float32)
    count = 0 if view.sparkle.mode == "off" else min(view.sparkle.light_count, len(environment.spreads))
    turn = math.radians(view.rotation_deg)
    cosine, sine = math.cos(turn), math.sin(turn)
    about_y = np.array([[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]])
    rows = block[1:].reshape(MOST_LIGHTS, 2, 4)
    rows[:count, 0, :3] = environment.directions[:count] @ about_y.T
    rows[:count, 0, 3] = _OF_ENVIRONMENT
    rows[:count, 1, :3] = environment.strengths[:count] @ environment_matrix(view.light_colour).T
    rows[:count, 1, 3] = environment.spreads[:count]
    for row, lamp in zip(rows[count:], view.lamps, strict=False):
        row[0, :3], row[0, 3] = _place(lamp)
        row[1, :3] = math.pi * lamp.strength * np.asarray(_colour(lamp.temperature_k))
    block[0, :2] = count, count + len(view.lamps)
    return block.tobytes()


def _place(lamp: Lamp) -> tuple[Floats, float]:
    if lamp.kind == "point":
        return np.asarray(lamp.position), _POINT
    azimuth, elevation = math.radians(lamp.azimuth_deg), math.radians(lamp.elevation_deg)
    level = math.cos(elevation)
    towards = np.array([level * math.sin(azimuth), math.sin(elevation), level * math.cos(azimuth)])
    return towards, _DIRECTIONAL


@lru_cache(maxsize=64)
def _colour(kelvin: float) -> tuple[float, ...]:
    return tuple(lamp_colour(kelvin).tolist())

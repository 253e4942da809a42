"""Sparkling flakes: normals from a texture in surface coordinates, faded with distance (section 5.2).

The counterpart of ``flake_texture.glsl``: the same hash, so the same flakes
as in the real-time picture's flake texture, and the same in every frame. Each light is multiplied by how bright the
flakes of the pixel are in it over their mean, for the share of the broad part that flakes which can be counted send;
its mean over the surface is 1, so flakes neither add light nor take it. The share is that of
``realtime/material/flake_share.py``,

    f = c R T(θi) T(θo) bell(δ) / (8π m² n² cosθi' cosθo'),

at both directions instead of the mirror direction alone (θ' below the coat), at most nine tenths of the broad part.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from brdf_suite.appearance.visible_flakes import (
    FLAKE_REFLECTANCE,
    FLAKE_WAVINESS,
    LARGEST_SHARE,
    flake_coverage,
)
from brdf_suite.documents.paint import Flakes
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Vector
from brdf_suite.reference.flakes.texture import FlakesSeen, seen_ratio
from brdf_suite.reference.mitsuba_modules import dr, mi


@dataclass(frozen=True)
class SparkleField:
    """Flake parameters in a coat of index ``ior``; ``strength`` is a factor on their light."""

    flakes: Flakes
    ior: float
    strength: float = 1.0

    @property
    def peak(self) -> float:
        """c R / (8π m² n²): how much the flakes that lie flat send."""
        below = 8.0 * math.pi * self.flakes.roughness**2 * self.ior**2
        return self.strength * flake_coverage(self.flakes) * FLAKE_REFLECTANCE / below


def sparkling(
    sparkle: SparkleField, seen: FlakesSeen, light: Vector, view: Vector, light_spread: Real, base: Colour
) -> Colour:
    """Return the broad value ``base`` (1/sr) of a light as the flakes of a pixel send it.

    ``light_spread`` is the light's, radians along one axis.
    """
    ior = sparkle.ior
    n2 = d.number(ior * ior)
    up_i = dr.sqrt(n2 - (dr.square(light.x) + dr.square(light.y)))
    up_o = dr.sqrt(n2 - (dr.square(view.x) + dr.square(view.y)))
    slope = mi.Vector2f(light.x + view.x, light.y + view.y) / dr.maximum(up_i + up_o, 1e-6)
    slope2 = dr.squared_norm(slope)
    # A light's spread moves the tilt by half of it, less what refraction takes.
    spread2 = dr.square(light_spread * d.number(0.5 / ior)) + d.number(FLAKE_WAVINESS**2)
    ratio = seen_ratio(sparkle.flakes, seen, slope, spread2)
    through = (1.0 - d.fresnel(light.z, ior)) * (1.0 - d.fresnel(view.z, ior))
    q = (1.0 + slope2 * d.number(1.0 / sparkle.flakes.roughness**2)) / (1.0 + slope2)
    # n cosθ' of both directions is `up`.
    wanted = d.number(sparkle.peak) * n2 * through / (up_i * up_o * q * dr.sqrt(q))
    share = dr.minimum(wanted / dr.maximum(dr.max(base), 1e-12), LARGEST_SHARE)
    return base * (1.0 + share * (ratio - 1.0))

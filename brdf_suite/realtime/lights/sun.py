"""The sun of an environment: its strongest small light.

Prefiltered maps hold the sun's light as if nothing were in its way; baked occlusion darkens all light alike. Where an
environment has a sun, its share is taken out of both and put in by what a place sees of it (``lit.glsl``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.realtime.lights.block import DistantLights

BROADEST = 0.06
"""Radians, standard deviation: broader lights cast shadows that baked occlusion shows as well."""
FAINTEST = 0.15
"""Of the irradiance of the environment's mean light: a fainter sun casts no shadow that is seen."""


@dataclass(frozen=True, eq=False)
class Sun:
    """A light of an environment before any turn: unit direction (3,), irradiance (3,) facing it, spread in radians."""

    direction: Floats
    irradiance: Floats
    spread: float


def find_sun(lights: DistantLights, mean_radiance: Floats) -> Sun | None:
    """Return the strongest light that is small and stands out of the mean radiance (3,); None where there is none."""
    luminous = lights.strengths @ LUMINANCE
    small = np.flatnonzero(lights.spreads <= BROADEST)
    if not len(small):
        return None
    strongest = int(small[np.argmax(luminous[small])])
    if luminous[strongest] < FAINTEST * math.pi * float(mean_radiance @ LUMINANCE):
        return None
    spread = float(lights.spreads[strongest])
    return Sun(lights.directions[strongest], lights.strengths[strongest], spread)

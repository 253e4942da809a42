"""An overcast day: the CIE standard overcast sky over a yard, trees and a few buildings."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.ground import ground_radiance
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment, draw, edge, finish, mix
from brdf_suite.lighting.procedural.skyline import Skyline

ILLUMINANCE_KLX = 15.0
"""On flat ground: a bright overcast day."""

# E = 7π/9 of the zenith's luminance, by integrating the formula below.
_ZENITH = ILLUMINANCE_KLX * 9.0 / (7.0 * np.pi)
# An upright wall gets 0.396 of the flat illuminance from this sky, and half of what the ground reflects.
_WALL_SHARE = 0.396 + 0.5 * 0.17


def overcast_sky(toward: Floats) -> Floats:
    """Return neutral radiance (..., 3), kcd/m²: CIE standard overcast sky (CIE S 011, type 16).

    ``L = L_zenith · (1 + 2 sin(elevation))/3`` (Moon and Spencer 1942).
    """
    luminance = _ZENITH * (1.0 + 2.0 * np.maximum(toward[..., 1], 0.0)) / 3.0
    return np.repeat(luminance[..., None], 3, axis=-1)


def overcast(height: int = 512, samples: int = 4) -> ProceduralEnvironment:
    """Return the overcast day; ``height`` rows, 15 klx on flat ground, its sky neutral (D65) white."""
    skyline = Skyline.grown(7)
    light = np.full(3, ILLUMINANCE_KLX / np.pi)

    def radiance(toward: Floats) -> Floats:
        sky = overcast_sky(toward)
        above = skyline.over(sky, toward, light * _WALL_SHARE)
        below = ground_radiance(toward, light, overcast_sky(toward * [1.0, 0.0, 1.0]))
        return mix(below, above, edge(toward[..., 1], 0.004))

    description = "An overcast day: CIE standard overcast sky, 15 klx on flat ground without a skyline."
    return finish("overcast", draw(radiance, height, samples), description)

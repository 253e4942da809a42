"""Shipped days: the CIE standard overcast sky, and the clear sky of Preetham et al. with the sun, over a yard, trees
and a few buildings.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.panorama import (
    ProceduralEnvironment,
    centres,
    directions,
    draw,
    edge,
    finish,
    mix,
    solid_angles,
)
from brdf_suite.lighting.procedural.preetham import sky_radiance
from brdf_suite.lighting.procedural.skyline import Skyline, ground_radiance
from brdf_suite.lighting.procedural.sun import Sun, add_disc

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


SUN = Sun(height_deg=42.0, azimuth_deg=62.0)
TURBIDITY = 2.6


def _sky_on(normal: Floats) -> Floats:
    """Return the sky's illuminance (3,) in klx, working space, on a surface that faces ``normal``."""
    toward = directions(centres(64), centres(128))
    cosine = np.maximum(toward @ normal, 0.0) * (toward[..., 1] > 0.0) * solid_angles(64)
    return np.asarray(np.einsum("rc,rck->k", cosine, sky_radiance(toward, SUN.direction, TURBIDITY)))


def sunny(height: int = 512, samples: int = 4) -> ProceduralEnvironment:
    """Return the sunny day; ``height`` rows, the sun 42° high, to the left of +z as the viewer looks along it."""
    skyline = Skyline.grown(19)
    up = np.array([0.0, 1.0, 0.0])
    beam = SUN.colour * SUN.normal_illuminance
    on_ground = _sky_on(up) + beam * SUN.direction[1]
    wall_sky = np.mean(
        [_sky_on(np.array([np.sin(a), 0.0, np.cos(a)])) for a in np.arange(8) * np.pi / 4], axis=0
    )
    bounced = 0.5 * 0.16 * on_ground

    def radiance(toward: Floats) -> Floats:
        sky = sky_radiance(toward, SUN.direction, TURBIDITY)
        flat = toward * [1.0, 0.0, 1.0]
        flat = flat / np.maximum(np.linalg.norm(flat, axis=-1, keepdims=True), 1e-9)
        facing = np.maximum(-(flat @ SUN.direction), 0.0)
        wall_light = (wall_sky + bounced + facing[..., None] * beam) / np.pi
        above = skyline.over(sky, toward, wall_light)
        haze = sky_radiance(flat, SUN.direction, TURBIDITY)
        below = ground_radiance(toward, on_ground / np.pi, haze)
        return mix(below, above, edge(toward[..., 1], 0.004))

    picture = add_disc(draw(radiance, height, samples), SUN)
    description = (
        "A sunny day: sky of Preetham, Shirley and Smits (1999), turbidity 2.6; sun 42° high, 0.53° across, "
        "127.5 klx·exp(-0.21/sin h) (IES)."
    )
    return finish("sunny", picture, description)

"""A sunny day: the clear sky of Preetham et al., the sun's disc, a yard, trees and a few buildings."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.ground import ground_radiance
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
from brdf_suite.lighting.procedural.skyline import Skyline
from brdf_suite.lighting.procedural.sun import Sun, add_disc

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

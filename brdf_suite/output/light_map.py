"""A picture of an environment with its directional lights marked."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import angles, column_angles, direction, ring_angles, sample
from brdf_suite.lighting.lights import DirectionalLights
from brdf_suite.realtime.pictures.tone_curves import to_display

_GREY = 0.18
_LEAST_TEXELS, _MOST_TEXELS = 2.5, 26.0


def picture_of_lights(
    environment: Environment, lights: DirectionalLights, width: int = 1024
) -> NDArray[np.uint8]:
    """Return the map (width/2, width, 3), sRGB, exposed for its mean, a ring about each light.

    The area of a ring goes with the light's share, from the smallest to the largest that can be distinguished; a black
    and a white line make it visible on anything.
    """
    height = width // 2
    theta, phi = ring_angles(height), column_angles(width)
    light = sample(environment.radiance, direction(theta[:, None], phi[None, :]))
    mean = float(environment.average() @ LUMINANCE)
    picture = to_display(light, float(np.log2(_GREY / mean)) if mean > 0.0 else 0.0)
    luminous = lights.strengths @ LUMINANCE
    shares = luminous / max(float(luminous.sum()), 1e-300)
    radii = np.clip(_MOST_TEXELS * np.sqrt(shares * 8.0), _LEAST_TEXELS, _MOST_TEXELS)
    at_theta, at_phi = angles(lights.directions)
    rows = at_theta * height / np.pi - 0.5
    columns = (at_phi + np.pi) * width / (2.0 * np.pi) - 0.5
    across = np.arange(width)
    for row, column, radius in zip(rows, columns, radii, strict=True):
        top, bottom = max(0, int(row - radius - 3)), min(height, int(row + radius + 4))
        apart = np.abs(across - column)
        apart = np.minimum(apart, width - apart)
        distance = np.hypot(apart[None, :], np.arange(top, bottom)[:, None] - row)
        strip = picture[top:bottom]
        strip[np.abs(distance - radius) < 1.6] = 0
        strip[np.abs(distance - radius) < 0.8] = 255
    return np.asarray(picture, dtype=np.uint8)

"""What is seen beside the object: the environment, or a plain colour, free of noise.

The path tracer gives the object's light and how much of each pixel the object covers; the rest of the pixel is the
backdrop's.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.lighting.latlong import sample
from brdf_suite.reference.scene import Eye

Pixels = npt.NDArray[np.float64]
PLACES = 3
"""Looks along each edge of a pixel."""


def environment_behind(
    radiance: npt.NDArray[np.float32], rotation_deg: float, eye: Eye, size: tuple[int, int]
) -> Pixels:
    """Return (h, w, 3): the mean radiance of a map (h, w, 3), turned about y, behind each pixel."""
    width, height = size
    total: Pixels = np.zeros((height, width, 3))
    turn = math.radians(rotation_deg)
    cos, sin = math.cos(turn), math.sin(turn)
    for j in range(PLACES):
        for i in range(PLACES):
            across = (np.arange(width) + (i + 0.5) / PLACES) * (2.0 / width) - 1.0
            down = (np.arange(height) + (j + 0.5) / PLACES) * (2.0 / height) - 1.0
            local = np.empty((height, width, 3))
            local[..., 0] = across * eye.half_width_tangent
            local[..., 1] = (-down * eye.half_width_tangent * height / width)[:, None]
            local[..., 2] = -1.0
            world = local @ eye.axes.T
            x, y, z = world[..., 0], world[..., 1], world[..., 2]
            total += sample(radiance, np.stack((cos * x - sin * z, y, sin * x + cos * z), axis=-1))
    return total / PLACES**2


def composed(radiance: Pixels, coverage: Pixels, behind: Any) -> Pixels:
    """Return the whole picture's radiance: the object's, and the backdrop's where the object leaves room."""
    room = np.clip(1.0 - coverage, 0.0, 1.0)[..., None]
    return np.asarray(radiance + room * behind)

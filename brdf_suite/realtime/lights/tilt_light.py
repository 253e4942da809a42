"""The light that a paint's flakes mirror: its mean and its second moment over all their tilts.

Flakes of one place mirror many directions. How much their light differs follows from the environment alone: from the
means of L and of L² over the directions that flakes of some spread send the eye to, L being what a single flake takes
in. Small bright lights are no part of it (``sparkle_glints.glsl``).
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.realtime.lights.block import LARGEST_GLINT, DistantLights
from brdf_suite.realtime.values import EnvironmentMaps

Singles = NDArray[np.float32]

EXPONENTS = (2.0, 4.0, 8.0, 16.0, 32.0, 64.0)
"""Of the slices: a lobe of cosines for the directions; each the square of the one before."""
SIZE = 33
"""Texels along an edge of a slice, an octahedral square."""
_OF_FLAKE = 1000.0
"""Exponent of the light that one flake takes in: its waviness, below a coat, is about .03 rad of directions."""
_MOST_BLOCKS = 24  # along an edge of a face


def tilt_light(maps: EnvironmentMaps, lights: DistantLights) -> NDArray[np.float32]:
    """Return the means of L and of L² (len(EXPONENTS), SIZE, SIZE, 2) over lobes of directions, L luminance."""
    nearest = int(np.argmin(np.abs(np.log(np.asarray(maps.exponents) / _OF_FLAKE))))
    faces, exponent = maps.lobes[nearest], maps.exponents[nearest]
    towards, area, whole, cosines = _geometry(faces.size)
    light = (faces.faces.astype(np.float32) @ LUMINANCE.astype(np.float32)) * np.float32(faces.scale)
    for direction, strength in _small(lights):
        near = np.maximum(towards @ direction.astype(np.float32), 1e-6)
        light -= np.float32(strength * (exponent + 1.0) / (2.0 * np.pi)) * near ** np.float32(exponent)
    light = np.maximum(light, 0.0)
    sums = [_blocks(values) for values in (light * area, light * light * area)]
    weights = np.stack([whole, *sums], axis=-1).reshape(-1, 3)
    powers = cosines
    slices = []
    for _ in EXPONENTS:
        powers = powers * powers
        total = powers @ weights
        slices.append(total[:, 1:] / np.maximum(total[:, :1], 1e-30))
    return np.asarray(slices, np.float32).reshape(len(EXPONENTS), SIZE, SIZE, 2)


@lru_cache(maxsize=2)
def _geometry(size: int) -> tuple[Singles, Singles, Singles, Singles]:
    """Return directions (6, F, F, 3) and areas (6, F, F) of texels, areas of blocks, and cosines (SIZE², blocks)."""
    towards = texel_directions(size)
    # A texel of a face at distance 1 covers as one over the cube of its distance.
    area = np.abs(towards).max(axis=-1) ** 3
    places = np.stack([_blocks(towards[..., k] * area) for k in range(3)], axis=-1).reshape(-1, 3)
    places /= np.linalg.norm(places, axis=-1, keepdims=True)
    cosines = np.maximum(_square_directions() @ places.T, 0.0)
    found = (towards, area, _blocks(area), cosines)
    return tuple(values.astype(np.float32) for values in found)  # type: ignore[return-value]  # four of them


def _small(lights: DistantLights) -> list[tuple[Floats, float]]:
    small = lights.smaller_than(LARGEST_GLINT)
    return list(zip(small.directions, (small.strengths @ LUMINANCE).tolist(), strict=True))


def _blocks(values: NDArray[Any]) -> NDArray[Any]:
    """Return sums of faces (6, F, F) over at most _MOST_BLOCKS blocks along each edge."""
    size = values.shape[1]
    starts = np.unique(np.linspace(0, size, min(size, _MOST_BLOCKS), endpoint=False).astype(int))
    return np.asarray(np.add.reduceat(np.add.reduceat(values, starts, axis=1), starts, axis=2))


def _square_directions() -> Floats:
    """Return the directions (SIZE², 3) of a slice's texels; see octahedral.glsl."""
    along = np.linspace(-1.0, 1.0, SIZE)
    x, z = np.meshgrid(along, along)
    y = 1.0 - np.abs(x) - np.abs(z)
    folded_x = np.where(x < 0.0, -1.0, 1.0) * (1.0 - np.abs(z))
    folded_z = np.where(z < 0.0, -1.0, 1.0) * (1.0 - np.abs(x))
    directions = np.stack([np.where(y < 0.0, folded_x, x), y, np.where(y < 0.0, folded_z, z)], axis=-1)
    return np.asarray((directions / np.linalg.norm(directions, axis=-1, keepdims=True)).reshape(-1, 3))

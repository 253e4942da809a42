"""Pairs of directions by angles of three coordinate systems, and a field to tabulate.

The pairs are made by turning vectors step by step, which shares no formula with the readers: those look angles up the
other way round.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np


def turn(vector: np.ndarray, axis: tuple[float, float, float] | np.ndarray, degrees: float) -> np.ndarray:
    """Rodrigues' rotation of a vector about a unit axis."""
    (kx, ky, kz), (x, y, z) = (float(k) for k in axis), vector.tolist()
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    along = (1.0 - c) * (kx * x + ky * y + kz * z)
    return np.array(
        (
            c * x + s * (ky * z - kz * y) + along * kx,
            c * y + s * (kz * x - kx * z) + along * ky,
            c * z + s * (kx * y - ky * x) + along * kz,
        )
    )


UP, Y = np.array([0.0, 0.0, 1.0]), (0.0, 1.0, 0.0)


@lru_cache
def polar(theta: float, phi: float) -> np.ndarray:
    """A direction by its angles from the normal and from the x axis."""
    return turn(turn(UP, Y, theta), UP, phi)


@lru_cache(maxsize=4096)
def spherical_pair(a: float, b: float, c: float, d: float) -> tuple[np.ndarray, np.ndarray]:
    return polar(a, b), polar(c, d)


@lru_cache(maxsize=4096)
def specular_pair(
    a: float, b: float, c: float, d: float, offset: float = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """The view leaves the mirror direction towards the normal, then turns about it."""
    light, mirror = polar(a, b), polar(a + offset, b + 180.0)
    across = turn(np.array(Y), UP, b)
    view = turn(mirror, across, c)  # about the y of the plane: from -x towards the normal
    return light, turn(view, mirror, d)


@lru_cache(maxsize=4096)
def half_pair(a: float, b: float, c: float, d: float) -> tuple[np.ndarray, np.ndarray]:
    """The light about the half vector; the view on its other side."""
    half = polar(a, b)
    light = turn(turn(polar(c, d), Y, a), UP, b)
    return light, turn(light, half, 180.0)


PAIRS = {
    "spherical_coordinate_system": spherical_pair,
    "specular_coordinate_system": specular_pair,
    "half_difference_coordinate_system": half_pair,
}


def field(light: np.ndarray, view: np.ndarray) -> float:
    """A reflectance, 1/sr, that is isotropic, mirror-symmetric and reciprocal, and depends on every angle else."""
    half = (light + view) / np.linalg.norm(light + view)
    return float(0.1 + 0.8 * max(half[2], 0.0) ** 30 + 0.05 * light[2] * view[2] + 0.03 * light @ view)


def brushed(light: np.ndarray, view: np.ndarray) -> float:
    """The same of a sample with a direction along x."""
    half = (light + view) / np.linalg.norm(light + view)
    return field(light, view) + 0.2 * float(half[0] ** 2)

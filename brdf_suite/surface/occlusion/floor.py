"""Floor under a mesh: the visible fraction of light from above at each place.

What is kept is not one number but the harmonics of the visible light (precomputed radiance transfer, Sloan, Kautz
and Snyder 2002), so that the shadow under the mesh falls to the side that the environment's light does not come
from, whatever the environment and however it is turned.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.geometry.low_harmonics import low_harmonics, rotate_harmonics
from brdf_suite.progress import Progress
from brdf_suite.surface.occlusion.rays import GroundLight, RayScene

DEGREE = 6
"""Harmonics up to here: a shadow's edge is about 30° wide in the direction of the light, soft as the task is."""

_LONG_SIDE = 192
_RAYS = 128
_MARGIN = 1.0
_RIM = 0.2
_LIFT = 2e-5


def bake_floor(scene: RayScene, low: Floats, high: Floats, progress: Progress | None = None) -> GroundLight:
    """Return the light on the floor that touches the lowest point of a mesh with the corners ``low``, ``high`` (3,).

    The baked field reaches beyond the mesh by its height, and by a tenth of its length, on each side; over the
    outer fifth it goes over into an open floor.
    """
    size = high - low
    margin = _MARGIN * size[1] + 0.1 * max(size[0], size[2])
    begin, end = low[[0, 2]] - margin, high[[0, 2]] + margin
    texel = float((end - begin).max()) / _LONG_SIDE
    columns, rows = (max(8, int(np.ceil(length / texel))) for length in end - begin)
    x = begin[0] + (np.arange(columns) + 0.5) / columns * (end[0] - begin[0])
    z = begin[1] + (np.arange(rows) + 0.5) / rows * (end[1] - begin[1])
    points = np.empty((rows, columns, 3), np.float32)
    points[..., 0], points[..., 2] = x, z[:, None]
    points[..., 1] = low[1] + _LIFT * size.max()
    count = rows * columns
    turns = np.asarray(2.0 * np.pi * ((np.arange(count) * 0.6180339887498949) % 1.0))
    # About +y, as dense as the cosine.
    radius, angle = (
        np.sqrt((np.arange(_RAYS) + 0.5) / _RAYS),
        2.0 * np.pi * 0.6180339887498949 * np.arange(_RAYS),
    )
    directions = np.stack([radius * np.sin(angle), np.sqrt(1.0 - radius**2), radius * np.cos(angle)], axis=1)
    seen = scene.leaves(points.reshape(-1, 3), directions, turns, progress, "occlusion of the floor")
    harmonics = low_harmonics(directions, DEGREE) * (np.pi / _RAYS)
    # What is taken from an open floor: exactly nothing where nothing is in the way.
    hidden = ((255 - seen) / np.float32(255.0)).astype(np.float32) @ harmonics.astype(np.float32)
    lost = rotate_harmonics(hidden.astype(np.float64), turns)
    lost = _smooth(lost.reshape(rows, columns, -1)) * _window(rows, columns)[..., None]
    transfer = open_floor(DEGREE) - lost
    return GroundLight(
        float(low[1]),
        (float(begin[0]), float(begin[1])),
        (float(end[0]), float(end[1])),
        transfer.astype(np.float32),
    )


def open_floor(degree: int) -> Floats:
    """Return ∫ max(0, y) Y_lm dω, ((degree + 1)²,), of a floor with nothing on it."""
    heights, weights = np.polynomial.legendre.leggauss(64)
    heights, weights = 0.5 * (heights + 1.0), 0.5 * weights
    # One longitude will do for the zonal ones; all others integrate to zero.
    around = np.stack([np.sqrt(1.0 - heights**2), heights, np.zeros_like(heights)], axis=1)
    values = 2.0 * np.pi * (weights * heights) @ low_harmonics(around, degree)
    zonal = np.zeros_like(values)
    for degree_l in range(degree + 1):
        zonal[degree_l * degree_l + degree_l] = values[degree_l * degree_l + degree_l]
    return np.asarray(zonal)


def _smooth(field: Floats) -> Floats:
    """Blur by the binomial (1 4 6 4 1)/16 along both axes: neighbours looked in different directions."""
    for axis in (0, 1):
        padded = np.concatenate([np.take(field, [0, 0], axis), field, np.take(field, [-1, -1], axis)], axis)
        length = field.shape[axis]
        parts = [padded[k : k + length] if axis == 0 else padded[:, k : k + length] for k in range(5)]
        field = (parts[0] + 4.0 * parts[1] + 6.0 * parts[2] + 4.0 * parts[3] + parts[4]) / 16.0
    return field


def _window(rows: int, columns: int) -> Floats:
    """Return (rows, columns): 1 in the middle, falling smoothly to 0 at the edge."""

    def ramp(count: int) -> Floats:
        inside = np.minimum(np.arange(count) + 0.5, count - np.arange(count) - 0.5) / count
        t = np.clip(inside / _RIM, 0.0, 1.0)
        return np.asarray(t * t * (3.0 - 2.0 * t))

    return ramp(rows)[:, None] * ramp(columns)

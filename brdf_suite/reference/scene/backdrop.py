"""Noise-free background beside the object: the environment, sharp or blurred, or a plain colour.

The path tracer gives the object's light and how much of each pixel the object covers; the rest of the pixel is the
backdrop's, darkened where the ground lies in the object's shadow.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.lobe_maps import prefilter
from brdf_suite.lighting.latlong import sample
from brdf_suite.reference.scene.camera import PinholeCamera

Look = Callable[[Floats], npt.NDArray[Any]]
"""Radiance (..., 3) along directions (..., 3) of the environment, before any turn."""
PLACES = 3
"""Looks along each edge of a pixel."""
LENS_ROUNDS = 7
"""Times that this is done through other places of a lens."""
_GOLDEN = 0.6180339887498949


def looks(eye: PinholeCamera, size: tuple[int, int]) -> Iterator[tuple[Floats, Floats]]:
    """Yield places (3,) and directions (h, w, 3) from there, of any length, through even places of each pixel.

    Both are in the world. Of a lens the places are spread evenly over its opening.
    """
    width, height = size
    rounds = LENS_ROUNDS if eye.aperture > 0.0 else 1
    count = rounds * PLACES**2
    for number in range(count):
        j, i = divmod(number % PLACES**2, PLACES)
        across = (np.arange(width) + (i + 0.5) / PLACES) * (2.0 / width) - 1.0
        down = (np.arange(height) + (j + 0.5) / PLACES) * (2.0 / height) - 1.0
        # Radii in another order than places of the pixel, so that one does not follow the other.
        away = eye.aperture * math.sqrt((number * rounds % count + number // PLACES**2 + 0.5) / count)
        angle = 2.0 * math.pi * _GOLDEN * number
        right, up = away * math.cos(angle), away * math.sin(angle)
        local = np.empty((height, width, 3))
        local[..., 0] = across * eye.half_width_tangent - right / eye.focus
        local[..., 1] = (-down * eye.half_width_tangent * height / width)[:, None] - up / eye.focus
        local[..., 2] = -1.0
        yield eye.place + eye.axes[:, :2] @ [right, up], local @ eye.axes.T


def backdrop(
    eye: PinholeCamera,
    size: tuple[int, int],
    rotation_deg: float,
    look: Look | None,
    plain: npt.NDArray[np.float64],
    share: Callable[[Floats, Floats], npt.NDArray[Any]] | None = None,
) -> Floats:
    """Return (h, w, 3): the mean light behind each pixel.

    ``look`` gives the environment's, turned about y; None: it is ``plain`` (3,) everywhere. ``share`` gives what a
    ground leaves of it, from a place (3,) along directions in the world.
    """
    width, height = size
    total: Floats = np.zeros((height, width, 3))
    turn, count = math.radians(rotation_deg), 0
    cos, sin = math.cos(turn), math.sin(turn)
    for place, world in looks(eye, size):
        x, y, z = world[..., 0], world[..., 1], world[..., 2]
        light: npt.NDArray[Any] = plain
        if look is not None:
            light = look(np.stack((cos * x - sin * z, y, sin * x + cos * z), axis=-1))
        total += light if share is None else light * share(place, world)
        count += 1
    return total / count


def sharp(radiance: npt.NDArray[np.float32]) -> Look:
    """Return the look-up of a map (h, w, 3)."""
    return lambda directions: sample(radiance, directions)


def blur_map(radiance: npt.NDArray[np.float32], exponent: float) -> Look:
    """Return the look-up of a map (h, w, 3) that is blurred by a cosine lobe: some tenths of a second."""
    faces = prefilter(Environment("backdrop", radiance), [exponent]).lobes[0].radiance()
    return lambda directions: sample_cube(faces, directions)


def sample_cube(faces: npt.NDArray[np.float32], directions: Floats) -> npt.NDArray[np.float32]:
    """Return radiance (..., 3) of a cube map (6, F, F, 3), OpenGL's layout, bilinear within each face."""
    flat = directions.reshape(-1, 3)
    size = faces.shape[1]
    axis = np.abs(flat).argmax(axis=1)
    rows = np.arange(len(flat))
    major = flat[rows, axis]
    negative = major < 0.0
    x, y, z = (flat / np.maximum(np.abs(major), 1e-300)[:, None]).T
    sign = np.where(negative, -1.0, 1.0)
    # OpenGL 3.3, table 3.10.
    s = np.choose(axis, [-sign * z, x, sign * x])
    t = np.choose(axis, [-y, sign * z, -y])
    across, down = (np.clip(0.5 * (place + 1.0) * size - 0.5, 0.0, size - 1.0) for place in (s, t))
    i, j = (np.minimum(place.astype(np.int64), size - 2) for place in (across, down))
    u, v = (across - i)[:, None].astype(np.float32), (down - j)[:, None].astype(np.float32)
    face = 2 * axis + negative
    top = faces[face, j, i] * (1.0 - u) + faces[face, j, i + 1] * u
    bottom = faces[face, j + 1, i] * (1.0 - u) + faces[face, j + 1, i + 1] * u
    found: npt.NDArray[np.float32] = top * (1.0 - v) + bottom * v
    return found.reshape(directions.shape)

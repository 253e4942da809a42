"""Simulated calibration photographs: a white tile in the sphere's place, and a chessboard in several poses."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from brdf_suite.acquisition.simulator.optics import SimulatedCamera, SimulatedLamp
from brdf_suite.acquisition.simulator.settings import SimulatorSettings
from brdf_suite.arrays import Floats

TILE_REFLECTANCE = 0.99
_TILE_HALF = 0.8
_REGION_HALF = 0.15
"""Half sides of the tile, and of the part of it that is read, in radii of the sphere."""

BOARD_COLUMNS, BOARD_ROWS, BOARD_PICTURES = 9, 6, 12
"""Inner corners of the board, and the number of its photographs."""
_BLACK, _WHITE, _WALL = 0.03, 0.65, 0.12
"""Fillings of the well by the board's squares and the wall behind."""
_MOST_TILT_DEG = 38.0
_SUBPIXELS = 5


def tile_picture(optics: SimulatedCamera, settings: SimulatorSettings, lamp: SimulatedLamp) -> Floats:
    """Return the radiance (h, w, 3), over the lamp's strength, of a matt tile at the origin that faces +z."""
    half = _TILE_HALF * settings.radius_m

    def shade(uv: Floats) -> Floats:
        lights, relative = lamp.at(np.pad(uv, ((0, 0), (0, 1))))
        value = TILE_REFLECTANCE / math.pi * np.maximum(lights[:, 2], 0.0) * relative
        return np.where((np.abs(uv) < half).all(axis=1), value, 0.0)

    return _plane_picture(optics, settings, np.zeros(3), np.eye(3), shade)


def tile_region(optics: SimulatedCamera, settings: SimulatorSettings) -> tuple[int, int, int, int]:
    """Return (left, top, width, height) in pixels of the tile's middle."""
    half = _REGION_HALF * settings.radius_m
    corners = optics.project(np.array([[-half, half, 0.0], [half, -half, 0.0]]))
    left, top = (int(v) for v in np.ceil(corners[0]))
    right, bottom = (int(v) for v in np.floor(corners[1]))
    return left, top, max(1, right - left + 1), max(1, bottom - top + 1)


def board_square_m(optics: SimulatedCamera, settings: SimulatorSettings) -> float:
    """Return the side of a square, in tenths of a millimetre, of a board that fills most of the picture."""
    field = settings.camera_distance_m * min(settings.size) / optics.lens.fx
    return round(0.78 * field / (BOARD_COLUMNS + 1), 4)


def board_picture(optics: SimulatedCamera, settings: SimulatorSettings, index: int) -> Floats:
    """Return fillings of the well (h, w, 3) of the board in its pose of this index."""
    square = board_square_m(optics, settings)
    axes, middle = _pose(optics, settings, index)

    def shade(uv: Floats) -> Floats:
        column = uv[:, 0] / square + 0.5 * (BOARD_COLUMNS + 1)
        row = uv[:, 1] / square + 0.5 * (BOARD_ROWS + 1)
        inside = (column > 0) & (column < BOARD_COLUMNS + 1) & (row > 0) & (row < BOARD_ROWS + 1)
        margin = (np.abs(column - 0.5 * (BOARD_COLUMNS + 1)) < 0.5 * BOARD_COLUMNS + 1.3) & (
            np.abs(row - 0.5 * (BOARD_ROWS + 1)) < 0.5 * BOARD_ROWS + 1.3
        )
        odd = (np.floor(column) + np.floor(row)) % 2 == 0
        return np.where(inside & odd, _BLACK, np.where(margin, _WHITE, _WALL))

    return _plane_picture(optics, settings, middle, axes, shade)


def _pose(optics: SimulatedCamera, settings: SimulatorSettings, index: int) -> tuple[Floats, Floats]:
    """Return the board's axes (rows across, up, towards the camera) and its middle, in the world."""
    random = np.random.default_rng([settings.seed, 2, index])
    # Tilts about every axis in turn, or the focal length cannot be separated from the distance.
    around = 2.0 * math.pi * index / BOARD_PICTURES
    tilt = math.radians(_MOST_TILT_DEG) * (0.5 + 0.5 * (index % 2)) * (index > 0)
    axis = np.array([math.cos(around), math.sin(around), 0.0])
    spin = math.radians(random.uniform(-10.0, 10.0))
    board = _turned(np.array([0.0, 0.0, 1.0]), spin) @ _turned(axis, tilt).T
    reach = settings.camera_distance_m * random.uniform(0.97, 1.2)
    shift = random.uniform(-0.06, 0.06, 2) * settings.camera_distance_m * min(settings.size) / optics.lens.fx
    # In the camera's frame the board's own "up" is -y, and it faces -z.
    flip = np.diag([1.0, -1.0, -1.0])
    axes = board @ flip @ optics.turn
    middle = optics.centre + np.array([shift[0], shift[1], reach]) @ optics.turn
    return axes, middle


def _turned(axis: Floats, angle: float) -> Floats:
    """Return the rotation about a unit axis (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * (cross @ cross))


def _plane_picture(
    optics: SimulatedCamera,
    settings: SimulatorSettings,
    middle: Floats,
    axes: Floats,
    shade: Callable[[Floats], Floats],
) -> Floats:
    """Return the means (h, w, 3) of ``shade`` of plane coordinates over each pixel; the finer ones at edges."""
    width, height = settings.size

    def seen(x: Floats, y: Floats) -> Floats:
        rays = optics.rays(x, y)
        reach = ((middle - optics.centre) @ axes[2]) / (rays @ axes[2])
        return shade((optics.centre + reach[:, None] * rays - middle) @ axes[:2].T)

    rows, columns = np.mgrid[0.0:height, 0.0:width]
    picture = seen(columns.ravel(), rows.ravel()).reshape(height, width)
    padded = np.pad(picture, 1, mode="edge")
    parts = [padded[i : i + height, j : j + width] for i in range(3) for j in range(3)]
    low, high = np.minimum.reduce(parts), np.maximum.reduce(parts)
    edges = np.argwhere(high > 1.1 * low + 1e-12)
    steps = (np.arange(_SUBPIXELS) + 0.5) / _SUBPIXELS - 0.5
    down, right = (part.ravel() for part in np.meshgrid(steps, steps, indexing="ij"))
    x, y = (edges[:, 1, None] + right).ravel(), (edges[:, 0, None] + down).ravel()
    picture[edges[:, 0], edges[:, 1]] = seen(x, y).reshape(len(edges), -1).mean(axis=1)
    return np.repeat(picture[..., None], 3, axis=-1)

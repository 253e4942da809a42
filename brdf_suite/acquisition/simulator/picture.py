"""Radiance of the sphere in each pixel: the mean over the pixel's square.

The clear coat's peak of a car paint is a degree wide, much less than a pixel of a small photograph. So a pixel gets as
many rays as its neighbourhood needs: one where the picture is smooth, a grid where the outline, the shadow's edge, an
occluder or a steep change passes, and the finest where the peak may lie in it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from brdf_suite.acquisition.simulator.optics import SimulatedCamera, SimulatedLamp, first_hits, lengths
from brdf_suite.acquisition.simulator.settings import SimulatorSettings
from brdf_suite.arrays import Bools, Floats, Integers
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.protocol import Reflectance

_LARGEST_GRID = 32
_OUTLINE_GRID, _DARK_OUTLINE_GRID = 16, 8
"""Rays each way along the outline: of pixels with light near them, and of others, where a crescent may be thin."""
_INNER_GRID = 8
_UNEVEN = 0.3
"""Along the outline the normal turns by a right angle within a pixel, and a peak is a sliver there: cells that differ
from a neighbour by this share of the pixel's mean are divided once more."""
_FINEST_STEP = 0.0025
"""Radians of the half vector between rays at a peak; the narrowest of Günther's Table 1 has m = 0.013."""
_PEAK_REACH = 3.0
"""The peak may lie in a pixel whose half vector is within so many steps to the next pixel of the normal."""
_OUTLINE_REACH = 0.35
"""Radians of θh next to the outline, within which a peak may lie in it."""
_STEEP = 1.35
_STEEPER = 2.5
"""Ratios within 3 × 3 pixels from which on one gets 4 × 4 and 8 × 8 rays.

A slope of ln(ratio)/√8 a pixel makes the middle differ from the mean by its square over 24 n²: under 5e-4."""
_BLOCK = 1 << 14
# The turntable below the sphere: how far, its radius in metres, its albedo; and the coat that mirrors it.
_BELOW_M = 0.15
_RADIUS_M = 0.6
_ALBEDO = 0.06
_INDEX = 1.5
"""Rays at once: their arrays stay in the processor's cache."""
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


@dataclass(frozen=True, eq=False)
class SimulatedScene:
    """A sphere in front of the camera; ``matrix`` (3, 3) converts reflectance to the camera's channels."""

    optics: SimulatedCamera
    size: tuple[int, int]
    centre: Floats
    radius: float
    reflectance: Reflectance
    matrix: Floats | None
    arm: bool

    def mean_radiance(self, lamp: SimulatedLamp) -> Floats:
        """Return (h, w, 3): the mean over each pixel, over the strength of the lamp's channel."""
        width, height = self.size
        rows, columns = np.mgrid[0.0:height, 0.0:width]
        values, covered, hidden, half = self._seen(lamp, columns.ravel(), rows.ravel(), angles=True)
        assert half is not None
        shape = (height, width)
        picture = values.reshape(height, width, 3)
        grid, deep = _grids(
            picture.mean(axis=-1), half.reshape(shape), covered.reshape(shape), hidden.reshape(shape)
        )
        for side in np.unique(grid[grid > 1]):
            self._refine(lamp, picture, np.argwhere((grid == side) & ~deep), int(side), deeper=False)
        self._refine(lamp, picture, np.argwhere(deep), _OUTLINE_GRID, deeper=True)
        return picture

    def _refine(
        self, lamp: SimulatedLamp, picture: Floats, pixels: Integers, side: int, *, deeper: bool
    ) -> None:
        """Replace pixels (n, 2) as (row, column) by the mean of ``side`` × ``side`` rays."""
        block = max(1, _BLOCK // (side * side))
        for start in range(0, len(pixels), block):
            part = pixels[start : start + block]
            means = self._means(lamp, part[:, 1].astype(float), part[:, 0].astype(float), 1.0, side, deeper)
            picture[part[:, 0], part[:, 1]] = means

    def _means(
        self, lamp: SimulatedLamp, x: Floats, y: Floats, width: float, side: int, deeper: bool
    ) -> Floats:
        """Return the mean radiance (n, 3) over squares of a width around (x, y), pixels.

        ``deeper``: cells that differ much from their neighbours are divided once more.
        """
        steps = ((np.arange(side) + 0.5) / side - 0.5) * width
        down, right = (part.ravel() for part in np.meshgrid(steps, steps, indexing="ij"))
        xs, ys = (x[:, None] + right).ravel(), (y[:, None] + down).ravel()
        values = self._seen(lamp, xs, ys)[0]
        if deeper:
            luminance = values.mean(axis=-1).reshape(-1, side, side)
            span = _around(luminance, np.maximum, -np.inf) - _around(luminance, np.minimum, np.inf)
            uneven = np.flatnonzero(span > _UNEVEN * luminance.mean(axis=(1, 2), keepdims=True))
            block = max(1, _BLOCK // _INNER_GRID**2)
            for start in range(0, len(uneven), block):
                part = uneven[start : start + block]
                values[part] = self._means(lamp, xs[part], ys[part], width / side, _INNER_GRID, False)
        return np.asarray(values.reshape(len(x), side * side, 3).mean(axis=1))

    def _seen(
        self, lamp: SimulatedLamp, x: Floats, y: Floats, *, angles: bool = False
    ) -> tuple[Floats, Bools, Bools, Floats | None]:
        """Return of each ray: radiance (n, 3), whether it meets the sphere, whether it is hidden, and θh (n,) or NaN.

        The last where ``angles`` are asked for, which cost as much as the radiance; else None.
        """
        values, half = np.zeros((len(x), 3)), np.full(len(x), np.nan) if angles else None
        covered, hidden = np.zeros(len(x), bool), np.zeros(len(x), bool)
        for start in range(0, len(x), _BLOCK):
            here = slice(start, start + _BLOCK)
            rays = self.optics.rays(x[here], y[here])
            reach = first_hits(self.optics.centre, rays, self.centre, self.radius)
            covered[here] = hit = ~np.isnan(reach)
            if self.arm:
                hidden[here] = lamp.hides(self.optics.centre, rays, np.where(hit, reach, np.inf))
            shown = np.flatnonzero(hit & ~hidden[here])
            points = self.optics.centre + reach[shown, None] * rays[shown]
            values[start + shown] = self._shaded(lamp, points, -rays[shown])
            if half is not None:
                half[start + shown] = self._half_angles(lamp, points, -rays[shown])
        return values, covered, hidden, half

    def _half_angles(self, lamp: SimulatedLamp, points: Floats, views: Floats) -> Floats:
        """Return θh (n,), radians, of points on the sphere seen from directions (n, 3)."""
        halves = lamp.at(points)[0] + views
        halves /= lengths(halves)[:, None]
        # By the difference of two unit vectors: the arc cosine of nearly 1 has no digits.
        off = lengths(halves - (points - self.centre) / self.radius)
        return np.asarray(2.0 * np.arcsin(np.minimum(1.0, 0.5 * off)))

    def _shaded(self, lamp: SimulatedLamp, points: Floats, views: Floats) -> Floats:
        """Return the radiance (n, 3) of points on the sphere seen from directions (n, 3)."""
        normals = (points - self.centre) / self.radius
        lights, relative = lamp.at(points)
        cosines = np.einsum("ij,ij->i", normals, lights)
        values = np.zeros((len(points), 3))
        # Attached shadow: what looks away from the lamp is dark.
        lit = np.flatnonzero(cosines > 0.0)
        wi, wo = _in_frames(normals[lit], lights[lit], views[lit])
        found = np.asarray(self.reflectance.eval(wi, wo))
        if self.matrix is not None:
            found = found @ self.matrix.T
        values[lit] = found * (cosines * relative)[lit, None]
        if self.arm:
            values += turntable_reflection(lamp, points, normals, views)[:, None]
        return values


def _in_frames(normals: Floats, *vectors: Floats) -> list[Floats]:
    """Return vectors (n, 3) as tangent, bitangent, normal parts; the tangent runs level around the axis."""
    x, y, z = normals.T
    level = np.hypot(x, z)
    is_pole = level <= 1e-9
    level[is_pole] = 1.0
    # Tangent (along, 0, across), and the bitangent, which is normal × tangent.
    along, across = np.where(is_pole, 1.0, z / level), np.where(is_pole, 0.0, -x / level)
    rise = z * along - x * across
    found = []
    for vector in vectors:
        right, up, back = vector.T
        parts = np.empty_like(vector)
        parts[:, 0] = right * along + back * across
        parts[:, 1] = up * rise + y * (right * across - back * along)
        parts[:, 2] = right * x + up * y + back * z
        found.append(parts)
    return found


def _grids(luminance: Floats, half: Floats, covered: Bools, hidden: Bools) -> tuple[Integers, Bools]:
    """Return how many rays each way a pixel wants, (h, w), and where cells may need to be divided once more."""
    shown = covered & ~hidden
    grid = np.ones(luminance.shape, np.int64)
    lowest, highest = _around(luminance, np.minimum, np.inf), _around(luminance, np.maximum, -np.inf)
    ratio = np.divide(highest, lowest, out=np.full(luminance.shape, np.inf), where=lowest > 0.0)
    any_light = shown & (highest > 0.0)
    grid[any_light & (ratio > _STEEP)] = 4
    grid[any_light & (ratio > _STEEPER)] = 8
    seen = shown.astype(float)
    outline = _around(seen, np.minimum, np.inf) != _around(seen, np.maximum, -np.inf)
    near_light = _around(highest, np.maximum, -np.inf) > 0.0
    grid[outline] = np.where(near_light, _OUTLINE_GRID, _DARK_OUTLINE_GRID)[outline]
    known = np.where(np.isnan(half), np.inf, half)
    nearest = _around(known, np.minimum, np.inf)
    farthest = _around(np.where(np.isnan(half), 0.0, half), np.maximum, 0.0)
    step = np.maximum(farthest - nearest, 0.0)
    step[~np.isfinite(step)] = 0.0
    peak = any_light & (nearest < _PEAK_REACH * step)
    # Also where no middle of a pixel is lit: the crescent that a lamp behind the sphere leaves is thinner than one.
    deep = outline & (_around(np.where(shown, nearest, np.inf), np.minimum, np.inf) < _OUTLINE_REACH)
    wanted = np.clip(np.ceil(step / _FINEST_STEP), 4, _LARGEST_GRID)
    # In powers of two, so that there are few groups.
    grid[peak] = np.maximum(grid[peak], 2 ** np.ceil(np.log2(wanted[peak])).astype(np.int64))
    return grid, deep


def _around(values: Floats, choose: np.ufunc, outside: float) -> Floats:
    """Return the least or largest of each pixel's 3 × 3 neighbourhood; rows and columns are the last two axes."""
    found = values
    for axis in (-2, -1):
        rest = [(0, 0)] * values.ndim
        rest[axis] = (1, 1)
        padded = np.moveaxis(np.pad(found, rest, constant_values=outside), axis, -1)
        found = choose(choose(padded[..., :-2], padded[..., 1:-1]), padded[..., 2:])
        found = np.moveaxis(found, -1, axis)
    return found


def turntable_reflection(lamp: SimulatedLamp, points: Floats, normals: Floats, views: Floats) -> Floats:
    """Return the radiance (n,), over the lamp's strength, of a matt disc below the sphere mirrored in its coat."""
    cosines = np.einsum("ij,ij->i", normals, views)
    mirrored = 2.0 * cosines[:, None] * normals - views
    down = mirrored[:, 1] < -1e-6
    reach = np.where(down, (-_BELOW_M - points[:, 1]) / np.where(down, mirrored[:, 1], -1.0), 0.0)
    feet = points + reach[:, None] * mirrored
    seen = down & (np.hypot(feet[:, 0], feet[:, 2]) < _RADIUS_M)
    lights, relative = lamp.at(feet)
    radiance = _ALBEDO / np.pi * np.maximum(lights[:, 1], 0.0) * relative
    return np.where(seen, fresnel_dielectric(cosines, _INDEX) * radiance, 0.0)


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
        margin = np.abs(column - 0.5 * (BOARD_COLUMNS + 1)) < 0.5 * BOARD_COLUMNS + 1.3
        margin &= np.abs(row - 0.5 * (BOARD_ROWS + 1)) < 0.5 * BOARD_ROWS + 1.3
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

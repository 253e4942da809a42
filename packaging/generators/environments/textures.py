"""Textures computed from noise and regular patterns: reflectances (h, w, 3) in the working space, seamless."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.arrays import Floats
from environments.solids import srgb


@cache
def noise(seed: int, roughness: float = 1.0, size: int = 512) -> Floats:
    """Return periodic noise (size, size) of mean 0 and deviation 1, its amplitude falling as 1/frequency^roughness."""
    rng = np.random.default_rng(seed)
    frequency = np.hypot(np.fft.fftfreq(size)[:, None], np.fft.rfftfreq(size)[None, :]) * size
    frequency[0, 0] = np.inf
    made = np.fft.irfft2(np.fft.rfft2(rng.standard_normal((size, size))) / frequency**roughness, (size, size))
    return np.asarray((made - made.mean()) / made.std())


def field(x: Floats, y: Floats, seed: int, period: float, roughness: float = 1.0) -> Floats:
    """Return noise at places in metres; it repeats after ``period`` metres along both axes."""
    grid = noise(seed, roughness)
    size = len(grid)
    u, v = (x / period) % 1.0 * size, (y / period) % 1.0 * size
    i, j = u.astype(np.int64), v.astype(np.int64)
    a, b = u - i, v - j
    i, j = i % size, j % size
    k, n = (i + 1) % size, (j + 1) % size
    return (grid[j, i] * (1 - a) + grid[j, k] * a) * (1 - b) + (grid[n, i] * (1 - a) + grid[n, k] * a) * b


def places(wide: float, high: float, columns: int, rows: int) -> tuple[Floats, Floats]:
    """Return x (rows, columns) and y of the pixel centres of a picture so many metres wide and high, row 0 on top."""
    x = (np.arange(columns) + 0.5) / columns * wide
    y = (rows - 0.5 - np.arange(rows)) / rows * high
    first, second = np.meshgrid(x, y)
    return first, second


def hashed(i: Floats, j: Floats, seed: int) -> Floats:
    """Return even random numbers 0…1 for cells of whole numbers."""
    value = np.sin(i * 127.1 + j * 311.7 + seed * 74.7) * 43758.5453
    return np.asarray(value - np.floor(value))


def cells(
    x: Floats, y: Floats, wide: float, high: float, joint: float, shift: float = 0.5
) -> tuple[Floats, Floats, Floats]:
    """Return depth 0…1 within the joint of bricks or slabs at places, and their column and row numbers.

    1 is on a brick, 0 in the middle of a joint; every second row is shifted by ``shift`` of a brick.
    """
    row = np.floor(y / high)
    across = x / wide + shift * (row % 2)
    column = np.floor(across)
    u, v = across - column, y / high - row
    apart = np.minimum(np.minimum(u, 1 - u) * wide, np.minimum(v, 1 - v) * high)
    return np.clip(apart / joint, 0.0, 1.0), column, row


def shaded(colour: ArrayLike, factor: Floats) -> Floats:
    """Return a colour (3,) or (..., 3) times a factor (...), between 0.01 and 0.95."""
    return np.asarray(np.clip(np.asarray(colour) * factor[..., None], 0.01, 0.95))


def blend(first: Floats, second: ArrayLike, share: Floats) -> Floats:
    """Return what lies between two colours."""
    part = np.clip(share, 0.0, 1.0)[..., None]
    return np.asarray(first * (1.0 - part) + np.asarray(second) * part)


def plaster(seed: int) -> Floats:
    """Return white plaster of 8 m with stains, to be tinted."""
    x, y = places(8.0, 8.0, 1024, 1024)
    tone = 1.0 + 0.045 * field(x, y, seed, 8.0, 1.4) + 0.035 * field(x * 3.0, y, seed + 1, 8.0, 1.2)
    return shaded((0.86, 0.86, 0.85), tone + 0.03 * field(x, y, seed + 2, 2.0, 0.3))


def bricks(seed: int, tone: str = "#8d4f3a") -> Floats:
    """Return a wall of bricks, 4.0 m wide and 3.0 m high, no two of one colour."""
    x, y = places(4.0, 3.0, 1280, 960)
    depth, column, row = cells(x, y, 0.25, 0.075, 0.008)
    kind = hashed(column % 16, row % 40, seed)
    colour = blend(np.broadcast_to(srgb(tone), (*x.shape, 3)), srgb("#5e3a32"), 0.6 * (kind > 0.75) * kind)
    colour = blend(colour, srgb("#b5785a"), 0.5 * (kind < 0.25) * (1 - kind))
    light = 0.9 + 0.25 * hashed(column % 16, row % 40, seed + 1) + 0.1 * field(x, y, seed, 1.0, 0.6)
    mortar = shaded(srgb("#b3a899"), 1.0 + 0.1 * field(x, y, seed + 1, 1.0, 0.4))
    return np.clip(blend(mortar, shaded(colour, light), (depth - 0.35) * 6.0), 0.01, 0.95)


def ashlar(seed: int, tone: str = "#c9bda4", wide: float = 0.8, high: float = 0.4) -> Floats:
    """Return dressed stone, eight by eight blocks."""
    x, y = places(8 * wide, 8 * high, 1280, int(1280 * high / wide))
    depth, column, row = cells(x, y, wide, high, 0.014)
    light = 0.9 + 0.2 * hashed(column % 8, row % 8, seed) + 0.07 * field(x, y, seed, 8 * high, 1.0)
    stone = shaded(srgb(tone), light + 0.05 * field(x, y, seed + 1, 0.8, 0.4))
    return blend(shaded(srgb(tone), np.full(x.shape, 0.42)), stone, depth * 1.6 - 0.2)


def concrete(seed: int, tone: float = 0.3, size: float = 6.0) -> Floats:
    """Return trowelled concrete of ``size`` metres, cloudy, with fine cracks and spots."""
    x, y = places(size, size, 1536, 1536)
    cloud = 1.0 + 0.1 * field(x, y, seed, size, 1.3) + 0.05 * field(x, y, seed + 1, size / 3, 0.8)
    spot = np.clip(field(x, y, seed + 2, size, 0.9) - 1.7, 0.0, 1.0)
    crack = np.clip(1.0 - np.abs(field(x, y, seed + 3, size, 1.7)) * 90.0, 0.0, 1.0)
    crack *= np.clip(field(x, y, seed + 4, size, 1.5) - 0.5, 0.0, 1.0)
    return shaded((tone, tone * 0.99, tone * 0.96), cloud * (1 - 0.25 * spot) * (1 - 0.35 * crack))


def roof_tiles(seed: int, tone: str = "#7b4a38") -> Floats:
    """Return a tiled roof, 4 m by 4 m."""
    x, y = places(4.0, 4.0, 768, 768)
    column, row = np.floor(x / 0.25), np.floor(y / 0.2)
    light = 0.8 + 0.35 * hashed(column % 16, row % 20, seed) + 0.1 * field(x, y, seed, 4.0, 1.0)
    round_ = 0.75 + 0.25 * np.sin(np.pi * (x / 0.25 - column))
    lower = np.clip((y / 0.2 - row) * 8.0, 0.35, 1.0)
    return shaded(srgb(tone), light * round_ * lower)


def bark(seed: int) -> Floats:
    """Return the bark of a plane tree, 1 m by 1 m: patches of grey, olive and cream."""
    x, y = places(1.0, 1.0, 512, 512)
    patch = field(x * 2.0, y, seed, 1.0, 1.4)
    colour = blend(np.broadcast_to(srgb("#8a8270"), (*x.shape, 3)), srgb("#b9b294"), patch * 4.0 - 2.0)
    colour = blend(colour, srgb("#5d5a48"), -patch * 4.0 - 2.0)
    return shaded(colour, 1.0 + 0.15 * field(x * 4.0, y, seed + 1, 1.0, 0.8))

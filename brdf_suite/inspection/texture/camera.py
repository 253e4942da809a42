"""Pictures of a paint's flakes as the texture instrument's camera takes them, and the readings of those pictures.

Of the millions of flakes those that mirror any of the light are drawn: their number, places, areas, depths and tilts
have the distributions of the population of docs/method/texture.md. The same seed gives the same picture.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.appearance.texture import (
    AREA_SHAPE,
    LIGHTS_DEG,
    NO_TEXTURE,
    PIXEL_MM,
    VISIBLE_CONTRAST,
    Grain,
    PaintLight,
    Sparkle,
    Speckle,
    TextureReadings,
    grain,
    speckle,
)
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes
from brdf_suite.progress import Progress, report

LIT_FLAKES = 20_000
"""A picture in directed light is so large that it is expected to hold so many."""
SMALLEST_MM2, LARGEST_MM2 = 1_000.0, 30_000.0
"""Area of a picture in directed light."""
GRAIN_MM2 = 200.0
"""Area of the picture in diffuse light."""
MOST_CROWDED = 60.0
"""Flakes in the area of an image, beyond which one stands for several and deviates by the root of their number less;
no point of them is bright enough to be seen."""
SMALLEST_CELL_MM = 0.02
"""Of the mosaic in diffuse light; one stands for several likewise."""

_FEW = 50_000  # flakes, of which each is drawn as an image of its own
_REACH = 3  # pixels, of such an image, at least; and standard deviations
_FINE = 4  # places along a pixel's edge, of many
_BLUR_REACH = 4.0  # standard deviations, of the blur of many
_BLUR_ROWS = 32


def measure_texture(
    paint: PaintLight, flakes: Flakes | None, seed: int = 0, progress: Progress | None = None
) -> TextureReadings:
    """Return the readings of a paint's flakes; zeros where it has none.

    ``seed``: of the flakes' places and tilts, a whole number ≥ 0. :class:`Cancelled` where the callback asks for it.
    """
    if flakes is None or flakes.density_per_mm2 <= 0.0:
        return NO_TEXTURE
    rows = []
    for k, light in enumerate(LIGHTS_DEG):
        report(progress, 0.25 * k, "taking pictures of the flakes")
        seen = speckle(paint, flakes, light)
        picture = sparkle_picture(seen, np.random.default_rng((seed, k)))
        rows.append(read_sparkle(picture, seen.share, light))
    report(progress, 0.75, "taking pictures of the flakes")
    seen_grain = grain(paint, flakes)
    picture = grain_picture(seen_grain, np.random.default_rng((seed, len(LIGHTS_DEG))))
    mean = float(picture.mean())
    # So few flakes that none lies in the picture have no grain.
    return TextureReadings(tuple(rows), seen_grain.share * float(picture.std()) / mean if mean > 0.0 else 0.0)


def sparkle_picture(seen: Speckle, rng: np.random.Generator) -> Floats:
    """Return X (h, w): the light of the flakes over the mean of all; its edges are joined."""
    together = max(seen.crowding / MOST_CROWDED, 1.0)
    per_mm2 = seen.per_mm2 / together
    area = min(max(LIT_FLAKES / max(per_mm2, 1e-12), SMALLEST_MM2), LARGEST_MM2)
    side = math.ceil(math.sqrt(area) / PIXEL_MM)
    count = int(rng.poisson(per_mm2 * (side * PIXEL_MM) ** 2))
    at = rng.uniform(0.0, side, (2, count))
    # Of area, depth, and how near its tilt is to the one that mirrors the light; each over its mean.
    light = (
        rng.gamma(AREA_SHAPE, 1.0 / AREA_SHAPE, count)
        * (2.5 * rng.uniform(size=count) ** 1.5)
        * (3.0 * (1.0 - rng.uniform(size=count)) ** 2)
    ) / (per_mm2 * PIXEL_MM**2)
    draw = _images if count < _FEW else _blurred
    return np.asarray(1.0 + (draw(at, light, side, seen.spread_mm) - 1.0) / math.sqrt(together))


def _images(at: Floats, light: Floats, side: int, spread_mm: float) -> Floats:
    """Return a square picture of flakes ``at`` (2, n) pixels, its edges joined; its sum is that of the light."""
    first = np.floor(at).astype(np.int64)
    reach = max(_REACH, math.ceil(_REACH * spread_mm / PIXEL_MM))
    beside = first[:, :, None] + np.arange(-reach, reach + 1)
    bells = np.exp(-0.5 * ((beside + 0.5 - at[:, :, None]) * (PIXEL_MM / spread_mm)) ** 2)
    bells /= bells.sum(axis=2, keepdims=True)
    beside %= side
    places = beside[1][:, :, None] * side + beside[0][:, None, :]
    stamps = (light[:, None] * bells[1])[:, :, None] * bells[0][:, None, :]
    return np.asarray(np.bincount(places.ravel(), stamps.ravel(), side * side).reshape(side, side), float)


def _blurred(at: Floats, light: Floats, side: int, spread_mm: float) -> Floats:
    """Return the same of very many flakes, from a finer picture of points."""
    fine = side * _FINE
    column, line = np.minimum((at * _FINE).astype(np.int64), fine - 1)
    points: Floats = np.asarray(np.bincount(line * fine + column, light, fine * fine), float).reshape(
        fine, fine
    )
    spread = spread_mm * _FINE / PIXEL_MM
    reach = round(_BLUR_REACH * spread)
    bell = np.exp(-0.5 * (np.arange(-reach, reach + 1) / spread) ** 2)
    bell *= _FINE / bell.sum()
    # Of the blurred picture one row and column in four are wanted, so many rows at a time. scipy.ndimage works all of
    # them out, and takes a fifth of a second to import, for which the start of Designer would wait.
    band = np.zeros((_BLUR_ROWS, _FINE * (_BLUR_ROWS - 1) + bell.size))
    for row, weights in enumerate(band):
        weights[_FINE * row : _FINE * row + bell.size] = bell
    for _axis in range(2):
        around = np.pad(points, ((reach, reach + _FINE * _BLUR_ROWS), (0, 0)), mode="wrap")
        firsts = range(0, fine, _FINE * _BLUR_ROWS)
        points = np.concatenate([band @ around[first : first + band.shape[1]] for first in firsts])[:side].T
    return points


def read_sparkle(picture: Floats, share: float, light_deg: float) -> Sparkle:
    """Return the reading of X (h, w) of :func:`sparkle_picture`, of flakes that send a share of the light."""
    height, width = picture.shape
    if share <= 0.0:
        return Sparkle(light_deg, 0.0, 0.0, 0.0, 0.0)
    light = picture.ravel()
    seen = np.flatnonzero(light >= 1.0 + VISIBLE_CONTRAST / share)
    if seen.size == 0:
        return Sparkle(light_deg, 0.0, 0.0, 0.0, 0.0)
    peaks = seen
    for i, j in ((i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)):
        row, column = np.divmod(peaks, width)
        peaks = peaks[light[peaks] > light[(row + i) % height * width + (column + j) % width]]
    return Sparkle(
        light_deg,
        peaks.size / (light.size * PIXEL_MM**2),
        seen.size / light.size,
        share * float(light[peaks].mean() - 1.0) if peaks.size else 0.0,
        share * math.sqrt(float(((light[seen] - 1.0) ** 2).sum()) / light.size),
    )


def grain_picture(seen: Grain, rng: np.random.Generator) -> Floats:
    """Return the light (h, w) of the flakes over the mean of all: each place shows them by their nearness."""
    cell = max(1.0 / math.sqrt(seen.cells_per_mm2), SMALLEST_CELL_MM)
    together = cell * cell * seen.cells_per_mm2
    side = round(math.sqrt(GRAIN_MM2) / PIXEL_MM)
    # A whole number of cells, because the edges are joined.
    cells = max(round(side * PIXEL_MM / cell), 1)
    corner = np.indices((cells, cells)).reshape(2, -1)
    at = (corner + rng.uniform(size=corner.shape)) * (side / cells)
    area = rng.gamma(AREA_SHAPE, 1.0 / AREA_SHAPE, cells * cells)
    # Where few flakes are lit they are brighter, so that the mean stays.
    lit = rng.uniform(size=cells * cells) < seen.lit
    light = np.where(lit, 2.5 * rng.uniform(size=cells * cells) ** 1.5 / max(seen.lit, 1e-9), 0.0)
    light = 1.0 + (light - 1.0) / math.sqrt(together)
    sums = [_blurred(at, weights, side, seen.spread_mm) for weights in (area * light, area)]
    return np.asarray(sums[0] / np.maximum(sums[1], 1e-300))

"""Flake texture of Günther et al. 2005, section 5.2, as light over its mean.

The cell of the texture coordinate seeds a generator, which draws the flake's normal from Beckmann's distribution with
the paint's m; the flake is lit as a tiny mirror. One flake to a cell of 1/density, somewhere in it. A footprint wider
than a cell is held at that width, its contrast lowered as that of the mean of so many flakes would be, and fades out.
"""

from __future__ import annotations

import math
from itertools import product

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.reflectance.flakes.footprint import FOOTPRINT_END, flake_footprint
from brdf_suite.reflectance.flakes.glints import flake_tint
from brdf_suite.reflectance.flakes.hashing import GOLDEN, cell_key, halves, scramble
from brdf_suite.reflectance.flakes.tilt import beckmann_slopes, beckmann_tilt

RAREST_TILT = 0.002
FADE_FROM, FADE_TO = 0.75, 2.0
_SALT = np.uint32(0x51ED270B)
_TINT = np.uint32(0x3C6EF372)


def flake_texture_ratio(
    at: Floats,
    across: Floats,
    down: Floats,
    slope: Floats,
    spread: Floats | float,
    *,
    density: float,
    size: float,
    roughness: float,
    colour_spread: float = 0.0,
) -> Floats:
    """Return the ratio (n, 3) at places (n, 2) mm with derivatives (n, 2) mm per pixel, for tilts ``slope`` (n, 2).

    ``spread`` (n,): standard deviation of slope over which one flake still mirrors the light.
    """
    per_mm = math.sqrt(density)
    whole = flake_footprint(at, across, down, size)
    most = 0.5 / (FOOTPRINT_END * per_mm)
    held = min(size, 4.0 * most)
    pixel2 = np.maximum(whole.widest**2 - (0.25 * size) ** 2, 0.0)
    room = most**2 - (0.25 * held) ** 2
    shrink = np.sqrt(np.clip(room / np.maximum(pixel2, 1e-300), 0.0, 1.0))[:, None]
    part = flake_footprint(at, across * shrink, down * shrink, held)
    x = np.clip((whole.widest * per_mm - FADE_FROM) / (FADE_TO - FADE_FROM), 0.0, 1.0)
    contrast = np.minimum(np.sqrt(whole.height / part.height), 1.0) * (1.0 - x * x * (3.0 - 2.0 * x))
    narrow = 1.0 / (8.0 * np.asarray(spread, float) ** 2)
    first = np.floor(at * per_mm - 0.5)
    total = np.zeros((len(at), 3))
    for cell_x, cell_y in product((0, 1), repeat=2):
        cell = first + np.array([cell_x, cell_y])
        key = cell_key(cell[:, 0], cell[:, 1], _SALT)
        beside = at - (cell + np.stack(halves(scramble(key + GOLDEN)), -1)) / per_mm
        cover = part.cover(beside[:, 0], beside[:, 1]) / density
        apart2 = ((beckmann_tilt(*halves(key), roughness) - slope) ** 2).sum(-1)
        bell = np.maximum(1.0 - apart2 * narrow, 0.0) ** 2
        total += (cover * bell)[:, None] * flake_tint(scramble(key + _TINT), colour_spread)
    total *= (3.0 / math.pi * narrow)[..., None] if np.ndim(narrow) else 3.0 / math.pi * narrow
    wide = np.sqrt(roughness**2 + 2.0 * np.asarray(spread, float) ** 2)
    mean = beckmann_slopes((slope**2).sum(-1), wide)
    top = RAREST_TILT * beckmann_slopes(0.0, wide)
    return np.asarray(1.0 + (total - mean[:, None]) / np.maximum(mean, top)[:, None] * contrast[:, None])

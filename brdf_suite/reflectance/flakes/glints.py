"""Brightness of a footprint's visible flakes in one light, over their mean: 1 in the limit of many.

After Kemppinen et al., "Glinty NDFs in Constant Time" (SIGGRAPH Asia 2025). Flakes have a place on the surface, N to
the square millimetre, and one on the unit square of tilts. On level l both are cut into cells, 2^l/√N wide on the
surface and 2^-l on the square; a pair of cells holds one flake, jittered within both by a hash of the pair. The level
is such that a footprint ends within two by two cells. Between levels flakes of one appear one by one while the
other's go. Kernels end within the cells visited, so the mean is 1 exactly. Cells of tilts are never smaller than a
flake's own spread; beyond that level one flake represents the M of its pair of cells, its deviation from the mean
over √M. The flakes of a cell of the surface share their place in it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from brdf_suite.arrays import Floats, Words
from brdf_suite.reflectance.flakes.footprint import FOOTPRINT_END, Footprint, flake_footprint
from brdf_suite.reflectance.flakes.hashing import GOLDEN, cell_key, halves, scramble, wrap_words

APPEARING = 0.2
"""Flakes of a level appear over this range of its weight."""
FLAKE_AREA = 3.0
"""Of the mean: the largest flake's area. Areas are 3 u², u even, so most flakes are small."""


@dataclass(frozen=True)
class GlintField:
    """The flakes seen by footprints (n,): ``level`` (n,), not whole; ``root_count`` √N, 1/mm; ``finest`` level of the
    smallest cells of tilts, whole; ``colour_spread`` 0 to 1.
    """

    footprint: Footprint
    level: Floats
    root_count: float
    finest: float
    colour_spread: float


def glint_field(
    at: Floats,
    across: Floats,
    down: Floats,
    *,
    density: float,
    size: float,
    roughness: float,
    waviness: float,
    colour_spread: float = 0.0,
) -> GlintField:
    """Return what pixels at ``at`` (n, 2) mm with derivatives (n, 2) mm per pixel see.

    ``density`` 1/mm², ``size`` mm, ``roughness`` of the tilts, ``waviness`` of one flake in radians. The disc
    of tilts is π/4 of the square, so N is 4/π of the density.
    """
    footprint = flake_footprint(at, across, down, size)
    root = math.sqrt(4.0 / math.pi * density)
    level = np.maximum(np.log2(4.0 * FOOTPRINT_END * footprint.widest * root), 0.0)
    finest = max(math.floor(math.log2(roughness / (math.sqrt(0.5) * FOOTPRINT_END * waviness))), 0)
    return GlintField(footprint, level, root, float(finest), colour_spread)


def shown_share(weight: Floats) -> Floats:
    """Return the mean share (...) of a level's flakes that is shown at its weight, 0 to 1."""
    low = weight / APPEARING
    high = np.maximum(low + 1.0 - 1.0 / APPEARING, 0.0)
    first = np.where(low < 1.0, low**3 * (1.0 - 0.5 * low), low - 0.5)
    last = high**3 * (1.0 - 0.5 * high)
    return np.asarray((first - last) * (APPEARING / (1.0 - APPEARING)))


def shown_amount(order: Floats, weight: Floats) -> Floats:
    """Return how much of the flake of an ``order`` 0…1 is shown at a level's weight (...)."""
    low = (1.0 - APPEARING) * order
    s = np.clip((weight - low) / APPEARING, 0.0, 1.0)
    return np.asarray(s * s * (3.0 - 2.0 * s))


def flake_tint(word: Words, colour_spread: float) -> Floats:
    """Return a colour (..., 3) of mean 1 over all flakes; the channels a third of a turn apart."""
    turn = 2.0 * math.pi * ((word >> np.uint32(16)).astype(float) + 0.5) / 65536.0
    thirds = np.array([0.0, 1.0, 2.0]) * (2.0 * math.pi / 3.0)
    return np.asarray(1.0 + colour_spread * np.cos(turn[..., None] + thirds))


def glint_ratio(field: GlintField, place: Floats, stretch: Floats, spread: Floats | float) -> Floats:
    """Return the ratio (n, 3) for tilts at ``place`` (n, 2) on the square, ``stretch`` (n,): of ``tilt_place``.

    ``spread`` (n,): standard deviation of tilt over which one flake still mirrors the light, radians.
    """
    level = np.floor(field.level)
    rest = field.level - level
    wanted = stretch * spread
    near = _of_level(field, level, 1.0 - rest, place, wanted)
    return near + _of_level(field, level + 1.0, rest, place, wanted)


def _of_level(field: GlintField, level: Floats, weight: Floats, place: Floats, wanted: Floats) -> Floats:
    angular = np.minimum(level, field.finest)
    per_square = np.exp2(angular)
    per_mm = field.root_count * np.exp2(-level)
    sigma = np.minimum(wanted, 0.5 / (FOOTPRINT_END * per_square))
    contrast = np.exp2(angular - level) * sigma / wanted
    narrow = 1.0 / (8.0 * sigma * sigma)
    at = field.footprint.at
    first_cell = np.floor(at * per_mm[:, None] - 0.5)
    first_tilt = np.floor(place * per_square[:, None] - 0.5)
    salt = wrap_words(level) * GOLDEN
    total = np.zeros((len(level), 3))
    for cell_x, cell_y in product((0, 1), repeat=2):
        cell = first_cell + np.array([cell_x, cell_y])
        key = cell_key(cell[:, 0], cell[:, 1], salt)
        beside = at - (cell + np.stack(halves(scramble(key)), -1)) / per_mm[:, None]
        cover = field.footprint.cover(beside[:, 0], beside[:, 1])
        for tilt_x, tilt_y in product((0, 1), repeat=2):
            tilt = first_tilt + np.array([tilt_x, tilt_y])
            mixed = wrap_words(tilt[:, 0]) * np.uint32(0x3C6EF35F) + wrap_words(tilt[:, 1]) * np.uint32(
                0x19660D
            )
            word = scramble(key + mixed)
            apart = place - (tilt + np.stack(halves(word), -1)) / per_square[:, None]
            bell = np.maximum(1.0 - (apart**2).sum(-1) * narrow, 0.0) ** 2
            other = scramble(word + GOLDEN)
            order = ((other & np.uint32(0xFF)).astype(float) + 0.5) / 256.0
            area = (
                FLAKE_AREA * ((((other >> np.uint32(8)) & np.uint32(0xFF)).astype(float) + 0.5) / 256.0) ** 2
            )
            seen = bell * cover * area * shown_amount(order, weight)
            total += seen[:, None] * flake_tint(other, field.colour_spread)
    scale = 3.0 * narrow / (math.pi * (per_mm * per_square) ** 2)
    mean = shown_share(weight)[:, None]
    return np.asarray(mean + (total * scale[:, None] - mean) * contrast[:, None])

"""The sparkle's shader functions in numpy, with the same names and the same hash: a flake is the same one in both.

:func:`glint_ratio` is that of ``sparkle_glints.glsl``, after Kemppinen et al., "Glinty NDFs in Constant Time"
(SIGGRAPH Asia 2025); :func:`flake_texture_ratio` that of ``flake_texture.glsl``; the hash that of
``sparkle_hash.glsl``. The shaders and the path tracer's flakes are tested against them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.flakes.footprint import (
    FADE_FROM,
    FADE_TO,
    FOOTPRINT_END,
    RAREST_TILT,
    Footprint,
    flake_footprint,
)
from brdf_suite.arrays import Floats, Words

GOLDEN = np.uint32(0x9E3779B9)
APPEARING, FLAKE_AREA = 0.2, 3.0
AREA_MOMENT, COUNT_CELL = 1.8, 2.5
_COUNT_TURN = np.array([[0.8, -0.6], [0.6, 0.8]])
LEAST_COUNTED, COUNTED_FROM, COUNTED_WITHIN = 2.0, 0.3, 0.5
_SALT = np.uint32(0x51ED270B)
_TINT = np.uint32(0x3C6EF372)


def scramble(x: npt.ArrayLike) -> Words:
    """Return words (...) for words (...) of 32 bits: integers only, the same as in ``sparkle_hash.glsl``.

    A bijection of two rounds of multiplication and shift, with constants of Chris Wellons's search ("Hash function
    prospector"); each bit in changes each bit out with a chance near one half.


    >>> hex(int(scramble(np.uint32(1))))
    '0x6d3fa73'
    """
    # At least one axis: numpy wraps whole numbers silently in arrays, but warns for a single one.
    words = np.atleast_1d(np.asarray(x, np.uint32))
    words = (words ^ (words >> np.uint32(16))) * np.uint32(0x21F0AAAD)
    words = (words ^ (words >> np.uint32(15))) * np.uint32(0xD35A2D97)
    return np.asarray(words ^ (words >> np.uint32(15))).reshape(np.shape(x))


def cell_key(x: npt.ArrayLike, y: npt.ArrayLike, salt: npt.ArrayLike) -> Words:
    """Return a word (...) for whole numbers ``x``, ``y`` (...) of either sign, and a salt (...)."""
    return scramble(wrap_words(x) + scramble(wrap_words(y) + np.asarray(salt, np.uint32)))


def wrap_words(whole: npt.ArrayLike) -> Words:
    """Return whole numbers (...) modulo 2³²."""
    return np.asarray(whole).astype(np.int64).astype(np.uint32)


def halves(word: Words) -> tuple[Floats, Floats]:
    """Return two even numbers (...) in (0, 1) of 16 bits each."""
    low = (word & np.uint32(0xFFFF)).astype(float)
    high = (word >> np.uint32(16)).astype(float)
    return (low + 0.5) / 65536.0, (high + 0.5) / 65536.0


def beckmann_slopes(slope2: npt.ArrayLike, roughness: npt.ArrayLike) -> Floats:
    """Return Beckmann's density over slopes, exp(-s²/m²) / (π m²), for s² and m (...)."""
    m2 = np.asarray(roughness, float) ** 2
    return np.asarray(np.exp(-np.asarray(slope2, float) / m2) / (math.pi * m2))


def ggx_density(slope2: npt.ArrayLike, roughness: float) -> Floats:
    """Return GGX per solid angle, (1 + s²)² / (π m² (1 + s²/m²)²), for s² (...)."""
    slope2 = np.asarray(slope2, float)
    m2 = roughness * roughness
    return np.asarray(((1.0 + slope2) / (1.0 + slope2 / m2)) ** 2 / (math.pi * m2))


def beckmann_tilt(r1: npt.ArrayLike, r2: npt.ArrayLike, roughness: float) -> Floats:
    """Return slopes (..., 2) drawn by even numbers (...): tan θ = m √(-ln(1 - r1)), φ = 2π r2.

    The sampling of Beckmann's distribution by Günther et al. 2005, section 5.2.
    """
    tangent = roughness * np.sqrt(-np.log1p(-np.asarray(r1, float)))
    phi = 2.0 * math.pi * np.asarray(r2, float)
    return np.stack([tangent * np.cos(phi), tangent * np.sin(phi)], axis=-1)


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
    finest = max(math.floor(math.log2(roughness / (FOOTPRINT_END * waviness))), 0)
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
    above = field.level - max(field.finest, LEAST_COUNTED) - COUNTED_FROM
    single = (1.0 - np.clip(above / COUNTED_WITHIN, 0.0, 1.0))[:, None]
    counted = _counted_ratio(field, place, stretch * spread, ((1.0 - single) / (1.0 + single))[:, 0])
    return np.asarray(
        single * _single_ratio(field, place, stretch, spread)
        + np.where(single < 1.0, (1.0 - single) * counted, 0.0)
    )


def lit_flakes(even: Floats, lit: Floats) -> Floats:
    """Return what cells (n, ...) send over their mean, of mean 1 and variance 9/5 over ``lit`` (n,) flakes each."""
    lit = lit.reshape(lit.shape + (1,) * (even.ndim - lit.ndim))
    chance = np.minimum(lit * AREA_MOMENT / (AREA_MOMENT + lit), 1.0)
    deviation = np.minimum(1.5 / np.sqrt(lit), 1.0)
    return np.asarray(
        1.0 + deviation * (FLAKE_AREA / chance * np.maximum(1.0 - even / chance, 0.0) ** 2 - 1.0)
    )


def _bilinear(at: Floats) -> Floats:
    x, y = at[:, 0], at[:, 1]
    return np.stack([(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y], -1)


def _counted_ratio(field: GlintField, place: Floats, width: Floats, fewer: Floats) -> Floats:
    level = np.maximum(np.log2(COUNT_CELL * field.footprint.widest * field.root_count), 0.0)
    low = np.floor(level)
    on_square = place * 2.0 ** (field.finest + 1.0) - 0.5
    tilt = np.floor(on_square)
    tilts = _bilinear(on_square - tilt)
    mixed = wrap_words(tilt[:, 0]) * np.uint32(0x3C6EF35F) + wrap_words(tilt[:, 1]) * np.uint32(0x19660D)
    apart = np.array([0, 0x3C6EF35F, 0x19660D, 0x3C6EF35F + 0x19660D], np.uint32)
    keys, weights = [], []
    for above in (0.0, 1.0):
        at = field.footprint.at @ _COUNT_TURN.T * (field.root_count * np.exp2(-low - above))[:, None] - 0.5
        first = np.floor(at)
        weights.append((1.0 - np.abs(level - low - above))[:, None] * _bilinear(at - first))
        salt = wrap_words(low + above) * GOLDEN + _SALT
        keys.append(
            np.stack([cell_key(first[:, 0] + x, first[:, 1] + y, salt) for y in (0, 1) for x in (0, 1)], -1)
        )
    key, weight = np.concatenate(keys, -1), np.concatenate(weights, -1)
    contrast2 = 9.0 / 40.0 / math.pi * 26.0 / 35.0 * 9.0 / 5.0 * field.footprint.height
    contrast2 = contrast2 / (width * field.root_count) ** 2
    lit = fewer * AREA_MOMENT * (weight**2).sum(-1) * (tilts**2).sum(-1) / contrast2
    word = (key + mixed[:, None])[..., None] + apart
    word = (word ^ (word >> np.uint32(16))) * np.uint32(0x21F0AAAD)
    even = ((word >> np.uint32(8)).astype(float) + 0.5) / 16777216.0
    seen = (lit_flakes(even, np.maximum(lit, 1e-300)) * tilts[:, None, :]).sum(-1)
    return np.asarray(((weight * seen)[..., None] * flake_tint(key, field.colour_spread)).sum(1))


def _single_ratio(field: GlintField, place: Floats, stretch: Floats, spread: Floats | float) -> Floats:
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
            across, down = wrap_words(tilt[:, 0]), wrap_words(tilt[:, 1])
            word = scramble(key + across * np.uint32(0x3C6EF35F) + down * np.uint32(0x19660D))
            apart = place - (tilt + np.stack(halves(word), -1)) / per_square[:, None]
            bell = np.maximum(1.0 - (apart**2).sum(-1) * narrow, 0.0) ** 2
            other = scramble(word + GOLDEN)
            order, size = (
                ((other >> np.uint32(bits) & np.uint32(0xFF)).astype(float) + 0.5) / 256.0 for bits in (0, 8)
            )
            seen = bell * cover * (FLAKE_AREA * size**2) * shown_amount(order, weight)
            total += seen[:, None] * flake_tint(other, field.colour_spread)
    scale = 3.0 * narrow / (math.pi * (per_mm * per_square) ** 2)
    mean = shown_share(weight)[:, None]
    return np.asarray(mean + (total * scale[:, None] - mean) * contrast[:, None])


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

    The flake texture of Günther et al. 2005, section 5.2, as light over its mean. The cell of the texture coordinate
    seeds a generator, which draws the flake's normal from Beckmann's distribution with the paint's m; the flake is lit
    as a tiny mirror. One flake to a cell of 1/density, somewhere in it. A footprint wider than a cell is held at that
    width, its contrast lowered as that of the mean of so many flakes would be, and fades out. ``spread`` (n,): standard
    deviation of slope over which one flake still mirrors the light.
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

"""Shared parts of both flake models: the hash that generates flakes, their tint, and their visibility in a sample.

The counterpart of ``flakes.footprint``, and of the hash and ``flake_tint`` of the shaders.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real
from brdf_suite.reference.mitsuba_modules import dr, mi

Word = Any
GOLDEN = 0x9E3779B9


def scramble(x: Word) -> Word:
    """Return a hash of a word of 32 bits, each bit of which hangs on each of ``x``; see ``sparkle_hash.glsl``."""
    x = (x ^ (x >> 16)) * mi.UInt32(0x21F0AAAD)
    x = (x ^ (x >> 15)) * mi.UInt32(0xD35A2D97)
    return x ^ (x >> 15)


def cell_key(x: Real, y: Real, salt: Word) -> Word:
    """Return a word for whole numbers of either sign."""
    return scramble(mi.UInt32(mi.Int32(x)) + scramble(mi.UInt32(mi.Int32(y)) + salt))


def halves(word: Word) -> tuple[Real, Real]:
    """Return two even numbers in (0, 1) of 16 bits each."""
    scale = 1.0 / 65536.0
    return (mi.Float(word & 0xFFFF) + 0.5) * scale, (mi.Float(word >> 16) + 0.5) * scale


def tint(word: Word, colour_spread: float) -> Colour:
    """Return a colour of mean 1 over all flakes."""
    if colour_spread == 0.0:
        return mi.Color3f(1.0)
    turn = (mi.Float(word >> 16) + 0.5) * (2.0 * math.pi / 65536.0)
    spread = d.number(colour_spread)
    return mi.Color3f(*(1.0 + spread * dr.cos(turn + k * 2.0 * math.pi / 3.0) for k in range(3)))


@dataclass(frozen=True, eq=False)
class Spot:
    """Density of a flake's position as seen by one sample; see ``flakes.footprint``."""

    at: Any
    inverse: Any
    height: Real
    edge: Real

    def cover(self, x: Real, y: Real) -> Real:
        """Return the density, 1/mm², for a flake that lies (x, y) mm beside the place."""
        xx, xy, yy = self.inverse
        t = x * (xx * x + 2.0 * xy * y) + yy * y * y
        s = dr.clip((4.0 + self.edge - t) / (2.0 * self.edge), 0.0, 1.0)
        return self.height * s * s * (3.0 - 2.0 * s)


def spot(at: Any, across: Any, down: Any, own: Real, reach: float) -> tuple[Spot, Real]:
    """Return the spot of a pixel's reach (standard deviations, in pixels) with a flake's variance, and its widest."""
    pixel = reach * reach
    xx = pixel * (across.x**2 + down.x**2) + own
    xy = pixel * (across.x * across.y + down.x * down.y)
    yy = pixel * (across.y**2 + down.y**2) + own
    half_sum = 0.5 * (xx + yy)
    half_gap = dr.sqrt((0.5 * (xx - yy)) ** 2 + xy * xy)
    large = half_sum + half_gap
    det = dr.maximum(large * dr.maximum(half_sum - half_gap, own), 1e-20)
    sharpest = dr.sqrt(dr.maximum(large - own, 0.0) / large)
    made = Spot(
        at,
        (yy / det, -xy / det, xx / det),
        dr.rsqrt(det) * (0.25 / math.pi),
        4.0 * dr.clip(1.5 * sharpest, 0.01, 1.0),
    )
    return made, dr.sqrt(large)

"""Sparkling flakes: normals from a texture in surface coordinates, faded with distance (section 5.2).

The counterpart of :func:`brdf_suite.reflectance.flakes.glints.flake_texture_ratio`: the same hash, so the same flakes
as in the real-time picture's flake texture, and the same in every frame. Each light is multiplied by how bright the
flakes of the pixel are in it over their mean, for the share of the broad part that flakes which can be counted send;
its mean over the surface is 1, so flakes neither add light nor take it. The share is that of
``realtime/material/flake_share.py``,

    f = c R T(θi) T(θo) bell(δ) / (8π m² n² cosθi' cosθo'),

at both directions instead of the mirror direction alone (θ' below the coat), at most nine tenths of the broad part.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import Any

from brdf_suite.appearance.visible_flakes import (
    FLAKE_REFLECTANCE,
    FLAKE_WAVINESS,
    LARGEST_SHARE,
    flake_coverage,
)
from brdf_suite.documents.paint import Flakes
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Vector
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.numbers import scramble
from brdf_suite.reflectance.flakes.footprint import FOOTPRINT_END, PIXEL_REACH
from brdf_suite.reflectance.flakes.glints import FADE_FROM, FADE_TO, RAREST_TILT

_SALT, _TINT, _GOLDEN = 0x51ED270B, 0x3C6EF372, 0x9E3779B9


@dataclass(frozen=True)
class SparkleField:
    """Flake parameters in a coat of index ``ior``; ``strength`` is a factor on their light."""

    flakes: Flakes
    ior: float
    strength: float = 1.0

    @property
    def peak(self) -> float:
        """c R / (8π m² n²): how much the flakes that lie flat send."""
        below = 8.0 * math.pi * self.flakes.roughness**2 * self.ior**2
        return self.strength * flake_coverage(self.flakes) * FLAKE_REFLECTANCE / below


@dataclass
class FlakesSeen:
    """The four candidate flakes of a pixel: coverage of each, slopes and tints, and the remaining ``contrast``."""

    covers: tuple[Real, ...]
    slopes: tuple[Any, ...]
    tints: tuple[Colour, ...]
    contrast: Real


def flakes_seen(sparkle: SparkleField, at: Any, across: Any, down: Any) -> FlakesSeen:
    """Return the flakes at places ``at`` (mm, 2-D) whose pixels reach ``across`` and ``down`` (mm, 2-D)."""
    flakes = sparkle.flakes
    root = math.sqrt(flakes.density_per_mm2)
    per_mm, size = d.number(root), d.number(flakes.size_um * 1e-3)
    most = 0.5 / (FOOTPRINT_END * root)
    held = min(flakes.size_um * 1e-3, 4.0 * most)
    whole = _Footprint.of(across, down, size)
    pixel2 = dr.maximum(dr.square(whole.widest) - dr.square(0.25 * size), 0.0)
    room = d.number(most**2 - (0.25 * held) ** 2)
    shrink = dr.sqrt(dr.clip(room / dr.maximum(pixel2, 1e-30), 0.0, 1.0))
    part = _Footprint.of(across * shrink, down * shrink, d.number(held))
    x = dr.clip((whole.widest * per_mm - FADE_FROM) / (FADE_TO - FADE_FROM), 0.0, 1.0)
    contrast = dr.minimum(dr.sqrt(whole.height / part.height), 1.0) * (1.0 - x * x * (3.0 - 2.0 * x))
    on_grid = at * per_mm
    first = dr.floor(on_grid - 0.5)
    area = d.number(1.0 / flakes.density_per_mm2)
    m, spread = d.number(flakes.roughness), d.number(flakes.colour_spread)
    covers, slopes, tints = [], [], []
    for i, j in product((0, 1), repeat=2):
        cell = first + mi.Vector2f(i, j)
        key = _cell_key(cell)
        r1, r2 = _halves(key)
        x_in, y_in = _halves(scramble(key + mi.UInt32(_GOLDEN)))
        beside = (on_grid - cell - mi.Vector2f(x_in, y_in)) / per_mm
        covers.append(part.cover(beside) * area)
        tangent = m * dr.sqrt(-dr.log(1.0 - r1))
        sine, cosine = dr.sincos(2.0 * math.pi * r2)
        slopes.append(mi.Vector2f(tangent * cosine, tangent * sine))
        word = scramble(key + mi.UInt32(_TINT))
        turn = (mi.Float(word >> 16) + 0.5) * (2.0 * math.pi / 65536.0)
        tints.append(mi.Color3f(*(1.0 + spread * dr.cos(turn + k * (2.0 * math.pi / 3.0)) for k in range(3))))
    return FlakesSeen(tuple(covers), tuple(slopes), tuple(tints), contrast)


def sparkling(
    sparkle: SparkleField, seen: FlakesSeen, light: Vector, view: Vector, light_spread: Real, base: Colour
) -> Colour:
    """Return the broad value ``base`` (1/sr) of a light as the flakes of a pixel send it.

    ``light_spread`` is the light's, radians along one axis.
    """
    ior = sparkle.ior
    n2 = d.number(ior * ior)
    up_i = dr.sqrt(n2 - (dr.square(light.x) + dr.square(light.y)))
    up_o = dr.sqrt(n2 - (dr.square(view.x) + dr.square(view.y)))
    slope = mi.Vector2f(light.x + view.x, light.y + view.y) / dr.maximum(up_i + up_o, 1e-6)
    slope2 = dr.squared_norm(slope)
    ratio = _ratio(sparkle, seen, slope, slope2, light_spread)
    through = (1.0 - d.fresnel(light.z, ior)) * (1.0 - d.fresnel(view.z, ior))
    q = (1.0 + slope2 * d.number(1.0 / sparkle.flakes.roughness**2)) / (1.0 + slope2)
    # n cosθ' of both directions is `up`.
    wanted = d.number(sparkle.peak) * n2 * through / (up_i * up_o * q * dr.sqrt(q))
    share = dr.minimum(wanted / dr.maximum(dr.max(base), 1e-12), LARGEST_SHARE)
    return base * (1.0 + share * (ratio - 1.0))


def _ratio(sparkle: SparkleField, seen: FlakesSeen, slope: Any, slope2: Real, light_spread: Real) -> Colour:
    """Return the brightness of the flakes over their mean; see ``reflectance/flakes/texture.py``."""
    m2 = sparkle.flakes.roughness**2
    # A light's spread moves the tilt by half of it, less what refraction takes.
    spread2 = dr.square(light_spread * d.number(0.5 / sparkle.ior)) + d.number(FLAKE_WAVINESS**2)
    narrow = 1.0 / (8.0 * spread2)
    total = mi.Color3f(0.0)
    for cover, tilt, tint in zip(seen.covers, seen.slopes, seen.tints, strict=True):
        bell = dr.square(dr.maximum(1.0 - dr.squared_norm(tilt - slope) * narrow, 0.0))
        total += cover * bell * tint
    total *= (3.0 / math.pi) * narrow
    wide2 = d.number(m2) + 2.0 * spread2
    top = 1.0 / (math.pi * wide2)
    mean = dr.exp(-slope2 / wide2) * top
    return 1.0 + (total - mean) / dr.maximum(mean, RAREST_TILT * top) * seen.contrast


@dataclass
class _Footprint:
    """See ``reflectance/flakes/footprint.py``; for one place."""

    xx: Real
    xy: Real
    yy: Real
    height: Real
    edge: Real
    widest: Real

    @classmethod
    def of(cls, across: Any, down: Any, size: Real) -> _Footprint:
        own = dr.square(0.25 * size)
        pixel = PIXEL_REACH**2
        xx = pixel * (dr.square(across.x) + dr.square(down.x)) + own
        xy = pixel * (across.x * across.y + down.x * down.y)
        yy = pixel * (dr.square(across.y) + dr.square(down.y)) + own
        middle = 0.5 * (xx + yy)
        gap = dr.sqrt(dr.square(0.5 * (xx - yy)) + dr.square(xy))
        large = middle + gap
        det = dr.maximum(large * dr.maximum(middle - gap, own), 1e-20)
        sharpest = dr.sqrt(dr.maximum(large - own, 0.0) / large)
        return cls(
            yy / det,
            -xy / det,
            xx / det,
            dr.rsqrt(det) * (0.25 / math.pi),
            4.0 * dr.clip(1.5 * sharpest, 0.01, 1.0),
            dr.sqrt(large),
        )

    def cover(self, apart: Any) -> Real:
        t = apart.x * (self.xx * apart.x + 2.0 * self.xy * apart.y) + self.yy * dr.square(apart.y)
        s = dr.clip((4.0 + self.edge - t) / (2.0 * self.edge), 0.0, 1.0)
        return self.height * s * s * (3.0 - 2.0 * s)


def _cell_key(cell: Any) -> Any:
    x, y = (mi.UInt32(mi.Int32(c)) for c in (cell.x, cell.y))
    return scramble(x + scramble(y + mi.UInt32(_SALT)))


def _halves(word: Any) -> tuple[Real, Real]:
    low, high = mi.Float(word & mi.UInt32(0xFFFF)), mi.Float(word >> 16)
    return (low + 0.5) / 65536.0, (high + 0.5) / 65536.0

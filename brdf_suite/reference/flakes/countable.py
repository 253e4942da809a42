"""Single visible flakes of a place, as :mod:`brdf_suite.reflectance.flakes.glints`.

The same flakes, by the same hash, as the real-time picture has: a path that leaves the camera through a pixel meets
the ones that this pixel covers. The real-time picture sees a pixel as one soft spot; here each sample sees a smaller
one, at its own place in the pixel, and together they make up the same. Their light over their mean is 1 on the average
of the surface, whatever the light, so they move light about and add none.
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
from brdf_suite.reference.flakes.cells import GOLDEN, Spot, cell_key, halves, scramble, spot, tint
from brdf_suite.reference.flakes.texture import flakes_seen, seen_ratio
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.scene.place import Place, footprint_of_sample
from brdf_suite.reflectance.flakes.footprint import FOOTPRINT_END, PIXEL_REACH
from brdf_suite.reflectance.flakes.glints import APPEARING, FLAKE_AREA

_ALONG_S, _ALONG_T = 0x3C6EF35F, 0x19660D


@dataclass(frozen=True)
class FlakeLayer:
    """The flakes of a paint below a coat of index ``ior``; ``strength`` is a factor on their light.

    ``as_texture``: by the flake texture of 2005, else as converging glints.
    """

    flakes: Flakes
    ior: float
    strength: float = 1.0
    waviness: float = FLAKE_WAVINESS
    as_texture: bool = False

    def visible_part(self, base: Colour, light: Vector, view: Vector) -> Colour:
        """Return the part of the base's f_r, 1/sr, that visible flakes reflect.

        It is c R T(light) T(view) bell / (8π m² n² cosθ'l cosθ'v): flakes of coverage c and reflectance R whose tilts
        have the density bell / (2π m²) per solid angle, below a coat of index n, θ' below it; never most of the base.
        """
        slope = d.slope_between(light, view, self.ior)
        m2 = self.flakes.roughness**2
        most = self.strength * flake_coverage(self.flakes) * FLAKE_REFLECTANCE / (8.0 * math.pi * m2)
        wanted = d.number(most / self.ior**2) * tilt_bell(dr.squared_norm(slope), self.flakes.roughness)
        for w in (light, view):
            below = dr.sqrt(1.0 - (w.x * w.x + w.y * w.y) * d.number(1.0 / self.ior**2))
            wanted *= (1.0 - d.fresnel(w.z, self.ior)) / dr.maximum(below, 1e-6)
        return base * dr.minimum(wanted / dr.maximum(dr.max(base), 1e-12), LARGEST_SHARE)

    def ratio(self, place: Place, light: Vector, view: Vector, to_flakes: Any) -> Colour:
        """Return the light of the place's flakes over their mean; ``to_flakes`` turns directions to theirs."""
        slope = d.slope_between(to_flakes(light), to_flakes(view), self.ior)
        if self.as_texture:
            reach = footprint_of_sample(PIXEL_REACH)
            seen = flakes_seen(self.flakes, place.uv, place.across, place.down, reach)
            found = seen_ratio(self.flakes, seen, slope, d.number(self.waviness**2))
        else:
            found = FlakeField.of(place, self).ratio(slope)
        return dr.select(place.seen, found, mi.Color3f(1.0))


def tilt_bell(slope2: Real, roughness: float) -> Real:
    """Return the density of tilts over that along the normal."""
    q = (1.0 + slope2 * d.number(1.0 / roughness**2)) / (1.0 + slope2)
    return dr.rsqrt(q) / q


@dataclass(frozen=True, eq=False)
class FlakeField:
    """The flakes in the footprint of a place; see ``sparkle_glints.glsl``."""

    spot: Spot
    level: Real
    layer: FlakeLayer

    @classmethod
    def of(cls, place: Place, layer: FlakeLayer) -> FlakeField:
        """Return the flakes of a layer at a place."""
        own = d.number((0.25e-3 * layer.flakes.size_um) ** 2)
        # The level is that of the whole pixel, so that the flakes are those of the real-time picture.
        _, widest = spot(place.uv, place.across, place.down, own, PIXEL_REACH)
        seen, _ = spot(place.uv, place.across, place.down, own, footprint_of_sample(PIXEL_REACH))
        cells = d.number(4.0 * FOOTPRINT_END * _root(layer))
        return cls(seen, dr.maximum(dr.log2(cells * widest), 0.0), layer)

    def ratio(self, slope: Any) -> Colour:
        """Return the ratio for the tilt that mirrors the light."""
        place, stretch = _on_square(slope, self.layer.flakes.roughness)
        wanted = stretch * d.number(self.layer.waviness)
        low = dr.floor(self.level)
        rest = self.level - low

        # A loop that is not written out: eight times over, it would take the compiler seconds.
        def step(pair: Any, total: Any) -> tuple[Any, Any]:
            above = mi.Float(pair >> 2)
            weight = dr.select(above == 0.0, 1.0 - rest, rest)
            cell = mi.Float(pair & 1), mi.Float((pair >> 1) & 1)
            return pair + 1, total + self._of_cell(low + above, weight, cell, place, wanted)

        start = mi.Color3f(0.0)
        for above, weight in ((0.0, 1.0 - rest), (1.0, rest)):
            level = self._level(low + above, wanted)
            start += _shown_share(weight) * (1.0 - level.contrast)
        _, total = dr.while_loop((mi.UInt32(0), start), lambda pair, _total: pair < 8, step)
        return total

    def _level(self, level: Real, wanted: Real) -> _Level:
        """Return a level's cells per millimetre and on the square, a bell's width there, and the remaining contrast."""
        roughness, waviness = self.layer.flakes.roughness, self.layer.waviness
        finest = max(math.floor(math.log2(roughness / (math.sqrt(0.5) * FOOTPRINT_END * waviness))), 0)
        angular = dr.minimum(level, d.number(finest))
        per_square = dr.exp2(angular)
        sigma = dr.minimum(wanted, 0.5 / FOOTPRINT_END / per_square)
        return _Level(
            d.number(_root(self.layer)) * dr.exp2(-level),
            per_square,
            1.0 / (8.0 * sigma * sigma),
            dr.exp2(angular - level) * sigma / wanted,
        )

    def _of_cell(
        self, number: Real, weight: Real, corner: tuple[Real, Real], place: Any, wanted: Real
    ) -> Colour:
        """Return the contribution of one surface cell's flakes to the ratio."""
        level = self._level(number, wanted)
        at, per_mm, per_square = self.spot.at, level.per_mm, level.per_square
        x, y = (dr.floor(along * per_mm - 0.5) + c for along, c in zip((at.x, at.y), corner, strict=True))
        s0, t0 = (dr.floor(along * per_square - 0.5) for along in (place.x, place.y))
        key = cell_key(x, y, mi.UInt32(mi.Int32(number)) * mi.UInt32(GOLDEN))
        jitter_x, jitter_y = halves(scramble(key))
        cover = self.spot.cover(at.x - (x + jitter_x) / per_mm, at.y - (y + jitter_y) / per_mm)
        total = mi.Color3f(0.0)
        for right, above in product((0.0, 1.0), repeat=2):
            s, t = s0 + right, t0 + above
            along_s = mi.UInt32(mi.Int32(s)) * mi.UInt32(_ALONG_S)
            word = scramble(key + along_s + mi.UInt32(mi.Int32(t)) * mi.UInt32(_ALONG_T))
            jitter_s, jitter_t = halves(word)
            beside_s, beside_t = place.x - (s + jitter_s) / per_square, place.y - (t + jitter_t) / per_square
            apart = beside_s * beside_s + beside_t * beside_t
            bell = dr.square(dr.maximum(1.0 - apart * level.narrow, 0.0))
            other = scramble(word + mi.UInt32(GOLDEN))
            order = (mi.Float(other & 0xFF) + 0.5) * (1.0 / 256.0)
            area = FLAKE_AREA * dr.square((mi.Float((other >> 8) & 0xFF) + 0.5) * (1.0 / 256.0))
            total += (bell * area * _shown(order, weight)) * tint(other, self.layer.flakes.colour_spread)
        scale = 3.0 / math.pi * level.narrow / dr.square(per_mm * per_square)
        return total * (scale * cover * level.contrast)


@dataclass(frozen=True, eq=False)
class _Level:
    per_mm: Real
    per_square: Real
    narrow: Real
    contrast: Real


def _root(layer: FlakeLayer) -> float:
    # The disc of tilts is π/4 of the square.
    return math.sqrt(4.0 / math.pi * layer.flakes.density_per_mm2)


def _on_square(slope: Any, roughness: float) -> tuple[Any, Real]:
    """Return the place of a tilt on the unit square, and the stretch of angles; see ``flakes.tilt.tilt_place``."""
    wide = slope * d.number(1.0 / roughness)
    up = dr.rsqrt(1.0 + dr.squared_norm(wide))
    place = 0.5 + wide * (0.5 * up * dr.rsqrt(1.0 + up))
    stretch = dr.sqrt(tilt_bell(dr.squared_norm(slope), roughness) * 0.125) * d.number(1.0 / roughness)
    return place, stretch


def _shown_share(weight: Real) -> Real:
    low = weight / APPEARING
    high = dr.maximum(low + (1.0 - 1.0 / APPEARING), 0.0)
    first = dr.select(low < 1.0, low**3 * (1.0 - 0.5 * low), low - 0.5)
    return (first - high**3 * (1.0 - 0.5 * high)) * (APPEARING / (1.0 - APPEARING))


def _shown(order: Real, weight: Real) -> Real:
    s = dr.clip((weight - (1.0 - APPEARING) * order) / APPEARING, 0.0, 1.0)
    return s * s * (3.0 - 2.0 * s)

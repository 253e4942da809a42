"""Flake texture in the renderer, as ``flakes.texture`` (Günther et al. 2005, section 5.2)."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

from brdf_suite.documents.paint import Flakes
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real
from brdf_suite.reference.flakes.cells import GOLDEN, cell_key, halves, scramble, spot, tint
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.scene.place import Place
from brdf_suite.reflectance.flakes.footprint import FOOTPRINT_END, PIXEL_REACH
from brdf_suite.reflectance.flakes.glints import FADE_FROM, FADE_TO, RAREST_TILT

_SALT, _TINT = 0x51ED270B, 0x3C6EF372


def texture_ratio(place: Place, slope: Any, spread: float, flakes: Flakes, reach: float) -> Colour:
    """Return the light of a place's flakes over their mean, for the tilt ``slope`` that mirrors the light.

    ``spread``: standard deviation of slope over which one flake still mirrors it; ``reach`` of a sample, in pixels.
    """
    per_mm, size = math.sqrt(flakes.density_per_mm2), 1e-3 * flakes.size_um
    whole, widest = spot(place.uv, place.across, place.down, d.number((0.25 * size) ** 2), PIXEL_REACH)
    most = 0.5 / (FOOTPRINT_END * per_mm)
    held = min(size, 4.0 * most)
    # Held at half a cell's reach by shrinking the pixel's share; a sample's share of it shrinks alike.
    pixel2 = dr.maximum(widest * widest - d.number((0.25 * size) ** 2), 0.0)
    room = d.number(max(most**2 - (0.25 * held) ** 2, 0.0))
    shrink = dr.sqrt(dr.clip(room / dr.maximum(pixel2, 1e-30), 0.0, 1.0))
    across, down = place.across * shrink, place.down * shrink
    own = d.number((0.25 * held) ** 2)
    kept, _ = spot(place.uv, across, down, own, PIXEL_REACH)
    seen, _ = spot(place.uv, across, down, own, reach)
    x = dr.clip((widest * d.number(per_mm) - FADE_FROM) / (FADE_TO - FADE_FROM), 0.0, 1.0)
    contrast = dr.minimum(dr.sqrt(whole.height / kept.height), 1.0) * (1.0 - x * x * (3.0 - 2.0 * x))
    narrow = 1.0 / (8.0 * spread * spread)
    first_x, first_y = (dr.floor(along * d.number(per_mm) - 0.5) for along in (place.uv.x, place.uv.y))
    total = mi.Color3f(0.0)
    for right, above in product((0.0, 1.0), repeat=2):
        cell_x, cell_y = first_x + right, first_y + above
        key = cell_key(cell_x, cell_y, mi.UInt32(_SALT))
        jitter_x, jitter_y = halves(scramble(key + mi.UInt32(GOLDEN)))
        step = d.number(1.0 / per_mm)
        cover = seen.cover(place.uv.x - (cell_x + jitter_x) * step, place.uv.y - (cell_y + jitter_y) * step)
        r1, r2 = halves(key)
        tangent = d.number(flakes.roughness) * dr.sqrt(-dr.log(1.0 - r1))
        sine, cosine = dr.sincos(2.0 * math.pi * r2)
        apart = (tangent * cosine - slope.x) ** 2 + (tangent * sine - slope.y) ** 2
        bell = dr.square(dr.maximum(1.0 - apart * narrow, 0.0))
        total += (cover * bell) * tint(scramble(key + mi.UInt32(_TINT)), flakes.colour_spread)
    total *= d.number(3.0 / math.pi * narrow / flakes.density_per_mm2)
    wide2 = flakes.roughness**2 + 2.0 * spread**2
    top = 1.0 / (math.pi * wide2)
    mean: Real = dr.exp(-dr.squared_norm(slope) * d.number(1.0 / wide2)) * d.number(top)
    return 1.0 + (total - mean) / dr.maximum(mean, d.number(RAREST_TILT * top)) * contrast

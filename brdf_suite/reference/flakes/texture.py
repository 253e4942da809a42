"""Flake texture in the renderer, as ``flake_texture.glsl`` (Günther et al. 2005, section 5.2)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import Any

from brdf_suite.appearance.flakes.footprint import FADE_FROM, FADE_TO, FOOTPRINT_END, PIXEL_REACH, RAREST_TILT
from brdf_suite.appearance.flakes.visible import visible_density
from brdf_suite.documents.paint import Flakes
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real
from brdf_suite.reference.flakes.cells import GOLDEN, cell_key, halves, scramble, spot, tint
from brdf_suite.reference.mitsuba_modules import dr, mi

_SALT, _TINT = 0x51ED270B, 0x3C6EF372


@dataclass
class FlakesSeen:
    """The four candidate flakes of a footprint: coverage of each, slopes and tints, and the remaining ``contrast``."""

    covers: tuple[Real, ...]
    slopes: tuple[Any, ...]
    tints: tuple[Colour, ...]
    contrast: Real


def flakes_seen(flakes: Flakes, at: Any, across: Any, down: Any, reach: float = PIXEL_REACH) -> FlakesSeen:
    """Return the flakes at places ``at`` (mm, 2-D) whose pixels reach ``across`` and ``down`` (mm, 2-D).

    ``reach`` of a sample, in pixels.
    """
    root, size = math.sqrt(visible_density(flakes)), 1e-3 * flakes.size_um
    per_mm = d.number(root)
    whole, widest = spot(at, across, down, d.number((0.25 * size) ** 2), PIXEL_REACH)
    most = 0.5 / (FOOTPRINT_END * root)
    held = min(size, 4.0 * most)
    # Held at half a cell's reach by shrinking the pixel's share; a sample's share of it shrinks alike.
    pixel2 = dr.maximum(widest * widest - d.number((0.25 * size) ** 2), 0.0)
    room = d.number(max(most**2 - (0.25 * held) ** 2, 0.0))
    shrink = dr.sqrt(dr.clip(room / dr.maximum(pixel2, 1e-30), 0.0, 1.0))
    across, down = across * shrink, down * shrink
    own = d.number((0.25 * held) ** 2)
    kept, _ = spot(at, across, down, own, PIXEL_REACH)
    seen = kept if reach == PIXEL_REACH else spot(at, across, down, own, reach)[0]
    x = dr.clip((widest * per_mm - FADE_FROM) / (FADE_TO - FADE_FROM), 0.0, 1.0)
    contrast = dr.minimum(dr.sqrt(whole.height / kept.height), 1.0) * (1.0 - x * x * (3.0 - 2.0 * x))
    first_x, first_y = (dr.floor(along * per_mm - 0.5) for along in (at.x, at.y))
    area, step = d.number(1.0 / visible_density(flakes)), d.number(1.0 / root)
    covers, slopes, tints = [], [], []
    for right, above in product((0.0, 1.0), repeat=2):
        cell_x, cell_y = first_x + right, first_y + above
        key = cell_key(cell_x, cell_y, mi.UInt32(_SALT))
        jitter_x, jitter_y = halves(scramble(key + mi.UInt32(GOLDEN)))
        covers.append(seen.cover(at.x - (cell_x + jitter_x) * step, at.y - (cell_y + jitter_y) * step) * area)
        r1, r2 = halves(key)
        tangent = d.number(flakes.roughness) * dr.sqrt(-dr.log(1.0 - r1))
        sine, cosine = dr.sincos(2.0 * math.pi * r2)
        slopes.append(mi.Vector2f(tangent * cosine, tangent * sine))
        tints.append(tint(scramble(key + mi.UInt32(_TINT)), flakes.colour_spread))
    return FlakesSeen(tuple(covers), tuple(slopes), tuple(tints), contrast)


def seen_ratio(flakes: Flakes, seen: FlakesSeen, slope: Any, spread2: Real) -> Colour:
    """Return the light of flakes over their mean, for the tilt ``slope`` that mirrors the light.

    ``spread2``: variance of slope over which one flake still mirrors it.
    """
    narrow = 1.0 / (8.0 * spread2)
    total = mi.Color3f(0.0)
    for cover, tilt, colour in zip(seen.covers, seen.slopes, seen.tints, strict=True):
        bell = dr.square(dr.maximum(1.0 - dr.squared_norm(tilt - slope) * narrow, 0.0))
        total += cover * bell * colour
    total *= (3.0 / math.pi) * narrow
    wide2 = d.number(flakes.roughness**2) + 2.0 * spread2
    top = 1.0 / (math.pi * wide2)
    mean: Real = dr.exp(-dr.squared_norm(slope) / wide2) * top
    return 1.0 + (total - mean) / dr.maximum(mean, RAREST_TILT * top) * seen.contrast

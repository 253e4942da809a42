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

import numpy as np

from brdf_suite.appearance.flakes.footprint import flake_footprint

APPEARING = 0.2
"""Flakes of a level appear over this range of its weight."""
FLAKE_AREA = 3.0
"""Of the mean: the largest flake's area. Areas are 3 u², u even, so most flakes are small."""


@dataclass(frozen=True)
class Spots:
    """Spots per mm² above a contrast, their mean contrast (0 without any), and how many lie in one footprint."""

    per_mm2: float
    mean_contrast: float
    per_footprint: float


def spots(
    *,
    density: float,
    size: float,
    stretch: float,
    spread: float,
    share: float,
    footprint: float,
    contrast: float,
) -> Spots:
    """Return the spots of flakes of ``density`` 1/mm² and ``size`` mm, without rendering.

    A footprint (what an eye or a pixel takes in at once) that lies on one flake i sees over the mean of all flakes

        r_i = a_i b_i k(0) · 3 / (8π σ² N),

    a_i = 3u² the flake's area over the mean (u even on 0 to 1), b = (1 - d² / 8σ²)² for a flake whose place on the
    square of tilts is d from the one that mirrors the light to the eye, k(0) the footprint's height, σ the spread of a
    flake on that square, N the flakes per mm² and unit of it. With the share s of all light that visible flakes
    reflect, the spot's contrast to the surface around it is c = s r. Let c = C (1 - v)² u² with v = d² / 8σ², which is
    even on 0 to 1 over an area of 8πσ² of the square. Then of the N · 8πσ² flakes per mm² that mirror any light to the
    eye the share that passes a contrast c₀ is, with t = √(c₀ / C) < 1,

        ∫∫ [u (1 - v) > t] du dv = 1 - t + t ln t,

    and the mean of c over those is C · (1/9 - t³ (1/9 - ln t / 3)) / (1 - t + t ln t).

    Parameters
    ----------
    stretch
        Of a small angle of tilt on the square of tilts, 1/rad, at the tilt that is seen (``tilt_place``).
    spread
        Standard deviation of tilt over which one flake still mirrors the light, radians.
    share
        Of the light that the surface sends to the eye, what visible flakes reflect, 0 to 1.
    footprint
        Width of what the eye takes in at once, mm.
    contrast
        How much brighter than the surface around it a spot is at least, over that surface: 1 is twice as bright.
    """
    if density <= 0.0 or share <= 0.0:
        return Spots(0.0, 0.0, 0.0)
    per_square = 4.0 / math.pi * density
    sigma2 = (stretch * spread) ** 2
    seen = flake_footprint(np.zeros((1, 2)), np.array([[footprint, 0.0]]), np.array([[0.0, footprint]]), size)
    height = float(seen.height[0])
    highest = share * FLAKE_AREA * height * 3.0 / (8.0 * math.pi * sigma2 * per_square)
    if highest <= contrast:
        return Spots(0.0, 0.0, 0.0)
    t = math.sqrt(contrast / highest)
    passing = 1.0 - t + t * math.log(t)
    count = per_square * 8.0 * math.pi * sigma2 * passing
    mean = highest * (1.0 / 9.0 - t**3 * (1.0 / 9.0 - math.log(t) / 3.0)) / passing
    return Spots(count, mean, count / height if height > 0.0 else 0.0)


RAREST_TILT = 0.002
FADE_FROM, FADE_TO = 0.75, 2.0

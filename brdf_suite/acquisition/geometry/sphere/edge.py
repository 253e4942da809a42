"""Subpixel detection of a lit sphere's outline.

Around the outline as it is known so far, pixels are gathered by sectors; each pixel has its distance s to the
outline, positive inside. A sector's pixels lie at all phases of the grid, so no picture need be resampled. Its
radiance is described as

    dark + a H₀(s - δ) + b H½(s - δ) + c H₁(s - δ),      Hₚ(s) = E[max(s + σ Z, 0)^p],

a step, a root and a ramp behind a blur σ of pixel and lens. The root is what distinguishes a sphere: towards its
outline the cosine of the view falls as √s, and with it every reflection. δ is found by search, the factors by
least squares at each δ. Only sectors count where the light reaches the outline itself: elsewhere the sphere ends
in its own shadow, which lies inside of the outline.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import numpy.typing as npt
from scipy.special import ndtr

from brdf_suite.acquisition.geometry.lens import lens_rays
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, azimuths_about, unit
from brdf_suite.arrays import Bools, Floats, Singles

_OUTSIDE = 5.0
_INSIDE = 0.06  # of the radius
_LEAST_INSIDE, _MOST_INSIDE = 5.0, 14.0
_ARC = 5.0
_BLURS = (0.3, 0.42, 0.6, 0.85, 1.2, 1.7)
LEAST_LIT = 0.12
_REACH = 2.5
_MOST_SIGMA = 0.3
_BLUR_SECTORS = 12
_LEAST_PIXELS = 40


class PhotographUnion:
    """Sum of merged photographs over light positions, in which more of the outline is lit; add 6 to 40.

    Radiances are added, not their logarithms: a pixel that the outline cuts keeps the share of the sphere in it.

    Attributes
    ----------
    picture
        Mean of the three channels, summed over the positions (h, w), float32.
    unknown
        Pixels that were clipped, or left out, at some position (h, w).
    positions
        Indices of the positions in the sum.
    """

    def __init__(self, shape: tuple[int, int]) -> None:
        self.picture: Singles = np.zeros(shape, np.float32)
        self.unknown: Bools = np.zeros(shape, bool)
        self.positions: tuple[int, ...] = ()

    def add(self, k: int, radiance: npt.NDArray[np.floating], valid: Bools | None = None) -> None:
        """Add the radiance (h, w, 3) or (h, w) of position ``k``; where it is not ``valid`` (h, w), it is unknown."""
        value = radiance if radiance.ndim == 2 else radiance.mean(axis=-1)
        known = np.isfinite(value) if valid is None else np.isfinite(value) & valid
        self.picture += np.where(np.isfinite(value), value, 0.0).astype(np.float32)
        self.unknown |= ~known
        self.positions = (*self.positions, k)


@dataclass(frozen=True)
class Edge:
    """Points of a detected outline.

    Attributes
    ----------
    pixels
        (n, 2) x and y.
    sigma_px
        (n,) standard error across the outline.
    blur_px
        The σ with which all sectors fit best.
    """

    pixels: Floats
    sigma_px: Floats
    blur_px: float


def circle(count: int) -> Floats:
    """Return the middles (count,) of even parts of a circle, radians."""
    half = math.pi / count
    return np.linspace(half, 2.0 * math.pi - half, count)


def lit_share(geometry: RigGeometry, union: PhotographUnion, azimuths: Floats) -> Floats:
    """Return the largest cosine (n,) of the light at the outline's azimuths (n,) over the union's positions."""
    rays = lens_rays(geometry.lens, geometry.outline(azimuths))
    distance = math.sqrt(float(geometry.centre @ geometry.centre) - geometry.radius_m**2)
    normals = unit(distance * rays - geometry.centre)
    points = geometry.centre + geometry.radius_m * normals
    lights = geometry.light(np.array(geometry.angles_deg)[list(union.positions)])
    cosines = np.einsum("nki,ni->nk", unit(lights[None] - points[:, None]), normals)
    return np.asarray(cosines.max(axis=1))


def find_edge(union: PhotographUnion, geometry: RigGeometry, mask: Bools | None = None) -> Edge:
    """Return points of the outline near that of ``geometry``, one for each sector in which it can be seen."""
    radius = math.tan(geometry.outline_angle) * geometry.lens.fx
    count = int(np.clip(2.0 * math.pi * radius / _ARC, 48, 240))
    azimuths = circle(count)
    sectors = _sectors(union, geometry, mask, count)
    lit = lit_share(geometry, union, azimuths) > LEAST_LIT
    chosen = [(int(k), *sectors[k]) for k in np.flatnonzero(lit) if len(sectors[k][0]) >= _LEAST_PIXELS]
    # The blur with which some sectors fit best, in the median.
    some = chosen[:: max(1, len(chosen) // _BLUR_SECTORS)]
    misfits = [np.median([_offset(s, value, blur)[2] for _, s, value in some] or [0.0]) for blur in _BLURS]
    blur = _BLURS[int(np.argmin(misfits))]
    found = [(azimuths[k], *_offset(s, value, blur)[:2]) for k, s, value in chosen]
    kept = [row for row in found if abs(row[1]) < _REACH and row[2] < _MOST_SIGMA]
    at, offset, sigma = np.array(kept).reshape(-1, 3).T
    pixels = geometry.outline(at) + offset[:, None] * _inward(geometry, at)
    return Edge(pixels, sigma, blur)


def _inward(geometry: RigGeometry, azimuths: Floats) -> Floats:
    """Return directions (n, 2) in the picture across the outline, inward, length 1."""
    step = 1e-3
    along = geometry.outline(azimuths + step) - geometry.outline(azimuths - step)
    across = np.stack((-along[:, 1], along[:, 0]), axis=-1)
    return unit(across)


def _sectors(
    union: PhotographUnion, geometry: RigGeometry, mask: Bools | None, count: int
) -> list[tuple[Floats, Floats]]:
    """Return (distance to the outline inward, radiance) of the pixels of each sector."""
    picture = union.picture
    outline = geometry.outline(np.linspace(0.0, 2.0 * math.pi, 1440, endpoint=False))
    radii = np.linalg.norm(outline - outline.mean(axis=0), axis=-1)
    low = np.maximum(np.floor(outline.min(axis=0) - _OUTSIDE - 2.0), 0).astype(int)
    high = np.ceil(outline.max(axis=0) + _OUTSIDE + 3.0).astype(int)
    inside = float(np.clip(_INSIDE * radii.mean(), _LEAST_INSIDE, _MOST_INSIDE))
    rows = np.arange(low[1], min(int(high[1]), picture.shape[0]))
    columns = np.arange(low[0], min(int(high[0]), picture.shape[1]))
    if not len(rows) or not len(columns):
        return [(np.empty(0), np.empty(0))] * count
    pixels = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 2)
    away = np.linalg.norm(pixels - outline.mean(axis=0), axis=-1)
    pixels = pixels[(away > radii.min() - inside - 2.0) & (away < radii.max() + _OUTSIDE + 2.0)]
    rays = lens_rays(geometry.lens, pixels)
    azimuth = azimuths_about(unit(geometry.centre), rays) % (2.0 * math.pi)
    edge = geometry.outline(azimuth)
    distance = np.einsum("ni,ni->n", pixels - edge, _inward(geometry, azimuth))
    known = ~union.unknown[pixels[:, 1], pixels[:, 0]]
    if mask is not None:
        known &= mask[pixels[:, 1], pixels[:, 0]]
    known &= (distance > -_OUTSIDE) & (distance < inside)
    sector = np.minimum((azimuth / (2.0 * math.pi) * count).astype(int), count - 1)
    order = np.argsort(sector[known], kind="stable")
    cuts = np.searchsorted(sector[known][order], np.arange(1, count))
    value = picture[pixels[:, 1], pixels[:, 0]].astype(float)[known][order]
    return list(zip(np.split(distance[known][order], cuts), np.split(value, cuts), strict=True))


def _offset(s: Floats, value: Floats, blur: float) -> tuple[float, float, float]:
    """Return (δ, its standard error, relative misfit) of one sector's pixels; an error of inf: no edge there."""
    scale = float(np.abs(value).max(initial=0.0))
    if not scale > 0.0:
        return 0.0, math.inf, math.inf
    value = value / scale

    def misfits(*deltas: float) -> tuple[list[float], Floats]:
        """Return the misfit at each place, and the factors (4,) at the last."""
        columns = _columns((s - np.array(deltas)[:, None]) / blur, blur)
        gram = columns @ columns.transpose(0, 2, 1) + 1e-10 * len(s) * np.eye(columns.shape[1])
        factors = np.linalg.solve(gram, columns @ value[:, None])
        rest = value - (factors.transpose(0, 2, 1) @ columns)[:, 0]
        sums: list[float] = np.einsum("ni,ni->n", rest, rest).tolist()
        return sums, np.asarray(factors[-1, :, 0], float)

    tried = np.arange(-_REACH, _REACH + 0.01, 0.5)
    sums = misfits(*tried)[0]
    centre, step = float(tried[int(np.argmin(sums))]), 0.25
    here = min(sums)
    for _ in range(9):
        left, right = misfits(centre - step, centre + step)[0]
        if left < here and left <= right:
            centre, here = centre - step, left
        elif right < here:
            centre, here = centre + step, right
        else:
            bend = left + right - 2.0 * here
            if bend > 0.0 and step < 0.1:
                centre += 0.5 * step * (left - right) / bend
                here = misfits(centre)[0][0]
            step *= 0.5
    step = 0.1
    (before, after, _), factors = misfits(centre - step, centre + step, centre)
    bend = (before + after - 2.0 * here) / step**2
    variance = here / max(len(s) - 5, 1)
    # The sphere is brighter than what is behind it: just inside, step and root together.
    if bend <= 0.0 or factors[1] + factors[2] + factors[3] <= 0.0:
        return 0.0, math.inf, here / len(s)
    return centre, math.sqrt(2.0 * variance / bend), here / len(s)


def _columns(x: Floats, blur: float) -> Floats:
    """Return 1, H₀, H½ and H₁ (k, 4, n) at distances (k, n) of x blurs inside the edge."""
    step = ndtr(x)
    ramp = x * step + np.exp(-0.5 * x * x) / math.sqrt(2.0 * math.pi)
    places, roots = _root_table()
    root = np.where(x > places[-1], np.sqrt(np.maximum(x, 0.0)), np.interp(x, places, roots))
    return np.stack((np.ones_like(x), step, math.sqrt(blur) * root, blur * ramp), axis=1)


@lru_cache(maxsize=1)
def _root_table() -> tuple[Floats, Floats]:
    """Return E[√max(x + Z, 0)] of a standard normal Z at x from -6 to 12."""
    places = np.linspace(-6.0, 12.0, 721)
    # Substituting x + z = t² leaves a smooth integrand: 2 t² φ(t² - x) dt.
    t = np.linspace(0.0, 4.4, 1761)
    density = np.exp(-0.5 * (t[None, :] ** 2 - places[:, None]) ** 2) / math.sqrt(2.0 * math.pi)
    roots = np.trapezoid(2.0 * t[None, :] ** 2 * density, t, axis=1)
    return places, np.asarray(roots, float)

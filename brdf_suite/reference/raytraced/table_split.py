"""A table of values cut in a broad part and its peak, by clamping or by subtracting a lobe (section 5.1.3).

*Clamp*: the broad part is the table, no higher than what it has 15° beside the mirror direction; the peak is what is
above. *Subtract*: a lobe A(θd) exp(-tan²θh / m²) is fitted to the peak, its height at every θd the table's own above
the clamp, its slope m that which halves it where the table does; the broad part is the table less that lobe, never
negative. Either way the two sum up to the table exactly, and the peak is sampled by the facets that were fitted to it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import drjit as dr
import mitsuba as mi
import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colorimetry import LUMINANCE
from brdf_suite.geometry.directions import spherical
from brdf_suite.reference import directions as d
from brdf_suite.reference.directions import Colour, Half, Real, Square, Vector
from brdf_suite.reference.raytraced.lobes import (
    LARGEST_SLOPE,
    cosine_lobe_density,
    cosine_lobe_mirrored,
    exponent_of,
)
from brdf_suite.reference.raytraced.numbers import own
from brdf_suite.reference.terms import Facets

TableSplit = Literal["clamp", "subtract"]
TABLE_SPLITS: tuple[TableSplit, ...] = ("clamp", "subtract")

CLAMP_DEG = 15.0
_VIEWS_DEG = (15.0, 45.0, 65.0)
_FLANK, _FLANK_SHARE = 0.1, 0.15
"""A lobe about as wide as the clamp, and its least share of the samples: so that no flank is left out."""
_HEIGHTS = 65
_WIDTHS = 400

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Clamped:
    """A term, no higher than ``cap``."""

    term: Any
    cap: tuple[float, float, float]

    def value(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return dr.minimum(self.term.value(light, view), d.colour(self.cap))


@dataclass(frozen=True, eq=False)
class AboveClamp:
    """What a term has above ``cap``."""

    term: Any
    cap: tuple[float, float, float]

    def value(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return dr.maximum(self.term.value(light, view) - d.colour(self.cap), 0.0)


@dataclass(frozen=True, eq=False)
class FittedPeak:
    """A lobe A(θd) exp(-tan²θh / m²): ``heights`` (65 × 3) over the cosine of θd, the slope m."""

    heights: Any
    slope: float

    def value(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        half = Half.of(light, view)
        place = dr.clip(half.cos_d, 0.0, 1.0) * (_HEIGHTS - 1.0)
        low = dr.minimum(mi.UInt32(place), _HEIGHTS - 2)
        first, second = (dr.gather(mi.Color3f, self.heights, low + k) for k in (0, 1))
        height = dr.fma(place - mi.Float(low), second - first, first)
        return height * dr.exp(-half.tan2_h * d.number(1.0 / self.slope**2))


@dataclass(frozen=True, eq=False)
class Less:
    """A term less a lobe, never negative."""

    term: Any
    lobe: FittedPeak

    def value(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return dr.maximum(self.term.value(light, view) - self.lobe.value(light, view), 0.0)


@dataclass(frozen=True, eq=False)
class Within:
    """What of a term is within a lobe."""

    term: Any
    lobe: FittedPeak

    def value(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return dr.minimum(self.term.value(light, view), self.lobe.value(light, view))


@dataclass(frozen=True, eq=False)
class FacetMixture:
    """A narrow part that is sampled by several cosine lobes: (share, slope) of each, the shares of sum 1."""

    term: Any
    lobes: tuple[tuple[float, float], ...]
    share: float = 1.0

    def weight(self, _view: Vector) -> Real:
        """Return the share of a mixture with other narrow lobes."""
        return d.number(self.share)

    def value(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return self.term.value(light, view)

    def draw(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        low = mi.Float(0.0)
        exponent, inside = mi.Float(1.0), u.x
        for share, slope in self.lobes:
            mine = (u.x >= low) if share > 0.0 else mi.Bool(False)
            width = d.number(share)
            exponent = dr.select(mine, d.number(exponent_of(slope)), exponent)
            inside = dr.select(mine, (u.x - low) / width, inside)
            low = low + width
        # A number of 24 bits, less those that chose the lobe, is enough for a direction.
        return cosine_lobe_mirrored(view, mi.Point2f(dr.clip(inside, 0.0, 0.9999999), u.y), exponent)

    def density(self, light: Vector, view: Vector) -> Real:
        """Return the density of :meth:`draw` per solid angle."""
        half, total = Half.of(light, view), mi.Float(0.0)
        for share, slope in self.lobes:
            total += d.number(share) * cosine_lobe_density(half, d.number(exponent_of(slope)))
        return total


def split_by_values(term: Any, how: TableSplit) -> tuple[list[Any], list[Any]]:
    """Return the broad term and the narrow lobe of a term; all is broad where it has no peak."""
    facets = [s for s in term.samplers if isinstance(s, Facets) and s.slope <= LARGEST_SLOPE]
    if not facets:
        return [term], []
    cap = clamp_of(term)
    total = sum(f.weight for f in facets)
    lobes = [(f.weight / total * (1.0 - _FLANK_SHARE), f.slope) for f in facets]
    lobes.append((_FLANK_SHARE, _FLANK))
    if how == "clamp":
        return [Clamped(term, cap)], [FacetMixture(AboveClamp(term, cap), tuple(lobes))]
    peak = fitted_peak(term, cap)
    if peak is None:
        return [term], []
    only = ((1.0 - _FLANK_SHARE, peak.slope), (_FLANK_SHARE, min(2.0 * peak.slope, LARGEST_SLOPE)))
    return [Less(term, peak)], [FacetMixture(Within(term, peak), only)]


def clamp_of(term: Any) -> tuple[float, float, float]:
    """Return the largest value of each channel 15° beside the mirror direction, for three views."""
    found = []
    for theta_deg in _VIEWS_DEG:
        view = spherical(math.radians(theta_deg), 0.0)
        mirror = np.array([-view[0], -view[1], view[2]])
        beside = np.cross(mirror, [0.0, 1.0, 0.0])
        turn = np.linspace(0.0, 2.0 * math.pi, 32, endpoint=False)[:, None]
        away = np.cos(turn) * beside + np.sin(turn) * np.array([0.0, 1.0, 0.0])
        cosine, sine = math.cos(math.radians(CLAMP_DEG)), math.sin(math.radians(CLAMP_DEG))
        light = cosine * mirror + sine * away
        found.append(values_of(term, light[light[:, 2] > 0.05], view).max(axis=0))
    red, green, blue = np.max(found, axis=0).tolist()
    return red, green, blue


def fitted_peak(term: Any, cap: Sequence[float]) -> FittedPeak | None:
    """Return the lobe that is fitted to a term's peak above ``cap``; None where there is no peak."""
    cos_d = np.clip(np.linspace(0.0, 1.0, _HEIGHTS), 0.03, 1.0)
    theta = np.arccos(cos_d)
    heights = values_of(term, spherical(theta, math.pi), spherical(theta, 0.0))
    heights = np.maximum(heights - np.asarray(cap), 0.0)
    tilt = np.linspace(0.0, math.radians(0.5 * CLAMP_DEG), _WIDTHS)
    view_theta = math.radians(45.0)
    light = spherical(view_theta - 2.0 * tilt, np.full(_WIDTHS, math.pi))
    profile = (
        np.maximum(values_of(term, light, spherical(view_theta, 0.0)) - np.asarray(cap), 0.0) @ LUMINANCE
    )
    if not profile[0] > 0.0:
        return None
    below = np.flatnonzero(profile < 0.5 * profile[0])
    halved = tilt[below[0]] if len(below) else tilt[-1]
    slope = max(math.tan(halved) / math.sqrt(math.log(2.0)), 1e-3)
    table = mi.Float(np.ascontiguousarray(heights, np.float32).ravel())
    dr.eval(table)
    return FittedPeak(table, min(slope, LARGEST_SLOPE))


def values_of(term: Any, light: Floats, view: Floats) -> Floats:
    """Return f_r (n, 3) of a term for lights (n, 3) and views (n, 3), or one (3,), as numbers."""
    views = np.broadcast_to(view, light.shape)
    at, to = (mi.Vector3f(*(own(row, mi.Float) for row in x.T.astype(np.float32))) for x in (light, views))
    return np.asarray(np.array(term.value(at, to), np.float64).T)

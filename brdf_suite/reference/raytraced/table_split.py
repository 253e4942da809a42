"""Split of a table into a broad part and its peak, by clamping or by subtracting a lobe (section 5.1.3).

*Clamp*: the broad part is the table, no higher at any θd than what the table has there some angle beside the mirror
direction; the peak is what is above. Where it is mirrored, that angle is 15°. Where it is sampled, it is 25°, for
lights are too far apart for what is narrower, and the peak is cut once more at 6°, into the clearcoat's and a flank.

*Subtract*: a lobe A(θd) exp(-tan²θh / m²) is fitted to the peak, its height at every θd the table's own above the
clamp, its slope m that which halves it where the table does; the broad part is the table less that lobe.

Either way the parts sum up to the table exactly.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import spherical
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Half, Real, Square, Vector
from brdf_suite.reference.bsdfs.terms import Facets
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.lobes import (
    LARGEST_SLOPE,
    LEAST_SUNLIT_SLOPE,
    cosine_lobe_mirrored,
    cosine_lobe_pdf,
    equivalent_exponent,
)
from brdf_suite.reference.raytraced.numbers import copy_to_device

TableSplit = Literal["clamp", "subtract"]
CLAMP_DEG = 15.0
"""Beside the mirror direction; both sides of it are half as far from the normal, as half vectors."""
OUTER_DEG, INNER_DEG = 25.0, 6.0
_TURNS, _LEAST_COSINE = 9, 0.02
_PROFILE = math.radians(45.0)
_FLANK, _FLANK_SHARE = 0.1, 0.15
"""A lobe about as wide as the clamp, and its least share of the samples: so that nothing is left out."""
_INNER_FLANK = 0.04
_OUTER_LOBES = ((0.5, 0.08), (0.5, 0.2))
_LEAST_SHARE = 0.2
_HEIGHTS = 65
_WIDTHS = 400


@dataclass(frozen=True, eq=False)
class DifferenceAngleTable:
    """Values (65, 3) over the cosine of θd, at even steps from 0 to 1, in the renderer's memory."""

    table: Any

    @classmethod
    def of(cls, values: Floats) -> DifferenceAngleTable:
        """Return the values as arrays of the renderer."""
        table = mi.Float(np.ascontiguousarray(values, np.float32).ravel())
        dr.eval(table)
        return cls(table)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return the values at pairs of directions, linear in between."""
        place = dr.clip(Half.of(light, view).cos_d, 0.0, 1.0) * (_HEIGHTS - 1.0)
        low = dr.minimum(mi.UInt32(place), _HEIGHTS - 2)
        first, second = (dr.gather(mi.Color3f, self.table, low + k) for k in (0, 1))
        return dr.fma(place - mi.Float(low), second - first, first)


@dataclass(frozen=True, eq=False)
class BandTerm:
    """The part of a term above ``low`` and below ``high``; None: no bound."""

    term: Any
    low: DifferenceAngleTable | FittedPeak | None = None
    high: DifferenceAngleTable | FittedPeak | None = None

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        value = self.term.eval(light, view)
        top = value if self.high is None else dr.minimum(value, self.high.eval(light, view))
        return top if self.low is None else top - dr.minimum(value, self.low.eval(light, view))


@dataclass(frozen=True, eq=False)
class FittedPeak:
    """A lobe A(θd) exp(-tan²θh / m²): its ``heights``, the slope m."""

    heights: DifferenceAngleTable
    slope: float

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        bell = dr.exp(-Half.of(light, view).tan2_h * d.number(1.0 / self.slope**2))
        return self.heights.eval(light, view) * bell


@dataclass(frozen=True, eq=False)
class FacetMixture:
    """A narrow part sampled by several cosine lobes: (share, slope) of each, the shares of sum 1."""

    term: Any
    lobes: tuple[tuple[float, float], ...]
    weight: float = 1.0

    @property
    def is_sunlit(self) -> bool:
        """Whether suns light it, and its rays leave them out: where none of its lobes is narrower than that."""
        return min(slope for _, slope in self.lobes) >= LEAST_SUNLIT_SLOPE

    def share(self, _view: Vector) -> Real:
        """Return the share of a mixture with other narrow lobes."""
        return d.number(self.weight)

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        low = mi.Float(0.0)
        exponent, inside = mi.Float(1.0), u.x
        for share, slope in self.lobes:
            mine = (u.x >= low) if share > 0.0 else mi.Bool(False)
            width = d.number(share)
            exponent = dr.select(mine, d.number(equivalent_exponent(slope)), exponent)
            inside = dr.select(mine, (u.x - low) / width, inside)
            low = low + width
        # A number of 24 bits, less those that chose the lobe, is enough for a direction.
        return cosine_lobe_mirrored(view, mi.Point2f(dr.clip(inside, 0.0, 0.9999999), u.y), exponent)

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density of :meth:`sample` per solid angle."""
        half, total = Half.of(light, view), mi.Float(0.0)
        for share, slope in self.lobes:
            total += d.number(share) * cosine_lobe_pdf(half, d.number(equivalent_exponent(slope)))
        return total


def split_by_values(term: Any, how: TableSplit, *, mirror: bool = False) -> tuple[list[Any], list[Any]]:
    """Return the broad term and the narrow lobes of a term; all is broad where it has no peak."""
    facets = [s for s in term.samplers if isinstance(s, Facets) and s.slope <= LARGEST_SLOPE]
    if not facets:
        return [term], []
    if how == "clamp" and not mirror:
        return _clamped_twice(term, facets)
    cap = find_caps(term, CLAMP_DEG)
    if how == "clamp":
        clamp = DifferenceAngleTable.of(cap)
        lobes = _mixture(facets, _FLANK)
        return [BandTerm(term, high=clamp)], [FacetMixture(BandTerm(term, low=clamp), lobes)]
    peak = fitted_peak(term, cap)
    if peak is None:
        return [term], []
    only = ((1.0 - _FLANK_SHARE, peak.slope), (_FLANK_SHARE, min(2.0 * peak.slope, LARGEST_SLOPE)))
    return [BandTerm(term, low=peak)], [FacetMixture(BandTerm(term, high=peak), only)]


def _clamped_twice(term: Any, facets: Sequence[Facets]) -> tuple[list[Any], list[Any]]:
    high = find_caps(term, INNER_DEG)
    inner = DifferenceAngleTable.of(high)
    outer = DifferenceAngleTable.of(np.minimum(find_caps(term, OUTER_DEG), high))
    narrow = [f for f in facets if f.slope < _INNER_FLANK]
    total = sum(f.weight for f in facets)
    share = min(max(sum(f.weight for f in narrow) / total, _LEAST_SHARE), 1.0 - _LEAST_SHARE)
    return [BandTerm(term, high=outer)], [
        FacetMixture(BandTerm(term, low=inner), _mixture(narrow, _INNER_FLANK), share),
        FacetMixture(BandTerm(term, outer, inner), _OUTER_LOBES, 1.0 - share),
    ]


def _mixture(facets: Sequence[Facets], flank: float) -> tuple[tuple[float, float], ...]:
    """The facets, by their weights, and a flank."""
    total = sum(f.weight for f in facets)
    shares = [(f.weight / total * (1.0 - _FLANK_SHARE), f.slope) for f in facets]
    return (*shares, (1.0 - sum(share for share, _ in shares), flank))


def find_caps(term: Any, beside_deg: float) -> Floats:
    """Return for each θd (65, 3) the largest value that many degrees beside the mirror direction."""
    theta_d = np.arccos(np.clip(np.linspace(0.0, 1.0, _HEIGHTS), 0.03, 1.0))
    tilt = math.radians(0.5 * beside_deg)
    turns = np.linspace(0.0, math.pi, _TURNS)
    # In the frame of the half vector, then that frame tilted about axes all around.
    light, view = (spherical(theta_d, phi) for phi in (math.pi, 0.0))
    caps = np.zeros((_HEIGHTS, 3))
    for turn in turns:
        axis = np.array([-math.sin(turn), math.cos(turn), 0.0])
        wi, wo = (_rotated(directions, axis, tilt) for directions in (light, view))
        above = (wi[:, 2] > _LEAST_COSINE) & (wo[:, 2] > _LEAST_COSINE)
        wi[~above] = wo[~above] = (0.0, 0.0, 1.0)
        caps = np.maximum(caps, np.where(above[:, None], evaluate_term(term, wi, wo), 0.0))
    # Towards grazing no such pair is above the horizon: there the last cap that is known holds.
    known = np.flatnonzero(caps.max(axis=1) > 0.0)
    if len(known):
        caps[: known[0]] = caps[known[0]]
    return caps


def _rotated(directions: Floats, axis: Floats, angle: float) -> Floats:
    """Turn directions (n, 3) about a unit axis (Rodrigues)."""
    cosine, sine = math.cos(angle), math.sin(angle)
    along = (directions @ axis)[:, None] * axis
    return np.asarray(cosine * directions + sine * np.cross(axis, directions) + (1.0 - cosine) * along)


def fitted_peak(term: Any, caps: Floats) -> FittedPeak | None:
    """Return the lobe that is fitted to a term's peak above ``caps`` (65, 3); None where there is no peak."""
    theta = np.arccos(np.clip(np.linspace(0.0, 1.0, _HEIGHTS), 0.03, 1.0))
    heights = np.maximum(evaluate_term(term, spherical(theta, math.pi), spherical(theta, 0.0)) - caps, 0.0)
    tilt = np.linspace(0.0, math.radians(0.5 * CLAMP_DEG), _WIDTHS)
    light = spherical(_PROFILE - 2.0 * tilt, np.full(_WIDTHS, math.pi))
    cap = caps[round(math.cos(_PROFILE) * (_HEIGHTS - 1))]
    profile = np.maximum(evaluate_term(term, light, spherical(_PROFILE, 0.0)) - cap, 0.0) @ LUMINANCE
    if not profile[0] > 0.0:
        return None
    below = np.flatnonzero(profile < 0.5 * profile[0])
    halved = tilt[below[0]] if len(below) else tilt[-1]
    slope = max(math.tan(halved) / math.sqrt(math.log(2.0)), 1e-3)
    return FittedPeak(DifferenceAngleTable.of(heights), min(slope, LARGEST_SLOPE))


def evaluate_term(term: Any, light: Floats, view: Floats) -> Floats:
    """Return f_r (n, 3) of a term for lights (n, 3) and views (n, 3), or one (3,), as numbers."""
    views = np.broadcast_to(view, light.shape)
    at, to = (
        mi.Vector3f(*(copy_to_device(row, mi.Float) for row in x.T.astype(np.float32)))
        for x in (light, views)
    )
    return np.asarray(np.array(term.eval(at, to), np.float64).T)

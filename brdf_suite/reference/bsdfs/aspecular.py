"""Base of a designed paint in the renderer: its rule over the aspecular angle, or over the flakes' tilt.

The flake rule is evaluated as it is. Any other rule is a table over the angle, fine enough that it errs by less than
single precision does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Vector
from brdf_suite.reference.bsdfs.terms import Crossing, Diffuse, Facets, Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.albedo import normal_albedo
from brdf_suite.reflectance.designed.aspecular_base import MEETING, AspecularBase, SeveralLights
from brdf_suite.reflectance.designed.rules import FlakeRule, squared_tilt

TABLE_POINTS = 16_385
_CELLS = 1025
_FLOP_SLOPE = 0.3
"""Facet slope of a lobe about as wide as a metallic paint's flop."""


@dataclass(frozen=True, eq=False)
class AspecularBaseTerm:
    """Term of an :class:`~brdf_suite.reflectance.designed.aspecular_base.AspecularBase`."""

    base: AspecularBase
    albedo: float
    table: Any = field(init=False)
    crossing: Crossing = field(init=False)

    def __post_init__(self) -> None:
        table = None
        if not isinstance(self.base.rule, FlakeRule):
            gamma = np.linspace(0.0, self.base.farthest, TABLE_POINTS)
            # As the rule has it, also where that is negative: what is clamped has a kink, which no table follows.
            table = mi.Float(np.asarray(self.base.rule(gamma), np.float32).ravel())
            dr.eval(table)
        object.__setattr__(self, "table", table)
        object.__setattr__(self, "crossing", Crossing(self.base.ior, self.base.roughness))

    @classmethod
    def of(cls, base: AspecularBase) -> AspecularBaseTerm:
        """Return the counterpart of a base."""
        return cls(base, float(normal_albedo(base) @ LUMINANCE))

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Half diffuse, half about the flop."""
        return (Diffuse(0.5 * self.albedo + 0.01), Facets(0.5 * self.albedo, _FLOP_SLOPE))

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        base = self.base
        # 2 asin(|R - V|/2) keeps the digits that the cosine has lost near the mirror direction.
        apart = dr.clip(0.5 * dr.norm(d.mirrored(light) - view), 0.0, 1.0)
        gamma = dr.minimum(2.0 * dr.asin(apart), d.number(base.farthest))
        there = self.crossing.entering(dr.cos(d.number(base.illumination) - gamma))
        here = math.pi * float(base.entering(math.cos(base.illumination)))
        through = self.crossing.entering(light.z) * self.crossing.entering(view.z)
        return self._factor(gamma, light, view) * (through / (d.number(here) * there))

    def _factor(self, gamma: Real, light: Vector, view: Vector) -> Colour:
        base, rule = self.base, self.base.rule
        if not isinstance(rule, FlakeRule):
            factor = self._of_table(gamma)
        else:
            if base.by_half_vector:
                farthest = float(squared_tilt(np.array(base.farthest), base.illumination, base.ior))
                between = dr.squared_norm(d.slope_between(light, view, base.ior))
                tilt = dr.minimum(between, d.number(farthest))
            else:
                tilt = _tilt(gamma, base.illumination, base.ior)
            ground, height, u = (d.colour(part.tolist()) for part in (rule.ground, rule.height, rule.u))
            factor = ground + height * dr.exp(-u * tilt)
        if base.near_specular != 1.0 and base.nearest > 0.0:
            t = dr.maximum(1.0 - gamma * d.number(1.0 / base.nearest), 0.0)
            factor *= 1.0 + d.number(base.near_specular - 1.0) * (t * t * (3.0 - 2.0 * t))
        return dr.maximum(factor, 0.0)

    def _of_table(self, gamma: Real) -> Colour:
        place = gamma * d.number((TABLE_POINTS - 1) / self.base.farthest)
        low = dr.minimum(mi.UInt32(place), TABLE_POINTS - 2)
        part = place - mi.Float(low)
        first, second = (dr.gather(mi.Color3f, self.table, low + k) for k in (0, 1))
        return dr.fma(part, second - first, first)


@dataclass(frozen=True, eq=False)
class SeveralLightsTerm:
    """Term of :class:`~brdf_suite.reflectance.designed.aspecular_base.SeveralLights`.

    For two lights the shares are computed; for more they are tables over γ and θd, whose kinks lie along lines, so
    that they err by up to half a cell there.
    """

    terms: tuple[AspecularBaseTerm, ...]
    tables: tuple[Any, ...]

    @classmethod
    def of(cls, lights: SeveralLights) -> SeveralLightsTerm:
        """Return the counterpart."""
        terms = tuple(AspecularBaseTerm.of(base) for base in lights.bases)
        if len(terms) == 2:
            return cls(terms, ())
        axes = np.linspace(0.0, math.pi, _CELLS), np.linspace(0.0, 0.5 * math.pi, _CELLS)
        shares = lights.shares(*np.meshgrid(*axes, indexing="ij"))
        return cls(terms, tuple(mi.Float(share.astype(np.float32).ravel()) for share in shares))

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of the first light's base."""
        return self.terms[0].samplers

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        gamma = 2.0 * dr.asin(dr.clip(0.5 * dr.norm(d.mirrored(light) - view), 0.0, 1.0))
        theta_d = dr.asin(dr.clip(0.5 * dr.norm(light - view), 0.0, 1.0))
        shares = self._of_table(gamma, theta_d) if self.tables else self._of_two(gamma, theta_d)
        total = mi.Color3f(0.0)
        for term, share in zip(self.terms, shares, strict=True):
            total += share * term.eval(light, view)
        return total

    def _of_two(self, gamma: Real, theta_d: Real) -> tuple[Real, Real]:
        first, second = (dr.abs(d.number(term.base.illumination) - 0.5 * gamma) for term in self.terms)
        near, far = dr.minimum(first, second), dr.maximum(first, second)
        passed = dr.clip((theta_d - near) / dr.maximum(far - near, 1e-12), 0.0, 1.0)
        mixed = dr.clip(1.0 - (far - near) / MEETING, 0.0, 1.0)
        further = passed - 0.5 * mixed * (2.0 * passed - 1.0)
        nearer = 1.0 - further
        return dr.select(first <= second, nearer, further), dr.select(first <= second, further, nearer)

    def _of_table(self, gamma: Real, theta_d: Real) -> list[Real]:
        x, y = gamma * ((_CELLS - 1) / math.pi), theta_d * ((_CELLS - 1) / (0.5 * math.pi))
        i, j = (dr.minimum(mi.UInt32(place), _CELLS - 2) for place in (x, y))
        u, v = x - mi.Float(i), y - mi.Float(j)
        at = i * _CELLS + j
        shares = []
        for table in self.tables:
            a, b = dr.gather(mi.Float, table, at), dr.gather(mi.Float, table, at + 1)
            c, e = (dr.gather(mi.Float, table, at + _CELLS + k) for k in (0, 1))
            shares.append((1.0 - u) * ((1.0 - v) * a + v * b) + u * ((1.0 - v) * c + v * e))
        return shares


def _tilt(gamma: Real, illumination: float, ior: float) -> Real:
    """tan²δ; see :func:`brdf_suite.reflectance.designed.rules.squared_tilt`."""
    # δ = (a - b)/2 with sin a = sin θ0/n: the difference of two angles, as the arc of the sine of the difference.
    sine = dr.sin(d.number(illumination) - gamma) * d.number(1.0 / ior)
    a = math.asin(math.sin(illumination) / ior)
    cosine = dr.sqrt(1.0 - sine * sine)
    # sin(a - b) with its digits: n sin a - n sin b = 2 cos(θ0 - γ/2) sin(γ/2).
    apart = d.number(2.0 / ior) * dr.cos(d.number(illumination) - 0.5 * gamma) * dr.sin(0.5 * gamma)
    first = math.sin(a)
    # tan((a - b)/2) = (sin a - sin b)/(cos a + cos b).
    tangent = apart / (d.number(math.sqrt(1.0 - first * first)) + cosine)
    return tangent * tangent

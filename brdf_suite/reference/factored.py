"""A product of textures in the renderer: the twin of :class:`brdf_suite.reflectance.factored.Factored`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from brdf_suite.geometry.directions import Floats
from brdf_suite.reference import directions as d
from brdf_suite.reference.directions import TINY, Colour, Real, Square, Vector
from brdf_suite.reference.terms import Matt, Sampler
from brdf_suite.reflectance.factored import Factored


@dataclass(frozen=True, eq=False)
class FactoredTerm:
    """alpha p(wo) q(h) p(wi), each looked up bilinearly in its parabolic map."""

    model: Factored
    p: Any = field(init=False)
    q: Any = field(init=False)
    samplers: Sequence[Sampler] = field(init=False)

    def __post_init__(self) -> None:
        for name in ("p", "q"):
            values = np.ascontiguousarray(getattr(self.model, name), np.float32)
            held = mi.Float(values.ravel())
            dr.eval(held)
            object.__setattr__(self, name, held)
        matt, of_p, of_q = self.model.shares
        of_light, of_half = self.model.densities
        samplers: list[Sampler] = [Matt(matt)]
        if of_p > 0.0:
            samplers.append(MapSampler.of(of_p, of_light, mirrored=False))
        if of_q > 0.0:
            samplers.append(MapSampler.of(of_q, of_half, mirrored=True))
        object.__setattr__(self, "samplers", tuple(samplers))

    def value(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        half = dr.normalize(light + view)
        p, q = (self.p, len(self.model.p)), (self.q, len(self.model.q))
        product = _look_up(*p, light) * _look_up(*p, view) * _look_up(*q, half)
        return product * d.colour(np.asarray(self.model.alpha).tolist())


@dataclass(frozen=True, eq=False)
class MapSampler:
    """Draws texels of a map by their chance, as light directions or as half vectors that mirror the view."""

    weight: float
    size: int
    bounds: Any
    chances: Any
    mirrored: bool

    @classmethod
    def of(cls, weight: float, density: Floats, *, mirrored: bool) -> MapSampler:
        """Return the sampler of a map's chances (n, n)."""
        bounds = np.cumsum(density.ravel())
        limits, chances = (
            mi.Float((values / bounds[-1]).astype(np.float32)) for values in (bounds, density.ravel())
        )
        dr.eval(limits, chances)
        return cls(weight, len(density), limits, chances, mirrored)

    def share(self, _view: Vector) -> Real:
        """Return the share of a mixture."""
        return d.number(self.weight)

    def draw(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        count = self.size * self.size
        search: Any = dr.binary_search
        index = search(0, count - 1, lambda k: dr.gather(mi.Float, self.bounds, k) <= u.x)
        start = dr.select(index > 0, dr.gather(mi.Float, self.bounds, dr.maximum(index, 1) - 1), 0.0)
        chance = dr.gather(mi.Float, self.chances, index)
        within = dr.clip((u.x - start) / dr.maximum(chance, TINY), 0.0, 1.0)
        row = index // self.size
        s = (mi.Float(index - row * self.size) + within) * (2.0 / self.size) - 1.0
        t = (mi.Float(row) + u.y) * (2.0 / self.size) - 1.0
        r2 = s * s + t * t
        found = mi.Vector3f(2.0 * s, 2.0 * t, 1.0 - r2) / (1.0 + r2)
        if not self.mirrored:
            return found
        light = dr.fma(2.0 * dr.dot(view, found), found, -view)
        return dr.select(found.z > 0.0, light, mi.Vector3f(0.0, 0.0, -1.0))

    def density(self, light: Vector, view: Vector) -> Real:
        """Return the density per solid angle."""
        total = light + view
        length = dr.maximum(dr.norm(total), TINY)
        w = total / length if self.mirrored else light
        s, t = _place(w)
        column, row = (_texel(0.5 * (along + 1.0) * self.size, self.size - 1) for along in (s, t))
        chance = dr.gather(mi.Float, self.chances, row * self.size + column)
        per_angle = chance * (self.size * self.size / 16.0) * dr.square(1.0 + s * s + t * t)
        # w·h is half the length of the sum.
        return per_angle / (2.0 * length) if self.mirrored else per_angle


def _place(w: Vector) -> tuple[Real, Real]:
    over = dr.maximum(1.0 + w.z, TINY)
    return w.x / over, w.y / over


def _texel(along: Real, last: int) -> Any:
    return mi.UInt32(dr.clip(dr.floor(along), 0.0, float(last)))


def _look_up(values: Any, size: int, w: Vector) -> Colour:
    x, y = (dr.clip(0.5 * (along + 1.0) * size - 0.5, 0.0, size - 1.0) for along in _place(w))
    i, j = (dr.minimum(mi.UInt32(along), size - 2) for along in (x, y))
    u, v = x - mi.Float(i), y - mi.Float(j)
    rows = []
    for row in (j, j + 1):
        left, right = (dr.gather(mi.Color3f, values, row * size + i + k) for k in (0, 1))
        rows.append(dr.fma(u, right - left, left))
    return dr.fma(v, rows[1] - rows[0], rows[0])

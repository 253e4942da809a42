"""Product of textures in the renderer, as :class:`brdf_suite.reflectance.factored.model.Factored`."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Self

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import TINY, Colour, Real, Square, Vector
from brdf_suite.reference.bsdfs.terms import Diffuse, Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.factored.map import MapFactor, ring_bounds
from brdf_suite.reflectance.factored.model import Factored


@dataclass(frozen=True, eq=False)
class _Chances:
    """Distribution over a parabolic map's disc, of lights or of half vectors that mirror the view.

    ``bounds``: sums of the chances; ``measure``: the density per area of the disc in each piece.
    """

    weight: float
    size: int
    bounds: Any
    chances: Any
    measure: Any
    mirrored: bool

    @classmethod
    def of(cls, weight: float, density: Floats, *, mirrored: bool) -> Self:
        """Return the sampler of a map's chances."""
        bounds = np.cumsum(density.ravel())
        arrays = (bounds / bounds[-1], density.ravel(), cls.per_area(density).ravel())
        limits, chances, measure = (mi.Float(values.astype(np.float32)) for values in arrays)
        dr.eval(limits, chances, measure)
        return cls(weight, len(density), limits, chances, measure, mirrored)

    @classmethod
    def per_area(cls, density: Floats) -> Floats:
        """Return chances over the area of their pieces of the disc."""
        raise NotImplementedError

    def share(self, _view: Vector) -> Real:
        """Return the share of a mixture."""
        return d.number(self.weight)

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        search: Any = dr.binary_search
        last = dr.width(self.bounds) - 1
        index = search(0, last, lambda k: dr.gather(mi.Float, self.bounds, k) <= u.x)
        start = dr.select(index > 0, dr.gather(mi.Float, self.bounds, dr.maximum(index, 1) - 1), 0.0)
        chance = dr.gather(mi.Float, self.chances, index)
        within = dr.clip((u.x - start) / dr.maximum(chance, TINY), 0.0, 1.0)
        s, t = self.inside(index, within, u.y)
        r2 = s * s + t * t
        found = mi.Vector3f(2.0 * s, 2.0 * t, 1.0 - r2) / (1.0 + r2)
        if not self.mirrored:
            return found
        light = dr.fma(2.0 * dr.dot(view, found), found, -view)
        return dr.select(found.z > 0.0, light, mi.Vector3f(0.0, 0.0, -1.0))

    def inside(self, index: Any, within: Real, other: Real) -> tuple[Real, Real]:
        """Return places on the disc, even in the pieces ``index``."""
        raise NotImplementedError

    def piece(self, s: Real, t: Real) -> Any:
        """Return in which pieces places on the disc lie."""
        raise NotImplementedError

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density per solid angle."""
        total = light + view
        length = dr.maximum(dr.norm(total), TINY)
        s, t = place(total / length if self.mirrored else light)
        per_area = dr.gather(mi.Float, self.measure, self.piece(s, t))
        per_angle = per_area * 0.25 * dr.square(1.0 + s * s + t * t)
        # w·h is half the length of the sum.
        return per_angle / (2.0 * length) if self.mirrored else per_angle


class ParabolicMapSampler(_Chances):
    """Sampler of a parabolic map's texels (n, n)."""

    @classmethod
    def per_area(cls, density: Floats) -> Floats:
        """Return chances over the area of a texel."""
        return np.asarray(density * (0.25 * density.size))

    def inside(self, index: Any, within: Real, other: Real) -> tuple[Real, Real]:
        """Return places in texels."""
        row = index // self.size
        s = (mi.Float(index - row * self.size) + within) * (2.0 / self.size) - 1.0
        return s, (mi.Float(row) + other) * (2.0 / self.size) - 1.0

    def piece(self, s: Real, t: Real) -> Any:
        """Return texels."""
        column, row = (_whole(0.5 * (along + 1.0) * self.size, self.size - 1) for along in (s, t))
        return row * self.size + column


class RingSampler(_Chances):
    """Sampler of rings about the normal, uniform in the root of their radius."""

    @classmethod
    def per_area(cls, density: Floats) -> Floats:
        """Return chances over the area of a ring."""
        return np.asarray(density / (math.pi * np.diff(ring_bounds() ** 2)))

    def inside(self, index: Any, within: Real, other: Real) -> tuple[Real, Real]:
        """Return places in rings."""
        inner, outer = (dr.square(dr.square((mi.Float(index) + step) / self.size)) for step in (0.0, 1.0))
        radius = dr.sqrt(dr.fma(outer - inner, within, inner))
        turn = 2.0 * math.pi * other
        return radius * dr.cos(turn), radius * dr.sin(turn)

    def piece(self, s: Real, t: Real) -> Any:
        """Return rings."""
        return _whole(dr.sqrt(dr.sqrt(s * s + t * t)) * self.size, self.size - 1)


def place(w: Vector) -> tuple[Real, Real]:
    """Return the place on a parabolic map's disc of directions that are not straight down."""
    over = dr.maximum(1.0 + w.z, TINY)
    return w.x / over, w.y / over


def _whole(along: Real, last: int) -> Any:
    return mi.UInt32(dr.clip(dr.floor(along), 0.0, float(last)))


_Place = Callable[[Vector, Vector, Vector], tuple[Real, ...]]


@dataclass(frozen=True, eq=False)
class FactoredTerm:
    """The sum of products of maps, each read between its texels as the reflectance reads it."""

    model: Factored
    terms: Sequence[tuple[Sequence[float], Sequence[_Held]]] = field(init=False)
    samplers: Sequence[Sampler] = field(init=False)

    def __post_init__(self) -> None:
        # One buffer for a map that two factors read.
        buffers: dict[tuple[int, bool], Any] = {}
        terms = [
            (scale.tolist(), [_Held.of(factor, buffers) for factor in factors])
            for scale, factors in self.model.terms
        ]
        object.__setattr__(self, "terms", terms)
        found = self.model.samplers
        samplers: list[Sampler] = [Diffuse(max(1.0 - sum(one.share for one in found), 0.0))]
        for one in found:
            kind = ParabolicMapSampler if one.density.ndim == 2 else RingSampler
            samplers.append(kind.of(one.share, one.density, mirrored=one.mirrored))
        object.__setattr__(self, "samplers", tuple(samplers))

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        half = dr.normalize(light + view)
        total = d.colour([0.0, 0.0, 0.0])
        for scale, factors in self.terms:
            product, logs = d.colour(scale), d.colour([0.0, 0.0, 0.0])
            for factor in factors:
                read = factor.read(light, view, half)
                if factor.logarithmic:
                    logs += read
                else:
                    product *= read
            total += product * dr.exp(logs)
        return total


@dataclass(frozen=True, eq=False)
class _Held:
    """A map in the renderer's memory: ``values`` row by row, logarithms or not, of ``size`` texels along an axis."""

    values: Any
    size: int
    projection: str
    logarithmic: bool

    @classmethod
    def of(cls, factor: MapFactor, buffers: dict[tuple[int, bool], Any]) -> _Held:
        key = (id(factor.values), factor.logarithmic)
        if key not in buffers:
            held = np.log(factor.values) if factor.logarithmic else factor.values
            buffers[key] = mi.Float(np.ascontiguousarray(held, np.float32).ravel())
            dr.eval(buffers[key])
        return cls(buffers[key], len(factor.values), factor.projection, factor.logarithmic)

    def read(self, light: Vector, view: Vector, half: Vector) -> Colour:
        """Return the map between its texels."""
        places = [
            dr.clip(along * self.size - 0.5, 0.0, self.size - 1.0)
            for along in _PLACES[self.projection](light, view, half)
        ]
        lows = [dr.minimum(mi.UInt32(along), self.size - 2) for along in places]
        shares = [along - mi.Float(low) for along, low in zip(places, lows, strict=True)]
        if len(places) == 1:
            return self._row(0, lows[0], shares[0])
        row = lows[1] * self.size
        below, above = (self._row(row + step, lows[0], shares[0]) for step in (0, self.size))
        return dr.fma(shares[1], above - below, below)

    def _row(self, first: Any, low: Any, share: Real) -> Colour:
        left, right = (dr.gather(mi.Color3f, self.values, first + low + step) for step in (0, 1))
        return dr.fma(share, right - left, left)


def _parabolic(w: Vector) -> tuple[Real, Real]:
    s, t = place(w)
    return 0.5 * (s + 1.0), 0.5 * (t + 1.0)


def _radius(w: Vector) -> Real:
    s, t = place(w)
    return dr.clip(dr.sqrt(s * s + t * t), 0.0, 1.0)


def _unit(cosine: Real) -> Real:
    return dr.clip(cosine, 0.0, 1.0)


_PLACES: Mapping[str, _Place] = {
    "wi": lambda light, _view, _half: _parabolic(light),
    "wo": lambda _light, view, _half: _parabolic(view),
    "h": lambda _light, _view, half: _parabolic(half),
    "wi.wo": lambda light, view, _half: (0.5 * (dr.dot(light, view) + 1.0),),
    "w.h": lambda light, _view, half: (_unit(dr.dot(light, half)),),
    "|wi|": lambda light, _view, _half: (_radius(light),),
    "|wo|": lambda _light, view, _half: (_radius(view),),
    "|h|": lambda _light, _view, half: (_radius(half),),
    "sqrt|h|": lambda _light, _view, half: (dr.sqrt(_radius(half)),),
    "w.h,h.n": lambda light, _view, half: (_unit(dr.dot(light, half)), _unit(half.z)),
    "wi.n,wo.n": lambda light, view, _half: (
        _unit(dr.minimum(light.z, view.z)),
        _unit(dr.maximum(light.z, view.z)),
    ),
}
"""What :data:`brdf_suite.geometry.factor_words.PROJECTIONS` gives, in the renderer's arithmetic."""

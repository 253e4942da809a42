"""Product of textures in the renderer, as :class:`brdf_suite.reflectance.factored.model.Factored`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import TINY, Colour, Real, Vector
from brdf_suite.reference.bsdfs.table import fitted_samplers
from brdf_suite.reference.bsdfs.terms import Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored


def place(w: Vector) -> tuple[Real, Real]:
    """Return the place on a parabolic map's disc of directions that are not straight down."""
    over = dr.maximum(1.0 + w.z, TINY)
    return w.x / over, w.y / over


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
        object.__setattr__(self, "samplers", fitted_samplers(self.model))

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

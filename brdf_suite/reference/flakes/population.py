"""The flakes of a paint's surface, side by side: each place that the camera sees shows one of them.

The population is that of the real-time picture (``mosaic.frag.glsl``, ``sparkle_glints.glsl``): one flake to a cell of
its own area, as the polygon of places that are nearest to it; tilts of Beckmann's density; brightnesses of one
distribution. They are not the same flakes: the two pictures agree in mean, contrast and spectrum. A flake's light over
the mean of all is 1 on the average of the surface, whatever the light, so flakes move light about and add none.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol, Self

import numpy as np

from brdf_suite.appearance.flakes.footprint import PIXEL_REACH
from brdf_suite.appearance.flakes.visible import (
    ASPECULAR,
    FLAKE_REFLECTANCE,
    FLAKE_WAVINESS,
    FLAKES_SHARE,
    LARGEST_SHARE,
    flake_coverage,
    flake_dimming,
    full_density,
)
from brdf_suite.documents.paint import Flakes
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Square, Vector
from brdf_suite.reference.bsdfs.terms import Sampler, Term
from brdf_suite.reference.flakes.cells import GOLDEN, cell_key, halves, scramble, tint
from brdf_suite.reference.flakes.texture import FlakesSeen, flakes_seen, seen_ratio
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.scene.place import Place, footprint_of_sample

_SALT = 0x51ED270B
_CELLS_PER_PIXEL = 16.0
"""At least so many are kept where flakes are taken together."""
_REACH = 0.5
"""Standard deviations of a pixel along an axis, in pixels; about the filter of the mosaic's mip levels."""


class SeenFlakes(Protocol):
    """The flakes of one place."""

    def ratio(self, light: Vector, view: Vector) -> Colour:
        """Return their light over the mean of all flakes."""
        ...

    def samplers(self, base: Sequence[Sampler]) -> Sequence[Sampler]:
        """Return samplers of the light that they mirror, to be mixed with those of their base."""
        ...


@dataclass(frozen=True)
class FlakeLayer:
    """The flakes of a paint below a coat of index ``ior``.

    ``strength`` is a factor on their light, ``dimming`` how much dimmer than clean mirrors they are.

    ``as_texture``: by the flake texture of 2005, else side by side.
    """

    flakes: Flakes
    ior: float
    strength: float = 1.0
    dimming: float = 1.0
    waviness: float = FLAKE_WAVINESS
    as_texture: bool = False

    @classmethod
    def of(cls, flakes: Flakes, base: Term, ior: float, strength: float, *, as_texture: bool) -> Self:
        """Return the flakes of a base, dimmed by what it reflects of light at 45°."""
        theta = 0.25 * math.pi
        away = theta - ASPECULAR
        light = mi.Vector3f(math.sin(theta), 0.0, math.cos(theta))
        view = mi.Vector3f(-math.sin(away), 0.0, math.cos(away))
        dimming = flake_dimming(flakes, float(np.array(base.eval(light, view)).max()), ior)
        return cls(flakes, ior, strength, dimming, as_texture=as_texture)

    def visible_part(self, base: Colour, light: Vector, view: Vector) -> Colour:
        """Return the part of the base's f_r, 1/sr, that visible flakes reflect.

        It is d c R T(light) T(view) bell / (4π m² n² cosθ'l cosθ'v): flakes of coverage c and reflectance R whose tilts
        have the density bell / (π m²) per solid angle, below a coat of index n, θ' below it, dimmer by d than clean
        mirrors; never more than most of the base.
        """
        slope = d.slope_between(light, view, self.ior)
        m2 = self.flakes.roughness**2
        most = self.strength * self.dimming * self.coverage * FLAKE_REFLECTANCE / (4.0 * math.pi * m2)
        wanted = d.number(most / self.ior**2) * tilt_bell(dr.squared_norm(slope), self.flakes.roughness)
        for w in (light, view):
            below = dr.sqrt(1.0 - (w.x * w.x + w.y * w.y) * d.number(1.0 / self.ior**2))
            wanted *= (1.0 - d.fresnel(w.z, self.ior)) / dr.maximum(below, 1e-6)
        return base * dr.minimum(wanted / dr.maximum(dr.max(base), 1e-12), LARGEST_SHARE)

    def at(self, place: Place, to_flakes: Any) -> SeenFlakes:
        """Return what a place shows; ``to_flakes`` turns directions to the frame of the tilts."""
        if self.as_texture:
            reach = footprint_of_sample(PIXEL_REACH)
            seen = flakes_seen(self.flakes, place.uv, place.across, place.down, reach)
            return TextureThere(self, place.seen, to_flakes, seen)
        return FlakeThere.of(self, place, to_flakes)

    @cached_property
    def coverage(self) -> float:
        """The share of the surface, 0 to 1, that shows a flake."""
        return flake_coverage(self.flakes)


def tilt_bell(slope2: Real, roughness: float) -> Real:
    """Return the density of tilts over that along the normal."""
    up = 1.0 + slope2
    return dr.exp(-slope2 * d.number(1.0 / roughness**2)) * up * dr.sqrt(up)


@dataclass(frozen=True, eq=False)
class TextureThere:
    """A place of the flake texture."""

    layer: FlakeLayer
    seen: Any
    to_flakes: Any
    flakes: FlakesSeen

    def ratio(self, light: Vector, view: Vector) -> Colour:
        """Return the light of the place's flakes over their mean."""
        layer = self.layer
        slope = d.slope_between(self.to_flakes(light), self.to_flakes(view), layer.ior)
        found = seen_ratio(layer.flakes, self.flakes, slope, d.number(layer.waviness**2))
        return dr.select(self.seen, found, mi.Color3f(1.0))

    def samplers(self, _base: Sequence[Sampler]) -> Sequence[Sampler]:
        """Return none: a few of many flakes are met, and their base's samplers do."""
        return ()


@dataclass(frozen=True, eq=False)
class FlakeThere:
    """The one flake that a place shows.

    Where a pixel holds very many, a cell is that of a whole power of four of them, and its one flake stands for them
    all: its light over the mean deviates by ``contrast``, one over the root of their number, times as much. Mean and
    variance over the pixel stay those of the population, and far fewer paths are needed.

    ``seen`: whether the camera sees the place; elsewhere the mean of all flakes is met. ``place`` (2-D): of its tilt
    on the disc of diameter 1, ``stretch`` of a small angle there; ``power`` its brightness over the mean, 0 where the
    place shows none.
    """

    layer: FlakeLayer
    seen: Any
    to_flakes: Any
    slope: Any
    place: Any
    stretch: Real
    power: Colour
    contrast: Real

    @classmethod
    def of(cls, layer: FlakeLayer, place: Place, to_flakes: Any) -> FlakeThere:
        """Return the flake whose seed is nearest to the place."""
        flakes = layer.flakes
        density = d.number(full_density(flakes.size_um))
        held = abs(place.across.x * place.down.y - place.across.y * place.down.x) * density
        level = dr.maximum(dr.floor(0.5 * dr.log2(dr.maximum(held, 1e-6) / _CELLS_PER_PIXEL)), 0.0)
        contrast = dr.exp2(-level)
        per_mm = dr.sqrt(density) * contrast
        salt = mi.UInt32(mi.Int32(level)) * mi.UInt32(GOLDEN) + mi.UInt32(_SALT)
        at = _spread_over_pixel(place) * per_mm
        cell_x, cell_y = dr.floor(at.x), dr.floor(at.y)

        # A loop that is not written out: 25 times over, it would take the compiler seconds.
        def step(number: Any, nearest: Any, found: Any) -> tuple[Any, Any, Any]:
            x, y = cell_x + mi.Float(number % 5) - 2.0, cell_y + mi.Float(number // 5) - 2.0
            key = cell_key(x, y, salt)
            right, above = halves(key)
            apart = dr.square(x + right - at.x) + dr.square(y + above - at.y)
            closer = apart < nearest
            return number + 1, dr.select(closer, apart, nearest), dr.select(closer, key, found)

        start = (mi.UInt32(0), mi.Float(1e9), mi.UInt32(0))
        _, _, key = dr.while_loop(start, lambda number, *_: number < 25, step)
        words = [scramble(key + mi.UInt32(GOLDEN * (k + 1) & 0xFFFFFFFF)) for k in range(3)]
        r1, r2 = halves(words[0])
        covers, u = halves(words[1])
        tangent = d.number(flakes.roughness) * dr.sqrt(-dr.log(1.0 - r1))
        sine, cosine = dr.sincos(2.0 * math.pi * r2)
        slope = mi.Vector2f(tangent * cosine, tangent * sine)
        on_disc, stretch = _on_disc(slope, flakes.roughness)
        bright = dr.select(covers < d.number(layer.coverage), 2.5 * u * dr.sqrt(u), 0.0)
        power = tint(words[2], flakes.colour_spread) * (bright * d.number(1.0 / max(layer.coverage, 1e-6)))
        return cls(layer, place.seen, to_flakes, slope, on_disc, stretch, power, contrast)

    def ratio(self, light: Vector, view: Vector) -> Colour:
        """Return the light of the flake over the mean of all."""
        slope = d.slope_between(self.to_flakes(light), self.to_flakes(view), self.layer.ior)
        on_disc, stretch = _on_disc(slope, self.layer.flakes.roughness)
        # Tilts are even over the disc, of the area π/4.
        found = self.power * (
            0.25 * math.pi * _bell(on_disc - self.place, stretch * d.number(self.layer.waviness))
        )
        found = 1.0 + (found - 1.0) * self.contrast
        return dr.select(self.seen, found, mi.Color3f(1.0))

    def samplers(self, base: Sequence[Sampler]) -> Sequence[Sampler]:
        """Return that of the flake; the larger part of the base's light is its."""
        return (FlakeSampler(self, base, FLAKES_SHARE * self.layer.coverage),)


@dataclass(frozen=True, eq=False)
class FlakeSampler:
    """Sampler of the light that one flake mirrors; ``part`` is its share of the mixture with its base's samplers."""

    there: FlakeThere
    base: Sequence[Sampler]
    part: float

    def share(self, view: Vector) -> Real:
        """Return the share of the mixture: none where no flake is seen."""
        total = mi.Float(0.0)
        for sampler in self.base:
            total += sampler.share(view)
        shown = self.there.seen & (self.there.power.x > 0.0)
        part = d.number(self.part) * self.there.contrast
        return dr.select(shown, part / (1.0 - part) * total, 0.0)

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        there, roughness = self.there, self.there.layer.flakes.roughness
        reach = dr.sqrt(8.0 * (1.0 - dr.cbrt(dr.maximum(1.0 - u.x, 0.0)))) * self._sigma
        sine, cosine = dr.sincos(2.0 * math.pi * u.y)
        p = mi.Vector2f(there.place.x + reach * cosine - 0.5, there.place.y + reach * sine - 0.5)
        radius2 = dr.minimum(dr.squared_norm(p), 0.249999)
        wide2 = -dr.log(1.0 - 4.0 * radius2)
        slope = p * (d.number(roughness) * dr.sqrt(wide2 / dr.maximum(radius2, 1e-12)))
        below, flake, _ = self._mirror(view, slope)
        light = 2.0 * dr.dot(below, flake) * flake - below
        # Past the rim of the disc there is no tilt.
        within = dr.squared_norm(p) < 0.249999
        flat = light.x * light.x + light.y * light.y
        out = mi.Vector3f(light.x, light.y, dr.sqrt(dr.maximum(1.0 - flat, 0.0)))
        return self._back(
            dr.select(within & (flat < 1.0) & (light.z > 0.0), out, mi.Vector3f(0.0, 0.0, -1.0))
        )

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density per solid angle."""
        there = self.there
        light_there, view_there = there.to_flakes(light), there.to_flakes(view)
        slope = d.slope_between(light_there, view_there, there.layer.ior)
        on_disc, stretch = _on_disc(slope, there.layer.flakes.roughness)
        below, flake, n = self._mirror(view, slope)
        n2 = n * n
        within = dr.sqrt(dr.maximum(n2 - (light_there.x**2 + light_there.y**2), 1e-6))
        # dω = 4 n² (h·v') cosθ'/cosθ dω_h, the two cosines below the coat and the vectors of the length n.
        turned = light_there.z / dr.maximum(4.0 * dr.dot(below, flake) * within, 1e-6)
        return _bell(on_disc - there.place, self._sigma) * dr.square(stretch) * turned

    @property
    def _sigma(self) -> Real:
        return self.there.stretch * d.number(self.there.layer.waviness)

    def _mirror(self, view: Vector, slope: Any) -> tuple[Vector, Vector, Real]:
        """Return the view below the coat, of the length n, a flake's normal, and n."""
        view = self.there.to_flakes(view)
        n = d.number(self.there.layer.ior)
        below = mi.Vector3f(view.x, view.y, dr.sqrt(dr.maximum(n * n - (view.x**2 + view.y**2), 1e-6)))
        return below, dr.normalize(mi.Vector3f(slope.x, slope.y, 1.0)), n

    def _back(self, direction: Vector) -> Vector:
        return self.there.to_flakes(direction, back=True)


def _bell(apart: Any, sigma: Real) -> Real:
    """Return the density over the disc of the tilts at which one flake mirrors a light."""
    narrow = 1.0 / (8.0 * sigma * sigma)
    return (3.0 / math.pi) * narrow * dr.square(dr.maximum(1.0 - dr.squared_norm(apart) * narrow, 0.0))


def _on_disc(slope: Any, roughness: float) -> tuple[Any, Real]:
    """Return the place of a tilt on the disc, and the stretch of angles; see ``flakes.tilt.tilt_place``."""
    wide = slope * d.number(1.0 / roughness)
    wide2 = dr.squared_norm(wide)
    grows = dr.select(wide2 < 1e-3, 1.0 - 0.5 * wide2, (1.0 - dr.exp(-wide2)) / dr.maximum(wide2, 1e-12))
    stretch = dr.sqrt(tilt_bell(dr.squared_norm(slope), roughness)) * d.number(0.5 / roughness)
    return 0.5 + wide * (0.5 * dr.sqrt(grows)), stretch


def _spread_over_pixel(place: Place) -> Any:
    """Return where a sample looks, mm: about its place, so that those of a pixel see what its footprint is.

    A sample's numbers are not known here; its place, even over the pixel, has them in its last digits.
    """
    x: Any = dr.reinterpret_array(mi.UInt32, place.uv.x)
    y: Any = dr.reinterpret_array(mi.UInt32, place.uv.y)
    r1, r2 = halves(scramble(x + scramble(y + mi.UInt32(GOLDEN))))
    reach = footprint_of_sample(_REACH) * dr.sqrt(-2.0 * dr.log(1.0 - r1))
    sine, cosine = dr.sincos(2.0 * math.pi * r2)
    return place.uv + (reach * cosine) * place.across + (reach * sine) * place.down

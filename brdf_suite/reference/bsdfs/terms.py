"""BSDF terms of the path tracer with eval, sample and pdf: diffuse, microfacets, lobes, and mixtures of them.

Each matches a model of ``brdf_suite.reflectance`` and is tested against it. Directions are local, z along the
normal; ``light`` and ``view`` are those of ``wi`` and ``wo`` of the core. Values are f_r in 1/sr, without the cosine;
the caller makes sure that both directions are above the horizon.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Half, Real, Square, Vector
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.facet_albedo import COSINE_NODES, coat_albedo
from brdf_suite.reflectance.models.coated import Coated

Triple = tuple[float, float, float]


class Sampler(Protocol):
    """A sampler of directions to the light; ``share`` is its weight in a mixture at a view, to a common factor."""

    def share(self, view: Vector) -> Real:
        """Return the share for a view, not negative."""
        ...

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions for uniform numbers ``u``; those below the horizon are discarded."""
        ...

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density of :meth:`sample` per solid angle, for directions above the horizon."""
        ...


class Term(Protocol):
    """A reflectance, or a part of one, with its samplers."""

    samplers: Sequence[Sampler]

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        ...


@dataclass(frozen=True)
class Diffuse:
    """Cosine-weighted sampler of a diffuse surface; ``weight`` is its albedo."""

    weight: float

    def share(self, _view: Vector) -> Real:
        """Return the share of a mixture."""
        return d.number(self.weight)

    def sample(self, _view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        return mi.warp.square_to_cosine_hemisphere(u)

    def pdf(self, light: Vector, _view: Vector) -> Real:
        """Return the density per solid angle."""
        return dr.maximum(light.z, 0.0) / math.pi


@dataclass(frozen=True)
class Facets:
    """Sampler of Beckmann microfacets; with ``ior`` its share follows Fresnel towards grazing."""

    weight: float
    slope: float
    ior: float | None = None

    def share(self, view: Vector) -> Real:
        """Return the share of a mixture."""
        return (
            d.number(self.weight) if self.ior is None else d.number(self.weight) * d.fresnel(view.z, self.ior)
        )

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        return d.beckmann_mirrored(view, u, self.slope)

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density per solid angle."""
        return d.beckmann_pdf(Half.of(light, view), self.slope)


@dataclass(frozen=True)
class AboutMirror:
    """Sampler of a cosine lobe about the mirror direction."""

    weight: float
    exponent: float

    def share(self, _view: Vector) -> Real:
        """Return the share of a mixture."""
        return d.number(self.weight)

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        return d.lobe_about_mirror(view, u, self.exponent)

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density per solid angle."""
        away = d.one_minus_mirror_cosine(light, view)
        return d.number((self.exponent + 1.0) / (2.0 * math.pi)) * d.mirror_lobe(away, self.exponent)


@dataclass(frozen=True)
class LambertianTerm:
    """A Lambertian term of ``albedo``; ``weight`` is its share of a mixture where that is not the albedo."""

    albedo: Triple
    weight: float | None = None

    @property
    def samplers(self) -> Sequence[Sampler]:
        """One cosine-weighted sampler."""
        return (Diffuse(luminance(self.albedo) if self.weight is None else self.weight),)

    def eval(self, _light: Vector, _view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return d.colour([a / math.pi for a in self.albedo])


@dataclass(frozen=True, eq=False)
class Crossing:
    """What a clearcoat lets through, as :func:`brdf_suite.reflectance.facet_albedo.entering`."""

    ior: float
    roughness: float
    change: Any = field(init=False)

    def __post_init__(self) -> None:
        rough = self.roughness > 0.0
        change = _on_device(coat_albedo(self.ior, self.roughness).change) if rough else None
        object.__setattr__(self, "change", change)

    def entering(self, cosine: Real) -> Real:
        """Return T at a cosine."""
        smooth = 1.0 - d.fresnel(cosine, self.ior)
        return smooth if self.change is None else dr.clip(smooth - _between(self.change, cosine), 0.0, 1.0)


def _on_device(nodes: Floats) -> Any:
    """Return a table in the renderer's memory; made before anything is traced, since a kernel cannot write it."""
    table = mi.Float(np.ascontiguousarray(nodes, np.float32))
    dr.eval(table)
    return table


def _between(nodes: Any, cosine: Real) -> Real:
    """Return a table of the albedo over √μ at a cosine, by straight lines."""
    place = dr.sqrt(dr.clip(cosine, 0.0, 1.0)) * (COSINE_NODES - 1)
    low = dr.minimum(mi.UInt32(place), COSINE_NODES - 2)
    first, second = (dr.gather(mi.Float, nodes, low + k) for k in (0, 1))
    return dr.fma(place - mi.Float(low), second - first, first)


@dataclass(frozen=True, eq=False)
class CoatLobeTerm:
    """The specular lobe of a clearcoat, the twin of ``lobe``."""

    lobe: CoatLobe
    lost: Any = field(init=False)

    def __post_init__(self) -> None:
        albedo = self.lobe.multiple
        object.__setattr__(self, "lost", None if albedo is None else _on_device(albedo.lost))

    @property
    def ior(self) -> float:
        """Index of the coat."""
        return self.lobe.ior

    @property
    def roughness(self) -> float:
        """Beckmann α of the coat."""
        return self.lobe.roughness

    @property
    def samplers(self) -> Sequence[Sampler]:
        """The microfacets, weighted by their Fresnel reflectance, and what several of them send everywhere."""
        facets, albedo = Facets(1.0, self.roughness, self.ior), self.lobe.multiple
        return (facets,) if albedo is None else (facets, Diffuse(float(albedo.multiple_albedo)))

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        half, a2 = Half.of(light, view), self.roughness**2
        facets = dr.exp(-half.tan2_h * d.number(1.0 / a2)) * dr.square(1.0 + half.tan2_h)
        shadowing = 1.0 / (1.0 + self._lambda(light.z) + self._lambda(view.z))
        scale = d.number(0.25 / (math.pi * a2))
        value = scale * facets * shadowing * d.fresnel(half.cos_d, self.ior) / (light.z * view.z)
        if (albedo := self.lobe.multiple) is not None:
            further = d.number(float(albedo.multiple))
            value += further * _between(self.lost, light.z) * _between(self.lost, view.z)
        return mi.Color3f(value)

    def _lambda(self, cosine: Real) -> Real:
        cosine = dr.maximum(cosine, 1e-8)
        sine = dr.sqrt(dr.maximum(dr.fma(-cosine, cosine, 1.0), TINY_SINE2))
        a = dr.minimum(cosine / (d.number(self.roughness) * sine), 1.6)
        return dr.maximum(1.0 - 1.259 * a + 0.396 * a * a, 0.0) / (a * (3.535 + 2.181 * a))


TINY_SINE2 = 1e-14


@dataclass(frozen=True)
class FacetLobe:
    """One lobe of Cook-Torrance: colour ``ks``, slope, ``scale`` of D, index (None: a mirror, F = 1)."""

    ks: Triple
    slope: float
    scale: float
    ior: float | None
    weight: float

    @property
    def samplers(self) -> Sequence[Sampler]:
        """The microfacets."""
        return (Facets(self.weight, self.slope),)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        half = Half.of(light, view)
        low = dr.minimum(light.z, view.z)
        grooves = dr.minimum(1.0, 2.0 * half.cos_h * low / half.cos_d)
        facets = dr.exp(-half.tan2_h * d.number(1.0 / self.slope**2)) * dr.square(1.0 + half.tan2_h)
        grey = facets * grooves / (light.z * view.z) * d.number(self.scale / (math.pi * self.slope**2))
        if self.ior is not None:
            grey *= d.fresnel(half.cos_d, self.ior)
        return d.colour(self.ks) * grey


@dataclass(frozen=True)
class SumTerm:
    """The sum of terms, sampled by the samplers of all."""

    terms: tuple[Any, ...]

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of all terms."""
        return tuple(sampler for term in self.terms for sampler in term.samplers)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        total: Colour = mi.Color3f(0.0)
        for term in self.terms:
            total += term.eval(light, view)
        return total


def sample(samplers: Sequence[Sampler], view: Vector, choice: Real, u: Square) -> Vector:
    """Return directions sampled from a mixture; ``choice``, uniform in [0, 1), selects the sampler."""
    shares = _shares(samplers, view)
    light = samplers[-1].sample(view, u)
    above = mi.Float(0.0)
    bounds = []
    for share in shares[:-1]:
        above = above + share
        bounds.append(above)
    for sampler, bound in zip(reversed(samplers[:-1]), reversed(bounds), strict=True):
        light = dr.select(choice < bound, sampler.sample(view, u), light)
    return light


def pdf(samplers: Sequence[Sampler], light: Vector, view: Vector) -> Real:
    """Return the density of :func:`sample` per solid angle, for directions above the horizon."""
    total = mi.Float(0.0)
    for share, sampler in zip(_shares(samplers, view), samplers, strict=True):
        total = total + share * sampler.pdf(light, view)
    return total


def _shares(samplers: Sequence[Sampler], view: Vector) -> list[Real]:
    raw = [sampler.share(view) for sampler in samplers]
    total = raw[0]
    for share in raw[1:]:
        total = total + share
    # A black term may be sampled in any way: all by the first.
    total = dr.maximum(total, 1e-20)
    return [share / total for share in raw]


def luminance(colour: Sequence[float] | Floats) -> float:
    """Return the luminance Y of a colour (3,) of the working space, to weigh samplers with."""
    return float(0.2627 * colour[0] + 0.678 * colour[1] + 0.0593 * colour[2])


@dataclass(frozen=True, eq=False)
class UnderCoat:
    """``base`` seen through the coat of ``model``, and the coat."""

    model: Coated
    base: Any
    coat: CoatLobeTerm = field(init=False)
    crossing: Crossing = field(init=False)

    def __post_init__(self) -> None:
        lobe = self.model.coat
        object.__setattr__(self, "coat", CoatLobeTerm(lobe))
        object.__setattr__(self, "crossing", Crossing(lobe.ior, lobe.crossing_roughness))

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of the base and of the coat."""
        return (*self.base.samplers, *self.coat.samplers)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return self.base.eval(light, view) * self.factor(light, view) + self.coat.eval(light, view)

    def factor(self, light: Vector, view: Vector) -> Colour:
        """Return what the base's f_r is multiplied by, seen through the coat."""
        m = self.model
        through = self.crossing.entering(light.z) * self.crossing.entering(view.z)
        even = m.mean_reflected
        one_way = dr.sqrt(dr.maximum(through, 1e-30))
        inner = 1.0 - (1.0 - even) / m.ior**2
        direct = d.number(1.0 - m.spread)
        stays = direct * (1.0 - one_way) + d.number(m.spread * inner)
        mean = direct * one_way + d.number(m.spread * (1.0 - even))
        albedo = d.colour(m.base_albedo.tolist())
        return (through / mean * (1.0 - stays)) / (1.0 - mi.Color3f(stays) * albedo)


@dataclass(frozen=True, eq=False)
class SeenThroughTerm:
    """A base seen through a coat, without the coat."""

    under: UnderCoat

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of the base."""
        return tuple(self.under.base.samplers)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return self.under.base.eval(light, view) * self.under.factor(light, view)

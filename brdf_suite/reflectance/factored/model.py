"""A reflectance as a product of textures: f_r = α p(wo) q(h) p(wi) (McCool, Ang and Ahmad 2001, equations 9 and 20).

p and q are maps over the hemisphere: p of the light and, the same one, of the view; q of the half vector
h = (wi + wo)/|wi + wo|. The product is reciprocal whatever the maps hold, and needs few numbers a channel to be
evaluated: real-time hardware does it per pixel. α takes what is left when the maps are normalised.

The maps of two axes are parabolic (``geometry.parabolic``), as the paper recommends; texels outside of the disc are met
by the interpolation near the horizon only. Those of isotropic reflectances are radially symmetric, and may be given as
their radius alone. More factors over other projections may be multiplied in (``more``), and the specular peak, which no
such product holds, may be a product of its own that is added (``peak``).

Sampling takes the maps for densities, as section 5 of the paper proposes: p(wi) cosθ, or q(h) and a mirror there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats, Singles
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.geometry.parabolic import texel_directions
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.factored.density import (
    HALF_PROJECTIONS,
    LIGHT_PROJECTIONS,
    build_density,
    direction_density,
    sample_directions,
    unevenness,
)
from brdf_suite.reflectance.factored.map import MapFactor, check_map
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import rgb

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {"alpha": Parameter("Scale", "1/sr", 0.0, 1e6, 1.0, "What the product of the maps is multiplied by")}
)
MOST_MORE = 8
"""Factors beside p and q, and factors of a peak."""
_LEAST_MATT = 0.1
_LEAST_PEAK, _MOST_PEAK = 0.05, 0.8

Term = tuple[Floats, tuple[MapFactor, ...]]
"""α (3,) in 1/sr and the factors by which it is multiplied."""


@dataclass(frozen=True)
class MapSampler:
    """A sampling map: ``share`` of the mixture, ``density`` (n, n) or (rings,), ``mirrored`` at it or not."""

    share: float
    density: Floats
    mirrored: bool


@dataclass(frozen=True, eq=False)
class Factored:
    """f_r = ``alpha`` p(wo) q(h) p(wi) Π ``more`` + Π ``peak``, in 1/sr.

    Attributes
    ----------
    p, q
        Maps of the light's and the view's direction and of the half vector, each of a size of its own: (n, n, 3)
        parabolic, or (n, 3) over the radius alone, r = tan(θ/2), texel i at (i + ½)/n. Linear working space, finite,
        not negative, kept as float32; the first row of a parabolic one is that of the least t.
    alpha
        (3,), or one number for all channels, 0 to 10⁶.
    source
        Where the data come from, for the user.
    facts
        What the reader learned from the file, for the user; ``largest``: the largest sample that was factored, 1/sr.
    more
        Further factors of the product.
    peak
        Factors of what is added: the specular part, clamped off before the rest was factored (section 4.2). Empty:
        nothing is added.
    logarithmic
        Whether p and q are interpolated as logarithms; they are then over 0.

    Raises
    ------
    ValueRangeError
        A map has no such form, or holds a number that cannot be; the message names it.
    """

    p: Singles
    q: Singles
    alpha: npt.ArrayLike = (1.0, 1.0, 1.0)
    source: str = ""
    facts: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    more: tuple[MapFactor, ...] = ()
    peak: tuple[MapFactor, ...] = ()
    logarithmic: bool = False
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    # Nothing in the form keeps a product of maps from sending back more than it gets.
    energy_conserving: ClassVar[bool] = False

    def __post_init__(self) -> None:
        for name in ("p", "q"):
            values = check_map(getattr(self, name), name)
            if self.logarithmic and not (values > 0.0).all():
                raise ValueRangeError(name, "a map between whose logarithms is interpolated holds a 0")
            object.__setattr__(self, name, values)
        object.__setattr__(self, "alpha", rgb(self.alpha, "alpha", PARAMETERS["alpha"]))
        for name in ("more", "peak"):
            object.__setattr__(self, name, tuple(getattr(self, name)))
            if len(getattr(self, name)) > MOST_MORE:
                raise ValueRangeError(name, f"expected at most {MOST_MORE} factors")

    @classmethod
    def from_functions(
        cls, p: Callable[[Floats], Floats], q: Callable[[Floats], Floats], size: int = 64
    ) -> Factored:
        """Return the product of two functions of directions (..., 3), each giving (..., 3), at the texels' centres.

        Texels outside of the hemisphere take the value of the horizon nearest to them.
        """
        where = texel_directions(size)
        return cls(np.asarray(p(where), np.float32), np.asarray(q(where), np.float32))

    @cached_property
    def terms(self) -> tuple[Term, ...]:
        """The products of the sum: p twice, q and ``more``, times α; and ``peak``, where there is one."""
        around_p = ("wi", "wo") if self.p.ndim == 3 else ("|wi|", "|wo|")
        about_h = "h" if self.q.ndim == 3 else "|h|"
        body = (
            *(MapFactor(name, self.p, self.logarithmic, "p") for name in around_p),
            MapFactor(about_h, self.q, self.logarithmic, "q"),
            *self.more,
        )
        found: list[Term] = [(np.asarray(self.alpha, np.float64), body)]
        if self.peak:
            found.append((np.ones(3), self.peak))
        return tuple(found)

    @property
    def reciprocal(self) -> bool:
        """Whether exchanging light and view changes nothing: each map over one is there over the other."""
        factors = [factor for _, term in self.terms for factor in term]
        of_light, of_view = (
            Counter(factor.values.tobytes() for factor in factors if factor.projection in names)
            for names in (("wi", "|wi|"), ("wo", "|wo|"))
        )
        return of_light == of_view

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
        light, view = wi[above], wo[above]
        found = np.zeros(wi.shape)
        found[above] = sum(_product(term, light, view) for term in self.terms)
        return found

    def sample(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return directions (..., 3) for ``u`` (..., 3): matt, of the light's map, or mirrors of the half vector's."""
        return mixture.sample(self._parts, wo, u)

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle."""
        return mixture.pdf(self._parts, wi, wo)

    @cached_property
    def samplers(self) -> tuple[MapSampler, ...]:
        """The sampling maps, weighted by their unevenness; the remaining share is diffuse."""
        wanted = [
            (factor, factor.projection in HALF_PROJECTIONS)
            for factor in self.terms[0][1]
            if factor.projection in (*LIGHT_PROJECTIONS, *HALF_PROJECTIONS)
        ]
        uneven = [unevenness(factor) for factor, _ in wanted]
        total = sum(uneven)
        of_body = (1.0 - _LEAST_MATT) / total if total > 1e-6 else 0.0
        found = [
            MapSampler(of_body * amount, build_density(factor), mirrored)
            for (factor, mirrored), amount in zip(wanted, uneven, strict=True)
            if of_body * amount > 0.0
        ]
        peak = next((factor for factor in self.peak if factor.projection in HALF_PROJECTIONS), None)
        if peak is None:
            return tuple(found)
        density = build_density(peak)
        share = self._peak_share(density)
        body = [MapSampler(one.share * (1.0 - share), one.density, one.mirrored) for one in found]
        return (*body, MapSampler(share, density, mirrored=True))

    def _peak_share(self, density: Floats) -> float:
        """Return the peak's fraction of the light reflected at 45°, from a few quasi-random numbers."""
        count = 1024
        u = np.stack(
            ((np.arange(count) + 0.5) / count, (np.arange(count) * 0.6180339887498949) % 1.0), axis=-1
        )
        wo = np.broadcast_to(spherical(0.25 * np.pi, 0.3), (count, 3))
        matt = warps.cosine_hemisphere(u)
        body = float((_product(self.terms[0], matt, wo) @ LUMINANCE).mean()) * np.pi
        wi = _mirrored_above(wo, sample_directions(density, u))
        keep = wi[:, 2] > 0.0
        h = warps.half_vector(wi[keep], wo[keep])
        pdf = warps.mirrored_pdf(direction_density(density, h), wo[keep], h)
        added = (
            (_product(self.terms[1], wi[keep], wo[keep]) @ LUMINANCE) * wi[keep, 2] / np.maximum(pdf, 1e-30)
        )
        peak = float(added.sum()) / count
        return float(np.clip(peak / max(peak + body, 1e-30), _LEAST_PEAK, _MOST_PEAK))

    @cached_property
    def _parts(self) -> list[mixture.MixturePart]:
        parts = [mixture.diffuse(max(1.0 - sum(one.share for one in self.samplers), 0.0))]
        for one in self.samplers:
            if one.mirrored:
                draw, density = partial(_draw_half, one.density), partial(_half_density, one.density)
            else:
                draw, density = partial(_draw_light, one.density), partial(_light_density, one.density)
            parts.append(mixture.MixturePart(one.share, draw, density))
        return parts


def _product(term: Term, wi: Floats, wo: Floats) -> Floats:
    scale, factors = term
    found = np.broadcast_to(scale, wi.shape).copy()
    for factor in factors:
        found *= factor.at(wi, wo)
    return found


def _draw_light(density: Floats, _wo: Floats, u: Floats) -> Floats:
    return sample_directions(density, u)


def _light_density(density: Floats, wi: Floats, _wo: Floats) -> Floats:
    return direction_density(density, wi)


def _draw_half(density: Floats, wo: Floats, u: Floats) -> Floats:
    return _mirrored_above(wo, sample_directions(density, u))


def _half_density(density: Floats, wi: Floats, wo: Floats) -> Floats:
    h = warps.half_vector(wi, wo)
    return warps.mirrored_pdf(direction_density(density, h), wo, h)


def _mirrored_above(wo: Floats, h: Floats) -> Floats:
    """Mirror views at half vectors; those below the horizon are discarded."""
    return np.where(h[:, 2:] > 0.0, warps.mirror_at(wo, h), np.array([0.0, 0.0, -1.0]))

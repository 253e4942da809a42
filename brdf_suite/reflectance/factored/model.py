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
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats, Singles
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import spherical
from brdf_suite.geometry.factor_words import Factor
from brdf_suite.geometry.parabolic import texel_directions
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.factored.map import (
    HALF_PROJECTIONS,
    LIGHT_PROJECTIONS,
    MapFactor,
    build_density,
    check_map,
    direction_density,
    sample_directions,
    unevenness,
)
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

    def draw(self, wo: Floats, u: Floats) -> Floats:
        """Return directions to the light (n, 3) for views (n, 3) and ``u`` (n, 2); a half vector below gives -z."""
        w = sample_directions(self.density, u)
        return np.where(w[:, 2:] > 0.0, warps.mirror_at(wo, w), [0.0, 0.0, -1.0]) if self.mirrored else w

    def pdf(self, wi: Floats, wo: Floats) -> Floats:
        """Return the density (n,) of :meth:`draw` per solid angle."""
        if not self.mirrored:
            return direction_density(self.density, wi)
        h = warps.half_vector(wi, wo)
        return warps.mirrored_pdf(direction_density(self.density, h), wo, h)


@dataclass(frozen=True, eq=False)
class Factored(mixture.MixtureSampled):
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
        mirrors = MapSampler(1.0, build_density(peak), mirrored=True)
        share = self._peak_share(mirrors)
        body = [replace(one, share=one.share * (1.0 - share)) for one in found]
        return (*body, replace(mirrors, share=share))

    def _peak_share(self, mirrors: MapSampler) -> float:
        """Return the peak's fraction of the light reflected at 45°, from a few quasi-random numbers."""
        count = 1024
        u = np.stack(
            ((np.arange(count) + 0.5) / count, (np.arange(count) * 0.6180339887498949) % 1.0), axis=-1
        )
        wo = np.broadcast_to(spherical(0.25 * np.pi, 0.3), (count, 3))
        matt = warps.cosine_hemisphere(u)
        body = float((_product(self.terms[0], matt, wo) @ LUMINANCE).mean()) * np.pi
        wi = mirrors.draw(wo, u)
        above = wi[:, 2] > 0.0
        wi, wo = wi[above], wo[above]
        pdf = np.maximum(mirrors.pdf(wi, wo), 1e-30)
        peak = float(((_product(self.terms[1], wi, wo) @ LUMINANCE) * wi[:, 2] / pdf).sum()) / count
        return float(np.clip(peak / max(peak + body, 1e-30), _LEAST_PEAK, _MOST_PEAK))

    @cached_property
    def _parts(self) -> list[mixture.MixturePart]:
        matt = mixture.diffuse(max(1.0 - sum(one.share for one in self.samplers), 0.0))
        return [matt, *(mixture.MixturePart(one.share, one.draw, one.pdf) for one in self.samplers)]


def _product(term: Term, wi: Floats, wo: Floats) -> Floats:
    scale, factors = term
    found = np.broadcast_to(scale, wi.shape).copy()
    for factor in factors:
        found *= factor.at(wi, wo)
    return found


_LIGHTS_AND_VIEWS = (("wi", "wo"), ("|wi|", "|wo|"))


def build_factored(
    factors: tuple[Factor, ...],
    maps: Mapping[str, Singles],
    alpha: npt.ArrayLike,
    *,
    peak: tuple[Factor, ...] = (),
    logarithmic: bool = True,
    source: str = "",
    facts: Mapping[str, Any] | None = None,
) -> Factored:
    """Return the product of ``factors`` and the added one of ``peak``, from maps (n, 3) or (n, n, 3) by their names.

    A map over both light and view becomes p, one over the half vector q; the others stand beside them.

    Raises
    ------
    ValueRangeError
        A map is missing or is not of the form that its factors read.
    """
    kept: dict[str, Singles] = {}
    for name, values in maps.items():
        kept[name] = np.array(values, np.float32, order="C")
        kept[name].flags.writeable = False
    rest = list(factors)
    p = q = np.ones((2, 3), np.float32)
    for light, view in _LIGHTS_AND_VIEWS:
        pair = next(
            (
                (one, other)
                for one in rest
                for other in rest
                if one.name == other.name and (one.projection.name, other.projection.name) == (light, view)
            ),
            None,
        )
        if pair is not None and len(rest) == len(factors):
            p = kept[pair[0].name]
            # One of each: a map that is read twice by the light stays once beside p.
            for factor in pair:
                rest.remove(factor)
    half = next((factor for factor in rest if factor.projection.name in ("h", "|h|")), None)
    if half is not None:
        q = kept[half.name]
        rest.remove(half)

    def read(some: list[Factor]) -> tuple[MapFactor, ...]:
        return tuple(
            MapFactor(factor.projection.name, kept[factor.name], logarithmic, factor.name) for factor in some
        )

    return Factored(
        p,
        q,
        alpha,
        source=source,
        facts=facts or {},
        more=read(rest),
        peak=read(list(peak)),
        logarithmic=logarithmic,
    )


def factored_paint_reflectance(paint: FactoredPaint) -> Factored:
    """Return the reflectance of a factored paint without its clearcoat; its textures are read.

    Raises
    ------
    FileError, DocumentError
        The textures cannot be read, or are not the ones that are meant.
    """
    # What reads EXR files is loaded for such a paint alone.
    from brdf_suite.documents.factor_textures import read_textures

    factors, peak = paint.terms
    facts: dict[str, Any] = {"format": "product of textures", "factors": paint.factors}
    if paint.peak:
        facts["peak"] = paint.peak
    if paint.largest > 0.0:
        facts["largest"] = paint.largest
    return build_factored(
        factors,
        read_textures(paint),
        paint.alpha,
        peak=peak,
        logarithmic=paint.logarithmic,
        source=paint.source,
        facts=facts,
    )

"""Split of a reflectance into a broad part, lit by the lights, and narrow lobes, sampled or mirrored (section 5.1.3).

A sum of lobes is cut by their widths; a table by its values (:mod:`.table_split`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Square, Vector
from brdf_suite.reference.bsdfs.lobe_weights import LobeWeightsTerm
from brdf_suite.reference.bsdfs.table import HalfAngleTable, MeasuredTerm
from brdf_suite.reference.bsdfs.terms import CoatLobeTerm, FacetLobe, SumTerm, UnderCoat, luminance
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.lobes import (
    LARGEST_MIRROR_SLOPE,
    LARGEST_SLOPE,
    FacetGlint,
    MirrorLobe,
    WideFacets,
)
from brdf_suite.reference.raytraced.numbers import in_cube
from brdf_suite.reference.raytraced.table_split import TableSplit, split_by_values

_MIRROR_NODES, _MIRROR_SAMPLES = 64, 1024


@dataclass(frozen=True, eq=False)
class Split:
    """``broad`` and ``narrow`` of one material; f_r is the sum of all."""

    broad: BroadPart
    narrow: tuple[Any, ...]

    @property
    def sunlit(self) -> tuple[Any, ...]:
        """Narrow lobes lit by suns, whose rays exclude suns."""
        return tuple(lobe for lobe in self.narrow if lobe.is_sunlit)

    def narrow_value(self, light: Vector, view: Vector, *, sunlit: bool = False) -> Colour:
        """Return f_r of the narrow lobes, or of those that suns light, 1/sr."""
        total: Colour = mi.Color3f(0.0)
        for lobe in self.sunlit if sunlit else self.narrow:
            total += lobe.term.eval(light, view)
        return total

    def sample(self, view: Vector, choice: Real, u: Square) -> tuple[Vector, Colour, Real]:
        """Return directions to the light, f_r cosθ over the density, and 1 where the ray finds suns as well, else 0.

        One lobe is drawn for each, chosen by its share. The weight is 0 where the direction lies below the horizon.
        """
        if not self.narrow:
            return mi.Vector3f(0.0, 0.0, 1.0), mi.Color3f(0.0), mi.Float(1.0)
        shares = [lobe.share(view) for lobe in self.narrow]
        total = shares[0]
        for share in shares[1:]:
            total = total + share
        rest = choice * total
        light, weight, suns = mi.Vector3f(0.0), mi.Color3f(0.0), mi.Float(1.0)
        left = mi.Bool(True)
        for index, (lobe, share) in enumerate(zip(self.narrow, shares, strict=True)):
            chosen = left & (rest < share) if index + 1 < len(self.narrow) else left
            drawn = lobe.sample(view, u)
            above = (drawn.z > 0.0) & (view.z > 0.0)
            pdf = lobe.pdf(drawn, view) * share / total
            value = lobe.term.eval(drawn, view) * (drawn.z / pdf)
            light = dr.select(chosen, drawn, light)
            weight = dr.select(chosen, dr.select(above & (pdf > 0.0), value, 0.0), weight)
            if lobe.is_sunlit:
                suns = dr.select(chosen, 0.0, suns)
            left &= ~chosen
            rest = rest - share
        return light, weight, suns


@dataclass(frozen=True, eq=False)
class MirroredSplit(Split):
    """A split whose narrow lobes are replaced by mirror reflection with their whole albedo."""

    albedo: Any

    @classmethod
    def of(cls, split: Split) -> MirroredSplit:
        """Return it with the lobes' albedo over the cosine of the view, from 64 angles of 1,024 samples."""
        lane = dr.arange(mi.UInt32, _MIRROR_NODES * _MIRROR_SAMPLES)
        cosine = (mi.Float(lane // _MIRROR_SAMPLES) + 0.5) / _MIRROR_NODES
        view = mi.Vector3f(dr.sqrt(dr.maximum(1.0 - cosine * cosine, 0.0)), 0.0, cosine)
        choice, u = in_cube(lane % _MIRROR_SAMPLES, mi.UInt32(0))
        _, weight, _ = split.sample(view, choice, u)
        means = np.array(weight).reshape(3, _MIRROR_NODES, _MIRROR_SAMPLES).mean(axis=2)
        table = mi.Float(np.ascontiguousarray(means.T, np.float32).ravel())
        dr.eval(table)
        return cls(split.broad, split.narrow, table)

    @property
    def sunlit(self) -> tuple[Any, ...]:
        """None: mirrored rays hit suns as well."""
        return ()

    def sample(self, view: Vector, _choice: Real, _u: Square) -> tuple[Vector, Colour, Real]:
        """Return the mirror direction, the lobes' albedo for the view, and 1: the ray finds suns as well."""
        place = dr.clip(view.z * _MIRROR_NODES - 0.5, 0.0, _MIRROR_NODES - 1.0)
        low = dr.minimum(mi.UInt32(place), _MIRROR_NODES - 2)
        first, second = (dr.gather(mi.Color3f, self.albedo, low + k) for k in (0, 1))
        return d.mirrored(view), dr.fma(place - mi.Float(low), second - first, first), mi.Float(1.0)


@dataclass(frozen=True, eq=False)
class BroadPart:
    """The sum of a material's broad parts; zero without any."""

    parts: tuple[Any, ...]

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        total: Colour = mi.Color3f(0.0)
        for part in self.parts:
            total += part.eval(light, view)
        return total

    def lit(self, light: Vector, view: Vector, spread: Real) -> Colour:
        """Return f_r for a light whose directions have ``spread``, radians along an axis."""
        total: Colour = mi.Color3f(0.0)
        for part in self.parts:
            total += _lit(part, light, view, spread)
        return total


@dataclass(frozen=True, eq=False)
class ThroughCoat:
    """A part of a base seen through the coat."""

    coated: UnderCoat
    part: Any

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return self.part.eval(light, view) * self.coated.factor(light, view)

    def lit(self, light: Vector, view: Vector, spread: Real) -> Colour:
        """Return f_r for a light whose directions have ``spread``, radians along an axis."""
        return _lit(self.part, light, view, spread) * self.coated.factor(light, view)


def _lit(part: Any, light: Vector, view: Vector, spread: Real) -> Colour:
    return part.lit(light, view, spread) if hasattr(part, "lit") else part.eval(light, view)


@dataclass(frozen=True, eq=False)
class PartOfWeights(LobeWeightsTerm):
    """A subset of fitted lobes, with the gains common to all of them."""

    whole: LobeWeightsTerm | None = None

    @classmethod
    def of(cls, whole: LobeWeightsTerm, kd: Any, kept: Any) -> PartOfWeights:
        """Return the part with the diffuse weights ``kd`` and the lobes that are ``kept`` (m, 1)."""
        known = {f.name: getattr(whole, f.name) for f in fields(whole) if f.init}
        return cls(**{**known, "kd": kd, "kdd": whole.kdd * kept, "kg": whole.kg * kept}, whole=whole)

    def _gains(self, cosine: Real) -> tuple[Real, Colour]:
        return super()._gains(cosine) if self.whole is None else self.whole._gains(cosine)


def split(term: Any, *, mirror: bool = False, tables: TableSplit = "clamp") -> Split:
    """Return a term cut in two; ``mirror``: its narrow lobes are mirrored, and then fewer lobes are narrow."""
    largest = LARGEST_MIRROR_SLOPE if mirror else LARGEST_SLOPE
    broad, narrow = _parts(term, largest, tables, mirror)
    whole = Split(BroadPart(tuple(broad)), tuple(narrow))
    return MirroredSplit.of(whole) if mirror and narrow else whole


def _parts(term: Any, largest: float, tables: TableSplit, mirror: bool) -> tuple[list[Any], list[Any]]:
    """Return the broad terms and the narrow lobes of a term."""
    if isinstance(term, SumTerm):
        pieces = [_parts(one, largest, tables, mirror) for one in term.terms]
        return [b for broad, _ in pieces for b in broad], [n for _, narrow in pieces for n in narrow]
    if isinstance(term, CoatLobeTerm):
        if term.roughness > largest:
            return [term], []
        return [], [FacetGlint(1.0, term.roughness, term.ior, term)]
    if isinstance(term, FacetLobe):
        if term.slope > largest:
            return [WideFacets(term)], []
        share = 4.0 * term.scale * luminance(term.ks)
        return [], [FacetGlint(share, term.slope, term.ior, term)]
    if isinstance(term, UnderCoat):
        broad, narrow = _parts(term.base, largest, tables, mirror)
        seen = [ThroughCoat(term, part) for part in broad]
        lobes = [replace(lobe, term=ThroughCoat(term, lobe.term)) for lobe in narrow]
        coat_broad, coat_narrow = _parts(term.coat, largest, tables, mirror)
        return [*seen, *coat_broad], [*lobes, *coat_narrow]
    if isinstance(term, LobeWeightsTerm):
        return _of_lobe_weights(term, largest)
    if isinstance(term, (HalfAngleTable, MeasuredTerm)):
        return split_by_values(term, tables, mirror=mirror)
    return [term], []


def _of_lobe_weights(term: LobeWeightsTerm, largest: float) -> tuple[list[Any], list[Any]]:
    """Lobes about the mirror direction are four times as steep there as their facets are about the normal."""
    steepest = 2.0 / largest**2 / 4.0
    sharp = term.exponents > steepest
    used = np.flatnonzero(sharp & ((term.kdd > 0.0).any(axis=1) | (term.kg > 0.0).any(axis=1)))
    if not len(used):
        return [term], []
    keep = (~sharp)[:, None]
    broad = PartOfWeights.of(term, term.kd, keep)
    lobes = []
    for k in used.tolist():
        only = (np.arange(len(term.exponents)) == k)[:, None]
        lobe = PartOfWeights.of(term, 0.0 * term.kd, only)
        share = luminance((term.kdd + term.kg)[k]) * 2.0 * math.pi / (float(term.exponents[k]) + 1.0)
        lobes.append(MirrorLobe(share, float(term.exponents[k]), lobe))
    return [broad], lobes

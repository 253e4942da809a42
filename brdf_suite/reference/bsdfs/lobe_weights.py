"""Lobes of the real-time picture as a BSDF term: stock materials, and any fit, integrated without look-ups.

With a paint's fitted weights this separates the two errors of the real-time picture: what the fit costs (against the
paint itself) and what looking lobes up in prefiltered maps costs (against the real-time picture).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.geometry.fresnel import fresnel_dielectric, sheet_reflectance
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Vector
from brdf_suite.reference.bsdfs.terms import AboutMirror, Diffuse, Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi


@dataclass(frozen=True, eq=False)
class LobeWeightsTerm:
    """f_r (N·L) = KD (N·L) + (N·L) Σ KDD_i (R·V)^E_i + Σ KG_i (R·V)^E_i, with the gains of the angle.

    Attributes
    ----------
    exponents, kd, kdd, kg
        (m,), (3,), (m, 3), (m, 3): as :class:`brdf_suite.realtime.values.MaterialWeights` has them.
    coat
        ``none``, ``dielectric``, ``facets``, ``metal`` or ``sheet``: how the gains follow the angle of the view.
    theta_fit_rad, ior
        Incidence of the fit; index of the coat.
    raised
        Whether the gains follow the angle at all.
    transmittance
        Above 0 for a pane: :meth:`passing` of the paths that meet it go through it, chosen by chance before, and the
        others carry what it mirrors for all.
    """

    exponents: Floats
    kd: Floats
    kdd: Floats
    kg: Floats
    coat: str
    theta_fit_rad: float
    ior: float
    raised: bool = True
    transmittance: float = 0.0
    _lobes: tuple[int, ...] = field(init=False)

    def __post_init__(self) -> None:
        used = np.flatnonzero((self.kdd > 0.0).any(axis=1) | (self.kg > 0.0).any(axis=1))
        object.__setattr__(self, "_lobes", tuple(used.tolist()))

    @cached_property
    def _solid(self) -> Floats:
        return np.asarray(2.0 * math.pi / (self.exponents + 1.0))

    @property
    def samplers(self) -> Sequence[Sampler]:
        """One diffuse, and one for each lobe with a weight."""
        y = (self.kdd + self.kg) @ LUMINANCE * self._solid
        matt = math.pi * float(self.kd @ LUMINANCE)
        lobes = [AboutMirror(float(y[k]), float(self.exponents[k])) for k in self._lobes]
        least = 0.05 * (matt + sum(lobe.weight for lobe in lobes))
        return (Diffuse(max(matt, least, 1e-4)), *lobes)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        away = d.one_minus_mirror_cosine(light, view)
        base, gloss = d.colour(self.kd.tolist()), mi.Color3f(0.0)
        for k in self._lobes:
            lobe = d.mirror_lobe(away, float(self.exponents[k]))
            if self.kdd[k].any():
                base += d.colour(self.kdd[k].tolist()) * lobe
            if self.kg[k].any():
                gloss += d.colour(self.kg[k].tolist()) * lobe
        base_gain, gloss_gain = self._gains(view.z)
        return base * base_gain + gloss * (gloss_gain / light.z)

    def passing(self, cosine: Real) -> Real:
        """Return which share of the light passes a pane at this cosine of the view."""
        return d.number(self.transmittance) * (1.0 - self._mirrored(cosine))

    def _mirrored(self, cosine: Real) -> Real:
        _, gloss = self._raised(cosine)
        return dr.minimum(gloss.y * d.number(float((self.kg.T @ self._solid)[1])), 1.0)

    def _gains(self, cosine: Real) -> tuple[Real, Colour]:
        base, gloss = self._raised(cosine)
        if self.transmittance > 0.0:
            gloss = gloss / dr.maximum(1.0 - self.passing(cosine), 1e-6)
        return base, gloss

    def _raised(self, cosine: Real) -> tuple[Real, Colour]:
        """Return the shader's ``fresnel_gains``; see its derivation there."""
        one = mi.Float(1.0)
        if not self.raised or self.coat == "none":
            return one, mi.Color3f(1.0)
        albedo = self.kg.T @ self._solid
        if self.coat == "metal":
            s = dr.clip(1.0 - cosine, 0.0, 1.0)
            rise = s * dr.square(dr.square(s))
            g = d.colour(np.maximum(albedo, 1e-4).tolist())
            return one, (g + dr.maximum(1.0 - g, 0.0) * rise) / g
        f = d.fresnel(cosine, self.ior)
        mirrored = fresnel_dielectric
        if self.coat == "sheet":
            f, mirrored = 2.0 * f / (1.0 + f), sheet_reflectance
        at_fit = float(mirrored(math.cos(self.theta_fit_rad), self.ior))
        limit = max(1.0 / float(albedo.max()), 1.0) if albedo.max() > 0.0 else 1.0
        gloss = dr.minimum(f * d.number(1.0 / at_fit), d.number(limit)) if at_fit > 0.0 else one
        base = dr.square((1.0 - f) * d.number(1.0 / (1.0 - at_fit))) if self.coat == "dielectric" else one
        return base, mi.Color3f(gloss)

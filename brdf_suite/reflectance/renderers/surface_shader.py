"""A surface shader as MaterialX evaluates it: Standard Surface, OpenPBR Surface, glTF PBR.

    f_r = (1 - w_c E_c(wo)) a [ (1 - μ) ((1 - w_s E_s(wo)) B + w_s t S) + μ w_m M ] + w_c C,

B the diffuse base (Oren and Nayar 1994, or its energy-compensated form of Fujii that OpenPBR takes) and the colour of
the subsurface; S, M and C lobes of :mod:`brdf_suite.reflectance.renderers.facet_lobe` with the multiple scattering of
Turquin 2019: S a dielectric, or after Schlick with any f0 and f90, M a metal, C the coat; E their albedos, the mean
over the channels; a what the coat absorbs. Layers take light from those below on the way to the view only, so the
models are not reciprocal. The formulas of M's Fresnel reflectance:

- OpenPBR (Kutz, Hašan and Edmondson 2021): F0 + (1 - F0)(1 - c)⁵ - b c (1 - c)⁶, with b such that F at cos θ = 1/7 is
  Schlick's times the colour F82;
- Standard Surface: a conductor of index n + ik that has the colour at normal incidence and the edge colour
  (Gulbrandsen 2014).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.renderers.facet_lobe import RendererLobe, normal_reflectance

Rgb = tuple[float, float, float]

BLACK: Rgb = (0.0, 0.0, 0.0)
WHITE: Rgb = (1.0, 1.0, 1.0)

# Fujii's constants: the share that the rough lobe loses, and that of its mean.
_FUJII_1 = 0.5 - 2.0 / (3.0 * math.pi)
_FUJII_2 = 2.0 / 3.0 - 28.0 / (15.0 * math.pi)
_EDGE_COSINE = 1.0 / 7.0
_TINY = 1e-6
_LARGEST_METAL = 0.99  # MaterialX limits the colour of a conductor here


@dataclass(frozen=True)
class SurfaceShader(mixture.MixtureSampled):
    """Parameters in linear Rec. 709.

    Attributes
    ----------
    base, base_roughness, compensated
        Albedo (3,) and roughness 0 to 1 of the diffuse base, and whether it is Fujii's energy-compensated form.
    subsurface
        Albedo (3,) of the part below the surface, which is taken as Lambertian.
    specular, specular_f0, specular_f90, specular_ior, tint, alpha
        w_s; f0 and f90 (3,) of S; the index of the dielectric that its rise follows, 1 for Schlick's; t; and α, the
        square of the shader's roughness, which M shares.
    metalness, metal, metal_f0, metal_edge, conductor
        μ, w_m, the colour of M along the normal and its edge colour, and whether it is a conductor.
    attenuation
        a.
    coat, coat_ior, coat_alpha
        w_c, index and α of C.
    source, facts
        Where the parameters come from, and what the reader learned, for the user.
    """

    base: Rgb = BLACK
    base_roughness: float = 0.0
    compensated: bool = False
    subsurface: Rgb = BLACK
    specular: float = 0.0
    specular_f0: Rgb = (0.04, 0.04, 0.04)
    specular_f90: Rgb = WHITE
    specular_ior: float = 1.0
    tint: Rgb = WHITE
    alpha: float = 0.04
    metalness: float = 0.0
    metal: float = 1.0
    metal_f0: Rgb = WHITE
    metal_edge: Rgb = WHITE
    conductor: bool = False
    attenuation: Rgb = WHITE
    coat: float = 0.0
    coat_ior: float = 1.5
    coat_alpha: float = 0.01
    source: str = ""
    facts: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))

    reciprocal: ClassVar[bool] = False
    energy_conserving: ClassVar[bool] = False
    isotropic: ClassVar[bool] = True
    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, working space, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
        value = np.zeros((len(wi), 3))
        if above.any():
            value[above] = self._eval_above(wi[above], wo[above]) @ REC709_TO_WORKING.T
        return np.maximum(value, 0.0)

    def _eval_above(self, wi: Floats, wo: Floats) -> Floats:
        """Return f_r (n, 3), linear Rec. 709, of directions above the horizon."""
        cos_o = wo[:, 2]
        value = np.zeros((len(wi), 3))
        if self.metalness < 1.0:
            matt = self._base_term(wi, wo) + np.asarray(self.subsurface) / math.pi
            if self.specular > 0.0:
                f0, f90 = np.asarray(self.specular_f0), np.asarray(self.specular_f90)
                left = 1.0 - self.specular * self._lobe.albedo(f0, cos_o, f90).mean(axis=-1, keepdims=True)
                shine = self._lobe.sum_terms(self._lobe.terms(wi, wo), f0, cos_o, f90)
                matt = left * matt + self.specular * np.asarray(self.tint) * shine
            value += (1.0 - self.metalness) * matt
        if self.metalness > 0.0:
            fresnel = self.metal_fresnel(0.5 * np.linalg.norm(wi + wo, axis=-1))
            lobe = self._lobe.terms(wi, wo)[:, :1]
            value += (
                self.metalness
                * self.metal
                * lobe
                * fresnel
                * (1.0 + fresnel * self._lobe.lost(cos_o)[:, None])
            )
        value *= np.asarray(self.attenuation)
        if self.coat > 0.0 and self.coat_ior > 1.0:
            f0 = np.array([normal_reflectance(self.coat_ior)])
            value *= 1.0 - self.coat * self._coat.albedo(f0, cos_o)
            value += self.coat * self._coat.sum_terms(self._coat.terms(wi, wo), f0, cos_o)
        return value

    def _base_term(self, wi: Floats, wo: Floats) -> Floats:
        """Return f_r (n, 3) of the diffuse base."""
        colour = np.asarray(self.base)
        rough = self.base_roughness
        if rough == 0.0:
            return np.broadcast_to(colour / math.pi, (len(wi), 3))
        cos_i, cos_o = wi[:, 2], wo[:, 2]
        s = np.einsum("ni,ni->n", wi, wo) - cos_i * cos_o
        over = s / np.maximum(cos_i, cos_o)
        if not self.compensated:
            square = rough * rough
            a = 1.0 - 0.5 * square / (square + 0.33)
            b = 0.45 * square / (square + 0.09)
            return np.asarray((a + b * over.clip(0.0))[:, None] * colour / math.pi)
        a = 1.0 / (1.0 + _FUJII_1 * rough)
        single = a * (1.0 + rough * np.where(s > 0.0, over, s))[:, None] * colour
        mean = a * (1.0 + _FUJII_2 * rough)
        again = colour * colour * mean / (1.0 - colour * max(0.0, 1.0 - mean))
        lost_i, lost_o = (np.maximum(1.0 - self._fujii_albedo(c), _TINY) for c in (cos_i, cos_o))
        return np.asarray((single + again * (lost_i * lost_o / max(_TINY, 1.0 - mean))[:, None]) / math.pi)

    def _fujii_albedo(self, cosine: Floats) -> Floats:
        a = 1.0 / (1.0 + _FUJII_1 * self.base_roughness)
        sine = np.sqrt((1.0 - cosine * cosine).clip(0.0))
        g = sine * (np.arccos(cosine.clip(-1.0, 1.0)) - sine * cosine)
        g = g + 2.0 * ((sine / np.maximum(cosine, _TINY)) * (1.0 - sine**3) - sine) / 3.0
        return np.asarray(a + self.base_roughness * a * g / math.pi)

    def metal_fresnel(self, cosine: Floats) -> Floats:
        """Return F (n, 3) of the metal."""
        f0, edge = np.asarray(self.metal_f0), np.asarray(self.metal_edge)
        c = cosine.clip(0.0, 1.0)[:, None]
        if not self.conductor:
            at_edge = f0 + (1.0 - f0) * (1.0 - _EDGE_COSINE) ** 5
            bend = at_edge * (1.0 - edge) / (_EDGE_COSINE * (1.0 - _EDGE_COSINE) ** 6)
            return np.asarray((f0 + (1.0 - f0) * (1.0 - c) ** 5 - bend * c * (1.0 - c) ** 6).clip(0.0))
        f0 = np.minimum(f0, _LARGEST_METAL)
        root = np.sqrt(f0)
        n = (1.0 - edge) * (1.0 + root) / (1.0 - root) + edge * (1.0 - f0) / (1.0 + f0)
        k = np.sqrt(((f0 * (n + 1.0) ** 2 - (n - 1.0) ** 2) / (1.0 - f0)).clip(0.0))
        index = (n + 1j * k) ** 2
        t = np.sqrt(index - (1.0 - c * c))
        parts = ((c - t) / (c + t), (index * c - t) / (index * c + t))
        return np.asarray(0.5 * sum(np.abs(part) ** 2 for part in parts))

    @cached_property
    def _lobe(self) -> RendererLobe:
        return RendererLobe(self.alpha, self.specular_ior, "turquin")

    @cached_property
    def _coat(self) -> RendererLobe:
        return RendererLobe(self.coat_alpha, self.coat_ior, "turquin")

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        matt = (1.0 - self.metalness) * (max(self.base) + max(self.subsurface)) + 0.02
        lobe = (1.0 - self.metalness) * self.specular * (max(self.specular_f0) + 0.05)
        lobe += self.metalness * self.metal * max(self.metal_f0)
        coat = self.coat * 2.0 * normal_reflectance(self.coat_ior)
        return [
            mixture.diffuse(matt),
            mixture.ggx(lobe + 0.01, self.alpha),
            mixture.ggx(coat, self.coat_alpha),
        ]

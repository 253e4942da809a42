"""A matt layer and a GGX lobe under a clearcoat: glTF, OpenPBR and USD Preview Surface.

    f_r = (1 - E_c(wo)) [ (1 - E_s(wo)) d / π + t S(wi, wo) ] + C(wi, wo)

S and C lobes of :mod:`brdf_suite.reflectance.renderers.facet_lobe`, E_s and E_c their albedos. In glTF and OpenPBR
metalness is 0, which leaves the colour of the lobe free. Many programs know nothing but the metalness of USD Preview
Surface. It has one colour, d, for either the matt layer, below an uncoloured S, or a metal, which has no matt layer and
is S of f0 = d. Between the two, programs differ: MaterialX, Blender and Pixar's own renderer take three formulas.

| | glTF as Blender's Cycles evaluates it | OpenPBR by MaterialX | USD Preview Surface by MaterialX |
|---|---|---|---|
| S | f0 in three channels, rise of index 6, t = 1 | a dielectric of one f0; t is the colour | Schlick from R², or d |
| E_s | the largest channel | of t = 1 | of R² |
| C | index 1.5 | any index | Schlick; its R² is that of S, too |
| multiple scattering | Kulla and Conty | Turquin | Turquin |
| width of S | α | √(α² + 2 α_c²) for a coat of α_c | α |

Blender evaluates USD Preview Surface as MaterialX does, but for C, which follows the equations of Fresnel.

A metal rises after Schlick; MaterialX takes a conductor's curve, up to 7 % higher in dark channels. Layers take light
from those below on the way to the view only, so the models are not reciprocal.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import ClassVar, Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.renderers.facet_lobe import (
    Compensation,
    RendererLobe,
    index_of,
    normal_reflectance,
)

Kind = Literal["gltf", "openpbr", "usd"]
Rgb = tuple[float, float, float]

COMPENSATIONS: Mapping[Kind, Compensation] = MappingProxyType(
    {"gltf": "kulla_conty", "openpbr": "turquin", "usd": "turquin"}
)
GLTF_COAT_IOR = 1.5
"""The index of glTF's clearcoat, whatever the paint's."""
GLTF_LOBE_IOR = 6.0
"""The index of the lobe in ``KHR_materials_ior``: of a high one the reflectance rises late towards grazing, as that of
flakes below a coat does."""


def matt_term(wi: Floats, _wo: Floats) -> Floats:
    """Return 1 / π (n, 1): f_r of a white matt layer."""
    return np.full((len(wi), 1), 1.0 / math.pi)


@dataclass(frozen=True)
class CoatedFacets(mixture.MixtureSampled):
    """Parameters in linear Rec. 709, 0 to 1.

    Attributes
    ----------
    kind
        Whose formulas.
    diffuse
        d.
    specular
        f0 of the lobe; of OpenPBR t; USD does without.
    alpha
        Width of the lobe, as the square of the format's roughness.
    coat_ior, coat_alpha
        Index and width of the clearcoat.
    grey
        f0 of OpenPBR's dielectric, below 1; the other kinds do without. No lobe where it is 0.
    metal
        Whether USD's colour is that of a metal; the other kinds do without.
    in_blender
        Whether USD's coat is evaluated as in Blender.
    """

    kind: Kind
    diffuse: Rgb
    specular: Rgb
    alpha: float
    coat_ior: float = GLTF_COAT_IOR
    coat_alpha: float = 0.002
    grey: float = 0.0
    metal: bool = False
    in_blender: bool = False
    reciprocal: ClassVar[bool] = False
    energy_conserving: ClassVar[bool] = False
    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})

    @property
    def has_lobe(self) -> bool:
        """Whether there is anything but the matt layer below the coat."""
        if self.kind == "usd":
            return True
        return self.grey > 0.0 if self.kind == "openpbr" else max(self.specular) > 0.0

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, working space, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
        value = np.zeros((len(wi), 3))
        value[above] = self.sum_terms(self.terms(wi[above], wo[above]), wo[above, 2]) @ REC709_TO_WORKING.T
        return np.maximum(value, 0.0)

    def terms(self, wi: Floats, wo: Floats) -> Floats:
        """Return what depends on both directions (n, 7), whatever the colours are."""
        return np.concatenate((matt_term(wi, wo), self.lobe.terms(wi, wo), self.coat.terms(wi, wo)), axis=-1)

    def sum_terms(self, terms: Floats, cos_o: Floats) -> Floats:
        """Return f_r (n, 3), linear Rec. 709, of ``terms`` (n, 7), or what they integrate to, at the view's cosine."""
        base = self._sum_usd(terms, cos_o) if self.kind == "usd" else self._sum_two_colours(terms, cos_o)
        f0 = np.array([normal_reflectance(self.coat_ior)])
        left = 1.0 - self.coat.albedo(f0, cos_o)
        return np.asarray(left * base + self.coat.sum_terms(terms[:, 4:], f0, cos_o))

    def _sum_two_colours(self, terms: Floats, cos_o: Floats) -> Floats:
        matt = terms[:, :1] * np.asarray(self.diffuse)
        if not self.has_lobe:
            return np.asarray(matt)
        tint, f0 = np.ones(3), np.asarray(self.specular)
        if self.kind == "openpbr":
            tint, f0 = f0, np.array([self.grey])
        left = 1.0 - self.lobe.albedo(f0, cos_o).max(axis=-1)
        return np.asarray(left[:, None] * matt + tint * self.lobe.sum_terms(terms[:, 1:4], f0, cos_o))

    def _sum_usd(self, terms: Floats, cos_o: Floats) -> Floats:
        if self.metal:
            return self.lobe.sum_terms(terms[:, 1:4], np.asarray(self.diffuse), cos_o)
        f0 = np.array([normal_reflectance(self.coat_ior)])
        matt = (1.0 - self.lobe.albedo(f0, cos_o)) * terms[:, :1] * np.asarray(self.diffuse)
        return np.asarray(matt + self.lobe.sum_terms(terms[:, 1:4], f0, cos_o))

    @cached_property
    def lobe(self) -> RendererLobe:
        """The lobe between the matt layer and the coat, S."""
        if self.kind == "openpbr":
            alpha = min(1.0, math.sqrt(self.alpha**2 + 2.0 * self.coat_alpha**2))
            return RendererLobe(alpha, index_of(self.grey), "turquin")
        return RendererLobe(
            self.alpha, GLTF_LOBE_IOR if self.kind == "gltf" else 1.0, COMPENSATIONS[self.kind]
        )

    @cached_property
    def coat(self) -> RendererLobe:
        """The lobe of the clearcoat, C."""
        ior = 1.0 if self.kind == "usd" and not self.in_blender else self.coat_ior
        return RendererLobe(self.coat_alpha, ior, COMPENSATIONS[self.kind])

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        lobe = (self.grey if self.kind == "openpbr" else 1.0) * max(self.specular) + 0.05 * self.has_lobe
        lobe += self.metal * max(self.diffuse)
        coat = 0.02 + 2.0 * normal_reflectance(self.coat_ior)
        return [
            mixture.diffuse(max(self.diffuse) + 0.02),
            mixture.ggx(lobe, self.lobe.alpha),
            mixture.ggx(coat, self.coat_alpha),
        ]

"""A rough metal: GGX facets, Smith's height-correlated shadowing, Schlick's Fresnel from a colour, over a diffuse part.

    f_r = D G F / (4 cosθi cosθo) + f_ms + kd/π (1 - E(θi)) (1 - E(θo)) / (1 - Ē),
    D = α² / (π (cos²θh (α² - 1) + 1)²),    F(c) = f0 + (1 - f0) (1 - c)⁵.

G / (4 cosθi cosθo) = ½ / (cosθo √(α² + (1-α²) cos²θi) + cosθi √(α² + (1-α²) cos²θo)) (Walter et al. 2007,
Heitz 2014). f_ms is what comes back after several facets, E the albedo of all facets and Ē its mean over even light
(:mod:`~brdf_suite.reflectance.facet_albedo`). The diffuse part gets what the facets let through on the way in and out
(Ashikhmin, Premože and Shirley 2000; Kelemen and Szirmay-Kalos 2001), so that f0 = 1 or kd = 1 reflects all light.
``scattering`` "single" is the form without: f_ms = 0, E = F, and kd/π is not divided. Reciprocal. A metal has no single
real index, so Schlick's form with the colour along the normal is used, not that of a dielectric.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import SCATTERINGS, Scattering
from brdf_suite.documents.parameter import Parameter, check_choices, set_numbers
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.facet_albedo import FacetAlbedo, facet_albedo
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance, set_rgb
from brdf_suite.reflectance.models.half_vector_terms import HalfVectorTerms

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "kd": Parameter("Diffuse", "", 0.0, 1.0, 0.0, "Diffuse reflectance, linear Rec. 2020"),
        "f0": Parameter("Metal", "", 0.0, 1.0, 0.8, "Fresnel reflectance along the normal, linear Rec. 2020"),
        "alpha": Parameter("Roughness", "", 0.001, 1.0, 0.3, "GGX width α"),
    }
)


@dataclass(frozen=True, eq=False)
class Ggx(mixture.MixtureSampled):
    """GGX facets of colour ``f0`` and width ``alpha`` over a diffuse part ``kd``."""

    kd: npt.ArrayLike = 0.0
    f0: npt.ArrayLike = 0.8
    alpha: float = 0.3
    scattering: Scattering = "multiple"
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True
    energy_conserving: ClassVar[bool] = True

    def __post_init__(self) -> None:
        set_rgb(self, PARAMETERS, "kd", "f0")
        set_numbers(self, PARAMETERS, "alpha")
        check_choices(self, scattering=SCATTERINGS)

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        terms = HalfVectorTerms.of(wi, wo)
        cos_i, cos_o, a2 = terms.cos_i, terms.cos_o, self.alpha**2
        # cos²θh (α² - 1) + 1 = cos²θh (α² + tan²θh), exact beside the normal.
        cos2 = 1.0 / (1.0 + terms.tan2_h)
        facets = a2 / (math.pi * (cos2 * (a2 + terms.tan2_h)) ** 2)
        seen = cos_o * np.sqrt(a2 + (1.0 - a2) * cos_i * cos_i)
        seen = seen + cos_i * np.sqrt(a2 + (1.0 - a2) * cos_o * cos_o)
        lobe = facets * 0.5 / np.maximum(np.where(terms.above, seen, 1.0), 1e-300)
        value = lobe[:, None] * self._fresnel(terms.cos_d)
        kd = np.asarray(self.kd) / math.pi
        if self.scattering == "single":
            value += kd * (1.0 - self._fresnel(cos_i)) * (1.0 - self._fresnel(cos_o))
        else:
            albedo = self._albedo
            value += albedo.further(cos_i, cos_o)
            if kd.any():
                # Where f0 is 1 nothing is let through: 0/0.
                rest = np.maximum(1.0 - albedo.mean, 1e-12)
                passed = (1.0 - albedo.at(cos_i)) * (1.0 - albedo.at(cos_o))
                value += kd * (passed / rest)
        return np.where(terms.above[:, None], value, 0.0)

    @cached_property
    def _albedo(self) -> FacetAlbedo:
        return facet_albedo("ggx", self.alpha, self._fresnel)

    def _fresnel(self, cosine: Floats) -> Floats:
        f0 = np.asarray(self.f0)
        rest = np.clip(1.0 - cosine, 0.0, 1.0)
        square = rest * rest
        return np.asarray(f0 + (1.0 - f0) * (square * square * rest)[:, None])

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        f0, kd = luminance(np.asarray(self.f0)), luminance(np.asarray(self.kd))
        # 1/21 is the mean of (1 - c)⁵ over a matt surface.
        lobe = f0 + (1.0 - f0) / 21.0
        further = luminance(self._albedo.multiple_albedo) if self.scattering == "multiple" else 0.0
        return [mixture.diffuse(kd * (1.0 - f0) + further + 0.05 * lobe), mixture.ggx(lobe, self.alpha)]

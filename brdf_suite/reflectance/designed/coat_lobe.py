"""Mirror lobe of a clearcoat: a Beckmann microfacet surface of a clear dielectric.

    f_r = D(h) G(wi, wo) F(wi·h) / (4 cosθi cosθo) + f_ms,    D = exp(-tan²θh / α²) / (π α² cos⁴θh),

F by Fresnel's equations, G = 1 / (1 + Λ(wi) + Λ(wo)) the height-correlated shadowing of Smith with Λ by the
rational fit of Walter et al. 2007 (within .0035 of the exact one), f_ms what comes back after several facets
(:mod:`~brdf_suite.reflectance.facet_albedo`; ``scattering`` "single" leaves it out). Reciprocal and not coloured.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Scattering
from brdf_suite.documents.parameter import Parameter
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.facet_albedo import FacetAlbedo, coat_albedo
from brdf_suite.reflectance.models import mixture

_TINY = 1e-300

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "ior": Parameter("Index", "", 1.0, 3.0, 1.5, "Index of refraction of the clearcoat"),
        "roughness": Parameter("Roughness", "", 0.001, 1.0, 0.005, "Beckmann α of the clearcoat"),
    }
)


@dataclass(frozen=True)
class CoatLobe(mixture.MixtureSampled):
    """A clearcoat's lobe: ``ior`` > 1 and Beckmann ``roughness`` α > 0."""

    ior: float
    roughness: float
    scattering: Scattering = "multiple"
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True
    energy_conserving: ClassVar[bool] = True

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        grey = self.eval_grey(wi, wo)
        return np.repeat(grey[..., None], 3, axis=-1)

    def eval_grey(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (...), the same in every channel."""
        wi, wo = np.asarray(wi, float), np.asarray(wo, float)
        total = wi + wo
        squares = total * total
        across = squares[..., 0] + squares[..., 1]
        up = np.maximum(squares[..., 2], _TINY)
        # tan²θh from the sum itself: exact also for a lobe narrower than the rounding of cos θh.
        tan2 = across / up
        cos_i, cos_o = wi[..., 2], wo[..., 2]
        above = (cos_i > 0.0) & (cos_o > 0.0)
        alpha2 = self.roughness * self.roughness
        # |wi + wo| = 2 wi·h; below the horizon the value is dropped, so the clip only keeps it finite.
        cos_d = 0.5 * np.sqrt(across + squares[..., 2])
        facets = np.exp(-np.minimum(tan2 / alpha2, 745.0)) * ((1.0 + tan2) ** 2 / (math.pi * alpha2))
        shadowing = 1.0 / (1.0 + self._lambda(cos_i) + self._lambda(cos_o))
        fresnel = fresnel_dielectric(cos_d, self.ior)
        value = facets * shadowing * fresnel / np.maximum(4.0 * cos_i * cos_o, _TINY)
        if (albedo := self.multiple) is not None:
            value = value + albedo.further(cos_i, cos_o)
        return np.where(above, value, 0.0)

    @property
    def multiple(self) -> FacetAlbedo | None:
        """The albedo with multiple scattering; None where that is left out or negligible."""
        if self.scattering == "single":
            return None
        albedo = coat_albedo(self.ior, self.roughness)
        return albedo if albedo.is_multiple else None

    @property
    def crossing_roughness(self) -> float:
        """The roughness for ``facet_albedo.entering``, by which light crosses the coat; 0 in the single form."""
        return 0.0 if self.scattering == "single" else self.roughness

    def _lambda(self, cos_theta: Floats) -> Floats:
        """Λ of Smith: with a = 1 / (α tanθ), (1 - 1.259a + .396a²) / (3.535a + 2.181a²) below 1.6, else 0."""
        if np.ndim(cos_theta) == 0:  # one light of an edit, as plain numbers
            cosine = max(float(cos_theta), 1e-8)
            one = min(cosine / (self.roughness * math.sqrt(max(1.0 - cosine * cosine, 1e-30))), 1.6)
            return np.asarray(max(1.0 - 1.259 * one + 0.396 * one * one, 0.0) / (one * (3.535 + 2.181 * one)))
        cos_theta = np.maximum(cos_theta, 1e-8)
        sin2 = np.maximum(1.0 - cos_theta * cos_theta, 1e-30)
        a = np.minimum(cos_theta / (self.roughness * np.sqrt(sin2)), 1.6)
        return np.asarray(np.maximum(1.0 - 1.259 * a + 0.396 * a * a, 0.0) / (a * (3.535 + 2.181 * a)))

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        albedo = self.multiple
        if albedo is None:
            return [mixture.beckmann(1.0, self.roughness)]
        further = float(albedo.multiple_albedo / albedo.mean)
        return [mixture.beckmann(1.0 - further, self.roughness), mixture.diffuse(further)]

"""A designed paint as a reflectance: the base under its clearcoat, and the coat's own lobe."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import PARAMETERS
from brdf_suite.documents.parameter import Parameter
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.albedo import normal_albedo
from brdf_suite.reflectance.designed.aspecular_base import AspecularBase, SeveralLights
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance

# Facet slope of a lobe about as wide as a metallic paint's flop.
_FLOP_SLOPE = 0.3


@dataclass(frozen=True)
class PaintReflectance(mixture.MixtureSampled):
    """Reflectance of a designed paint: base and coat; ``notices`` are sentences for the user about its construction."""

    base: AspecularBase | SeveralLights
    coat: CoatLobe
    notices: tuple[str, ...] = ()
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True
    # The readings are what they are: a paint that would reflect more than it gets carries a notice.
    energy_conserving: ClassVar[bool] = False
    base_under_coat: ClassVar[bool] = True

    @property
    def ior(self) -> float:
        """Return the index of refraction of the coat."""
        return self.coat.ior

    @property
    def roughness(self) -> float:
        """Return the Beckmann roughness of the coat."""
        return self.coat.roughness

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine, of base and coat; 0 below the horizon."""
        value = self.base.eval(wi, wo)
        value += self.coat.eval_grey(wi, wo)[..., None]
        return value

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        base = luminance(normal_albedo(self.base))
        coat = 0.02 + 2.0 * float(fresnel_dielectric(1.0, self.coat.ior))
        return [
            mixture.diffuse(0.5 * base + 0.02),
            mixture.beckmann(0.5 * base, _FLOP_SLOPE),
            mixture.beckmann(coat, self.coat.roughness),
        ]

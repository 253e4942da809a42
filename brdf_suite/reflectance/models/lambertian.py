"""Lambertian reflectance: the same radiance in every direction (Lambert 1760)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import set_rgb

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {"albedo": Parameter("Albedo", "", 0.0, 1.0, 0.5, "Share of the light reflected, linear Rec. 2020")}
)


@dataclass(frozen=True, eq=False)
class Lambertian(mixture.MixtureSampled):
    """f_r = albedo/π; ``albedo`` is three channels or one number for all."""

    albedo: npt.ArrayLike = 0.5
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True
    energy_conserving: ClassVar[bool] = True

    def __post_init__(self) -> None:
        set_rgb(self, PARAMETERS, "albedo")

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.asarray(wi, float), np.asarray(wo, float)
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        return np.where(above[..., None], np.asarray(self.albedo) / math.pi, 0.0)

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        return [mixture.diffuse(1.0)]

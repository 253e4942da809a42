"""Velvet: a matt cloth with upright fibres, which shine where light grazes them.

    f_r = (1 - s) a/π + s N exp(-cot²θh / w²),    θh the polar angle of the half vector,

after the sheen of Ashikhmin, Premože and Shirley, *A Microfacet-based BRDF Generator* (2000), without its shadowing.
N makes the largest value of the sheen 1/π.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.documents.parameter import Parameter, set_numbers
from brdf_suite.reflectance.registry import ModelEntry

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "sheen": Parameter("Sheen", "", 0.0, 1.0, 0.6, "Share of the fibres' shine"),
        "width": Parameter("Width", "", 0.05, 2.0, 0.5, "How far the fibres lean"),
    }
)
CLOTH = np.array([0.25, 0.03, 0.06])
"""Reflectance of the cloth, linear Rec. 2020."""


@dataclass(frozen=True, eq=False)
class Velvet:
    """Velvet of two numbers; the suite makes the sampler that path tracing needs."""

    sheen: float = 0.6
    width: float = 0.5
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True
    energy_conserving: ClassVar[bool] = True

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "sheen", "width")

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        half = wi + wo
        across = half[..., 0] ** 2 + half[..., 1] ** 2
        cot2 = half[..., 2] ** 2 / np.maximum(across, 1e-12)
        sheen = self.sheen / math.pi * np.exp(-cot2 / self.width**2)
        value = (1.0 - self.sheen) / math.pi * CLOTH + sheen[..., None]
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        return np.where(above[..., None], value, 0.0)


MODEL = ModelEntry(
    name="velvet",
    title="Velvet (example plug-in)",
    make=Velvet,
    reciprocal=True,
    energy_conserving=True,
    source="after Ashikhmin, Premože and Shirley 2000",
)

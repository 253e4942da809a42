"""Phong with a Fresnel-weighted clearcoat, a common industrial model of car paint.

Günther et al. 2005 describe it (section 6.1, Figure 7b): an enhanced Phong model whose Fresnel term controls
the coat. Its formulas are not published there; these are ours, in that spirit:

    f_r = T(θi) T(θo) [kd/π + ks (n+2)/(2π) (R·V)ⁿ] + F(wi·h) (N+1)/(2π) (R·V)^N / max(cosθi, cosθo)

with T = 1 - F. The base is a modified Phong lobe seen twice through the coat; the coat is a lobe whose share is
F at any angle (Neumann, Neumann and Szirmay-Kalos 1999 divide by the larger cosine to keep it so). Reciprocal.
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
from brdf_suite.documents.parameter import Parameter
from brdf_suite.geometry.directions import mirror_cosine
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance, rgb

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "kd": Parameter("Diffuse", "", 0.0, 1.0, 0.1, "Diffuse reflectance of the base, linear Rec. 2020"),
        "ks": Parameter("Flop", "", 0.0, 1.0, 0.4, "Share in the base's lobe, linear Rec. 2020"),
        "exponent": Parameter("Flop exponent", "", 0.0, 1e5, 8.0, "Sharpness n of the base's lobe"),
        "ior": Parameter("Index", "", 1.0, 3.0, 1.5, "Index of refraction of the clearcoat"),
        "coat_exponent": Parameter("Coat exponent", "", 1.0, 1e6, 20_000.0, "Sharpness N of the coat's lobe"),
    }
)


@dataclass(frozen=True, eq=False)
class CoatedPhong:
    """The enhanced Phong model with a clearcoat; see the module."""

    kd: npt.ArrayLike = 0.1
    ks: npt.ArrayLike = 0.4
    exponent: float = 8.0
    ior: float = 1.5
    coat_exponent: float = 20_000.0
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "kd", rgb(self.kd, "kd", PARAMETERS["kd"]))
        object.__setattr__(self, "ks", rgb(self.ks, "ks", PARAMETERS["ks"]))
        for name in ("exponent", "ior", "coat_exponent"):
            object.__setattr__(self, name, PARAMETERS[name].check(getattr(self, name), name))

    @property
    def energy_conserving(self) -> bool:
        """Return whether the base conserves energy by itself, and the coat's lobe is not so wide that F varies."""
        whole = np.asarray(self.kd) + np.asarray(self.ks) <= 1.0
        return bool(np.all(whole)) and self.coat_exponent >= 100.0

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.asarray(wi, float), np.asarray(wo, float)
        cos_i, cos_o = wi[..., 2], wo[..., 2]
        above = (cos_i > 0.0) & (cos_o > 0.0)
        dot = mirror_cosine(wi, wo)
        # cos of half the angle between light and view.
        cos_d = np.sqrt(np.clip(0.5 * (1.0 + np.sum(wi * wo, axis=-1)), 0.0, 1.0))
        passed = (1.0 - fresnel_dielectric(cos_i, self.ior)) * (1.0 - fresnel_dielectric(cos_o, self.ior))
        lobe = dot**self.exponent * (self.exponent + 2.0) / (2.0 * math.pi)
        base = np.asarray(self.kd) / math.pi + lobe[..., None] * np.asarray(self.ks)
        coat = fresnel_dielectric(cos_d, self.ior) * dot**self.coat_exponent * (self.coat_exponent + 1.0)
        coat = coat / (2.0 * math.pi * np.where(above, np.maximum(cos_i, cos_o), 1.0))
        return np.where(above[..., None], passed[..., None] * base + coat[..., None], 0.0)

    def _parts(self) -> list[mixture.MixturePart]:
        kd, ks = luminance(np.asarray(self.kd)), luminance(np.asarray(self.ks))
        # A mean over the directions; the share at grazing is larger.
        coat = 2.0 * float(fresnel_dielectric(1.0, self.ior)) + 0.02
        return [
            mixture.diffuse(kd + 0.02),
            mixture.mirror_lobe(ks, self.exponent),
            mixture.mirror_lobe(coat, self.coat_exponent),
        ]

    def sample(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return directions (..., 3) of the diffuse part, the base's lobe or the coat's."""
        return mixture.sample(self._parts(), wo, u)

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle."""
        return mixture.pdf(self._parts(), wi, wo)

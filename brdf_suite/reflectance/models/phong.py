"""Phong's lobe about the mirror direction, in two forms.

``original`` is Phong's picture (1975): the highlight is added to the reflected radiance whatever the light's
cosine, f_r cosθi = kd/π cosθi + ks (n+1)/(2π) (R·V)ⁿ. As a BRDF it is divided by cosθi, so it is not reciprocal
and grows without bound towards grazing light.

``modified`` leaves the division out (Lewis 1994): f_r = kd/π + ks (n+2)/(2π) (R·V)ⁿ, reciprocal, and with
kd + ks ≤ 1 conserving, because ∫ (R·V)ⁿ cosθ dω is 2π/(n+2) along the normal and less elsewhere.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar, Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter, check_choice, set_numbers
from brdf_suite.geometry.directions import mirror_cosine
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance, set_rgb

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "kd": Parameter("Diffuse", "", 0.0, 1.0, 0.2, "Diffuse reflectance, linear Rec. 2020"),
        "ks": Parameter(
            "Specular", "", 0.0, 1.0, 0.3, "Share in the lobe along the normal, linear Rec. 2020"
        ),
        "exponent": Parameter("Exponent", "", 0.0, 1e6, 50.0, "Sharpness n of the lobe"),
    }
)


@dataclass(frozen=True, eq=False)
class Phong(mixture.MixtureSampled):
    """Diffuse part and one lobe; see the module for the two values of ``form``."""

    kd: npt.ArrayLike = 0.2
    ks: npt.ArrayLike = 0.3
    exponent: float = 50.0
    form: Literal["modified", "original"] = "modified"
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS

    def __post_init__(self) -> None:
        set_rgb(self, PARAMETERS, "kd", "ks")
        set_numbers(self, PARAMETERS, "exponent")
        check_choice(self.form, "form", ("modified", "original"))

    @property
    def reciprocal(self) -> bool:
        """Return whether light and view may be exchanged."""
        return self.form == "modified" or not np.any(self.ks)

    @property
    def energy_conserving(self) -> bool:
        """Return whether no more light is reflected than arrives; the original form's lobe knows no bound."""
        whole = bool(np.all(np.asarray(self.kd) + np.asarray(self.ks) <= 1.0))
        return whole and (self.form == "modified" or not np.any(self.ks))

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.asarray(wi, float), np.asarray(wo, float)
        cos_i = wi[..., 2]
        above = (cos_i > 0.0) & (wo[..., 2] > 0.0)
        lobe = mirror_cosine(wi, wo) ** self.exponent / (2.0 * math.pi)
        if self.form == "modified":
            lobe = lobe * (self.exponent + 2.0)
        else:
            lobe = lobe * (self.exponent + 1.0) / np.where(above, cos_i, 1.0)
        value = np.asarray(self.kd) / math.pi + lobe[..., None] * np.asarray(self.ks)
        return np.where(above[..., None], value, 0.0)

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        kd, ks = luminance(np.asarray(self.kd)), luminance(np.asarray(self.ks))
        return [mixture.diffuse(kd), mixture.mirror_lobe(ks, self.exponent)]


COATED_PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "kd": Parameter("Diffuse", "", 0.0, 1.0, 0.1, "Diffuse reflectance of the base, linear Rec. 2020"),
        "ks": Parameter("Flop", "", 0.0, 1.0, 0.4, "Share in the base's lobe, linear Rec. 2020"),
        "exponent": Parameter("Flop exponent", "", 0.0, 1e5, 8.0, "Sharpness n of the base's lobe"),
        "ior": Parameter("Index", "", 1.0, 3.0, 1.5, "Index of refraction of the clearcoat"),
        "coat_exponent": Parameter("Coat exponent", "", 1.0, 1e6, 20_000.0, "Sharpness N of the coat's lobe"),
    }
)


@dataclass(frozen=True, eq=False)
class CoatedPhong(mixture.MixtureSampled):
    """Phong with a Fresnel-weighted clearcoat, a common industrial model of car paint.

    Günther et al. 2005 describe it (section 6.1, Figure 7b): an enhanced Phong model whose Fresnel term controls
    the coat. Its formulas are not published there; these are ours, in that spirit:

        f_r = T(θi) T(θo) [kd/π + ks (n+2)/(2π) (R·V)ⁿ] + F(wi·h) (N+1)/(2π) (R·V)^N / max(cosθi, cosθo)

    with T = 1 - F. The base is a modified Phong lobe seen twice through the coat; the coat is a lobe whose share is
    F at any angle (Neumann, Neumann and Szirmay-Kalos 1999 divide by the larger cosine to keep it so). Reciprocal.
    """

    kd: npt.ArrayLike = 0.1
    ks: npt.ArrayLike = 0.4
    exponent: float = 8.0
    ior: float = 1.5
    coat_exponent: float = 20_000.0
    parameters: ClassVar[Mapping[str, Parameter]] = COATED_PARAMETERS
    reciprocal: ClassVar[bool] = True

    def __post_init__(self) -> None:
        set_rgb(self, COATED_PARAMETERS, "kd", "ks")
        set_numbers(self, COATED_PARAMETERS, "exponent", "ior", "coat_exponent")

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

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        kd, ks = luminance(np.asarray(self.kd)), luminance(np.asarray(self.ks))
        # A mean over the directions; the share at grazing is larger.
        coat = 2.0 * float(fresnel_dielectric(1.0, self.ior)) + 0.02
        return [
            mixture.diffuse(kd + 0.02),
            mixture.mirror_lobe(ks, self.exponent),
            mixture.mirror_lobe(coat, self.coat_exponent),
        ]

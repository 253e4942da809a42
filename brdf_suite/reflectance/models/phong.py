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
from brdf_suite.documents.parameter import Parameter, check_choice
from brdf_suite.geometry.directions import mirror_cosine
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance, rgb

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
class Phong:
    """Diffuse part and one lobe; see the module for the two values of ``form``."""

    kd: npt.ArrayLike = 0.2
    ks: npt.ArrayLike = 0.3
    exponent: float = 50.0
    form: Literal["modified", "original"] = "modified"
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS

    def __post_init__(self) -> None:
        object.__setattr__(self, "kd", rgb(self.kd, "kd", PARAMETERS["kd"]))
        object.__setattr__(self, "ks", rgb(self.ks, "ks", PARAMETERS["ks"]))
        object.__setattr__(self, "exponent", PARAMETERS["exponent"].check(self.exponent, "exponent"))
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

    def _parts(self) -> list[mixture.MixturePart]:
        kd, ks = luminance(np.asarray(self.kd)), luminance(np.asarray(self.ks))
        return [mixture.diffuse(kd), mixture.mirror_lobe(ks, self.exponent)]

    def sample(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return directions (..., 3) of the diffuse part or of the lobe about the mirror direction."""
        return mixture.sample(self._parts(), wo, u)

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle."""
        return mixture.pdf(self._parts(), wi, wo)

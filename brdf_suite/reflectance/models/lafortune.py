"""Generalised cosine lobes (Lafortune, Foo, Torrance and Greenberg 1997).

    f_r = kd/π + Σ ks max(0, Cx ix ox + Cy iy oy + Cz iz oz)ⁿ

Cx = Cy = -1, Cz = 1 is the mirror lobe of Phong; unequal |Cx| and Cz shift the lobe off the mirror direction,
Cx > 0 makes it look back at the light, Cx ≠ Cy makes it anisotropic. The product is the same with light and
view exchanged, so the model is reciprocal.
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
from brdf_suite.documents.parameter import Parameter, describe, set_numbers
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry import warps
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance, set_rgb

_SIZE = "Weight of the product of the {} parts of light and view"
PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "kd": Parameter("Diffuse", "", 0.0, 1.0, 0.2, "Diffuse reflectance, linear Rec. 2020"),
        "lobes[].ks": Parameter(
            "Weight", "1/sr", 0.0, 1e6, 1.0, "f_r where the product is 1, linear Rec. 2020"
        ),
        "lobes[].cx": Parameter("Cx", "", -2.0, 2.0, -1.0, _SIZE.format("x")),
        "lobes[].cy": Parameter("Cy", "", -2.0, 2.0, -1.0, _SIZE.format("y")),
        "lobes[].cz": Parameter("Cz", "", -2.0, 2.0, 1.0, _SIZE.format("z")),
        "lobes[].exponent": Parameter("Exponent", "", 0.0, 1e5, 20.0, "Sharpness n of the lobe"),
    }
)


@dataclass(frozen=True, eq=False)
class LafortuneLobe:
    """One lobe: weight ``ks`` (3,), direction (``cx``, ``cy``, ``cz``) and ``exponent``."""

    ks: npt.ArrayLike
    cx: float = -1.0
    cy: float = -1.0
    cz: float = 1.0
    exponent: float = 20.0

    def __post_init__(self) -> None:
        set_rgb(self, PARAMETERS, "ks", group="lobes[].")
        set_numbers(self, PARAMETERS, "cx", "cy", "cz", "exponent", group="lobes[].")

    @property
    def direction(self) -> Floats:
        """(Cx, Cy, Cz)."""
        return np.array([self.cx, self.cy, self.cz])

    def part(self) -> mixture.MixturePart:
        """Return the sampler: a cosine lobe about the direction that the lobe gives the view."""
        longest = float(np.abs(self.direction).max())
        # Along the normal the lobe holds |Cz|ⁿ 2π/(n+2); where it leans elsewhere, its largest stretch counts.
        stretch = longest**self.exponent
        weight = luminance(np.asarray(self.ks)) * stretch * 2.0 * math.pi / (self.exponent + 2.0)
        return mixture.MixturePart(
            weight,
            lambda wo, u: warps.cosine_lobe(u, self._axis(wo), self.exponent),
            lambda wi, wo: warps.cosine_lobe_pdf(wi, self._axis(wo), self.exponent),
        )

    def _axis(self, wo: Floats) -> Floats:
        turned = wo * self.direction
        length = np.sqrt(np.einsum("...i,...i", turned, turned))[..., None]
        return np.where(length > 1e-12, turned / np.maximum(length, 1e-12), np.array([0.0, 0.0, 1.0]))


@dataclass(frozen=True, eq=False)
class Lafortune(mixture.MixtureSampled):
    """Diffuse part and generalised cosine lobes."""

    kd: npt.ArrayLike = 0.2
    lobes: tuple[LafortuneLobe, ...] = ()
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True

    def __post_init__(self) -> None:
        set_rgb(self, PARAMETERS, "kd")
        if not isinstance(self.lobes, (tuple, list)):
            raise ValueRangeError("lobes", f"expected a list, not {describe(self.lobes)}")
        for index, lobe in enumerate(self.lobes):
            if not isinstance(lobe, LafortuneLobe):
                raise ValueRangeError(f"lobes[{index}]", f"expected a lobe, not {describe(lobe)}")
        object.__setattr__(self, "lobes", tuple(self.lobes))

    @property
    def energy_conserving(self) -> bool:
        """Return whether the weights certainly keep the energy.

        A lobe is at most longestⁿ cosⁿ about its axis, which with the light's cosine holds at most 2π/(n+1).
        """
        total = np.array(self.kd)
        for lobe in self.lobes:
            stretch = float(np.abs(lobe.direction).max()) ** lobe.exponent
            total = total + np.asarray(lobe.ks) * stretch * 2.0 * math.pi / (lobe.exponent + 1.0)
        return bool(np.all(total <= 1.0))

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        product = wi * wo
        value = np.zeros(wi.shape) + np.asarray(self.kd) / math.pi
        for lobe in self.lobes:
            shape = np.maximum(product @ lobe.direction, 0.0) ** lobe.exponent
            value += shape[..., None] * np.asarray(lobe.ks)
        return np.where(above[..., None], value, 0.0)

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        parts = [lobe.part() for lobe in self.lobes]
        kd = luminance(np.asarray(self.kd))
        return [mixture.diffuse(max(kd, 0.05 * sum(part.weight for part in parts))), *parts]

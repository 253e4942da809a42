"""The suite's sum of cosine lobes as a reflectance (equations 1 to 3 of the BRDF paper).

    f_r cosθi = KD cosθi + cosθi Σ KDD_k (R·V)^E_k + Σ KG_k (R·V)^E_k

The gloss part has no cosine of its own, so as a BRDF it is divided by cosθi: it is not reciprocal, and nothing
but its weights holds its energy. It is what a fit returns, kept here to be measured like every other model.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter, describe
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import mirror_cosine
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance, rgb, set_rgb


class LobeSums(NamedTuple):
    """N·L (...) and whether light and view are above the horizon (...); the two sums (..., 3).

    ``base`` is KD + Σ KDD_k (R·V)^E_k, to be multiplied by N·L; ``gloss`` is Σ KG_k (R·V)^E_k, which has no cosine.
    """

    cos_light: Floats
    above: npt.NDArray[np.bool_]
    base: Floats
    gloss: Floats

    def reflected(self) -> Floats:
        """Return f_r (N·L) (..., 3) in 1/sr; 0 below the horizon."""
        return np.where(self.above[..., None], self.cos_light[..., None] * self.base + self.gloss, 0.0)

    def brdf(self) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        safe = np.where(self.above, self.cos_light, 1.0)[..., None]
        return np.where(self.above[..., None], self.base + self.gloss / safe, 0.0)


def lobe_sums(
    wi: npt.ArrayLike, wo: npt.ArrayLike, exponents: Floats, kd: Floats, kdd: Floats, kg: Floats
) -> LobeSums:
    """Return the sums of m lobes for directions (..., 3) that broadcast; ``kd`` (3,), ``kdd`` and ``kg`` (m, 3)."""
    light, view = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
    cos_light = light[..., 2]
    lobes = mirror_cosine(light, view)[..., None] ** exponents
    return LobeSums(cos_light, (cos_light > 0.0) & (view[..., 2] > 0.0), kd + lobes @ kdd, lobes @ kg)


PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "kd": Parameter("Diffuse", "1/sr", 0.0, 1e3, 0.05, "KD, f_r of the diffuse part, linear Rec. 2020"),
        "exponents[]": Parameter("Exponent", "", 0.0, 1e6, 10.0, "Sharpness E of a lobe"),
        "kdd[]": Parameter("Directional diffuse", "1/sr", 0.0, 1e3, 0.1, "KDD of a lobe, linear Rec. 2020"),
        "kg[]": Parameter("Gloss", "1/sr", 0.0, 1e6, 0.1, "KG of a lobe, linear Rec. 2020"),
    }
)


@dataclass(frozen=True, eq=False)
class CosineLobes(mixture.MixtureSampled):
    """KD (3,), and for each of m exponents KDD and KG (m, 3), linear Rec. 2020, not negative.

    Raises
    ------
    ValueRangeError
        A weight is negative or not finite, or the numbers of lobes differ; the place names it.
    """

    kd: npt.ArrayLike
    exponents: npt.ArrayLike
    kdd: npt.ArrayLike
    kg: npt.ArrayLike
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    energy_conserving: ClassVar[bool] = False

    def __post_init__(self) -> None:
        set_rgb(self, PARAMETERS, "kd")
        exponents = np.atleast_1d(np.asarray(self.exponents, float)).tolist()
        check = PARAMETERS["exponents[]"].check
        checked = np.array([check(e, f"exponents[{i}]") for i, e in enumerate(exponents)])
        checked.setflags(write=False)
        object.__setattr__(self, "exponents", checked)
        for name in ("kdd", "kg"):
            rows = list(np.asarray(getattr(self, name), float).reshape(-1, 3))
            if len(rows) != len(checked):
                raise ValueRangeError(
                    name, f"expected a colour for each of {len(checked)} exponents, not {describe(rows)}"
                )
            table = np.array(
                [rgb(row, f"{name}[{i}]", PARAMETERS[f"{name}[]"]) for i, row in enumerate(rows)]
            ).reshape(-1, 3)
            table.setflags(write=False)
            object.__setattr__(self, name, table)

    @property
    def reciprocal(self) -> bool:
        """Return whether light and view may be exchanged: only without gloss lobes."""
        return not np.any(self.kg)

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        weights = (np.asarray(value) for value in (self.exponents, self.kd, self.kdd, self.kg))
        return lobe_sums(wi, wo, *weights).brdf()

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        parts = [mixture.diffuse(math.pi * luminance(np.asarray(self.kd)))]
        rows = zip(np.asarray(self.exponents), np.asarray(self.kdd), np.asarray(self.kg), strict=True)
        for exponent, kdd, kg in rows:
            # What each reflects along the normal.
            weight = 2.0 * math.pi * (luminance(kdd) / (exponent + 2.0) + luminance(kg) / (exponent + 1.0))
            parts.append(mixture.mirror_lobe(weight, float(exponent)))
        return parts

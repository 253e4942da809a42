"""Sum of cosine lobes, equations 1 to 3 of the BRDF paper, shared by fits and models."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import mirror_cosine


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

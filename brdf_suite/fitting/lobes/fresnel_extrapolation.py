"""Extrapolation of one incidence's weights to all others by Fresnel's equations: the paper's first way (section 4).

    f_r·(N·L) ≈ T(θ)²/T(θ_fit)² · (N·L)·(KD + Σ KDD_i (R·V)^E_i) + F(θ)/F(θ_fit) · Σ KG_i (R·V)^E_i

F is the exact reflectance of the coat's dielectric, T = 1 - F. At the mirror direction incidence and view have one
angle θ, and there is no choice. Away from it there is:

- ``angle="light"`` (default): θ is the incidence, cos θ = N·L. Under light at θ_fit the weights are then those
  of the fit, at every view.
- ``angle="view"``: cos θ = N·V, as ``fresnel_gains`` of the shader ``material.glsl`` takes it, which knows the view
  of a pixel and sums over all its lights.

Never on top of weights that were fitted at several angles. As in the shader, the gloss is limited so that no
channel's lobes hold more than 1, and a coat that reflects nothing at θ_fit (index 1) changes nothing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.models.cosine_lobes import lobe_sums

#: Below this reflectance at θ_fit there is no coat whose ratios could be taken.
NO_COAT = 1e-6


@dataclass(frozen=True, eq=False)
class RaisedWeights:
    """``weights`` with their Fresnel gains; see the module. Raises FittingError for an ``angle`` of another name."""

    weights: LobeWeights
    angle: Literal["light", "view"] = "light"

    def __post_init__(self) -> None:
        if self.angle not in ("light", "view"):
            raise FittingError(f'Fresnel\'s angle is "light" or "view", not "{self.angle}".')

    def gains(self, cosine: npt.ArrayLike) -> tuple[Floats, Floats]:
        """Return what base and gloss are multiplied by, each (...), at cos θ (...), clipped to 0…1."""
        weights = self.weights
        cosine = np.asarray(cosine, np.float64)
        at_fit = float(fresnel_dielectric(math.cos(weights.theta_fit_rad), weights.ior))
        if at_fit < NO_COAT:
            return np.ones(cosine.shape), np.ones(cosine.shape)
        reflected = fresnel_dielectric(cosine, weights.ior)
        base: Floats = ((1.0 - reflected) / (1.0 - at_fit)) ** 2
        if not weights.base_under_coat:
            base = np.ones(cosine.shape)
        highest = 1.0 / max(float(weights.coat_energy().max()), NO_COAT)
        gloss: Floats = np.minimum(reflected / at_fit, max(highest, 1.0))
        return base, gloss

    def _parts(self, wi: Floats, wo: Floats) -> tuple[Floats, Floats, Floats]:
        """Return N·L (...), base without it and gloss (..., 3), both 0 below the horizon."""
        w = self.weights
        light, view = np.broadcast_arrays(np.asarray(wi, np.float64), np.asarray(wo, np.float64))
        sums = lobe_sums(light, view, w.exponents, w.kd, w.kdd, w.kg)
        base, gloss = self.gains(light[..., 2] if self.angle == "light" else view[..., 2])
        above = sums.above[..., None]
        return (
            sums.cos_light,
            np.where(above, base[..., None] * sums.base, 0.0),
            np.where(above, gloss[..., None] * sums.gloss, 0.0),
        )

    def reflected(self, wi: Floats, wo: Floats) -> Floats:
        """Return ``f_r·(N·L)`` (..., 3) in 1/sr, cosine included; shapes as for :meth:`LobeWeights.reflected`."""
        cosine, base, gloss = self._parts(wi, wo)
        result: Floats = np.maximum(cosine, 0.0)[..., None] * base + gloss
        return result

    def eval(self, wi: Floats, wo: Floats) -> Floats:
        """Return f_r (..., 3) in 1/sr, **without** the cosine; 0 at or below the horizon."""
        cosine, base, gloss = self._parts(wi, wo)
        result: Floats = base + gloss / np.where(cosine > 0.0, cosine, 1.0)[..., None]
        return result

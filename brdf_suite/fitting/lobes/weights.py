"""Fitted non-negative weights of the cosine lobes, and their reflectance."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.checks import check_ior
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.models.cosine_lobes import lobe_sums

#: Below this reflectance at θ_fit there is no coat whose ratios could be taken.
NO_COAT = 1e-6


def set_weights(owner: object, shapes: Mapping[str, tuple[int, ...]]) -> None:
    """Check and store a frozen value's weights as arrays of these ``shapes``; errors as :class:`LobeWeights`."""
    for name, shape in shapes.items():
        value = np.array(getattr(owner, name), dtype=np.float64)
        if value.shape != shape:
            raise FittingError(f"The lobe weights {name} have shape {value.shape}, not {shape}.")
        value.setflags(write=False)
        object.__setattr__(owner, name, value)
    # All at once, because this is on the path of every edit; not-a-number is neither.
    arrays: dict[str, Floats] = {name: getattr(owner, name) for name in shapes}
    together = np.concatenate([array.ravel() for array in arrays.values()])
    if not (together.min() >= 0.0 and together.max() < np.inf):
        wrong = next(n for n, array in arrays.items() if not ((array >= 0.0) & (array < np.inf)).all())
        raise FittingError(f"The lobe weights {wrong} hold a negative or not finite value.")


@dataclass(frozen=True, eq=False)
class LobeWeights:
    """Weights of diffuse (KD), directional-diffuse (KDD) and gloss (KG) lobes, linear Rec. 2020, ≥ 0.

    With ``wi`` to the light (polar cosine ``N·L``), ``R`` its mirror direction and ``V`` the view::

        f_r·(N·L) ≈ KD·(N·L) + (N·L)·Σ KDD_i·(R·V)^E_i + Σ KG_i·(R·V)^E_i      (negative dots are 0)

    Parameters
    ----------
    exponents
        ``(m,)`` lobe exponents E.
    kd, kdd, kg
        ``(3,)``, ``(m, 3)``, ``(m, 3)`` float64; finite and not negative; KD and KDD in 1/sr, KG without the
        cosine's share (radiance per irradiance on a plane that faces the light).
    theta_fit_rad
        Incidence angle of the fit, from which Fresnel factors are taken towards grazing.
    ior
        Refractive index of the coat, ≥ 1; 1 is none: the weights hold at every angle.
    base_under_coat
        Light for the base crosses the coat, so that the base darkens towards grazing by T(θ)²/T(θ_fit)² as the
        gloss gains F(θ)/F(θ_fit). False where gloss and base are parts of one sum that take nothing from each
        other (Cook-Torrance): the gloss still follows F, the base stays.
    time_limited
        The time limit came before the optimum: the best weights available, not the best there are.

    Raises
    ------
    FittingError
        A shape that does not fit, a weight that is negative or not finite, or an index that is not one.
    """

    exponents: Floats
    kd: Floats
    kdd: Floats
    kg: Floats
    theta_fit_rad: float
    ior: float
    time_limited: bool = False
    base_under_coat: bool = True

    def __post_init__(self) -> None:
        count = np.asarray(self.exponents).size
        set_weights(self, {"exponents": (count,), "kd": (3,), "kdd": (count, 3), "kg": (count, 3)})
        check_ior(self.ior)

    def reflected(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return ``f_r·(N·L)`` in 1/sr: reflected radiance for light of unit strength (cosine included).

        ``wi``, ``wo``: unit directions ``(..., 3)`` to light and view, local frame with the normal as z; they
        broadcast. Result ``(..., 3)``, 0 where either is at or below the horizon.
        """
        return lobe_sums(wi, wo, self.exponents, self.kd, self.kdd, self.kg).reflected()

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the lobes' f_r in 1/sr, **without** the cosine: ``reflected`` over ``N·L``.

        Shapes as for :meth:`reflected`; 0 at or below the horizon. The gloss part grows without bound as
        light goes to grazing, as the representation says; use :meth:`reflected` for radiance.
        """
        return lobe_sums(wi, wo, self.exponents, self.kd, self.kdd, self.kg).brdf()

    def coat_energy(self) -> Floats:
        """Return ``(3,)`` what the gloss lobes reflect of a constant environment: ``Σ KG_i·2π/(E_i+1)``.

        The part of wide lobes that reaches below the horizon is counted; for a car's clearcoat it is nothing.
        """
        return np.asarray((2.0 * np.pi / (self.exponents + 1.0)) @ self.kg)


@dataclass(frozen=True, eq=False)
class RaisedWeights:
    """Weights of one incidence extrapolated to all others by Fresnel's equations: the paper's first way (section 4).

        f_r·(N·L) ≈ T(θ)²/T(θ_fit)² · (N·L)·(KD + Σ KDD_i (R·V)^E_i) + F(θ)/F(θ_fit) · Σ KG_i (R·V)^E_i

    F is the exact reflectance of the coat's dielectric, T = 1 - F. At the mirror direction incidence and view have one
    angle θ, and there is no choice. Away from it there is:

    - ``angle="light"`` (default): θ is the incidence, cos θ = N·L. Under light at θ_fit the weights are then those
      of the fit, at every view.
    - ``angle="view"``: cos θ = N·V, as ``fresnel_gains`` of the shader ``material.glsl`` takes it, which knows the view
      of a pixel and sums over all its lights.

    Never on top of weights that were fitted at several angles. As in the shader, the gloss is limited so that no
    channel's lobes hold more than 1, and a coat that reflects nothing at θ_fit (index 1) changes nothing.

    Raises FittingError for an ``angle`` of another name.
    """

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

    def _parts(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> tuple[Floats, Floats, Floats]:
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

    def reflected(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return ``f_r·(N·L)`` (..., 3) in 1/sr, cosine included; shapes as for :meth:`LobeWeights.reflected`."""
        cosine, base, gloss = self._parts(wi, wo)
        return np.asarray(np.maximum(cosine, 0.0)[..., None] * base + gloss)

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, **without** the cosine; 0 at or below the horizon."""
        cosine, base, gloss = self._parts(wi, wo)
        return np.asarray(base + gloss / np.where(cosine > 0.0, cosine, 1.0)[..., None])

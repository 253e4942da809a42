"""Fitted non-negative weights of the cosine lobes, and their reflectance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.checks import check_ior
from brdf_suite.reflectance.models.cosine_lobes import lobe_sums


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
        shapes = {"exponents": (count,), "kd": (3,), "kdd": (count, 3), "kg": (count, 3)}
        for name, shape in shapes.items():
            value = np.array(getattr(self, name), dtype=np.float64)
            if value.shape != shape:
                raise FittingError(f"The lobe weights {name} have shape {value.shape}, not {shape}.")
            value.setflags(write=False)
            object.__setattr__(self, name, value)
        # All at once, because this is on the path of every edit; not-a-number is neither.
        together = np.concatenate((self.exponents, self.kd, self.kdd.ravel(), self.kg.ravel()))
        if not (together.min() >= 0.0 and together.max() < np.inf):
            name = next(n for n in shapes if not _is_sound(getattr(self, n)))
            raise FittingError(f"The lobe weights {name} hold a negative or not finite value.")
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
        result: Floats = (2.0 * np.pi / (self.exponents + 1.0)) @ self.kg
        return result


def _is_sound(values: Floats) -> bool:
    return bool((np.isfinite(values) & (values >= 0.0)).all())

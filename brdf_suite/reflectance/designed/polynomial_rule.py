"""Interpolation by a second-order polynomial over the aspecular angle (Westlund and Meyer; Shimizu 2003).

Linear in the reflectance factor, as the papers have it; it may turn negative between two readings of a paint
with much flop, where the caller clamps it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats


@dataclass(frozen=True)
class PolynomialRule:
    """ρ(γ) = c0 + c1 γ + c2 γ² per channel; ``coefficients`` (3, 3), a row per power."""

    coefficients: Floats

    def __call__(self, gamma: Floats) -> Floats:
        """Return ρ (..., 3) at aspecular angles (...), radians; it may be negative."""
        g = gamma[..., None]
        c0, c1, c2 = self.coefficients
        return np.asarray(c0 + g * (c1 + g * c2))

    @classmethod
    def through(cls, gamma: Floats, rho: Floats) -> PolynomialRule:
        """Return the rule for readings ``rho`` (n, 3) at ``gamma`` (n,): exact for 3, else least squares."""
        powers = np.stack((np.ones_like(gamma), gamma, gamma * gamma), axis=1)
        if len(gamma) == 3:
            return cls(np.asarray(np.linalg.solve(powers, rho), np.float64))
        coefficients, *_ = np.linalg.lstsq(powers, rho, rcond=None)
        return cls(np.asarray(coefficients, np.float64))

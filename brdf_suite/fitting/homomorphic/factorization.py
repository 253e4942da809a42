"""Result of a factorization: a reflectance as a product of maps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.factor_words import Factor
from brdf_suite.geometry.parabolic import bilinear
from brdf_suite.reflectance.blocks import in_blocks


@dataclass(frozen=True, eq=False)
class Factorization:
    """f_r = α Π exp(log map), in 1/sr: always positive, above the horizon.

    Attributes
    ----------
    factors
        The factors of the product in their order.
    logs
        Map name to natural logarithms (n, 3) or (n, n, 3), finite, linear working space; the mean of each is 0 in each
        channel, and what that takes is in ``alpha``. They are interpolated as logarithms, as they were fitted.
    alpha
        (3,) in 1/sr.
    """

    factors: tuple[Factor, ...]
    logs: Mapping[str, Floats]
    alpha: Floats

    @property
    def reciprocal(self) -> bool:
        """Whether exchanging light and view changes nothing: a factor of one has its like of the other, of one map."""
        lights = sorted(f.name for f in self.factors if f.projection.name in ("wi", "|wi|"))
        views = sorted(f.name for f in self.factors if f.projection.name in ("wo", "|wo|"))
        return lights == views

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
        found = np.zeros((len(wi), 3))
        found[above] = np.exp(self.log_product(wi[above], wo[above])) * self.alpha
        return found

    def log_product(self, wi: Floats, wo: Floats) -> Floats:
        """Return the sum (n, 3) of the maps' logarithms for directions (n, 3) above the horizon, without α."""
        total = np.zeros((len(wi), 3))
        for factor in self.factors:
            values = self.logs[factor.name]
            texels, weights = bilinear(factor.projection.places(wi, wo), values.shape[:-1])
            flat = values.reshape(-1, values.shape[-1])
            total += np.einsum("kc,kcj->kj", weights, flat[texels])
        return total

    @property
    def numbers(self) -> int:
        """How many numbers it is made of, α included."""
        return sum(values.size for values in self.logs.values()) + self.alpha.size


def normalize_maps(factors: tuple[Factor, ...], logs: Mapping[str, Floats], scale: Floats) -> Factorization:
    """Return the product of maps with mean logarithm 0, and α (3,) = ``scale`` times what the means held."""
    alpha = np.log(scale)
    centred: dict[str, Floats] = {}
    for name, values in logs.items():
        mean = values.reshape(-1, values.shape[-1]).mean(axis=0)
        centred[name] = values - mean
        alpha = alpha + mean * sum(factor.name == name for factor in factors)
    return Factorization(factors, centred, np.exp(alpha))

"""Result of a factorization: a reflectance as a product of maps."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.factor_words import PROJECTIONS, Factor
from brdf_suite.geometry.parabolic import bilinear, look_up_map
from brdf_suite.reflectance.blocks import in_blocks

SYMMETRIC = 0.02
"""RMS of the logarithm within a ring, up to which a map is taken for symmetric: 2 %, what 8 bits hold of a factor."""
_RADIAL_OF = {"wi": "|wi|", "wo": "|wo|", "h": "|h|"}
_AZIMUTHS = 64


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


def _on_rings(log: Floats) -> Floats:
    """Return a map (n, n, 3) along n radii and the azimuths (n, azimuths, 3), between its texels linear."""
    size = len(log)
    radius = (np.arange(size) + 0.5) / size
    turn = 2.0 * np.pi * (np.arange(_AZIMUTHS) + 0.5) / _AZIMUTHS
    places = 0.5 * (np.stack((np.outer(radius, np.cos(turn)), np.outer(radius, np.sin(turn))), axis=-1) + 1.0)
    return look_up_map(log, places.reshape(-1, 2)).reshape(size, _AZIMUTHS, 3)


def asymmetries(product: Factorization) -> dict[str, float]:
    """Return of each map over a hemisphere the RMS distance of its logarithm from the mean of its ring."""
    found = {}
    for factor in product.factors:
        if factor.projection.hemisphere and factor.name not in found:
            rings = _on_rings(product.logs[factor.name])
            # By area: the outer rings are wider.
            weight = (np.arange(len(rings)) + 0.5)[:, None, None]
            square = weight * (rings - rings.mean(axis=1, keepdims=True)) ** 2
            found[factor.name] = float(np.sqrt(square.sum() / (weight.sum() * _AZIMUTHS * 3)))
    return found


def as_radial(product: Factorization, tolerance: float = SYMMETRIC) -> Factorization:
    """Return the product with each map over a hemisphere that is symmetric within ``tolerance`` as its radius alone.

    Isotropic reflectances have such maps under p(ωo) q(h) p(ωi) (McCool, Ang and Ahmad 2001, section 4.3). A map of
    n × n texels then says no more than n/2 rings; n values along the radius hold it with the same fineness twice over.
    """
    symmetric = {name for name, size in asymmetries(product).items() if size <= tolerance}
    logs = dict(product.logs)
    for name in symmetric:
        logs[name] = _on_rings(product.logs[name]).mean(axis=1)
    factors = tuple(
        Factor(one.name, PROJECTIONS[_RADIAL_OF[one.projection.name]], one.size)
        if one.name in symmetric
        else one
        for one in product.factors
    )
    return Factorization(factors, logs, product.alpha)


@dataclass(frozen=True)
class Accuracy:
    """Means over all samples and channels, f_r in 1/sr; relative errors are of samples that are not 0.

    They are the rows of Table 1 of McCool, Ang and Ahmad 2001.

    ``snr_db``: 20 log10(RMS of the samples / RMS of the error).
    """

    mean: float
    mean_found: float
    bias: float
    mean_absolute: float
    largest_absolute: float
    mean_relative: float
    median_relative: float
    largest_relative: float
    rms: float
    snr_db: float


def accuracy(wanted: npt.ArrayLike, found: npt.ArrayLike) -> Accuracy:
    """Return the figures of an approximation ``found`` of ``wanted``, arrays of one shape."""
    truth, guess = np.asarray(wanted, np.float64), np.asarray(found, np.float64)
    error = guess - truth
    seen = np.abs(truth) > 0.0
    relative = np.abs(error[seen]) / np.abs(truth[seen]) if seen.any() else np.zeros(1)
    size, rms = float(np.sqrt(np.mean(truth**2))), float(np.sqrt(np.mean(error**2)))
    return Accuracy(
        mean=float(truth.mean()),
        mean_found=float(guess.mean()),
        bias=float(error.mean()),
        mean_absolute=float(np.abs(error).mean()),
        largest_absolute=float(np.abs(error).max()),
        mean_relative=float(relative.mean()),
        median_relative=float(np.median(relative)),
        largest_relative=float(relative.max()),
        rms=rms,
        snr_db=20.0 * math.log10(size / rms) if size > 0.0 < rms else math.inf,
    )

"""Radially symmetric maps over a hemisphere: detection, and storage as their radius alone.

Isotropic reflectances have such maps under p(ωo) q(h) p(ωi) (McCool, Ang and Ahmad 2001, section 4.3). A map of n × n
texels then says no more than n/2 rings; n values along the radius hold it with the same fineness twice over.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.fitting.homomorphic.factorization import Factorization
from brdf_suite.geometry.factor_words import PROJECTIONS, Factor
from brdf_suite.geometry.parabolic import look_up_map

SYMMETRIC = 0.02
"""RMS of the logarithm within a ring, up to which a map is taken for symmetric: 2 %, what 8 bits hold of a factor."""
_RADIAL_OF = {"wi": "|wi|", "wo": "|wo|", "h": "|h|"}
_AZIMUTHS = 64


def _rings(log: Floats) -> Floats:
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
            rings = _rings(product.logs[factor.name])
            # By area: the outer rings are wider.
            weight = (np.arange(len(rings)) + 0.5)[:, None, None]
            square = weight * (rings - rings.mean(axis=1, keepdims=True)) ** 2
            found[factor.name] = float(np.sqrt(square.sum() / (weight.sum() * _AZIMUTHS * 3)))
    return found


def as_radial(product: Factorization, tolerance: float = SYMMETRIC) -> Factorization:
    """Return the product with each map over a hemisphere that is symmetric within ``tolerance`` as its radius alone."""
    symmetric = {name for name, size in asymmetries(product).items() if size <= tolerance}
    logs = dict(product.logs)
    for name in symmetric:
        logs[name] = _rings(product.logs[name]).mean(axis=1)
    factors = tuple(
        Factor(one.name, PROJECTIONS[_RADIAL_OF[one.projection.name]], one.size)
        if one.name in symmetric
        else one
        for one in product.factors
    )
    return Factorization(factors, logs, product.alpha)

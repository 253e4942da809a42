"""Gloss reading of a paint: the coat by the standard's formula, and the base's own flux.

The base is nearly even over the receptor, so its flux is an integral of f_r cosθo over the receptor's solid
angle; relative to black glass, which sends F of the flux there. Weighted by luminance.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from brdf_suite.appearance.clearcoat_gloss import black_glass, gloss_units, receptor_deg
from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.protocol import Reflectance

_ANGLES = (20, 60)


def base_gloss(base: Reflectance) -> tuple[float, float]:
    """Return the gloss units that ``base`` alone adds at 20° and at 60°."""
    wi, wo, weights = _receptors()
    luminance = base.eval(wi, wo) @ LUMINANCE
    at_20, at_60 = (weights * luminance).sum(axis=-1).tolist()
    return at_20, at_60


def total_gloss(base: Reflectance, coat: CoatLobe) -> tuple[float, float]:
    """Return the gloss units at 20° and at 60° of a base under a coat, as a glossmeter reads them."""
    at_20, at_60 = base_gloss(base)
    return (
        at_20 + gloss_units(20, coat.ior, coat.roughness),
        at_60 + gloss_units(60, coat.ior, coat.roughness),
    )


@cache
def _receptors() -> tuple[Floats, Floats, Floats]:
    """wi (2, 1, 3), wo (2, 9, 3) and weights (2, 9) in GU sr: Gauss-Legendre, 3 by 3 over each receptor."""
    nodes, shares = np.polynomial.legendre.leggauss(3)
    u, v = (grid.ravel() for grid in np.meshgrid(nodes, nodes, indexing="ij"))
    share = np.outer(shares, shares).ravel()
    wi, wo, weights = [], [], []
    for angle in _ANGLES:
        theta = math.radians(angle)
        a, b = (0.5 * math.radians(width) for width in receptor_deg(angle))
        polar, side = theta + a * u, b * v
        view = np.stack((np.cos(side) * np.sin(polar), np.sin(side), np.cos(side) * np.cos(polar)), axis=-1)
        wi.append([[-math.sin(theta), 0.0, math.cos(theta)]])
        wo.append(view)
        # dω = cos(side) dpolar dside.
        weights.append(share * a * b * np.cos(side) * view[:, 2] * 100.0 / black_glass(angle))
    return np.array(wi), np.array(wo), np.array(weights)

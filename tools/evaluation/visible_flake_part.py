"""Fraction of a paint's base reflected by visible flakes, for any pair of directions.

Flakes that cover the share c of the surface are mirrors of reflectance R below a coat of
index n. With their tilts' density p = bell / (π m²) per solid angle, the light in and out through the coat (T), and a
solid angle outside being n² cosθ'/cosθ times that below,

    f = c R T(wi) T(wo) bell / (4π m² n² cosθ'i cosθ'o),

θ' below the coat, in 1/sr. It is what ``realtime.material.flake_share`` has at the mirror direction of the light
that a fit holds for, and it is reciprocal. They have the base's hue, and never send more than most of it.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.flakes.tilt import flake_slope, tilt_bell
from brdf_suite.appearance.flakes.visible import FLAKE_REFLECTANCE, LARGEST_SHARE, flake_coverage
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes
from brdf_suite.geometry.fresnel import fresnel_dielectric


def visible_flake_part(
    flakes: Flakes, wi: npt.ArrayLike, wo: npt.ArrayLike, base: Floats, ior: float, strength: float = 1.0
) -> Floats:
    """Return the part (..., 3) of the base's f_r ``base`` (..., 3), 1/sr, that visible flakes reflect.

    ``wi``, ``wo`` (..., 3) above the horizon, ``ior`` of the coat (1: none), ``strength``: factor on the flakes' light.
    """
    wi, wo = np.asarray(wi, float), np.asarray(wo, float)
    bell = tilt_bell((flake_slope(wi, wo, ior) ** 2).sum(-1), flakes.roughness)
    sent = strength * flake_coverage(flakes) * FLAKE_REFLECTANCE / (4.0 * math.pi * flakes.roughness**2)
    wanted: Floats = sent * bell / ior**2
    for w in (wi, wo):
        below = np.sqrt(1.0 - (w[..., 0] ** 2 + w[..., 1] ** 2) / ior**2)
        wanted = wanted * (1.0 - fresnel_dielectric(w[..., 2], ior)) / np.maximum(below, 1e-6)
    share = np.minimum(wanted / np.maximum(base.max(axis=-1), 1e-12), LARGEST_SHARE)
    return np.asarray(base * share[..., None])

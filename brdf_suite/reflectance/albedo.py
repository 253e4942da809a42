"""How much of the light a reflectance sends back."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from brdf_suite.geometry.directions import Floats
from brdf_suite.reflectance.protocol import Reflectance

_NORMAL = np.array([0.0, 0.0, 1.0])


def normal_albedo(reflectance: Reflectance) -> Floats:
    """Return the share (3,) of light along the normal that an isotropic reflectance sends back.

    2π ∫ f_r cosθ sinθ dθ by 16 Gauss-Legendre points in sin²θ; for smooth reflectances, not for mirror lobes.
    """
    wo, weights = _half_circle()
    return np.asarray(weights @ reflectance.eval(_NORMAL, wo))


@cache
def _half_circle() -> tuple[Floats, Floats]:
    nodes, shares = np.polynomial.legendre.leggauss(16)
    # With s = sin²θ, cosθ sinθ dθ = ds/2, and s runs from 0 to 1.
    s = 0.5 * (nodes + 1.0)
    wo = np.stack((np.sqrt(s), np.zeros_like(s), np.sqrt(1.0 - s)), axis=-1)
    return wo, 0.5 * math.pi * shares

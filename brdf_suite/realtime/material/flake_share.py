"""Fraction of a paint's base reflected by visible flakes, and the smooth remainder.

A paint's flakes lie in many layers; what sparkles are those that can be seen one by one: so many to the square
millimetre, so large. They cover the share c = 1 - exp(-density·π/4·size²) of the surface, and as mirrors they reflect
R of the light on them, in and out through the coat. With the density of tilts p = bell / (2π m²) per solid angle, and
the solid angle of a mirrored direction outside a coat of index n being 4 n² cos²θ'/cosθ times that of the tilt at the
mirror direction (θ' below the coat),

    f(γ) = c R T² bell(δ(γ)) / (8π m² n² cos²θ')

is their mean reflectance at the light's polar angle θ, in 1/sr: δ(γ) the tilt that an aspecular angle sees. Their
colour is the base's there, with R in its largest channel (they are seen through the same pigment), and they never
send more than most of it.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.appearance.visible_flakes import FLAKE_REFLECTANCE, LARGEST_SHARE, flake_coverage
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes
from brdf_suite.geometry.fresnel import fresnel_dielectric


def visible_flake_lobe(
    flakes: Flakes, gamma: Floats, base: Floats, theta: float, ior: float, strength: float = 1.0
) -> Floats:
    """Return the part (n, 3) of a base's lobes ``base`` (n, 3), 1/sr, at γ (n,) radians that visible flakes reflect.

    ``theta`` is the light's polar angle that the lobes hold for, radians, ``ior`` the coat's index; ``strength`` is a
    factor on the flakes' light, 1 being what the module derives.
    """
    n2 = ior * ior
    cos2_below = 1.0 - math.sin(theta) ** 2 / n2
    through = (1.0 - float(fresnel_dielectric(math.cos(theta), ior))) ** 2
    m2 = flakes.roughness**2
    peak = flake_coverage(flakes) * FLAKE_REFLECTANCE * through / (8.0 * math.pi * m2 * n2 * cos2_below)
    wanted = strength * peak * seen_tilts(gamma, theta, ior, flakes.roughness)
    share = np.minimum(wanted / np.maximum(base.max(axis=-1), 1e-12), LARGEST_SHARE)
    return np.asarray(base * share[:, None])


def seen_tilts(gamma: Floats, theta: float, ior: float, roughness: float) -> Floats:
    """Return how many flakes are tilted as γ (n,) radians sees, over how many lie flat: the bell of flake_tilt.glsl.

    In the plane of incidence, with the light at ``theta``: δ = (asin(sin θ / n) - asin(sin(θ - γ) / n)) / 2.
    """
    tilt = 0.5 * (math.asin(math.sin(theta) / ior) - np.arcsin(np.sin(theta - gamma) / ior))
    squared = np.tan(tilt) ** 2
    return np.asarray(((1.0 + squared / roughness**2) / (1.0 + squared)) ** -1.5)

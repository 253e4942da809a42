"""Model of the visible flakes shared by all renderers: slightly wavy aluminium mirrors.

A paint's flakes lie in many layers; visible are those on top, which cover all of the surface or a share of it
(docs/method/sparkle.md).
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.appearance.flakes.tilt import tilt_bell
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes
from brdf_suite.geometry.fresnel import fresnel_dielectric

FLAKE_REFLECTANCE = 0.9
"""Of an aluminium flake, the most common kind; published values are 0.87 to 0.92 over the visible range."""
FLAKE_WAVINESS = 0.01
"""Radians: standard deviation of the tilt within one flake, which is no perfect mirror (docs/method/sparkle.md)."""
FLAKES_SHARE = 0.6
"""Of the base's light at an aspecular angle of 15°: what flakes scatter at their edges, through each other and in the
binder has no texture."""
ASPECULAR = math.radians(15.0)
LARGEST_SHARE = 0.9
"""Of the base's light at any angle."""


def full_density(size_um: float) -> float:
    """Return how many flakes of a size lie side by side on a square millimetre: 4 / (π size²).

    >>> round(full_density(20.0))
    3183
    """
    return 4.0 / (math.pi * (1e-3 * size_um) ** 2)


def flake_coverage(flakes: Flakes) -> float:
    """Return the share of the surface, 0 to 1, that the visible flakes cover; what is more lies below others."""
    return min(flakes.density_per_mm2 / full_density(flakes.size_um), 1.0)


def visible_density(flakes: Flakes) -> float:
    """Return the flakes that can be seen, per mm²: those of a paint, at most so many as lie side by side."""
    return min(flakes.density_per_mm2, full_density(flakes.size_um))


def mirrored_share(flakes: Flakes, ior: float, theta: float) -> float:
    """Return what visible flakes mirror as clean mirrors of light at ``theta``, over what falls on the coat: c R T²."""
    through = (1.0 - float(fresnel_dielectric(math.cos(theta), ior))) ** 2
    return flake_coverage(flakes) * FLAKE_REFLECTANCE * through


def mirrored_by_flakes(flakes: Flakes, ior: float, theta: float = math.pi / 4.0) -> float:
    """Return the mean f_r, 1/sr, of the visible flakes as clean mirrors, at the mirror direction of a light.

    It is c R T² / (4π m² n² cos²θ'): flakes of coverage c and reflectance R below a coat of index ``ior``, whose tilts
    have Beckmann's density of the spread m; ``theta`` is the light's polar angle, θ' below the coat, radians.
    """
    cos2_below = 1.0 - (math.sin(theta) / ior) ** 2
    spread2 = 4.0 * math.pi * (flakes.roughness * ior) ** 2
    return mirrored_share(flakes, ior, theta) / (spread2 * cos2_below)


def flake_dimming(flakes: Flakes, base: float, ior: float, theta: float = math.pi / 4.0) -> float:
    """Return by how much flakes are dimmer than clean mirrors, 0 to 1: by pigment, and by each other.

    They then send :data:`FLAKES_SHARE` of the base's f_r at the aspecular angle :data:`ASPECULAR`, ``base`` (1/sr, of
    its largest channel), or all that they can where that is less; ``theta`` is the light's polar angle, radians.
    """
    mirrored = mirrored_by_flakes(flakes, ior, theta)
    there = mirrored * float(seen_tilts(np.array(ASPECULAR), theta, ior, flakes.roughness))
    return min(1.0, FLAKES_SHARE * base / max(there, 1e-12))


def seen_tilts(gamma: Floats, theta: float, ior: float, roughness: float) -> Floats:
    """Return how many flakes are tilted as γ (...) radians sees, over how many lie flat.

    In the plane of incidence, with the light at ``theta``: δ = (asin(sin θ / n) - asin(sin(θ - γ) / n)) / 2.
    """
    tilt = 0.5 * (math.asin(math.sin(theta) / ior) - np.arcsin(np.sin(theta - gamma) / ior))
    return tilt_bell(np.tan(tilt) ** 2, roughness)

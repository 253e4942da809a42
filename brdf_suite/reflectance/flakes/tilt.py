"""Tilt distribution of flakes, and the tilt that mirrors a light to the eye.

Tilts are slopes: the tangent of the angle from the surface's normal, along two axes. Spreads are of one flake, as a
standard deviation along an axis, in radians of tilt.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats


def flake_slope(wi: npt.ArrayLike, wo: npt.ArrayLike, ior: float) -> Floats:
    """Return the slope (..., 2) of the flake below a coat of index ``ior`` that mirrors ``wi`` to ``wo`` (..., 3).

    Inside the coat a direction's part across the normal is 1/n of that outside (Snell); the flake's normal is
    along the sum of the two.
    """
    wi, wo = np.asarray(wi, float), np.asarray(wo, float)
    n2 = ior * ior
    up = np.sqrt(n2 - (wi[..., :2] ** 2).sum(-1)) + np.sqrt(n2 - (wo[..., :2] ** 2).sum(-1))
    return np.asarray((wi[..., :2] + wo[..., :2]) / np.maximum(up, 1e-6)[..., None])


def tilt_bell(slope2: npt.ArrayLike, roughness: float) -> Floats:
    """Return the density of tilts over that along the normal, q^(-3/2), q = (1 + s²/m²) / (1 + s²), for s² (...)."""
    slope2 = np.asarray(slope2, float)
    q = (1.0 + slope2 / roughness**2) / (1.0 + slope2)
    return np.asarray(q**-1.5)


def tilt_place(slope: Floats, roughness: float) -> tuple[Floats, Floats]:
    """Return where slopes (..., 2) lie on the unit square (..., 2), and how a small angle is stretched there (...).

    Slopes over the roughness make a hemisphere, and the hemisphere is laid on a disc of diameter 1 without a change
    of areas (Lambert): even points are tilts of the density ``tilt_bell`` / (2π m²) per solid angle. The stretch,
    1/rad, is the root of the ratio of areas, (8 m² q^(3/2))^(-1/2).
    """
    wide = slope / roughness
    wide2 = (wide**2).sum(-1)
    up = 1.0 / np.sqrt(1.0 + wide2)
    place = 0.5 + wide * (0.5 * up / np.sqrt(1.0 + up))[..., None]
    stretch = np.sqrt(tilt_bell((slope**2).sum(-1), roughness) / 8.0) / roughness
    return place, np.asarray(stretch)


def beckmann_slopes(slope2: npt.ArrayLike, roughness: npt.ArrayLike) -> Floats:
    """Return Beckmann's density over slopes, exp(-s²/m²) / (π m²), for s² and m (...)."""
    m2 = np.asarray(roughness, float) ** 2
    return np.asarray(np.exp(-np.asarray(slope2, float) / m2) / (math.pi * m2))


def beckmann_tilt(r1: npt.ArrayLike, r2: npt.ArrayLike, roughness: float) -> Floats:
    """Return slopes (..., 2) drawn by even numbers (...): tan θ = m √(-ln(1 - r1)), φ = 2π r2.

    The sampling of Beckmann's distribution by Günther et al. 2005, section 5.2.
    """
    tangent = roughness * np.sqrt(-np.log1p(-np.asarray(r1, float)))
    phi = 2.0 * math.pi * np.asarray(r2, float)
    return np.stack([tangent * np.cos(phi), tangent * np.sin(phi)], axis=-1)

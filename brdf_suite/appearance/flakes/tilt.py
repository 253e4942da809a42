"""Tilt distribution of flakes, and the tilt that mirrors a light to the eye.

Tilts are slopes: the tangent of the angle from the surface's normal, along two axes. Spreads are of one flake, as a
standard deviation along an axis, in radians of tilt.
"""

from __future__ import annotations

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
    """Return the density of tilts over that along the normal, exp(-s²/m²) (1 + s²)^(3/2), for s² (...).

    These are Beckmann's slopes; over π m² it is their density per solid angle.
    """
    slope2 = np.asarray(slope2, float)
    return np.asarray(np.exp(-slope2 / roughness**2) * (1.0 + slope2) ** 1.5)


def tilt_place(slope: Floats, roughness: float) -> tuple[Floats, Floats]:
    """Return where slopes (..., 2) lie on the unit square (..., 2), and how a small angle is stretched there (...).

    They lie on a disc of diameter 1, at the radius √(1 - exp(-s²/m²)) / 2: even points are tilts of the density
    ``tilt_bell`` / (π m²) per solid angle. The stretch, 1/rad, is the root of the ratio of areas, (bell / 4m²)^(1/2).
    """
    wide2 = ((slope / roughness) ** 2).sum(-1)
    grows = -np.expm1(-wide2) / np.where(wide2 > 0.0, wide2, 1.0)
    grows = np.where(wide2 > 0.0, grows, 1.0)
    place = 0.5 + slope / roughness * (0.5 * np.sqrt(grows))[..., None]
    stretch = 0.5 * np.sqrt(tilt_bell((slope**2).sum(-1), roughness)) / roughness
    return place, np.asarray(stretch)

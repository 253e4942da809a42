"""Directional albedo of a reflectance."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.protocol import Reflectance

_NORMAL = np.array([0.0, 0.0, 1.0])

# Rings of half vectors, radians: widths double from this one, a fraction of the narrowest coat lobe, ...
_NARROWEST_RING = 2e-4
# ... up to this, narrow enough that the horizon's cut through a ring costs less than 1e-3.
_WIDEST_RING = 0.05
_RING_NODES = 4
# More azimuths than 128 are asked for where a peak lies away from the mirror direction: narrower rings then, too.
_RING_TIMES_AZIMUTHS = 6.4


def normal_albedo(reflectance: Reflectance) -> Floats:
    """Return the share (3,) of light along the normal that an isotropic reflectance reflects.

    2π ∫ f_r cosθ sinθ dθ by 16 Gauss-Legendre points in sin²θ; for smooth reflectances, not for mirror lobes.
    """
    wo, shares = _half_circle(16)
    return np.asarray(math.pi * shares @ reflectance.eval(_NORMAL, wo))


def directional_albedo(
    reflectance: Reflectance, wi: npt.ArrayLike, azimuths: int = 64, first: float = 0.5
) -> Floats:
    """Return the share (..., 3) of light from ``wi`` (..., 3) that is reflected: ∫ f_r(wi, wo) cosθo dωo.

    By quadrature over the half vector, in rings about the normal that narrow towards it (dωo = 4 wi·h dωh): mirror
    lobes are round there at any incidence, so a coat of roughness .002 is resolved as well as a matt base.

    Parameters
    ----------
    azimuths
        Points on each ring; an anisotropic streak needs more than the default.
    first
        Where the first of them lies, 0 to 1 of a step; the mean of the results for 0 and for 0.5 is that of twice
        as many azimuths on the same rings.
    """
    return _integral(reflectance, wi, azimuths, first, given_light=True)


def white_furnace(
    reflectance: Reflectance, wo: npt.ArrayLike, azimuths: int = 64, first: float = 0.5
) -> Floats:
    """Return the radiance (..., 3) towards ``wo`` (..., 3) under light of 1 from everywhere: ∫ f_r cosθi dωi.

    Equal to :func:`directional_albedo` where the reflectance is reciprocal; ``azimuths`` and ``first`` as there.
    """
    return _integral(reflectance, wo, azimuths, first, given_light=False)


def hemispherical_albedo(reflectance: Reflectance, azimuths: int = 32) -> Floats:
    """Return the share (3,) of even light that is reflected: the mean of the directional albedo over sin²θ.

    For isotropic reflectances, by 6 Gauss-Legendre points.
    """
    wi, shares = _half_circle(6)
    return np.asarray(shares @ directional_albedo(reflectance, wi, azimuths))


def _integral(
    reflectance: Reflectance, fixed: npt.ArrayLike, azimuths: int, first: float, *, given_light: bool
) -> Floats:
    fixed = np.asarray(fixed, float)
    out = np.empty(fixed.shape)
    for index in np.ndindex(fixed.shape[:-1]):
        one = fixed[index]
        # A lobe round about the mirror direction is 1/cosθ times longer than wide here: more azimuths.
        finer = int(2 ** min(5, max(0, math.ceil(math.log2(0.7 / max(float(one[2]), 1e-3))))))
        half, solid = _rings(azimuths * finer, min(_WIDEST_RING, _RING_TIMES_AZIMUTHS / azimuths), first)
        dot = half @ one
        # What is mirrored below the horizon is left out before it is made.
        up = (2.0 * dot * half[:, 2] > one[2]) & (dot > 0.0)
        dot = dot[up]
        other = 2.0 * dot[:, None] * half[up] - one
        pair = (one, other) if given_light else (other, one)
        out[index] = (4.0 * dot * solid[up] * other[:, 2]) @ reflectance.eval(*pair)
    return out


@cache
def _rings(azimuths: int, widest: float, first: float) -> tuple[Floats, Floats]:
    """Half vectors (n, 3) above the horizon, and their solid angles (n,)."""
    edges = [0.0, _NARROWEST_RING]
    while edges[-1] < 0.5 * math.pi:
        edges.append(edges[-1] + min(edges[-1], widest))
    edges[-1] = 0.5 * math.pi
    nodes, shares = np.polynomial.legendre.leggauss(_RING_NODES)
    low, high = np.array(edges[:-1])[:, None], np.array(edges[1:])[:, None]
    theta = (0.5 * (low + high) + 0.5 * (high - low) * nodes).ravel()
    weight = (0.5 * (high - low) * shares).ravel() * np.sin(theta) * (2.0 * math.pi / azimuths)
    phi = (np.arange(azimuths) + first) * (2.0 * math.pi / azimuths)
    return spherical(theta[:, None], phi).reshape(-1, 3), np.repeat(weight, azimuths)


@cache
def _half_circle(points: int) -> tuple[Floats, Floats]:
    """Directions (n, 3) in the plane y = 0 and their shares (n,) of an integral over sin²θ."""
    nodes, shares = np.polynomial.legendre.leggauss(points)
    # With s = sin²θ, cosθ sinθ dθ = ds/2, and s runs from 0 to 1.
    s = 0.5 * (nodes + 1.0)
    wo = np.stack((np.sqrt(s), np.zeros_like(s), np.sqrt(1.0 - s)), axis=-1)
    return wo, 0.5 * shares

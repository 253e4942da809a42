"""Sampling warps: from the unit square to directions, each with its pdf.

``u`` is (..., 2), even in [0, 1); densities are per solid angle. Directions have z as the normal, or lie about
an ``axis``. A direction mirrored at a half vector has the half vector's density over 4 |wo·h| (the Jacobian of
the mirroring, Torrance and Sparrow 1967).
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import spherical

_TINY = 1e-300


def cosine_hemisphere(u: npt.ArrayLike) -> Floats:
    """Return directions (..., 3) above the horizon with density cosθ/π: cos²θ is even."""
    u = np.asarray(u, float)
    return _from_cosine(np.sqrt(1.0 - u[..., 0]), u[..., 1])


def cosine_hemisphere_pdf(w: npt.ArrayLike) -> Floats:
    """Return cosθ/π (...) of directions (..., 3); 0 below the horizon."""
    return np.asarray(np.maximum(np.asarray(w, float)[..., 2], 0.0) / math.pi)


def cosine_lobe(u: npt.ArrayLike, axis: npt.ArrayLike, exponent: npt.ArrayLike) -> Floats:
    """Return directions (..., 3) about unit ``axis`` (..., 3) with density (n+1)/(2π) cosⁿ."""
    u = np.asarray(u, float)
    power = 1.0 / (np.asarray(exponent, float) + 1.0)
    return rotate_to_axis(axis, _from_cosine((1.0 - u[..., 0]) ** power, u[..., 1]))


def cosine_lobe_pdf(w: npt.ArrayLike, axis: npt.ArrayLike, exponent: npt.ArrayLike) -> Floats:
    """Return (n+1)/(2π) (w·axis)ⁿ (...); 0 behind the axis."""
    dot = np.clip(np.einsum("...i,...i", np.asarray(w, float), np.asarray(axis, float)), 0.0, 1.0)
    n = np.asarray(exponent, float)
    return np.asarray((n + 1.0) / (2.0 * math.pi) * dot**n)


def beckmann_normal(u: npt.ArrayLike, m: npt.ArrayLike) -> Floats:
    """Return half vectors (..., 3) with density D cosθ, D = exp(-tan²θ/m²)/(π m² cos⁴θ): θ = atan(m √-ln(1-u))."""
    u = np.asarray(u, float)
    tan2 = np.asarray(m, float) ** 2 * -np.log1p(-u[..., 0])
    return _from_cosine(1.0 / np.sqrt(1.0 + tan2), u[..., 1])


def beckmann_normal_pdf(h: npt.ArrayLike, m: npt.ArrayLike) -> Floats:
    """Return D cosθ (...) of half vectors (..., 3) of unit length; 0 below the horizon."""
    h, m2 = np.asarray(h, float), np.asarray(m, float) ** 2
    # From the parts across, which stay exact where cosθ is 1 but for rounding.
    across, up = h[..., 0] ** 2 + h[..., 1] ** 2, np.maximum(h[..., 2], 1e-60)
    tan2 = across / (up * up)
    density = np.exp(-np.minimum(tan2 / m2, 745.0)) / (math.pi * m2) * (1.0 + tan2) ** 1.5
    return np.where(h[..., 2] > 0.0, density, 0.0)


def ggx_visible_normal(u: npt.ArrayLike, wo: npt.ArrayLike, alpha: npt.ArrayLike) -> Floats:
    """Return half vectors (..., 3) of a GGX surface as ``wo`` (..., 3) sees them.

    The view is stretched so that the surface becomes a hemisphere; directions even on the spherical cap that
    the view sees, added to it, give the normals (Dupuy and Benyoub 2023).
    """
    u, wo, alpha = np.asarray(u, float), np.asarray(wo, float), np.asarray(alpha, float)
    stretch = np.stack(np.broadcast_arrays(alpha, alpha, 1.0), axis=-1)
    seen = wo * stretch
    seen = seen / np.sqrt(np.einsum("...i,...i", seen, seen))[..., None]
    z = (1.0 - u[..., 0]) * (1.0 + seen[..., 2]) - seen[..., 2]
    side, phi = np.sqrt(np.clip(1.0 - z * z, 0.0, 1.0)), 2.0 * math.pi * u[..., 1]
    cap = np.stack((side * np.cos(phi), side * np.sin(phi), z), axis=-1)
    normal = (cap + seen) * stretch
    length = np.maximum(np.sqrt(np.einsum("...i,...i", normal, normal)), _TINY)
    return np.asarray(normal / length[..., None])


def ggx_visible_normal_pdf(h: npt.ArrayLike, wo: npt.ArrayLike, alpha: npt.ArrayLike) -> Floats:
    """Return G1(wo) max(0, wo·h) D(h)/cosθo (...), the density of :func:`ggx_visible_normal`."""
    h, wo, a2 = np.asarray(h, float), np.asarray(wo, float), np.asarray(alpha, float) ** 2
    across = h[..., 0] ** 2 + h[..., 1] ** 2
    # D = α² / (π cos⁴θ (tan²θ + α²)²), with the part across, which stays exact beside cosθ = 1.
    facets = a2 / (math.pi * (across + a2 * h[..., 2] ** 2) ** 2)
    cos_o = np.maximum(wo[..., 2], 0.0)
    sin2 = wo[..., 0] ** 2 + wo[..., 1] ** 2
    # G1/cosθ = 2/(cosθ + √(cos²θ + α² sin²θ)), finite at grazing.
    seen = 2.0 / np.maximum(cos_o + np.sqrt(cos_o * cos_o + a2 * sin2), _TINY)
    dot = np.maximum(np.einsum("...i,...i", wo, h), 0.0)
    return np.where((h[..., 2] > 0.0) & (wo[..., 2] > 0.0), seen * dot * facets, 0.0)


def mirror_at(wo: npt.ArrayLike, h: npt.ArrayLike) -> Floats:
    """Return ``wo`` (..., 3) mirrored about unit half vectors ``h`` (..., 3)."""
    wo, h = np.asarray(wo, float), np.asarray(h, float)
    return np.asarray(2.0 * np.einsum("...i,...i", wo, h)[..., None] * h - wo)


def mirrored_pdf(half_pdf: npt.ArrayLike, wo: npt.ArrayLike, h: npt.ArrayLike) -> Floats:
    """Return the density (...) of :func:`mirror_at` for the half vectors' density."""
    dot = np.abs(np.einsum("...i,...i", np.asarray(wo, float), np.asarray(h, float)))
    return np.asarray(np.asarray(half_pdf, float) / (4.0 * np.maximum(dot, 1e-12)))


def half_vector(wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
    """Return normalize(wi + wo) (..., 3); the normal where the two cancel."""
    total = np.asarray(wi, float) + np.asarray(wo, float)
    length = np.sqrt(np.einsum("...i,...i", total, total))[..., None]
    return np.where(length > 1e-12, total / np.maximum(length, 1e-12), np.array([0.0, 0.0, 1.0]))


def rotate_to_axis(axis: npt.ArrayLike, local: npt.ArrayLike) -> Floats:
    """Return directions (..., 3) given about z turned to lie about the unit ``axis`` (..., 3).

    The frame is that of Duff et al. 2017, continuous but where the axis crosses the horizon.
    """
    axis, local = np.broadcast_arrays(np.asarray(axis, float), np.asarray(local, float))
    x, y, z = axis[..., 0], axis[..., 1], axis[..., 2]
    sign = np.where(z >= 0.0, 1.0, -1.0)
    a = -1.0 / (sign + z)
    b = x * y * a
    first = np.stack((1.0 + sign * x * x * a, sign * b, -sign * x), axis=-1)
    second = np.stack((b, sign + y * y * a, -y), axis=-1)
    return np.asarray(local[..., :1] * first + local[..., 1:2] * second + local[..., 2:] * axis)


def _from_cosine(cosine: Floats, turn: Floats) -> Floats:
    """Return directions (..., 3) at a polar angle of given cosine and an azimuth of ``turn`` full turns."""
    return spherical(np.arccos(np.clip(cosine, -1.0, 1.0)), 2.0 * math.pi * turn)

"""Logarithmic lobe shapes with their derivatives: microfacets with shadowing, and Fresnel.

A lobe of weight ks is ks F D G / (π cosθi cosθo), as equation 1 of Günther et al. 2005 has it. Only ks has a colour.

- Beckmann: D = exp(-tan²θh/m²) / (m² cos⁴θh) and the grooves G of Cook and Torrance 1982, as in
  :mod:`brdf_suite.reflectance.models.cook_torrance`.
- GGX: D = m² / (cos⁴θh (m² + tan²θh)²), and G of Smith, correlated by height, as in
  :mod:`brdf_suite.reflectance.models.ggx`: G / (cosθi cosθo) = 2 / (cosθo √(m² + (1-m²)cos²θi) + the same swapped).

Fresnel's F of a clear dielectric is taken as a function of e = 1/n, from 1 (r = 0) to 0 (r = 1, F = 1 everywhere):
with c = wo·h, s² = 1 - c² and t = √(1 - e² s²),

    A = (t - e c)/(t + e c),   B = (c t - e s²)/(c t + e s²),   F = A² (1 + B²)/2,
    dt/de = -e s²/t,           dA/de = -2c / (t (t + e c)²),    dB/de = -2 c s² / (t (c t + e s²)²),

which is the form of Cook and Torrance with g = t/e, and finite at both ends, where n and its derivatives are not.
r = ((1 - e)/(1 + e))².
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.reflectance.models.half_vector_terms import HalfVectorTerms

_TINY = 1e-300


@dataclass(frozen=True, eq=False)
class Terms:
    """Precomputed terms of n direction pairs above the horizon, (n,) each, shared by all lobes."""

    cos_i: Floats
    cos_o: Floats
    cos_d: Floats
    tan2_h: Floats
    log_grooves: Floats
    """log of G / (cosθi cosθo cos⁴θh) with the grooves of Cook and Torrance."""

    @classmethod
    def of(cls, wi: Floats, wo: Floats) -> Terms:
        """Return the terms of directions (n, 3) above the horizon."""
        found = HalfVectorTerms.of(wi, wo)
        low = np.minimum(found.cos_i, found.cos_o)
        grooves = np.minimum(1.0, 2.0 * found.cos_h * low / found.cos_d)
        shared = grooves * (1.0 + found.tan2_h) ** 2 / np.maximum(found.cos_i * found.cos_o, _TINY)
        logs = np.log(np.maximum(shared, _TINY))
        return cls(found.cos_i, found.cos_o, np.minimum(found.cos_d, 1.0), found.tan2_h, logs)


Shape = Callable[[Terms, float], tuple[Floats, Floats]]
"""``(terms, log m) -> log(D G/(cosθi cosθo)), its derivative by log m``, (n,) each."""


def beckmann(terms: Terms, log_m: float) -> tuple[Floats, Floats]:
    """Return the logarithm of Beckmann's facets in grooves, and its derivative by log m."""
    steep = terms.tan2_h * math.exp(-2.0 * log_m)
    return terms.log_grooves - steep - 2.0 * log_m, 2.0 * steep - 2.0


def ggx(terms: Terms, log_m: float) -> tuple[Floats, Floats]:
    """Return the logarithm of GGX facets with Smith's shadowing, and its derivative by log m."""
    m2 = math.exp(2.0 * log_m)
    t, ci, co = terms.tan2_h, terms.cos_i, terms.cos_o
    far = m2 + t
    root_i = np.sqrt(m2 + (1.0 - m2) * ci * ci)
    root_o = np.sqrt(m2 + (1.0 - m2) * co * co)
    seen = co * root_i + ci * root_o
    slope = co * (1.0 - ci * ci) / root_i + ci * (1.0 - co * co) / root_o
    value = 2.0 * (log_m + np.log1p(t) - np.log(far)) + math.log(2.0) - np.log(np.maximum(seen, _TINY))
    return value, 2.0 - 4.0 * m2 / far - m2 * slope / np.maximum(seen, _TINY)


def fresnel(cosine: Floats, e: float) -> tuple[Floats, Floats]:
    """Return F (n,) and dF/de (n,) at ``cosine`` (n,), 0 to 1, for e = 1/n, 0 to 1."""
    c = cosine
    s2 = 1.0 - c * c
    t = np.sqrt(np.maximum(1.0 - e * e * s2, _TINY))
    across = t + e * c
    along = np.maximum(c * t + e * s2, _TINY)
    a = (t - e * c) / across
    b = (c * t - e * s2) / along
    d_a = -2.0 * c / (t * across * across)
    d_b = -2.0 * c * s2 / (t * along * along)
    whole = 1.0 + b * b
    return 0.5 * a * a * whole, a * (d_a * whole + a * b * d_b)


def reflectance_from_inverse_index(e: float) -> float:
    """Return r, F along the normal, of e = 1/n.

    >>> round(reflectance_from_inverse_index(1.0 / 1.5), 9)
    0.04
    """
    return ((1.0 - e) / (1.0 + e)) ** 2


def inverse_index(r: float) -> float:
    """Return e = 1/n of a reflectance ``r`` along the normal, 0 to 1.

    >>> round(1.0 / inverse_index(0.04), 9)
    1.5
    """
    root = math.sqrt(r)
    return (1.0 - root) / (1.0 + root)

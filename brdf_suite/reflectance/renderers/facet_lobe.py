"""One GGX lobe as renderers with multiple scattering evaluate it.

    f = D V F · c,    F = f0 + (f90 - f0) r(wo·h),

D of Trowbridge and Reitz for α, V the height-correlated visibility of Smith, r a rise from 0 along the normal to 1 at
grazing: Schlick's (1 - wo·h)⁵, or that of a dielectric. Light that meets a second facet comes back by the factor c,
with E the share that one bounce of facets with F = 1 sends to the viewer, and Ē its mean:

- Turquin 2019: c = 1 + F (1 - E) / E;
- Kulla and Conty 2017: c = 1 + F_ms (1 - E) / E, F_ms = F̄ Ē / (1 - F̄ (1 - Ē)).

Everything but three terms, D V, D V r and D V r², depends on the direction of view alone: an integral over the light
needs these three only, whatever f0 is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.facet_albedo import single_scattering_albedo

Compensation = Literal["turquin", "kulla_conty"]

_GAUSS, _SHARES = np.polynomial.legendre.leggauss(32)
_MU: Floats = 0.5 + 0.5 * _GAUSS
_EVEN: Floats = _SHARES * _MU
"""Weights of 2 ∫ · μ dμ at ``_MU``."""


def normal_reflectance(ior: float) -> float:
    """Return ((n - 1) / (n + 1))²."""
    return ((ior - 1.0) / (ior + 1.0)) ** 2


def index_of(reflectance: float) -> float:
    """Return the index of which a dielectric reflects ``reflectance``, below 1, along the normal."""
    root = math.sqrt(reflectance)
    return (1.0 + root) / (1.0 - root)


@dataclass(frozen=True)
class RendererLobe:
    """A lobe of width ``alpha``; ``ior`` is the index of the dielectric that r follows, 1 for Schlick's."""

    alpha: float
    ior: float = 1.0
    compensation: Compensation = "turquin"

    def rise(self, cosine: Floats) -> Floats:
        """Return r (...)."""
        if self.ior == 1.0:
            return np.asarray((1.0 - cosine).clip(0.0) ** 5)
        low = normal_reflectance(self.ior)
        # Of an index above 2.4 it first falls below that along the normal; renderers hold it there.
        return np.asarray((fresnel_dielectric(cosine, self.ior) - low).clip(0.0) / (1.0 - low))

    def terms(self, wi: Floats, wo: Floats) -> Floats:
        """Return D V, D V r and D V r² (n, 3), 1/sr, of directions (n, 3) above the horizon."""
        total = wi + wo
        length = np.linalg.norm(total, axis=-1)
        cos_i, cos_o, a2 = wi[:, 2], wo[:, 2], self.alpha * self.alpha
        tan2 = (total[:, 0] ** 2 + total[:, 1] ** 2) / np.maximum(total[:, 2] ** 2, 1e-60)
        # cos²θh (α² - 1) + 1 = cos²θh (α² + tan²θh), exact beside the normal.
        facets = a2 / (math.pi * ((a2 + tan2) / (1.0 + tan2)) ** 2)
        across = cos_o * np.sqrt(cos_i * cos_i * (1.0 - a2) + a2)
        across = across + cos_i * np.sqrt(cos_o * cos_o * (1.0 - a2) + a2)
        lobe = facets * 0.5 / np.maximum(across, 1e-300)
        rise = self.rise(0.5 * length)
        return np.stack((lobe, lobe * rise, lobe * rise * rise), axis=-1)

    def sum_terms(self, terms: Floats, f0: Floats, cos_o: Floats, f90: Floats | float = 1.0) -> Floats:
        """Return f (n, c) of ``terms`` (n, 3), or their integrals, for ``f0`` (c,) at the view's cosine (n,)."""
        plain, once, twice = (terms[:, k, None] for k in range(3))
        rest = f90 - f0
        single = f0 * plain + rest * once
        lost = self.lost(cos_o)[:, None]
        if self.compensation == "turquin":
            return np.asarray(
                single + lost * (f0 * f0 * plain + 2.0 * f0 * rest * once + rest * rest * twice)
            )
        mean = f0 + rest * self._mean_rise
        again = mean * self._mean_once / (1.0 - mean * (1.0 - self._mean_once))
        return np.asarray(single * (1.0 + lost * again))

    def albedo(self, f0: Floats, cos_o: Floats, f90: Floats | float = 1.0) -> Floats:
        """Return the share (n, c) of light that the lobe sends to views of cosine (n,)."""
        once = single_scattering_albedo("ggx", self.alpha, cos_o)
        risen = single_scattering_albedo("ggx", self.alpha, cos_o, self.rise)
        return np.asarray(f0 + (f90 - f0) * np.clip(risen / once, 0.0, 1.0)[:, None])

    def lost(self, cos_o: Floats) -> Floats:
        """Return (1 - E) / E (n,) for views of cosine (n,)."""
        once = single_scattering_albedo("ggx", self.alpha, cos_o)
        return np.asarray((1.0 - once).clip(0.0) / once)

    @cached_property
    def _mean_once(self) -> float:
        return float(_EVEN @ single_scattering_albedo("ggx", self.alpha, _MU))

    @cached_property
    def _mean_rise(self) -> float:
        return float(_EVEN @ self.rise(_MU))

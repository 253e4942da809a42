"""Single-scattering albedo of microfacet mirrors, and MaterialX's multiple-scattering compensation.

A lobe of Trowbridge and Reitz with Smith's height-correlated shadowing loses the light that meets a second facet. The
reference implementation of MaterialX makes up for it by the factor 1 + F0 (1 - E) / E (Turquin 2019), E being the share
of the light from one direction that one bounce reflects where every facet reflects all.

E is the mean of (1 + Λo) / (1 + Λo + Λi) over the facets that are seen from there (Heitz 2018), here of an even grid of
them; tabulated once over roughness and direction.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from brdf_suite.arrays import Floats

_ALPHAS = np.linspace(0.03, 1.0, 25)
_COSINES = np.linspace(0.04, 1.0, 25)
_EACH = 40


def single_scattering_albedo(alpha: float, cosine: Floats) -> Floats:
    """Return E (n,) for roughness α and the cosines (n,) of the direction's polar angle.

    >>> bool(single_scattering_albedo(0.03, np.array([0.9]))[0] > 0.999)
    True
    """
    table = _table()
    place = float(np.interp(alpha, _ALPHAS, np.arange(len(_ALPHAS))))
    low = min(int(place), len(_ALPHAS) - 2)
    row = table[low] + (place - low) * (table[low + 1] - table[low])
    return np.asarray(np.interp(cosine, _COSINES, row), np.float64)


@cache
def _table() -> Floats:
    steps = (np.arange(_EACH) + 0.5) / _EACH
    u1, u2 = (grid.ravel() for grid in np.meshgrid(steps, steps, indexing="ij"))
    rows = [[_mean(float(alpha), float(cosine), u1, u2) for cosine in _COSINES] for alpha in _ALPHAS]
    return np.array(rows)


def _mean(alpha: float, cosine: float, u1: Floats, u2: Floats) -> float:
    view = np.array([np.sqrt(1.0 - cosine * cosine), 0.0, cosine])
    stretched = view * [alpha, alpha, 1.0]
    stretched /= np.linalg.norm(stretched)
    # The frame about the stretched view: its y axis is ours, since the view has none of it.
    across = np.array([-stretched[2], 0.0, stretched[0]])
    radius, phi = np.sqrt(u1), 2.0 * np.pi * u2
    t1, t2 = radius * np.cos(phi), radius * np.sin(phi)
    share = 0.5 * (1.0 + stretched[2])
    # t1 runs along y, t2 along the axis that leans with the view.
    t2 = (1.0 - share) * np.sqrt(np.maximum(1.0 - t1 * t1, 0.0)) + share * t2
    t3 = np.sqrt(np.maximum(1.0 - t1 * t1 - t2 * t2, 0.0))
    facet = t1[:, None] * [0.0, 1.0, 0.0] + t2[:, None] * across + t3[:, None] * stretched
    facet = facet * [alpha, alpha, 1.0]
    facet[:, 2] = np.maximum(facet[:, 2], 1e-9)
    facet /= np.linalg.norm(facet, axis=-1, keepdims=True)
    light = 2.0 * (facet @ view)[:, None] * facet - view
    up = light[:, 2]
    out = 1.0 + _lambda(np.array([cosine]), alpha)[0]
    weight = np.where(up > 0.0, out / (out + _lambda(np.maximum(up, 1e-6), alpha)), 0.0)
    return float(weight.mean())


def _lambda(cosine: Floats, alpha: float) -> Floats:
    """Λ of Smith for Trowbridge and Reitz: (√(1 + α² tan²θ) - 1) / 2."""
    tan2 = 1.0 / (cosine * cosine) - 1.0
    return np.asarray(0.5 * (np.sqrt(1.0 + alpha * alpha * tan2) - 1.0))

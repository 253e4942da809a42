"""Making of the table of :mod:`brdf_suite.reflectance.facet_albedo`, by quadrature of the lobes themselves.

    D_k(μ, α) = ∫ f(wi, wo) φ_k(wi·h) cosθi dωi - φ_k(μ),    f with F = 1, φ_k the Lagrange polynomials of the c_k.

Half vectors fill the square of a sampling warp of the lobe, so that the integrand is bounded and smooth but for the
horizon; the steepest facets are the densest. Deterministic: the same table on every machine, but for rounding.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial.chebyshev import chebvander

from brdf_suite.arrays import Floats, Singles
from brdf_suite.geometry import warps
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.facet_albedo import (
    COSINES,
    DISTRIBUTIONS,
    FRESNEL_COSINES,
    FRESNEL_NODES,
    ROUGHNESSES,
    Distribution,
)
from brdf_suite.reflectance.models.ggx import PARAMETERS, Ggx
from brdf_suite.reflectance.protocol import Reflectance

# An index so high that every facet reflects all light.
_MIRROR = 1e9
_LOWEST_COSINE = 1e-4
_ALONG, _AROUND = 112, 112


def facet_table(progress: Progress | None = None) -> Singles:
    """Return D (2, 33, 65, 8), rounded to a hundred-thousandth."""
    table = np.zeros((len(DISTRIBUTIONS), len(ROUGHNESSES), len(COSINES), FRESNEL_NODES))
    for first, distribution in enumerate(DISTRIBUTIONS):
        for second, alpha in enumerate(ROUGHNESSES.tolist()):
            done = (first + second / len(ROUGHNESSES)) / len(DISTRIBUTIONS)
            report(progress, done, f"{distribution} facets of α = {alpha:.3g}")
            if alpha > 0.0:
                table[first, second] = [change(distribution, alpha, c) for c in COSINES.tolist()]
    report(progress, 1.0, "the table is made")
    return np.asarray(np.round(table, 5), np.float32)


def change(
    distribution: Distribution, alpha: float, cosine: float, along: int = _ALONG, around: int = _AROUND
) -> Floats:
    """Return D (8,) at one roughness and one cosine of the view, by ``along`` × ``around`` half vectors."""
    rest, turn = ((np.arange(count) + 0.5) / count for count in (along, around))
    u = np.stack(np.meshgrid(1.0 - rest * rest, turn, indexing="ij"), axis=-1).reshape(-1, 2)
    share = np.repeat(2.0 * rest, around) / (along * around)
    cosine = max(cosine, _LOWEST_COSINE)
    wo = np.array([np.sqrt(1.0 - cosine * cosine), 0.0, cosine])
    white: Reflectance
    if distribution == "beckmann":
        h = warps.beckmann_normal(u, alpha)
        density = warps.beckmann_normal_pdf(h, alpha)
        white = CoatLobe(_MIRROR, alpha, "single")
    else:
        alpha = max(alpha, PARAMETERS["alpha"].low)  # the first node lies 2 % below the least α
        h = warps.ggx_visible_normal(u, wo, alpha)
        density = warps.ggx_visible_normal_pdf(h, wo, alpha)
        white = Ggx(0.0, 1.0, alpha, "single")
    seen = h @ wo
    wi = 2.0 * seen[:, None] * h - wo
    up = (seen > 0.0) & (wi[:, 2] > 0.0) & (density > 0.0)
    seen, wi = seen[up], wi[up]
    weight = white.eval(wi, wo)[:, 0] * wi[:, 2] * 4.0 * seen / density[up] * share[up]
    return np.asarray((weight @ _polynomials(seen)) - _polynomials(np.array([cosine]))[0])


def _polynomials(cosine: Floats) -> Floats:
    """φ_k (n, 8) at cosines (n,): with Chebyshev's nodes, the discrete sum over Chebyshev's polynomials."""
    at_nodes = chebvander(2.0 * FRESNEL_COSINES - 1.0, FRESNEL_NODES - 1)
    at_nodes[:, 0] *= 0.5
    return np.asarray(chebvander(2.0 * cosine - 1.0, FRESNEL_NODES - 1) @ at_nodes.T * (2.0 / FRESNEL_NODES))

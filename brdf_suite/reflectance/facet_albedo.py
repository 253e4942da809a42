"""Directional albedo of rough microfacet surfaces with multiple scattering, from a table.

A single-scattering lobe D G F / (4 cosθi cosθo) loses the light that meets a second facet. Of facets that reflect all
light (F = 1) it sends back E(μ), μ = cosθ; 1 - E(μ) is lost. The table of ``brdf-suite shading-table --facets``
(``facet_table.py``) holds how E of any Fresnel reflectance differs from that of a smooth surface:

    E_F(μ) = F(μ) + Σ_k D_k(μ, α) F(c_k),    c_k eight Chebyshev nodes, so that F is a polynomial of degree 7.

What is lost is given back by the lobe of Kulla and Conty 2017,

    f = F_ms (1 - E(μi)) (1 - E(μo)) / (π (1 - Ē)),    F_ms = F̄² Ē / (1 - F̄ (1 - Ē)),

with Ē and F̄ the means of E and F over even light, 2 ∫ · μ dμ: of the light F̄ (1 - Ē) that a first facet sends to
another, a share Ē leaves after each further one, and each reflects F̄. With F = 1 all light comes back. The table's
axes are even in √μ and √α; docs/method/energy.md has the derivation and the errors.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.resources import resource

Distribution = Literal["beckmann", "ggx"]
DISTRIBUTIONS: tuple[Distribution, ...] = get_args(Distribution)

ROUGHNESS_NODES, COSINE_NODES, FRESNEL_NODES = 33, 65, 8
ROUGHNESSES: Floats = np.linspace(0.0, 1.0, ROUGHNESS_NODES) ** 2
_PLACES: Floats = np.arange(float(COSINE_NODES))
COSINES: Floats = np.linspace(0.0, 1.0, COSINE_NODES) ** 2
FRESNEL_COSINES: Floats = 0.5 + 0.5 * np.cos((np.arange(FRESNEL_NODES) + 0.5) * math.pi / FRESNEL_NODES)

NEGLIGIBLE = 1e-4
"""Multiple scattering that returns less than this share of even light is left out; it is then not in E either."""

# Simpson's weights of 2 ∫ · μ dμ = ∫ · 4x³ dx over x = √μ.
_SIMPSON: Floats = np.where(np.arange(COSINE_NODES) % 2 == 0, 2.0, 4.0)
_SIMPSON[[0, -1]] = 1.0
_MEAN: Floats = _SIMPSON * 4.0 * COSINES**1.5 / (3.0 * (COSINE_NODES - 1))
_GAUSS, _GAUSS_SHARES = np.polynomial.legendre.leggauss(64)


@dataclass(frozen=True, eq=False)
class FacetAlbedo:
    """E of facets of one roughness and Fresnel reflectance; channels () where F is grey, (3,) where it is coloured.

    Attributes
    ----------
    fresnel
        F (..., channels) of cosines (...).
    change
        (65, channels): E - F at :data:`COSINES`, multiple scattering included.
    lost
        (65,): 1 - E of facets with F = 1.
    multiple
        (channels): F_ms / (π (1 - Ē)), what ``lost`` of light and view are multiplied by; 0 where negligible.
    """

    fresnel: Callable[[Floats], Floats]
    change: Floats
    lost: Floats
    multiple: Floats

    @cached_property
    def mean(self) -> Floats:
        """The mean (channels) of E over even light."""
        return np.asarray(_mean_of(self.fresnel) + np.tensordot(_MEAN, self.change, 1))

    @property
    def is_multiple(self) -> bool:
        """Whether multiple scattering is more than negligible."""
        return bool(self.multiple.any())

    @property
    def multiple_albedo(self) -> Floats:
        """The share (channels) of even light that comes back after more than one facet."""
        return np.asarray(math.pi * self.multiple * (_MEAN @ self.lost) ** 2)

    def at(self, cosine: npt.ArrayLike) -> Floats:
        """Return E (..., channels), 0 to 1, at ``cosine`` (...)."""
        cosine = np.asarray(cosine, float)
        # Not np.clip, which takes four times as long for few numbers.
        return np.asarray(
            np.minimum(np.maximum(self.fresnel(cosine) + _between(self.change, cosine), 0.0), 1.0)
        )

    def further(self, cos_i: Floats, cos_o: Floats) -> Floats:
        """Return f_r (..., channels), 1/sr, of multiple scattering at cosines (...) above the horizon."""
        both = _between(self.lost, cos_i) * _between(self.lost, cos_o)
        return np.asarray(np.multiply.outer(both, self.multiple))


def facet_albedo(
    distribution: Distribution, alpha: float, fresnel: Callable[[Floats], Floats]
) -> FacetAlbedo:
    """Return E of facets of width ``alpha``, 0 to 1 (held above), and ``fresnel``: F (n, channels) of cosines (n,)."""
    change = _at_roughness(distribution, alpha)
    lost = np.maximum(-change.sum(axis=-1), 0.0)  # the quadrature's error has either sign
    mean_lost = float(_MEAN @ lost)
    of_fresnel = change @ fresnel(FRESNEL_COSINES)
    again = np.zeros(of_fresnel.shape[1:])
    if mean_lost >= NEGLIGIBLE:  # less does not come back even where F = 1
        even = _mean_of(fresnel)
        returned = even**2 * (1.0 - mean_lost) / (1.0 - even * mean_lost)
        if float(np.max(returned)) * mean_lost >= NEGLIGIBLE:
            again = returned
            of_fresnel = of_fresnel + np.multiply.outer(lost, again)
    return FacetAlbedo(fresnel, of_fresnel, lost, np.asarray(again / (math.pi * max(mean_lost, 1e-12))))


def single_scattering_albedo(
    distribution: Distribution,
    alpha: float,
    cosine: npt.ArrayLike,
    fresnel: Callable[[Floats], Floats] | None = None,
) -> Floats:
    """Return E (...) of facets of reflectance ``fresnel`` (all light if None), without multiple scattering.

    ``cosine`` (...) is that of the view, or of the light; ``fresnel`` gives F (...) of cosines (...).

    >>> bool(single_scattering_albedo("ggx", 0.03, 0.9) > 0.998)
    True
    """
    change = _at_roughness(distribution, alpha)
    if fresnel is None:
        return 1.0 + _between(change.sum(axis=-1), cosine)
    return np.asarray(
        fresnel(np.asarray(cosine, float)) + _between(change @ fresnel(FRESNEL_COSINES), cosine)
    )


@lru_cache(maxsize=256)
def coat_albedo(ior: float, roughness: float) -> FacetAlbedo:
    """Return E of a clearcoat: Beckmann facets of a clear dielectric of index ``ior``, seen from outside."""
    return facet_albedo("beckmann", roughness, partial(fresnel_dielectric, ior=ior))


@lru_cache(maxsize=256)
def mean_reflected(ior: float, roughness: float = 0.0) -> float:
    """Return the share of even light that a clearcoat reflects, 2 ∫ (1 - T) μ dμ; ``roughness`` as in :func:`entering`.

    >>> round(mean_reflected(1.5), 3)
    0.092
    """
    if roughness == 0.0:
        return float(_mean_of(partial(fresnel_dielectric, ior=ior)))
    return float(coat_albedo(ior, roughness).mean)


def entering(cosine: npt.ArrayLike, ior: float, roughness: float) -> Floats:
    """Return T (...), the share of light at ``cosine`` (...) that a clearcoat lets through: 1 - E.

    ``roughness`` 0 is the smooth surface, 1 - F, as papers of single scattering take it for every roughness.

    >>> round(float(entering(1.0, 1.5, 0.0)), 6)
    0.96
    """
    if roughness == 0.0:
        return 1.0 - fresnel_dielectric(cosine, ior)
    return 1.0 - coat_albedo(ior, roughness).at(cosine)


def _mean_of(fresnel: Callable[[Floats], Floats]) -> Floats:
    """Return the mean (channels) of F over even light."""
    # With cosθ = x², the steep end at grazing gets most of the points.
    x = 0.5 * (_GAUSS + 1.0)
    return np.asarray(np.tensordot(0.5 * _GAUSS_SHARES * 4.0 * x**3, fresnel(x * x), 1))


def _between(nodes: Floats, cosine: npt.ArrayLike) -> Floats:
    """Return ``nodes`` (65, channels) at cosines (...), (..., channels), by straight lines over √μ."""
    place = np.sqrt(np.maximum(np.asarray(cosine, float), 0.0)) * (COSINE_NODES - 1)
    if nodes.ndim == 1:  # a coat, of which an edit asks a few places at a time
        return np.asarray(np.interp(place, _PLACES, nodes))  # held beyond both ends
    place = np.minimum(place, COSINE_NODES - 1)
    low = np.minimum(place.astype(int), COSINE_NODES - 2)
    share = (place - low).reshape(place.shape + (1,) * (nodes.ndim - 1))
    return np.asarray(nodes[low] + share * (nodes[low + 1] - nodes[low]))


@lru_cache(maxsize=64)
def _at_roughness(distribution: Distribution, alpha: float) -> Floats:
    """D (65, 8) at a roughness: the cubic through the four nearest nodes over √α."""
    place = math.sqrt(min(max(alpha, 0.0), 1.0)) * (ROUGHNESS_NODES - 1)
    first = min(max(int(place) - 1, 0), ROUGHNESS_NODES - 4)
    near = np.arange(4.0)
    weights = [
        math.prod((place - first - other) / (node - other) for other in near if other != node)
        for node in near
    ]
    return np.tensordot(weights, _table()[DISTRIBUTIONS.index(distribution), first : first + 4], 1)


@lru_cache(maxsize=1)
def _table() -> Floats:
    """D (2, 33, 65, 8): by distribution, √α, √μ and node of F."""
    path = resource("shading", "facet_albedo.npy")
    shape = (len(DISTRIBUTIONS), ROUGHNESS_NODES, COSINE_NODES, FRESNEL_NODES)
    try:
        table = np.load(path, allow_pickle=False)
        if table.shape != shape:
            raise ValueError(f"expected {shape}, not {table.shape}")
        return np.asarray(table, np.float64)
    except (OSError, ValueError) as error:
        raise FileError(path, "the table of facets cannot be read; install brdf-suite again") from error

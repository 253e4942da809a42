"""Separable expansion of Kautz and McCool 1999: a sum of products u_j(h) v_j(d), by SVD, signed.

It is what homomorphic factorization is compared with (McCool, Ang and Ahmad 2001, equation 3). h is the half vector,
d the light's direction in the frame about h whose tangent is the surface's one, orthonormalized (Gram-Schmidt). The
reflectance is resampled on a regular grid of both, so it must be known everywhere; the expansion is of least squares
over that grid.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError, ValueRangeError
from brdf_suite.geometry import warps
from brdf_suite.geometry.factor_words import PROJECTIONS
from brdf_suite.geometry.parabolic import bilinear, parabolic_place, texel_directions
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.protocol import Reflectance

MOST_TERMS = 64
_LOWEST = 0.05
"""Cosine to which directions below the horizon are raised: the grid has places that no pair has."""


@dataclass(frozen=True, eq=False)
class Separable:
    """f_r ≈ Σ_j u_j(h) v_j(d) in 1/sr, which may be negative.

    ``u`` (3, terms, n, n) and ``v`` (3, terms, m, m): parabolic maps over half vector and difference, for each channel.
    """

    u: Floats
    v: Floats

    @property
    def terms(self) -> int:
        """How many products are added."""
        return int(self.u.shape[1])

    def first(self, terms: int) -> Separable:
        """Return the expansion cut off after some terms: the best of that many over the grid."""
        return Separable(self.u[:, :terms], self.v[:, :terms])

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the sum (..., 3), signed; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        at_h = _read(self.u, PROJECTIONS["h"].places(wi, wo))
        at_d = _read(self.v, difference_places(wi, wo))
        above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
        return np.where(above[:, None], np.einsum("ctk,ctk->kc", at_h, at_d), 0.0)


def _read(maps: Floats, places: Floats) -> Floats:
    """Return maps (3, terms, n, n) at places (k, 2), bilinear: (3, terms, k)."""
    texels, weights = bilinear(places, maps.shape[2:])
    flat = maps.reshape(*maps.shape[:2], -1)
    return np.asarray(np.einsum("ctks,ks->ctk", flat[..., texels], weights))


def half_frames(h: Floats) -> tuple[Floats, Floats]:
    """Return tangents and bitangents (..., 3) about half vectors (..., 3): the surface's tangent, orthonormalized."""
    across = np.array([1.0, 0.0, 0.0]) - h[..., :1] * h
    # Where the half vector lies along the tangent, the bitangent decides.
    length = np.linalg.norm(across, axis=-1, keepdims=True)
    spare = np.array([0.0, 1.0, 0.0]) - h[..., 1:2] * h
    tangent = np.where(length > 1e-6, across / np.maximum(length, 1e-6), spare)
    return tangent, np.cross(h, tangent)


def difference_places(wi: Floats, wo: Floats) -> Floats:
    """Return places (k, 2) in [0, 1]² of the light's direction about the half vector, on a parabolic map."""
    h = warps.half_vector(wi, wo)
    tangent, bitangent = half_frames(h)
    d = np.stack([np.einsum("ki,ki->k", wi, axis) for axis in (tangent, bitangent, h)], axis=-1)
    return np.stack([0.5 * (place + 1.0) for place in parabolic_place(d)], axis=-1)


def separate(
    reflectance: Reflectance,
    terms: int,
    *,
    half_size: int = 32,
    difference_size: int = 16,
    progress: Progress | None = None,
) -> Separable:
    """Expand ``reflectance`` in ``terms`` products over maps of ``half_size``² and ``difference_size``² texels.

    Pairs of the grid that lie below the horizon are raised to it, each direction for itself.

    Raises
    ------
    ValueRangeError
        ``terms`` is not 1 to 64 and at most the texels of a map.
    FittingError
        The reflectance is not finite somewhere on the grid.
    """
    most = min(MOST_TERMS, half_size**2, difference_size**2)
    if not 1 <= terms <= most:
        raise ValueRangeError("terms", f"expected 1 to {most}, not {terms}")
    h = texel_directions(half_size).reshape(-1, 3)
    d = texel_directions(difference_size).reshape(-1, 3)
    tangent, bitangent = half_frames(h)
    table = np.empty((len(h), len(d), 3))
    for row in range(len(h)):
        if row % half_size == 0:
            report(progress, 0.7 * row / len(h), "sampling the grid")
        frame = np.stack((tangent[row], bitangent[row], h[row]))
        wi = d @ frame
        wo = 2.0 * (wi @ h[row])[:, None] * h[row] - wi
        table[row] = reflectance.eval(_raised(wi), _raised(wo))
    if not np.isfinite(table).all():
        raise FittingError("The reflectance is not finite everywhere on the grid; fill its holes first.")
    u = np.empty((3, terms, half_size, half_size))
    v = np.empty((3, terms, difference_size, difference_size))
    for channel in range(3):
        report(progress, 0.7 + 0.1 * channel, "singular values")
        left, size, right = np.linalg.svd(table[..., channel], full_matrices=False)
        root = np.sqrt(size[:terms])
        u[channel] = (left[:, :terms] * root).T.reshape(u.shape[1:])
        v[channel] = (right[:terms] * root[:, None]).reshape(v.shape[1:])
    return Separable(u, v)


def _raised(w: Floats) -> Floats:
    up = np.maximum(w[:, 2], _LOWEST)
    across = np.hypot(w[:, 0], w[:, 1])
    shrink = np.sqrt(1.0 - up * up) / np.maximum(across, 1e-12)
    return np.stack((w[:, 0] * shrink, w[:, 1] * shrink, up), axis=-1)

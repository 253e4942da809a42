"""Sampling of a sum of parts: select one by its share and sample it; the pdf is the weighted mean.

Every model's sampler is such a mixture, so one place holds the bookkeeping.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import mirror


@dataclass(frozen=True)
class MixturePart:
    """One part: its ``weight``, ``sample(wo, u)`` from u (n, 2), and ``pdf(wi, wo)``; all on (n, 3)."""

    weight: float
    sample: Callable[[Floats, Floats], Floats]
    pdf: Callable[[Floats, Floats], Floats]


class MixtureSampled:
    """Base of a reflectance that is sampled as a mixture of parts."""

    @property
    def _parts(self) -> Sequence[MixturePart]:
        raise NotImplementedError

    def sample(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return directions (..., 3) to the light of a part, for views ``wo`` and ``u`` (..., 3) in [0, 1).

        Of the three numbers two draw, and one chooses the part.
        """
        parts = self._parts
        wo, u = np.broadcast_arrays(np.asarray(wo, float), np.asarray(u, float))
        shape = wo.shape
        view, even = wo.reshape(-1, 3), u.reshape(-1, 3)
        choice = np.searchsorted(_shares(parts).cumsum()[:-1], even[:, 2], side="right")
        out = np.empty_like(view)
        for index, part in enumerate(parts):
            mine = choice == index
            if mine.any():
                out[mine] = part.sample(view[mine], even[mine, :2])
        return out.reshape(shape)

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle; 0 where either direction is below the horizon."""
        parts = self._parts
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        light, view = wi.reshape(-1, 3), wo.reshape(-1, 3)
        total = np.zeros(len(light))
        for share, part in zip(_shares(parts).tolist(), parts, strict=True):
            if share > 0.0:
                total += share * part.pdf(light, view)
        above = (light[:, 2] > 0.0) & (view[:, 2] > 0.0)
        return np.where(above, total, 0.0).reshape(wi.shape[:-1])


def diffuse(weight: float) -> MixturePart:
    """Return a part even in the projected solid angle, for any view."""
    return MixturePart(
        weight, lambda _wo, u: warps.cosine_hemisphere(u), lambda wi, _wo: warps.cosine_hemisphere_pdf(wi)
    )


def mirror_lobe(weight: float, exponent: float) -> MixturePart:
    """Return a cosine lobe about the mirror direction of the view."""
    return MixturePart(
        weight,
        lambda wo, u: warps.cosine_lobe(u, mirror(wo), exponent),
        lambda wi, wo: warps.cosine_lobe_pdf(wi, mirror(wo), exponent),
    )


def beckmann(weight: float, m: float) -> MixturePart:
    """Return mirrors whose normals are spread as a Beckmann surface of slope ``m``."""

    def density(wi: Floats, wo: Floats) -> Floats:
        h = warps.half_vector(wi, wo)
        return warps.mirrored_pdf(warps.beckmann_normal_pdf(h, m), wo, h)

    return MixturePart(weight, lambda wo, u: warps.mirror_at(wo, warps.beckmann_normal(u, m)), density)


def ggx(weight: float, alpha: float) -> MixturePart:
    """Return mirrors at the normals of a GGX surface that the view sees."""

    def density(wi: Floats, wo: Floats) -> Floats:
        h = warps.half_vector(wi, wo)
        return warps.mirrored_pdf(warps.ggx_visible_normal_pdf(h, wo, alpha), wo, h)

    return MixturePart(
        weight, lambda wo, u: warps.mirror_at(wo, warps.ggx_visible_normal(u, wo, alpha)), density
    )


def _shares(parts: Sequence[MixturePart]) -> Floats:
    weights = np.array([part.weight for part in parts])
    total = weights.sum()
    # A black model may be sampled in any way.
    return np.asarray(weights / total if total > 0.0 else np.full(len(parts), 1.0 / len(parts)))

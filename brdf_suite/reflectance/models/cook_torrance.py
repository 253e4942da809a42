"""Cook-Torrance with any number of lobes, as equation 1 of Günther et al. 2005 has it:

    f_r = kd/π + Σ ks F(wo·h; r) D(θh; m) G / (π cosθi cosθo).

D = exp(-tan²θh/m²) / (m² cos⁴θh): over the π of the equation that is Beckmann's distribution, whose projected
area is 1, so that a lobe of ks = ¼ is a mirror surface of rough facets. Section 5.1.3 of the paper prints a
quarter of this D; ``d_norm = "quarter"`` takes that one.

G = min(1, 2 cosθh cosθo / (wo·h), 2 cosθh cosθi / (wo·h)), the V-shaped grooves of Cook and Torrance 1982.

F is Fresnel's for a clear dielectric with the index that reflects r along the normal, n = (1+√r)/(1-√r), in
the form of Cook and Torrance with g² = n² - 1 + c²; it is 1 for r = 1. Reciprocal, since every term is.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import PARAMETERS, CookTorrancePaint
from brdf_suite.documents.parameter import Parameter
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance
from brdf_suite.reflectance.models.half_vector_terms import HalfVectorTerms

# The widest facets leave gaps towards grazing that a few even directions fill.
_LEAST_DIFFUSE_SHARE = 0.05


@dataclass(frozen=True)
class CookTorrance(mixture.MixtureSampled):
    """Cook-Torrance lobes of a checked :class:`CookTorrancePaint`; its clearcoat is not part of this model."""

    paint: CookTorrancePaint
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True

    @property
    def energy_conserving(self) -> bool:
        """Return whether the weights cannot reflect more than arrives.

        Facets in V-shaped grooves reflect at most all light, so kd + 4 Σ ks ≤ 1 suffices (Σ ks in the quarter
        form); more may still conserve energy, where F is small.
        """
        weights = np.array([lobe.ks for lobe in self.paint.lobes]).reshape(-1, 3).sum(axis=0)
        return bool(np.all(np.array(self.paint.kd) + self._facet_scale * weights <= 1.0))

    @property
    def _facet_scale(self) -> float:
        return 4.0 if self.paint.d_norm == "full" else 1.0

    @cached_property
    def _lobes(self) -> tuple[tuple[float, float, float | None], ...]:
        """(1/m², scale of D, n² - 1 or None for F = 1) of each lobe."""
        scale = 0.25 * self._facet_scale
        return tuple(
            (
                1.0 / lobe.m**2,
                scale / lobe.m**2,
                index_from_reflectance(lobe.r) ** 2 - 1.0 if lobe.r < 1.0 else None,
            )
            for lobe in self.paint.lobes
        )

    @cached_property
    def _weights(self) -> Floats:
        return np.array([lobe.ks for lobe in self.paint.lobes]).reshape(-1, 3) / math.pi

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        terms = HalfVectorTerms.of(wi, wo)
        c, tan2 = terms.cos_d, terms.tan2_h
        low = np.minimum(terms.cos_i, terms.cos_o)
        grooves = np.minimum(1.0, 2.0 * terms.cos_h * low / c)
        # Below the horizon tan⁴ is huge and the product of cosines no divisor.
        cosines = np.where(terms.above, np.maximum(terms.cos_i * terms.cos_o, 1e-300), 1.0)
        # 1/cos⁴θh = (1 + tan²θh)².
        shared = grooves * (1.0 + tan2) ** 2 / cosines
        shared[~terms.above] = 0.0
        c2 = c * c
        lobes = np.empty((len(self._lobes), len(c)))
        for row, (steep, height, bend) in zip(lobes, self._lobes, strict=True):
            np.multiply(tan2, -steep, out=row)
            np.exp(row, out=row)
            row *= height
            row *= shared
            if bend is not None:
                g = np.sqrt(bend + c2)
                up, down = g + c, g - c
                tilted = (c * up - 1.0) / (c * down + 1.0)
                ratio = down / up
                tilted *= tilted
                tilted += 1.0
                ratio *= ratio
                ratio *= tilted
                ratio *= 0.5
                row *= ratio
        value = lobes.T @ self._weights
        value += np.array(self.paint.kd) / math.pi
        value[~terms.above] = 0.0
        return value

    @cached_property
    def _parts(self) -> list[mixture.MixturePart]:
        kd = luminance(np.array(self.paint.kd))
        lobes = [
            # The mean of F over the directions is a little above that along the normal.
            mixture.beckmann(
                self._facet_scale * luminance(np.array(lobe.ks)) * (lobe.r + 0.05 * (1.0 - lobe.r)), lobe.m
            )
            for lobe in self.paint.lobes
        ]
        least = _LEAST_DIFFUSE_SHARE * (kd + sum(part.weight for part in lobes))
        return [mixture.diffuse(max(kd, least)), *lobes]


def index_from_reflectance(r: float) -> float:
    """Return the index of refraction that reflects ``r`` < 1 along the normal: r = ((n-1)/(n+1))².

    >>> round(index_from_reflectance(0.04), 9)
    1.5
    """
    root = math.sqrt(r)
    return (1.0 + root) / (1.0 - root)

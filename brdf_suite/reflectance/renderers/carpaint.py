"""LuxCore's ``carpaint``: a matt layer and three lobes, the third the clearcoat (Günther et al. 2005).

    f_r = kd / π + Σ ks_i D(h; m_i) G(wi; m_i) G(wo; m_i) F(wo·h; R_i) / (4 cosθi cosθo),

D = m² / (π (m² cos²θh + 1 - cos²θh)²) of Schlick 1994 (that of Trowbridge and Reitz),
G(w) = cosθ / (cosθ (1 - m²) + m²), F = R + (1 - R)(1 - wo·h)⁵. The absorption of the coat is switched off (ka 0, d 0).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.models import mixture

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class CarPaint(mixture.MixtureSampled):
    """Parameters by LuxCore's names, colours in linear Rec. 709, 0 to 1."""

    kd: Rgb
    ks: tuple[Rgb, Rgb, Rgb]
    r: Rgb
    m: Rgb
    reciprocal: ClassVar[bool] = True
    energy_conserving: ClassVar[bool] = False
    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, working space, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
        value = np.zeros((len(wi), 3))
        value[above] = self.sum_terms(self.terms(wi[above], wo[above])) @ REC709_TO_WORKING.T
        return value

    def terms(self, wi: Floats, wo: Floats) -> Floats:
        """Return the layers of weight 1 (n, 4), 1/sr, of directions above the horizon: matt, and the lobes."""
        lobes = [lobe(wi, wo, m, r) for m, r in zip(self.m, self.r, strict=True)]
        return np.stack((np.full(len(wi), 1.0 / math.pi), *lobes), axis=-1)

    def sum_terms(self, terms: Floats) -> Floats:
        """Return f_r (n, 3), linear Rec. 709, of ``terms`` (n, 4), or what they integrate to."""
        return np.asarray(terms @ np.array([self.kd, *self.ks]))

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        lobes = [mixture.ggx(0.02 + max(ks), m) for ks, m in zip(self.ks, self.m, strict=True)]
        return [mixture.diffuse(max(self.kd) + 0.02), *lobes]


def lobe(wi: Floats, wo: Floats, m: float, r: float) -> Floats:
    """Return one lobe (n,) of weight 1, 1/sr."""
    total = wi + wo
    cos_i, cos_o, a2 = wi[:, 2], wo[:, 2], m * m
    tan2 = (total[:, 0] ** 2 + total[:, 1] ** 2) / np.maximum(total[:, 2] ** 2, 1e-60)
    facets = a2 / (math.pi * ((a2 + tan2) / (1.0 + tan2)) ** 2)
    seen = 1.0 / ((cos_i * (1.0 - a2) + a2) * (cos_o * (1.0 - a2) + a2))
    rest = 1.0 - 0.5 * np.linalg.norm(total, axis=-1)
    return np.asarray(0.25 * facets * seen * (r + (1.0 - r) * rest.clip(0.0) ** 5))

"""Brushed metal and satin as parallel cylinders on a floor (Poulin and Fournier 1990), single scattering.

Cylinders of radius 1 lie along x, ``spacing`` apart; the floor is at ``floor`` above their axes, so their
sides reach the slope φm = arccos(floor). Every facet reflects as a matt and a glossy part,

    f = kd/π + ks (n+2)(n+4) / (8π (2^(-n/2) + n)) (N·h)ⁿ,

which alone reflects kd + ks along its normal and less elsewhere. What is seen is the sum over the facets
that light and view both reach, over one period:

    f_r = ∫ f (N·i)+ (N·o)+ ds / (spacing cosθi cosθo).

The paper's own account: the visible and lit part of the arc is an interval that the projections of the two
directions on the yz plane decide; so is that of the floor. With the projection at angle a from z towards +y,
the facet N = (0, sin φ, cos φ) faces it for φ > a - π/2, and the next cylinder hides it for

    sin(φ - a) > spacing cos a - 1,

since that line passes nearer than 1 to the next axis, unless the cylinder ends below the line. The floor is lit
up to spacing - (1 - floor sin a)/cos a. The matt integral is elementary; the glossy one is done by
Gauss-Legendre points about its peak (the paper tabulates Chebyshev polynomials). Reciprocal, anisotropic.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, partial
from types import MappingProxyType
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import Parameter, set_numbers
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry import warps
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import luminance, set_rgb

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        "kd": Parameter("Diffuse", "", 0.0, 1.0, 0.1, "Matt reflectance of a facet, linear Rec. 2020"),
        "ks": Parameter("Specular", "", 0.0, 1.0, 0.6, "Glossy reflectance of a facet, linear Rec. 2020"),
        "exponent": Parameter("Exponent", "", 0.0, 1e5, 50.0, "Sharpness n of a facet's gloss"),
        "spacing": Parameter("Spacing", "radii", 0.01, 1e3, 2.5, "Distance between the cylinders' axes"),
        "floor": Parameter("Floor", "radii", 0.0, 0.9999, 0.6, "Height of the floor above the axes"),
    }
)

# The points and weights in [-1, 1]: computed once, they take longer than a few hundred pairs.
_GAUSS_LEGENDRE = cache(partial(np.polynomial.legendre.leggauss, 24))
# Half the width of the peak (cos x)ⁿ in units of 1/√n: beyond it less than 1e-9 of it is left.
_PEAK = 6.5
# Pairs a block: each is spread over the nodes.
_BLOCK = 2048


@dataclass(frozen=True, eq=False)
class PoulinFournier(mixture.MixtureSampled):
    """Parallel cylinders along the tangent x; the highlight stretches across them, along y.

    Raises
    ------
    ValueRangeError
        A parameter is out of its range, or the cylinders stand so close that they would meet above the floor.
    """

    kd: npt.ArrayLike = 0.1
    ks: npt.ArrayLike = 0.6
    exponent: float = 50.0
    spacing: float = 2.5
    floor: float = 0.6
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True

    def __post_init__(self) -> None:
        set_rgb(self, PARAMETERS, "kd", "ks")
        set_numbers(self, PARAMETERS, "exponent", "spacing", "floor")
        least = 2.0 * math.sin(self.steepest)
        if self.spacing < least - 1e-12:
            raise ValueRangeError(
                "spacing",
                f"cylinders over a floor at {self.floor:g} need at least {least:.4g}, not {self.spacing:g}",
            )

    @property
    def steepest(self) -> float:
        """φm, radians: the slope at which a cylinder meets the floor."""
        return math.acos(self.floor)

    @property
    def energy_conserving(self) -> bool:
        """Return whether a facet reflects no more than it gets; then neither does the surface."""
        return bool(np.all(np.asarray(self.kd) + np.asarray(self.ks) <= 1.0))

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo, _BLOCK)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        cos_i, cos_o = wi[:, 2], wo[:, 2]
        above = (cos_i > 0.0) & (cos_o > 0.0)
        angle_i, size_i = np.arctan2(wi[:, 1], cos_i), np.hypot(wi[:, 1], cos_i)
        angle_o, size_o = np.arctan2(wo[:, 1], cos_o), np.hypot(wo[:, 1], cos_o)
        (low_i, high_i), (low_o, high_o) = self._arc(angle_i), self._arc(angle_o)
        low, high = np.maximum(low_i, low_o), np.minimum(high_i, high_o)
        high = np.maximum(low, high)
        floor = self._lit_floor(angle_i, angle_o)
        both = size_i * size_o
        # ∫ cos(φ - a) cos(φ - b) dφ = ½ (Δφ cos(a - b) + ½ [sin(2φ - a - b)]).
        total = angle_i + angle_o
        waves = 0.5 * (np.sin(2.0 * high - total) - np.sin(2.0 * low - total))
        matt = 0.5 * both * ((high - low) * np.cos(angle_i - angle_o) + waves) + floor * cos_i * cos_o
        half = warps.half_vector(wi, wo)
        glossy = both * self._glossy_arc(half, low, high, angle_i, angle_o)
        glossy += floor * cos_i * cos_o * np.maximum(half[:, 2], 0.0) ** self.exponent
        per = self.spacing * np.where(above, cos_i * cos_o, 1.0)
        value = (matt / per)[:, None] * (np.asarray(self.kd) / math.pi)
        n = self.exponent
        norm = float((n + 2.0) * (n + 4.0) / (8.0 * math.pi * (2.0 ** (-0.5 * n) + n)))
        value += (glossy / per * norm)[:, None] * np.asarray(self.ks)
        return np.where(above[:, None], np.maximum(value, 0.0), 0.0)

    def _arc(self, angle: Floats) -> tuple[Floats, Floats]:
        """The slopes φ (low, high) of the arc that a direction at ``angle`` from z, towards +y, reaches."""
        a = np.abs(angle)
        end = self.steepest
        line = self.spacing * np.cos(a) - 1.0
        # Where the next cylinder's body lies ahead on the line from the arc's foot, it hides what is below the line.
        hides = (line < 1.0) & (self.spacing * np.sin(a) > np.cos(end - a))
        high = np.where(hides, a + np.arcsin(np.clip(line, -1.0, 1.0)), a + 0.5 * math.pi)
        high = np.clip(high, -end, end)
        low = np.clip(a - 0.5 * math.pi, -end, end)
        right = angle >= 0.0
        return np.where(right, low, -high), np.where(right, high, -low)

    def _lit_floor(self, *angles: Floats) -> Floats:
        """The length of floor between two cylinders that all the directions reach."""
        foot = math.sin(self.steepest)
        low, high = np.full_like(angles[0], foot), np.full_like(angles[0], self.spacing - foot)
        for angle in angles:
            a = np.abs(angle)
            # The line that touches the cylinder, where it touches above the floor; else the cylinder's foot.
            touching = np.sin(a) > self.floor
            reach = np.where(touching, (1.0 - self.floor * np.sin(a)) / np.maximum(np.cos(a), 1e-12), foot)
            high = np.where(angle > 0.0, np.minimum(high, self.spacing - reach), high)
            low = np.where(angle < 0.0, np.maximum(low, reach), low)
        return np.maximum(high - low, 0.0)

    def _glossy_arc(
        self, half: Floats, low: Floats, high: Floats, angle_i: Floats, angle_o: Floats
    ) -> Floats:
        """∫ (N·h)ⁿ cos(φ - i) cos(φ - o) dφ (n,) from ``low`` to ``high``."""
        peak, size = np.arctan2(half[:, 1], half[:, 2]), np.hypot(half[:, 1], half[:, 2])
        phi, weight = _points_about_peak(peak, low, high, self.exponent)
        bell = np.maximum(np.cos(phi - peak[:, None]), 0.0) ** self.exponent
        bell *= np.cos(phi - angle_i[:, None]) * np.cos(phi - angle_o[:, None])
        return np.asarray(size**self.exponent * np.sum(weight * bell, axis=1))

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        kd, ks = luminance(np.asarray(self.kd)), luminance(np.asarray(self.ks))
        # Where the surface is seen from above, this share of it is floor.
        flat = 1.0 - 2.0 * math.sin(self.steepest) / self.spacing
        return [
            mixture.diffuse(kd + 0.1 * ks),
            mixture.MixturePart(ks * flat, self._draw_floor, self._floor_pdf),
            mixture.MixturePart(ks * (1.0 - flat), self._draw_arc, self._arc_pdf),
        ]

    def _draw_floor(self, wo: Floats, u: Floats) -> Floats:
        return warps.mirror_at(wo, warps.cosine_lobe(u, np.array([0.0, 0.0, 1.0]), self.exponent))

    def _floor_pdf(self, wi: Floats, wo: Floats) -> Floats:
        h = warps.half_vector(wi, wo)
        return warps.mirrored_pdf(warps.cosine_lobe_pdf(h, np.array([0.0, 0.0, 1.0]), self.exponent), wo, h)

    def _draw_arc(self, wo: Floats, u: Floats) -> Floats:
        # The slope is even over the arc; its digits below the cell turn the half vector about the facet's normal.
        cells = 4096.0
        scaled = u[:, 1] * cells
        turn = scaled - np.floor(scaled)
        phi = (2.0 * (np.floor(scaled) + 0.5) / cells - 1.0) * self.steepest
        normal = np.stack((np.zeros_like(phi), np.sin(phi), np.cos(phi)), axis=-1)
        h = warps.cosine_lobe(np.stack((u[:, 0], turn), axis=-1), normal, self.exponent)
        return warps.mirror_at(wo, h)

    def _arc_pdf(self, wi: Floats, wo: Floats) -> Floats:
        h = warps.half_vector(wi, wo)
        peak, size = np.arctan2(h[:, 1], h[:, 2]), np.hypot(h[:, 1], h[:, 2])
        end = np.full_like(peak, self.steepest)
        phi, weight = _points_about_peak(peak, -end, end, self.exponent)
        bell = np.sum(weight * np.maximum(np.cos(phi - peak[:, None]), 0.0) ** self.exponent, axis=1)
        density = (self.exponent + 1.0) / (4.0 * math.pi * self.steepest) * size**self.exponent * bell
        return warps.mirrored_pdf(density, wo, h)

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle."""
        whole = super().pdf
        return in_blocks(lambda i, o: np.repeat(whole(i, o)[:, None], 3, axis=1), wi, wo, _BLOCK)[..., 0]


def _points_about_peak(peak: Floats, low: Floats, high: Floats, exponent: float) -> tuple[Floats, Floats]:
    """Gauss-Legendre points (n, nodes) and weights over the part of [low, high] where cosⁿ(φ - peak) counts."""
    nodes, shares = _GAUSS_LEGENDRE()
    width = min(0.5 * math.pi, _PEAK / math.sqrt(exponent) if exponent > 0.0 else math.inf)
    first = np.clip(peak - width, low, high)
    last = np.clip(peak + width, low, high)
    centre, reach = 0.5 * (first + last), 0.5 * (last - first)
    return centre[:, None] + reach[:, None] * nodes, reach[:, None] * shares

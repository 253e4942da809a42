"""Half-angle table in the renderer, with the core's trilinear look-up."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from brdf_suite.reference.bsdfs.directions import TINY, Colour, Real, Vector
from brdf_suite.reference.bsdfs.terms import Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable


@dataclass(frozen=True, eq=False)
class HalfAngleTable:
    """Trilinear between the centres of bins (θh, θd, φd), as ``trilinear`` of the measured tables."""

    table: IsotropicTable
    values: Any
    samplers: Sequence[Sampler]

    @classmethod
    def of(cls, table: IsotropicTable, samplers: Sequence[Sampler]) -> HalfAngleTable:
        """Return the counterpart; ``samplers`` are those that suit its values."""
        values = mi.Float(np.ascontiguousarray(table.values, np.float32).ravel())
        dr.eval(values)
        return cls(table, values, samplers)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        grid = self.table.grid
        total, apart = light + view, light - view
        flat = total.x * total.x + total.y * total.y
        length = dr.sqrt(flat + total.z * total.z)
        h = dr.sqrt(dr.atan2(dr.sqrt(flat), total.z) / (0.5 * math.pi)) * grid.theta_h
        along_d = dr.atan2(dr.norm(apart), length) * (grid.theta_d / (0.5 * math.pi))
        turn = total.x * apart.y - total.y * apart.x
        ahead = -apart.z * length
        if grid.reciprocal:
            ahead = dr.select(turn < 0.0, -ahead, ahead)
            turn = dr.abs(turn)
        phi = dr.atan2(turn, dr.select(dr.abs(ahead) + dr.abs(turn) < TINY, 1.0, ahead))
        phi = dr.select(phi < 0.0, phi + 2.0 * math.pi, phi)
        p = phi * (grid.phi_d / grid.period) - 0.5
        p = dr.select(p < 0.0, p + grid.phi_d, p)
        i, u = _within(h, grid.theta_h)
        j, v = _within(along_d, grid.theta_d)
        k = dr.minimum(mi.UInt32(p), grid.phi_d - 1)
        w = p - mi.Float(k)
        after = dr.select(k + 1 >= grid.phi_d, mi.UInt32(0), k + 1)
        colour = mi.Color3f(0.0)
        for di, su in ((0, 1.0 - u), (1, u)):
            for dj, sv in ((0, 1.0 - v), (1, v)):
                row = ((i + di) * grid.theta_d + (j + dj)) * grid.phi_d
                first = dr.gather(mi.Color3f, self.values, row + k)
                second = dr.gather(mi.Color3f, self.values, row + after)
                colour += su * sv * dr.fma(w, second - first, first)
        return dr.maximum(colour, 0.0)


def _within(place: Real, bins: int) -> tuple[Any, Real]:
    between = dr.clip(place - 0.5, 0.0, bins - 1.0)
    low = dr.minimum(mi.UInt32(between), bins - 2)
    return low, between - mi.Float(low)

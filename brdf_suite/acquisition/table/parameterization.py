"""The three parameterizations of an isotropic reflectance in Figure 4: bin of a direction pair, centre of a bin.

After Günther, Chen, Goesele, Wald and Seidel, "Efficient Acquisition and Realistic Rendering of Car Paint" (2005),
section 4.1. ``half-angle`` is the layout that is kept: θh non-linear, so that highlights get fine bins. The others
stand beside it for comparison: ``linear``, the same with bins of one width along θh, and ``traditional``, the polar
angles of light and view and the azimuth between them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from brdf_suite.arrays import Floats, Singles
from brdf_suite.geometry.directions import from_half_angle_coordinates, spherical
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid

Layout = Literal["half-angle", "linear", "traditional"]
LAYOUTS: tuple[Layout, ...] = get_args(Layout)

_HALF_PI = 0.5 * np.pi


@dataclass(frozen=True)
class Parameterization:
    """Bins of one layout: along (θh, θd, φd), or (θi, θo, Δφ) where it is ``traditional``.

    >>> Parameterization("traditional").shape
    (90, 90, 180)
    """

    layout: Layout = "half-angle"
    shape: tuple[int, int, int] = (90, 90, 180)

    @property
    def bins(self) -> int:
        """Return the number of bins in all."""
        return int(np.prod(self.shape))

    @property
    def goes_round(self) -> bool:
        """Return whether the last axis goes round: a pair and its swap are one, so φd = π is φd = 0.

        Otherwise it ends at both sides as a mirror does: Δφ and -Δφ are one in an isotropic reflectance.
        """
        return self.layout != "traditional"

    @property
    def grid(self) -> HalfAngleGrid:
        """Return the bins of the two half-angle layouts; their θh is right for ``half-angle`` alone."""
        return HalfAngleGrid(*self.shape)

    def index_of(self, wi: Floats, wo: Floats) -> Floats:
        """Return places (3, n) in index space of directions (n, 3) above the horizon; bin k spans k to k + 1."""
        i, o = np.ascontiguousarray(wi.T), np.ascontiguousarray(wo.T)
        if self.layout == "traditional":
            turn = np.abs(np.arctan2(i[0] * o[1] - i[1] * o[0], i[0] * o[0] + i[1] * o[1]))
            polar_i = np.arctan2(np.hypot(i[0], i[1]), i[2])
            polar_o = np.arctan2(np.hypot(o[0], o[1]), o[2])
            scale = np.array(self.shape)[:, None] / np.array([_HALF_PI, _HALF_PI, np.pi])[:, None]
            places: Floats = np.stack((polar_i, polar_o, turn)) * scale
        else:
            h, d, p = self.grid.index_of(i, o)
            if self.layout == "linear":
                # The non-linear place is n·√(θh / (π/2)).
                h = h * h / self.shape[0]
            places = np.stack((h, d, p))
        # θ = π/2 and Δφ = π belong to the last bin.
        ends = np.nextafter(np.array(self.shape, float), 0.0)[:, None]
        return np.asarray(np.minimum(places, ends), np.float64)

    def centres(self, first: int) -> tuple[Floats, Floats]:
        """Return ``wi`` and ``wo`` (b, c, 3) at the centres of the bins with index ``first`` along the first axis."""
        a, b, c = self.shape
        second = (np.arange(b) + 0.5) / b * _HALF_PI
        third = (np.arange(c) + 0.5) / c * np.pi
        if self.layout == "traditional":
            wi = spherical(_HALF_PI * (first + 0.5) / a, np.zeros((b, c)))
            return wi, spherical(second[:, None], third[None, :])
        share = (first + 0.5) / a
        theta_h = _HALF_PI * (share if self.layout == "linear" else share * share)
        return from_half_angle_coordinates(theta_h, 0.0, second[:, None], third[None, :])

    def cosines(self) -> tuple[Singles, Singles]:
        """Return cos θi and cos θo (shape) at the centres of the bins; negative below the horizon."""
        light = np.empty(self.shape, np.float32)
        view = np.empty(self.shape, np.float32)
        for first in range(self.shape[0]):
            wi, wo = self.centres(first)
            light[first], view[first] = wi[..., 2], wo[..., 2]
        return light, view

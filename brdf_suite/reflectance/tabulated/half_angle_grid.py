"""Bins of an isotropic half-angle table: bin of a direction pair, centre of a bin.

Axes (Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation", 1998): θh non-linear, bin k
from (k/n)²·π/2 to ((k+1)/n)²·π/2, so that highlights get fine bins; θd linear over [0, π/2); φd linear over
[0, π) where the table is reciprocal - swapping ``wi`` and ``wo`` turns φd by π - and over [0, 2π) where it is not.
A bin's value belongs to its centre in index space, k + ½.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import from_half_angle_coordinates

_HALF_PI = 0.5 * np.pi
_MAX_BINS = 1 << 26


@dataclass(frozen=True)
class HalfAngleGrid:
    """Numbers of bins along (θh, θd, φd), each at least 2; ``reciprocal``: φd covers [0, π) instead of [0, 2π).

    >>> HalfAngleGrid().shape
    (90, 90, 180)
    """

    theta_h: int = 90
    theta_d: int = 90
    phi_d: int = 180
    reciprocal: bool = True

    def __post_init__(self) -> None:
        if min(self.shape) < 2 or self.bins > _MAX_BINS:
            raise ValueRangeError(
                "grid", f"{self.shape} bins; 2 along each axis to {_MAX_BINS:,} in all are held"
            )

    @property
    def shape(self) -> tuple[int, int, int]:
        """Return the numbers of bins along (θh, θd, φd)."""
        return self.theta_h, self.theta_d, self.phi_d

    @property
    def bins(self) -> int:
        """Return the number of bins in all."""
        return self.theta_h * self.theta_d * self.phi_d

    @property
    def period(self) -> float:
        """Return the range of φd, radians: π or 2π."""
        return np.pi if self.reciprocal else 2.0 * np.pi

    def angles(self, h: npt.ArrayLike, d: npt.ArrayLike, p: npt.ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Return (θh, θd, φd), radians, at places in index space (bin k spans k to k + 1)."""
        theta_h = _HALF_PI * (np.asarray(h, float) / self.theta_h) ** 2
        theta_d = _HALF_PI * np.asarray(d, float) / self.theta_d
        return theta_h, theta_d, self.period * np.asarray(p, float) / self.phi_d

    def centres(self) -> tuple[Floats, Floats, Floats]:
        """Return the centres along each axis, radians, 1-D."""
        return self.angles(*(np.arange(n) + 0.5 for n in self.shape))

    def pairs(self, h: int) -> tuple[Floats, Floats]:
        """Return ``wi`` and ``wo`` (θd, φd, 3) at the centres of the bins of one θh."""
        theta_h, theta_d, phi_d = self.centres()
        return from_half_angle_coordinates(theta_h[h], 0.0, theta_d[:, None], phi_d[None, :])

    def above_horizon(self) -> npt.NDArray[np.bool_]:
        """Return (θh, θd, φd): whether both directions at a bin's centre are above the horizon."""
        return self._above(*self.centres())

    def reached(self) -> npt.NDArray[np.bool_]:
        """Return (θh, θd, φd): whether a trilinear look-up of directions above the horizon can touch a bin.

        These are the bins above the horizon and a rim of one bin beside them.
        """
        h, d, p = (np.arange(n, dtype=float) for n in self.shape)
        theta_h, theta_d, _ = self.angles(np.maximum(h - 0.5, 0.0), np.maximum(d - 0.5, 0.0), 0.0)
        # A look-up within one step of the centre; the one nearest to |cos φd| = 0 lies deepest above.
        steps = np.stack([p - 0.5, p + 0.0, p + 0.5, p + 1.0, p + 1.5])
        _, _, phi = self.angles(0.0, 0.0, steps)
        nearest = np.abs(np.cos(phi)).min(axis=0)
        return self._above(theta_h, theta_d, np.arccos(nearest))

    def _above(self, theta_h: Floats, theta_d: Floats, phi_d: Floats) -> npt.NDArray[np.bool_]:
        # z of the two directions is cos θh cos θd ∓ sin θh sin θd cos φd; float32 serves a yes or no.
        along = np.outer(np.cos(theta_h), np.cos(theta_d)).astype(np.float32)
        across = np.outer(np.sin(theta_h), np.sin(theta_d)).astype(np.float32)
        ahead = np.abs(np.cos(phi_d)).astype(np.float32)
        return np.asarray(along[:, :, None] > across[:, :, None] * ahead)

    def index_of(self, i: Floats, o: Floats) -> tuple[Floats, Floats, Floats]:
        """Return places in index space, (n,) each, of directions (3, n); φd within [0, bins).

        In closed form, without a rotation: with S = wi + wo and D = wi - wo, tan θh = |S_xy|/S_z,
        tan θd = |D|/|S| and tan φd = (S_x D_y - S_y D_x) / (-D_z |S|); every term is a difference of inputs,
        so a half vector close to the normal keeps its digits. For h = z exactly, φd has no meaning and is 0.
        """
        total, difference = i + o, i - o
        flat = total[0] * total[0] + total[1] * total[1]
        length = np.sqrt(flat + total[2] * total[2])
        apart = np.sqrt(difference[0] ** 2 + difference[1] ** 2 + difference[2] ** 2)
        h = np.sqrt(np.arctan2(np.sqrt(flat), total[2]) / _HALF_PI) * self.theta_h
        d = np.arctan2(apart, length) * (self.theta_d / _HALF_PI)
        turn = total[0] * difference[1] - total[1] * difference[0]
        ahead = -difference[2] * length
        if self.reciprocal:
            # Swapping turns both signs: folding them first makes a pair and its swap equal to the last bit.
            ahead = np.where(turn < 0.0, -ahead, ahead)
            turn = np.abs(turn)
        p = np.arctan2(turn, ahead) * (self.phi_d / self.period)
        p[p < 0.0] += self.phi_d
        # Under reciprocity φd = π is φd = 0; a tiny negative angle also rounds up to a whole turn.
        p[p >= self.phi_d] = 0.0
        return h, d, p

"""Interpolation over the aspecular angle by shape-preserving cubics in L*, a* and b* (PCHIP).

Slopes by Fritsch and Butland (1984): the weighted harmonic mean of the two neighbours' secants, 0 where they
differ in sign; at the ends the one-sided three-point slope, held so that no new extremum appears. Towards the
mirror direction the first cubic is carried on, so it runs away there, as Lab interpolation does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.arrays import Floats


@dataclass(frozen=True)
class MonotoneRule:
    """Cubics between ``knots`` (n,), radians; ``coefficients`` (n-1, 4, 3), lowest power first."""

    knots: Floats
    coefficients: Floats

    def __call__(self, gamma: Floats) -> Floats:
        """Return ρ (..., 3) at aspecular angles (...), radians; a channel may be negative."""
        piece = np.clip(np.searchsorted(self.knots, gamma, side="right") - 1, 0, len(self.knots) - 2)
        t = (gamma - self.knots[piece])[..., None]
        c = self.coefficients[piece]
        lab = c[..., 0, :] + t * (c[..., 1, :] + t * (c[..., 2, :] + t * c[..., 3, :]))
        # A lightness below 0 represents nothing; the colour there is black.
        np.maximum(lab[..., 0], 0.0, out=lab[..., 0])
        return lab_to_working(lab)

    @classmethod
    def through(cls, gamma: Floats, rho: Floats) -> MonotoneRule:
        """Return the rule for readings ``rho`` (n, 3) at rising ``gamma`` (n,), n ≥ 2."""
        lab = working_to_lab(rho)
        width = np.diff(gamma)[:, None]
        secant = np.diff(lab, axis=0) / width
        slope = pchip_slopes(width, secant)
        first, second = slope[:-1], slope[1:]
        coefficients = np.stack(
            (
                lab[:-1],
                first,
                (3.0 * secant - 2.0 * first - second) / width,
                (first + second - 2.0 * secant) / (width * width),
            ),
            axis=1,
        )
        return cls(gamma, coefficients)


def pchip_slopes(width: Floats, secant: Floats) -> Floats:
    """Return the slopes (n, k) at n knots from interval ``width`` (n-1, 1) and ``secant`` (n-1, k).

    Secants may be of any size, subnormal ones too.
    """
    count = len(width) + 1
    slope = np.empty((count, secant.shape[1]))
    if count == 2:
        slope[:] = secant
        return slope
    left, right = secant[:-1], secant[1:]
    w_left, w_right = 2.0 * width[1:] + width[:-1], width[1:] + 2.0 * width[:-1]
    same = np.sign(left) * np.sign(right) > 0.0
    flatter_left = np.abs(left) < np.abs(right)
    flat, steep = np.where(flatter_left, left, right), np.where(flatter_left, right, left)
    w_flat, w_steep = np.where(flatter_left, w_left, w_right), np.where(flatter_left, w_right, w_left)
    # In the ratio of the secants: the quotient of a weight and a secant may be larger than any number.
    ratio = np.where(same, flat / np.where(same, steep, 1.0), 0.0)
    slope[1:-1] = np.where(same, flat * ((w_left + w_right) / (w_flat + w_steep * ratio)), 0.0)
    slope[0] = _end_slope(width[0], width[1], secant[0], secant[1])
    slope[-1] = _end_slope(width[-1], width[-2], secant[-1], secant[-2])
    return slope


def _end_slope(near: Floats, far: Floats, secant: Floats, following: Floats) -> Floats:
    slope = ((2.0 * near + far) * secant - near * following) / (near + far)
    slope = np.where(np.sign(slope) * np.sign(secant) <= 0.0, 0.0, slope)
    turning = (np.sign(secant) * np.sign(following) <= 0.0) & (np.abs(slope) > 3.0 * np.abs(secant))
    return np.asarray(np.where(turning, 3.0 * secant, slope))

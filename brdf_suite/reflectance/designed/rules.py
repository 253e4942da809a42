"""Interpolation over the aspecular angle: by a distribution of flake tilts, by cubics, by a polynomial.

A flake under a coat of index n sends the light to the view when its normal halves the angle between the
two refracted directions. In the plane of incidence, with the light at θ and the view at θ - γ, its tilt is

    δ(γ) = (asin(sin θ / n) - asin(sin(θ - γ) / n)) / 2.

Flakes whose slopes are spread like a Beckmann surface of roughness m, over a matt ground, give per channel

    ρ(γ) = ρ_d + A exp(-tan²δ / m²).

Three readings fix ρ_d, A and m: with x = tan²δ and u = 1/m²,

    (ρ1 - ρ2) / (ρ2 - ρ3) = (e^(-x1 u) - e^(-x2 u)) / (e^(-x2 u) - e^(-x3 u))
                          = expm1((x2 - x1) u) / -expm1(-(x3 - x2) u),

which rises with u from (x2 - x1) / (x3 - x2), 0.16 for 15/45/110°, without bound: there is one u or none.
More readings are fitted by least squares.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.arrays import Floats

# u = 1/m²: from m = 5 (no bell at all) to m = 0.01 (a mirror).
_LOW_U, _HIGH_U = 0.04, 1e4
# A channel that varies by less than this share of its size is flat, and any bell of height 0 fits it.
_FLAT = 1e-6
# Of the search for u: cells of a round, and rounds.
_CELLS, _ROUNDS = 32, 6
# Where even the first reading sees less than this share of the bell, its top is a guess, not a measurement.
_FAINTEST = 0.01


def squared_tilt(gamma: Floats, illumination: float, ior: float) -> Floats:
    """Return tan²δ (...) of the flakes seen at aspecular angles ``gamma``, radians; see the module."""
    view = np.arcsin(np.sin(illumination - gamma) / ior)
    tilt = np.tan(0.5 * (math.asin(math.sin(illumination) / ior) - view))
    return np.asarray(tilt * tilt)


def squared_tilt_between(wi: Floats, wo: Floats, ior: float) -> Floats:
    """Return tan²δ (...) of the flake under the coat that mirrors ``wi`` to ``wo`` (..., 3), in any plane.

    Inside the coat a direction's part across the normal is 1/n of that outside (Snell); the flake's normal is
    along the sum of the two. In the readings' plane that is :func:`squared_tilt`.
    """
    across_i = wi[..., 0] ** 2 + wi[..., 1] ** 2
    across_o = wo[..., 0] ** 2 + wo[..., 1] ** 2
    n2 = ior * ior
    up = np.sqrt(n2 - across_i) + np.sqrt(n2 - across_o)
    across = (wi[..., 0] + wo[..., 0]) ** 2 + (wi[..., 1] + wo[..., 1]) ** 2
    return np.asarray(across / (up * up))


@dataclass(frozen=True)
class FlakeRule:
    """ρ(γ) = ρ_d + A exp(-u tan²δ) per channel; ``ground``, ``height`` and ``u`` are (3,) arrays."""

    ground: Floats
    height: Floats
    u: Floats
    illumination: float
    ior: float

    def __call__(self, gamma: Floats) -> Floats:
        """Return ρ (..., 3) at aspecular angles (...), radians; it may be negative."""
        return self.at_squared_tilt(squared_tilt(gamma, self.illumination, self.ior))

    def at_squared_tilt(self, x: Floats) -> Floats:
        """Return ρ (..., 3) of flakes tilted by tan²δ = ``x`` (...), for any light and view; may be negative."""
        return np.asarray(self.ground + self.height * np.exp(x[..., None] * -self.u))

    @property
    def spread(self) -> tuple[float | None, float | None, float | None]:
        """Return m per channel, the root-mean-square slope of the flakes; None for a flat channel."""
        red, green, blue = (
            None if height == 0.0 else 1.0 / math.sqrt(u)
            for height, u in zip(self.height.tolist(), self.u.tolist(), strict=True)
        )
        return red, green, blue

    @classmethod
    def through(cls, gamma: Floats, rho: Floats, illumination: float, ior: float) -> FlakeRule | None:
        """Return the rule for readings ``rho`` (n, 3) at rising ``gamma`` (n,), n ≥ 3, or None.

        None: no spread of flakes gives these readings, or it would need a negative reflectance.
        """
        return cls.through_tilts(squared_tilt(gamma, illumination, ior), rho, illumination, ior)

    @classmethod
    def through_tilts(
        cls, x: Floats, rho: Floats, illumination: float, ior: float, weight: Floats | None = None
    ) -> FlakeRule | None:
        """Return the rule for readings ``rho`` (n, 3) at rising tan²δ ``x`` (n,), n ≥ 3, or None as :meth:`through`.

        ``weight`` (n,) is that of each reading in the least squares that more than three need; left out, all equal.
        """
        tilts = x.tolist()
        if not all(before < after for before, after in pairwise(tilts)):
            return None
        fitted: list[tuple[float, float, float] | None] = [None] * 3
        if len(tilts) > 3:
            fitted = _least_squares(tilts, rho, np.ones(len(tilts)) if weight is None else weight)
        channels = [
            _solve(tilts, channel, best) for channel, best in zip(rho.T.tolist(), fitted, strict=True)
        ]
        solved = [channel for channel in channels if channel is not None]
        if len(solved) < 3:
            return None
        # At the mirror direction x = 0 and the bell is at its top; at the far end at most at its foot.
        if any(ground + height < 0.0 for ground, height, _ in solved):
            return None
        ground, height, u = np.array(solved).T
        return cls(ground, height, u, illumination, ior)


def _solve(
    x: list[float], rho: list[float], fitted: tuple[float, float, float] | None
) -> tuple[float, float, float] | None:
    """(ρ_d, A, u) of one channel, or None; ``fitted`` is the answer for more than three readings."""
    size = max(abs(value) for value in rho)
    if max(rho) - min(rho) <= _FLAT * size:
        return sum(rho) / len(rho), 0.0, 1.0
    if len(x) > 3:
        return fitted
    x1, x2, x3 = x
    first, second = rho[0] - rho[1], rho[1] - rho[2]
    if first * second <= 0.0:
        return None
    u = _root(x2 - x1, x3 - x2, first / second)
    if u is None:
        return None
    if math.exp(-x1 * u) < _FAINTEST:
        return None
    # From the two ends: e1 - e3 is the largest difference, so the best known.
    e1, e3 = math.exp(-x1 * u), math.exp(-x3 * u)
    height = (rho[0] - rho[2]) / (e1 - e3)
    return rho[0] - height * e1, height, u


def _root(a: float, b: float, ratio: float) -> float | None:
    """u with expm1(a u) / -expm1(-b u) = ratio, by Newton's method in the logarithm of both sides.

    g(u) = ln expm1(a u) - ln(-expm1(-b u)) - ln ratio rises; its slope is a e^(au)/expm1(au) - b/expm1(bu).
    """
    target = math.log(ratio)

    def value(rising: float, falling: float) -> float:
        return math.log(rising) - math.log(-falling) - target

    low, high = _LOW_U, min(_HIGH_U, 600.0 / a)
    if value(math.expm1(a * low), math.expm1(-b * low)) >= 0.0:
        return None
    if value(math.expm1(a * high), math.expm1(-b * high)) <= 0.0:
        return None
    u = min(high, max(low, math.log1p(ratio) / a))
    for _ in range(60):
        rising, falling = math.expm1(a * u), math.expm1(-b * u)
        g = value(rising, falling)
        if g > 0.0:
            high = u
        else:
            low = u
        # Both terms by what is known: e^(au)/expm1(au) = 1 + 1/expm1(au), and b/expm1(bu) = -b (1 + 1/expm1(-bu)).
        slope = a + a / rising + b + b / falling
        following = u - g / slope
        if not low <= following <= high:
            following = 0.5 * (low + high)
        if abs(following - u) <= 1e-13 * u:
            return following
        u = following
    return u


def _least_squares(x: list[float], rho: Floats, weight: Floats) -> list[tuple[float, float, float] | None]:
    """The best (ρ_d, A, u) of each channel of (n, 3) for n > 3: linear in two of them, a search in the third.

    All channels are searched at once: the time goes into calls, not into numbers.
    """
    tilts, values = np.array(x), rho.T
    weight = weight / weight.sum()
    mean = values @ weight
    low, high = np.full(3, math.log(_LOW_U)), np.full(3, math.log(_HIGH_U))
    along = np.linspace(0.0, 1.0, _CELLS + 1)
    rows = np.arange(3)
    # Each round keeps the two cells about the best of 33: 16 times finer, 2e-8 of the range after six.
    for _ in range(_ROUNDS):
        grid = low[:, None] + (high - low)[:, None] * along
        bell = np.exp(-np.exp(grid)[..., None] * tilts)
        middle = bell @ weight
        centred = bell - middle[..., None]
        spread = np.maximum((centred * centred) @ weight, 1e-300)
        height = np.einsum("cgn,cn->cg", centred, weight * values) / spread
        ground = mean[:, None] - height * middle
        missed = ground[..., None] + height[..., None] * bell - values[:, None, :]
        best = np.argmin((missed * missed) @ weight, axis=1)
        low, high = grid[rows, np.maximum(best - 1, 0)], grid[rows, np.minimum(best + 1, _CELLS)]
    found = zip(
        ground[rows, best].tolist(),
        height[rows, best].tolist(),
        np.exp(grid[rows, best]).tolist(),
        strict=True,
    )
    return [
        (base, top, u) if 1.5 * _LOW_U < u < 0.67 * _HIGH_U and math.exp(-x[0] * u) >= _FAINTEST else None
        for base, top, u in found
    ]


@dataclass(frozen=True)
class MonotoneRule:
    """Shape-preserving cubics in L*, a* and b* (PCHIP) between ``knots`` (n,), radians.

    ``coefficients`` (n-1, 4, 3), lowest power first. Slopes by Fritsch and Butland (1984): the weighted harmonic mean
    of the two neighbours' secants, 0 where they differ in sign; at the ends the one-sided three-point slope, held so
    that no new extremum appears. Towards the mirror direction the first cubic is carried on, so it runs away there.
    """

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


@dataclass(frozen=True)
class PolynomialRule:
    """ρ(γ) = c0 + c1 γ + c2 γ² per channel; ``coefficients`` (3, 3), a row per power.

    Linear in the reflectance factor (Westlund and Meyer 2001; Shimizu 2003); it may turn negative between two readings
    of a paint with much flop, where the caller clamps it.
    """

    coefficients: Floats

    def __call__(self, gamma: Floats) -> Floats:
        """Return ρ (..., 3) at aspecular angles (...), radians; it may be negative."""
        g = gamma[..., None]
        c0, c1, c2 = self.coefficients
        return np.asarray(c0 + g * (c1 + g * c2))

    @classmethod
    def through(cls, gamma: Floats, rho: Floats) -> PolynomialRule:
        """Return the rule for readings ``rho`` (n, 3) at ``gamma`` (n,): exact for 3, else least squares."""
        powers = np.stack((np.ones_like(gamma), gamma, gamma * gamma), axis=1)
        if len(gamma) == 3:
            return cls(np.asarray(np.linalg.solve(powers, rho), np.float64))
        coefficients, *_ = np.linalg.lstsq(powers, rho, rcond=None)
        return cls(np.asarray(coefficients, np.float64))

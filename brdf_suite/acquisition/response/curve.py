"""Response curve model: cubic B-splines over the codes, finer towards black and towards full scale.

ln g is a spline in u = ln(q) - ln(1.05 - q), q being the share of the code above black: straight for power laws near
black, with room for a shoulder near full scale. Robertson's table of one free value for each code needs every code to
be seen often, and in a series of exposures with one common ratio it cannot be determined at all: with g, g·p(ln g) is
as good where p has that ratio's logarithm as its period. A smooth curve has no such ripples, so smoothness fixes them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats

_BEYOND = 1.05
_DEGREE = 3


@dataclass(frozen=True, eq=False)
class CurveBasis:
    """Splines over the codes ``low`` … ``high`` of one channel.

    ``first`` (codes,) int64 is the first of the four splines at a code, ``values`` (codes, 4) their values,
    both held outside; ``count`` is how many splines there are.
    """

    low: int
    high: int
    first: npt.NDArray[np.int64]
    values: Floats
    count: int

    def logarithm(self, coefficients: Floats) -> Floats:
        """Return the spline (codes,), held outside low … high."""
        at = self.first[:, None] + np.arange(_DEGREE + 1)
        return np.asarray(np.sum(self.values * coefficients[at], axis=1))


def coordinate(codes: npt.ArrayLike, black: float, bit_depth: int) -> Floats:
    """Return u of codes above black."""
    share = (np.asarray(codes, float) - black) / ((1 << bit_depth) - 1 - black)
    return np.asarray(np.log(share) - np.log(_BEYOND - share))


def curve_basis(bit_depth: int, black: float, low: int, high: int, knots: int) -> CurveBasis:
    """Return ``knots + 3`` splines on evenly spaced knots in u between two codes above black."""
    codes = 1 << bit_depth
    u = coordinate(np.clip(np.arange(codes), low, high), black, bit_depth)
    at = (u - u[0]) / (u[-1] - u[0]) * knots
    interval = np.minimum(at.astype(np.int64), knots - 1)
    t = at - interval
    values = np.stack(((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3), axis=1)
    return CurveBasis(low, high, interval, values / 6.0, knots + _DEGREE)


def whole_table(basis: CurveBasis, exposure: Floats, black: float) -> Floats:
    """Return ``exposure`` (codes,) continued beyond the basis: by a power law to black, and straight at the top.

    The power is the curve's own slope near its low end, held to 0.3 … 4; below black the same, negative.
    """
    table = exposure.copy()
    codes = np.arange(len(table), dtype=float)
    low, high = basis.low, basis.high
    near = min(high, max(low + 2, int(low + 0.5 * (low - black))))
    power = np.log(exposure[near] / exposure[low]) / np.log((near - black) / (low - black))
    power = float(np.clip(power, 0.3, 4.0))
    away = (codes[:low] - black) / (low - black)
    table[:low] = exposure[low] * np.sign(away) * np.abs(away) ** power
    run = max(2, (high - low) // 50)
    slope = (exposure[high] - exposure[high - run]) / run
    table[high + 1 :] = exposure[high] + slope * (codes[high + 1 :] - high)
    return np.asarray(np.maximum.accumulate(table))

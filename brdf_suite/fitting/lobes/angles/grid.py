"""Incidence grid of a multi-angle fit, and interpolation in it.

With x running evenly from 0 to 1 over the K texels of a 1-D texture, the cosine of incidence is

    c(x) = c_0 + (1 - c_0) x^p.

p = 1 places the fits evenly in the cosine, p > 1 more densely towards grazing, where Fresnel's factors turn
fast. The power is adjusted until one texel falls on 45° exactly: there paints are measured, and there a
multi-angle fit must be as true as a single one. Its inverse is one power in a shader,
``x = ((N·L - c_0)/(1 - c_0))^(1/p)``. Measurements behind the defaults: docs/method/incidence.md.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError

DEFAULT_COUNT = 16
#: The least angles of a fit, and the most: the joint program grows with the square of their number.
FEWEST, MOST = 3, 256
DEFAULT_POWER = 1.5
#: The smallest cosine: 88.3°. Below it weights are held.
LOWEST_COSINE = 0.03
MEASURED_COSINE = math.cos(math.pi / 4.0)


@dataclass(frozen=True)
class AngleGrid:
    """K cosines of incidence, rising from ``lowest_cosine`` to 1, one of them cos 45°.

    Parameters
    ----------
    count
        K, 3 to 256.
    wanted_power
        The power p asked for, more than 0; ``power`` is the nearest that has a texel at 45°.
    lowest_cosine
        The smallest cosine, between 0 and cos 45°.

    Attributes
    ----------
    cosines
        ``(K,)``, rising.
    measured
        Index of the texel at 45°.

    >>> grid = AngleGrid(16)
    >>> round(float(np.degrees(np.arccos(grid.cosines[grid.measured]))), 6)
    45.0

    Raises
    ------
    FittingError
        A count, power or cosine out of range.
    """

    count: int = DEFAULT_COUNT
    wanted_power: float = DEFAULT_POWER
    lowest_cosine: float = LOWEST_COSINE
    power: float = field(init=False)
    measured: int = field(init=False)
    cosines: Floats = field(init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        if not FEWEST <= self.count <= MOST:
            raise FittingError(
                f"A fit at several angles needs at least {FEWEST} angles of incidence and takes at most {MOST}, "
                f"not {self.count}."
            )
        if not (math.isfinite(self.wanted_power) and self.wanted_power > 0.0):
            raise FittingError(
                f"The power of the angles' placement is {self.wanted_power:g}; it must be more than 0."
            )
        if not 0.0 < self.lowest_cosine < MEASURED_COSINE:
            raise FittingError(
                f"The smallest cosine of incidence is {self.lowest_cosine:g}; it must lie between 0 and cos 45°."
            )
        share = math.log((MEASURED_COSINE - self.lowest_cosine) / (1.0 - self.lowest_cosine))
        last = self.count - 1
        powers = [share / math.log(k / last) for k in range(1, last)]
        nearest = min(range(last - 1), key=lambda k: abs(math.log(powers[k] / self.wanted_power)))
        cosines = (
            self.lowest_cosine
            + (1.0 - self.lowest_cosine) * (np.arange(self.count) / last) ** powers[nearest]
        )
        cosines[nearest + 1] = MEASURED_COSINE
        cosines.setflags(write=False)
        object.__setattr__(self, "power", powers[nearest])
        object.__setattr__(self, "measured", nearest + 1)
        object.__setattr__(self, "cosines", cosines)

    def position(self, cosine: npt.ArrayLike) -> Floats:
        """Return x·(K-1) (...), 0 to K-1, of cosines (...): held below the smallest cosine and above 1."""
        share = (np.asarray(cosine, np.float64) - self.lowest_cosine) / (1.0 - self.lowest_cosine)
        result: Floats = (self.count - 1) * np.clip(share, 0.0, 1.0) ** (1.0 / self.power)
        return result

    def coordinate(self, cosine: npt.ArrayLike) -> Floats:
        """Return the texture coordinate (...) of cosines (...): (x (K-1) + ½)/K, texel centres at (k + ½)/K."""
        result: Floats = (self.position(cosine) + 0.5) / self.count
        return result

    def shares(self, cosine: npt.ArrayLike) -> tuple[npt.NDArray[np.intp], Floats]:
        """Return the lower texel (...) and the share (...) of the one above it, as linear filtering mixes them."""
        position = self.position(cosine)
        lower = np.minimum(position.astype(np.intp), self.count - 2)
        return lower, position - lower

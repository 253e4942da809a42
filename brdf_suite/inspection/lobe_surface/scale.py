"""How long a lobe is drawn for a value: linear, by the cube root, or by the logarithm over some decades."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Singles
from brdf_suite.errors import ValueRangeError

RadiusKind = Literal["linear", "cbrt", "log"]
RADIUS_KINDS: tuple[RadiusKind, ...] = ("linear", "cbrt", "log")

LEAST_DECADES, MOST_DECADES = 1.0, 12.0


@dataclass(frozen=True)
class RadiusScale:
    """Radius 1 is the value ``full``, in 1/sr.

    ``decades`` is what the logarithm shows: a value of ``full`` / 10^decades, and all below, has the radius 0.

    >>> float(RadiusScale("cbrt", full=8.0).radius(1.0))
    0.5
    """

    kind: RadiusKind = "cbrt"
    full: float = 1.0
    decades: float = 4.0

    def __post_init__(self) -> None:
        if self.kind not in RADIUS_KINDS:
            raise ValueRangeError("kind", f"one of {', '.join(RADIUS_KINDS)} is wanted, not {self.kind!r}")
        if not 0.0 < self.full < np.inf:
            raise ValueRangeError("full", f"a value in 1/sr above 0 is wanted, not {self.full}")
        if not LEAST_DECADES <= self.decades <= MOST_DECADES:
            raise ValueRangeError("decades", f"{LEAST_DECADES:g} to {MOST_DECADES:g} decades are shown")

    def radius(self, values: npt.ArrayLike) -> Singles:
        """Return the radius (...), float32, of values (...) in 1/sr, not negative; NaN stays NaN.

        It is above 1 where a value is above ``full``.
        """
        share = np.asarray(values, np.float32) * np.float32(1.0 / self.full)
        if self.kind == "linear":
            return share
        if self.kind == "cbrt":
            return np.asarray(np.cbrt(share))
        least = np.float32(10.0**-self.decades)
        # np.maximum keeps a NaN.
        risen = np.log10(np.maximum(share, least))
        risen *= np.float32(1.0 / self.decades)
        risen += np.float32(1.0)
        # The least value would miss 0 by a rounding; a NaN stays one.
        return np.asarray(risen * (share > least))

    def value(self, radius: float) -> float:
        """Return the value in 1/sr that is drawn at ``radius``, above 0; the inverse of :meth:`radius`."""
        if self.kind == "linear":
            return radius * self.full
        if self.kind == "cbrt":
            return radius**3 * self.full
        return float(self.full * 10.0 ** ((radius - 1.0) * self.decades))


def nice_ceiling(value: float) -> float:
    """Return the least of 1, 2, 5 times a power of ten that is not below ``value`` > 0.

    >>> nice_ceiling(0.3)
    0.5
    """
    power = 10.0 ** np.floor(np.log10(value))
    for step in (1.0, 2.0, 5.0, 10.0):
        if value <= step * power * (1.0 + 1e-9):
            return float(step * power)
    return float(10.0 * power)

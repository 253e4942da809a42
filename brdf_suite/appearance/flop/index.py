"""Flop: the change of lightness from near the mirror direction to grazing views."""

from __future__ import annotations

import math
from dataclasses import dataclass

ILL_CONDITIONED_BELOW = 12.0
"""L* at 45° under which a small error of that reading changes the index a lot."""


@dataclass(frozen=True)
class FlopIndex:
    """The flop index with a notice where needed; NaN where undefined."""

    value: float
    notice: str | None = None


def flop_index(l15: float, l45: float, l110: float) -> FlopIndex:
    """Return the flop index 2.69 (L15 - L110)^1.11 / L45^0.86 of L* at 15, 45 and 110°.

    0 for a solid colour; about 15 to 17 for a very high flop. The formula is the one in general use; it was
    taken from expert memory, not read in a standard.

    >>> round(flop_index(108.6, 40.9, 8.7).value, 1)
    18.3
    """
    if l15 < l110:
        return FlopIndex(0.0, "lighter at 110° than at 15°: the flop index does not describe this paint")
    if l45 <= 0.0:
        if l15 == l110:
            return FlopIndex(0.0)
        return FlopIndex(math.nan, "L* at 45° is 0: there is no flop index")
    value = 2.69 * (l15 - l110) ** 1.11 / l45**0.86
    if l45 < ILL_CONDITIONED_BELOW:
        return FlopIndex(value, f"L* at 45° is below {ILL_CONDITIONED_BELOW:g}: the flop index is uncertain")
    return FlopIndex(value)

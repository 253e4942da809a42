"""Flop and colour travel: the change of lightness, and of colour, over the aspecular angle."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.errors import ValueRangeError

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


FIRST_DEG, LAST_DEG = 15.0, 110.0
"""Where travel begins and ends; readings outside are not part of it."""

GREY_BELOW = 2.0
"""C*ab under which a hue is mostly noise."""

_SAME_DEG = 1e-6


@dataclass(frozen=True)
class Travel:
    """The path through the readings from 15 to 110°.

    ``length`` is the path in the a*b* plane; ``hue_deg`` the sum of the hue's signed turns (positive: from red
    towards yellow), each the short way round; ``hue_path_deg`` the sum of their sizes; ``chroma`` C*ab at the
    last angle minus C*ab at the first; ``lightness`` the same of L*.
    """

    length: float
    hue_deg: float
    hue_path_deg: float
    chroma: float
    lightness: float
    notice: str | None = None


def travel(aspecular_deg: npt.ArrayLike, lab: npt.ArrayLike) -> Travel:
    """Return the travel of L*a*b* readings (k, 3) at aspecular angles (k,), in any order.

    >>> travel([15.0, 45.0, 110.0], [[60.0, 10.0, 0.0], [30.0, 10.0, 10.0], [9.0, 0.0, 10.0]]).length
    20.0

    Raises
    ------
    ValueRangeError
        There are no readings at 15 and at 110°, between which travel is defined.
    """
    angles, lab = np.asarray(aspecular_deg, float), np.asarray(lab, float)
    inside = (angles >= FIRST_DEG - _SAME_DEG) & (angles <= LAST_DEG + _SAME_DEG)
    order = np.argsort(angles[inside], kind="stable")
    angles, lab = angles[inside][order], lab[inside][order]
    if len(angles) < 2 or angles[0] > FIRST_DEG + _SAME_DEG or angles[-1] < LAST_DEG - _SAME_DEG:
        raise ValueRangeError("aspecular_deg", "travel needs readings at 15° and at 110°")
    steps = np.diff(lab[:, 1:], axis=0)
    lch = lab_to_lch(lab)
    turns = (np.diff(lch[:, 2]) + 180.0) % 360.0 - 180.0
    grey = lch[:, 1].min() < GREY_BELOW
    return Travel(
        length=float(np.hypot(steps[:, 0], steps[:, 1]).sum()),
        hue_deg=float(turns.sum()),
        hue_path_deg=float(np.abs(turns).sum()),
        chroma=float(lch[-1, 1] - lch[0, 1]),
        lightness=float(lch[-1, 0] - lch[0, 0]),
        notice=f"a reading has a chroma below {GREY_BELOW:g}: the hue travel is uncertain" if grey else None,
    )

"""Colour travel: the path of a paint's colour over the aspecular angle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.errors import ValueRangeError

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

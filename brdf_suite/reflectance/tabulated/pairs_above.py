"""Look-up restricted to direction pairs above the horizon."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats

LookUp = Callable[[Floats, Floats], npt.NDArray[np.floating]]
"""Contiguous columns of ``wi`` and ``wo``, (3, n) each, all above the horizon -> (n, c)."""


def look_up_above(look_up: LookUp, light: Floats, view: Floats, channels: int = 3) -> Floats:
    """Return (n, channels) of ``look_up`` for directions (n, 3).

    Pairs with either direction at or below the horizon, or not a number, give 0 and are never looked up.
    """
    i, o = np.ascontiguousarray(light.T), np.ascontiguousarray(view.T)
    above = (i[2] > 0.0) & (o[2] > 0.0)
    # A sum is finite only where every term is; one test for all six columns.
    above &= np.isfinite(i.sum(axis=0) + o.sum(axis=0))
    if above.all():
        return np.asarray(look_up(i, o), np.float64)
    result = np.zeros((len(light), channels))
    if above.any():
        result[above] = look_up(np.compress(above, i, axis=1), np.compress(above, o, axis=1))
    return result

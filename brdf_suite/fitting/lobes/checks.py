"""Input checks of the fits: samples, time limit, and coat index."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError

CHANNELS = ("red", "green", "blue")
#: Samples above this are no reflectance, in 1/sr; sums of what is below stay finite.
BRIGHTEST = 1e100


def check_targets(
    subject: str,
    values: npt.ArrayLike,
    shape: tuple[int, ...],
    where: Callable[[tuple[int, ...]], str],
) -> Floats:
    """Return ``values`` as float64 of ``shape``, which ends with three channels.

    ``subject`` begins the message of an error ("The base"); ``where`` names the place of a sample from its index
    without the channel ("at the aspecular angle 45°").

    Raises
    ------
    FittingError
        Another shape, or the first sample that is negative, not finite, or beyond any reflectance.
    """
    array = np.asarray(values, dtype=np.float64)
    if array.shape != shape:
        raise FittingError(f"{subject} has samples of shape {array.shape}, not {shape}.")
    # On the path of every edit; neither holds for a not-a-number.
    if array.size == 0 or (array.min() >= 0.0 and array.max() <= BRIGHTEST):
        return array
    place = tuple(int(i) for i in np.argwhere(~((array >= 0.0) & (array <= BRIGHTEST)))[0])
    value = array[place]
    what = "is not finite"
    if np.isfinite(value):
        what = f"is {'negative' if value < 0.0 else 'beyond any reflectance'} ({value:g} 1/sr)"
    channel = f"{CHANNELS[place[-1]]} channel {what} {where(place[:-1])}"
    raise FittingError(f"{subject} cannot be fitted: its {channel}.")


def check_limit(seconds: float) -> float:
    """Return the time limit of a fit, or raise a FittingError where it is not a positive number of seconds."""
    if not (math.isfinite(seconds) and seconds > 0.0):
        raise FittingError(f"The time limit of a fit is {seconds:g} s; it must be more than 0.")
    return float(seconds)


def check_ior(ior: float) -> float:
    """Return the refractive index of a coat, or raise a FittingError where it is not a number from 1 on."""
    if not (math.isfinite(ior) and ior >= 1.0):
        raise FittingError(f"The refractive index of the coat is {ior:g}; it must be 1 or more.")
    return float(ior)

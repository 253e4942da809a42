"""Sample weights of a fit: three choices, all relative to the magnitude of the targets.

absolute
    The weights that come with the samples: the measured angles of the base, the solid angle of the coat's rings.
relative
    The same over the target, so that a miss of a tenth counts the same in a dark sample as in a bright one. A
    target below a twentieth of the channel's largest counts as that twentieth: rounding must not rule the fit.
    These weights depend on the target; they bound the dual's columns and leave its matrix alone.
solid angle
    The solid angle that a sample represents. Targets hold the cosine of incidence already, so that this is the
    cosine-weighted error of the whole lobe, the mean L1 kin of the usual cosine-weighted RMS.
"""

from __future__ import annotations

from typing import Literal, get_args

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError

Weighting = Literal["absolute", "relative", "solid angle"]

#: Smallest target that relative weights resolve, over the channel's largest: weights differ by 20 at most.
SMALLEST_SHARE = 0.05


def check_weighting(weighting: str) -> None:
    """Raise a FittingError where there is no such weighting."""
    if weighting not in get_args(Weighting):
        known = ", ".join(repr(name) for name in get_args(Weighting))
        raise FittingError(f"There is no sample weighting {weighting!r}; choose one of {known}.")


def relative_factors(target: Floats) -> Floats:
    """Return factors ``(n, channels)`` from 1 to 20 for ``target`` of that shape: the largest over each.

    ``target`` is not weighted. A channel of zeros gets ones.
    """
    sizes = np.abs(target)
    largest = sizes.max(axis=0)
    whole = np.where(largest > 0.0, largest, 1.0)
    shares = np.where(largest > 0.0, sizes / whole, 1.0)
    factors: Floats = 1.0 / np.maximum(shares, SMALLEST_SHARE)
    return factors


def ring_solid_angles(gamma_rad: Floats) -> Floats:
    """Return ``(n,)`` sr for ascending signed angles ``gamma_rad`` ``(n,)`` from the mirror direction.

    Each sample represents the directions nearer to it than to its neighbours, on its own side of the mirror
    direction; the outermost reach as far outwards as inwards. A sample alone gets 1.
    """
    if gamma_rad.size == 1:
        return np.ones(1)
    middles = 0.5 * (gamma_rad[1:] + gamma_rad[:-1])
    first, last = 2.0 * gamma_rad[0] - middles[0], 2.0 * gamma_rad[-1] - middles[-1]
    edges = np.concatenate([[first], middles, [last]])
    # Half of a cap of angle γ, with the sign of γ: differences are the half rings between two edges.
    caps = np.sign(edges) * np.pi * (1.0 - np.cos(edges))
    rings: Floats = np.diff(caps)
    return rings

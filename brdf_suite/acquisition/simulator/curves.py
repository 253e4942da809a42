"""Response curves of simulated cameras: from the fill of a pixel's well to the fraction of the code range."""

from __future__ import annotations

import functools

import numpy as np

from brdf_suite.acquisition.simulator.settings import Curve
from brdf_suite.arrays import Floats

CURVE_STEPS = 1 << 16
"""Cells of a curve's table, so many that linear steps between are no error of a 16-bit code."""

# A logarithm with a straight share: steep in the dark, with a shoulder, and different in each channel.
_FILM_STEEPNESS = np.array([9.0, 8.0, 10.0])
_FILM_STRAIGHT = np.array([0.25, 0.30, 0.22])


def response(curve: Curve, filling: Floats) -> Floats:
    """Return (..., 3): the share of the scale for a filling (..., 3) from 0 to 1."""
    x = np.asarray(filling, dtype=float)
    if curve == "linear":
        return x * np.ones(3)
    if curve == "srgb":
        bent = 1.055 * np.maximum(x, 0.0031308) ** (1.0 / 2.4) - 0.055
        return np.where(x <= 0.0031308, 12.92 * x, bent) * np.ones(3)
    bent = np.log1p(_FILM_STEEPNESS * x) / np.log1p(_FILM_STEEPNESS)
    soft: Floats = (1.0 - _FILM_STRAIGHT) * bent + _FILM_STRAIGHT * x
    return soft


@functools.cache
def curve_table(curve: Curve) -> Floats:
    """Return (3, steps + 1): the curve at even fillings from 0 to 1."""
    table = np.ascontiguousarray(response(curve, np.linspace(0.0, 1.0, CURVE_STEPS + 1)[:, None]).T)
    table.flags.writeable = False
    return table


def exposure_at(curve: Curve, share: float) -> Floats:
    """Return the filling (3,) at which a share of the scale is reached."""
    table = curve_table(curve)
    places = np.linspace(0.0, 1.0, CURVE_STEPS + 1)
    return np.array([np.interp(share, row, places) for row in table])

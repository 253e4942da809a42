"""Colour parameters of the models: three checked numbers as a read-only array."""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import check_rgb
from brdf_suite.documents.parameter import Parameter


def rgb(value: object, place: str, parameter: Parameter) -> Floats:
    """Return ``value``, three numbers or one for all channels, as (3,) float64 that cannot be written.

    Raises
    ------
    ValueRangeError
        A number is missing, not finite or out of the parameter's range; ``place`` names the channel.
    """
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        value = (value, value, value)
    channels = np.array(check_rgb(value, place, parameter))
    channels.setflags(write=False)
    return channels


def luminance(value: Floats) -> float:
    """Return Y of a colour (3,) of the working space; weights a sampler's choices."""
    return float(LUMINANCE @ value)

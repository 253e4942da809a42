"""Values of a slice's image as codes of a screen: the colour itself, or one channel through a colour map.

A reflectance spans five decades, a screen two. Two ways: **gamma** shows what lies below a white value with the
screen's curve, so that ratios near white look as they are; **log** shows the decades below it evenly, and keeps the
ratios of the channels.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, WORKING_TO_SRGB, srgb_decode, srgb_encode
from brdf_suite.arrays import Bytes, Floats

Tone = Literal["gamma", "log"]
TONES: tuple[Tone, ...] = ("gamma", "log")
DECADES = 4.0
"""Decades below white that a logarithmic image shows."""


def share_of(value: npt.ArrayLike, tone: Tone, white: float) -> Floats:
    """Return the place (...), 0…1, of values on the scale that ends at ``white`` > 0; NaN stays NaN.

    The place is that along a scale bar and in a colour map: for gamma it is even in the value's lightness.
    """
    share = np.clip(np.asarray(value, float) / white, 0.0, 1.0)
    if tone == "gamma":
        return srgb_encode(share)
    with np.errstate(divide="ignore"):
        return np.maximum(1.0 + np.log10(share) / DECADES, 0.0)


def value_at(place: npt.ArrayLike, tone: Tone, white: float) -> Floats:
    """Return values (...) at places of the scale, 0…1; the inverse of :func:`share_of`."""

    place = np.asarray(place, float)
    if tone == "gamma":
        return np.asarray(white * srgb_decode(place))
    return np.asarray(white * 10.0 ** (DECADES * (place - 1.0)))


def colour_codes(value: Floats, tone: Tone, white: float) -> Bytes:
    """Return sRGB codes (rows, columns, 3) of values (rows, columns, 3) of the working space; not finite is 0."""
    known = np.nan_to_num(value, nan=0.0, posinf=0.0, neginf=0.0)
    if tone == "log":
        bright = known @ LUMINANCE
        # The channels keep their ratios; lightness is the place on the logarithmic scale.
        scale = np.zeros_like(bright)
        np.divide(srgb_decode(share_of(bright, "log", white)), bright, out=scale, where=bright > 0.0)
        rgb = np.clip((known * scale[..., None]) @ WORKING_TO_SRGB.T, 0.0, 1.0)
        return np.asarray(np.rint(255.0 * srgb_encode(rgb)), np.uint8)
    rgb = np.clip(known @ WORKING_TO_SRGB.T / white, 0.0, 1.0)
    return np.asarray(np.rint(255.0 * srgb_encode(rgb)), np.uint8)


def mapped_codes(place: Floats, colours: Bytes) -> Bytes:
    """Return codes (..., 3) of places 0…1 in a table of colours (n, 3); NaN is the table's first."""
    last = len(colours) - 1
    rows = np.rint(np.nan_to_num(place, nan=0.0) * last).astype(np.intp)
    return np.asarray(colours[np.clip(rows, 0, last)])

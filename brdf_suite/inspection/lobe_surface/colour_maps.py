"""Colour maps for values: one that runs evenly from dark to light, and one for signed differences.

Both are curves in OKLab (Ottosson 2020), whose points are moved along it until neighbours differ by the same
CAM02-UCS distance, so that equal steps of a value look like equal steps. Lightness alone orders either, so they are
read without colour too; the hues, blue to yellow and blue to orange, are those that all kinds of colour vision
distinguish.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, WORKING_TO_XYZ, srgb_decode, srgb_encode
from brdf_suite.appearance.difference.cam02ucs import xyz_to_cam02ucs
from brdf_suite.arrays import Bytes, Floats

ENTRIES = 256
_TO_LMS = np.array(
    [
        [4.0767416621, -3.3077115913, 0.2309699292],
        [-1.2684380046, 2.6097574011, -0.3413193965],
        [-0.0041960863, -0.7034186147, 1.7076147010],
    ]
)
"""Linear sRGB of the cubes of OKLab's responses."""
_FINE = 1025


@lru_cache(maxsize=1)
def value_map() -> Bytes:
    """Return (256, 3) sRGB codes: dark blue for the least by green to yellow for the most."""
    t = np.linspace(0.0, 1.0, _FINE)
    hue = np.radians(np.interp(t, [0.0, 0.3, 0.6, 1.0], [285.0, 238.0, 165.0, 105.0]))
    return _even(_in_gamut(0.24 + 0.68 * t, 0.13 + 0.05 * t, hue))


@lru_cache(maxsize=1)
def difference_map() -> Bytes:
    """Return (256, 3) sRGB codes: blue below, neutral grey in the middle, orange above; the ends are as dark."""
    t = np.linspace(0.0, 1.0, _FINE)
    blue = _even(_in_gamut(0.46 + 0.46 * t, 0.17 * (1.0 - t) ** 0.9, np.full_like(t, np.radians(255.0))), 128)
    warm = _even(_in_gamut(0.46 + 0.46 * t, 0.17 * (1.0 - t) ** 0.9, np.full_like(t, np.radians(48.0))), 128)
    return np.concatenate((blue, warm[::-1]))


def _in_gamut(lightness: Floats, chroma: Floats, hue: Floats) -> Floats:
    """Linear sRGB (n, 3) of OKLab's lightness, chroma and hue; the chroma is lowered to what sRGB holds."""
    low, high = np.zeros_like(chroma), chroma.copy()
    for _ in range(24):
        middle = 0.5 * (low + high)
        rgb = _linear(lightness, middle, hue)
        inside = ((rgb >= 0.0) & (rgb <= 1.0)).all(axis=-1)
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    return np.clip(_linear(lightness, low, hue), 0.0, 1.0)


def _linear(lightness: Floats, chroma: Floats, hue: Floats) -> Floats:
    a, b = chroma * np.cos(hue), chroma * np.sin(hue)
    responses = np.stack(
        (
            lightness + 0.3963377774 * a + 0.2158037573 * b,
            lightness - 0.1055613458 * a - 0.0638541728 * b,
            lightness - 0.0894841775 * a - 1.2914855480 * b,
        ),
        axis=-1,
    )
    return np.asarray(responses**3 @ _TO_LMS.T)


def _even(linear: Floats, entries: int = ENTRIES) -> Bytes:
    """Codes (entries, 3) along a curve of linear sRGB, at equal distances of CAM02-UCS."""
    uniform = _uniform(linear)
    travelled = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(uniform, axis=0), axis=-1))))
    places = np.linspace(0.0, travelled[-1], entries)
    even = np.stack([np.interp(places, travelled, linear[:, i]) for i in range(3)], axis=-1)
    return np.asarray(np.round(255.0 * srgb_encode(even)), np.uint8)


def _uniform(linear: Floats) -> Floats:
    white = 100.0 * WORKING_TO_XYZ.sum(axis=1)
    working = linear @ np.linalg.inv(WORKING_TO_SRGB).T
    return xyz_to_cam02ucs(100.0 * working @ WORKING_TO_XYZ.T, white)


def uniform_steps(codes: Bytes) -> Floats:
    """Return the CAM02-UCS distances (n - 1,) between neighbours of a map (n, 3)."""
    return np.asarray(np.linalg.norm(np.diff(_uniform(srgb_decode(codes / 255.0)), axis=0), axis=-1))

"""The colours of a surface's points: of the reflected light, of one channel or line, or from a map of values.

Colours are sRGB codes (..., 3) uint8. The light's colour is shown at full brightness: how bright it is, the radius
says already, and a dark flank of a lobe would else be black.

The maps, one from dark to light and one for signed differences, are curves in OKLab (Ottosson 2020), whose points are
moved along it until neighbours differ by the same CAM02-UCS distance, so that equal steps of a value look like equal
steps. Lightness alone orders either, so they are read without colour too; the hues, blue to yellow and blue to orange,
are those that all kinds of colour vision distinguish.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from brdf_suite.appearance.colour.colorimetry import (
    LUMINANCE,
    WORKING_TO_SRGB,
    WORKING_TO_XYZ,
    srgb_encode,
)
from brdf_suite.appearance.colour.spaces import oklab_to_srgb
from brdf_suite.appearance.difference.cam02ucs import xyz_to_cam02ucs
from brdf_suite.arrays import Bytes, Floats, Singles
from brdf_suite.inspection.slices.values import Channel

ENTRIES = 256
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
    low, high, cos, sin = np.zeros_like(chroma), chroma.copy(), np.cos(hue), np.sin(hue)
    for _ in range(24):
        middle = 0.5 * (low + high)
        rgb = oklab_to_srgb(lightness, middle * cos, middle * sin)
        inside = ((rgb >= 0.0) & (rgb <= 1.0)).all(axis=-1)
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    return np.clip(oklab_to_srgb(lightness, low * cos, low * sin), 0.0, 1.0)


def _even(linear: Floats, entries: int = ENTRIES) -> Bytes:
    """Codes (entries, 3) along a curve of linear sRGB, at equal distances of CAM02-UCS."""
    white = 100.0 * WORKING_TO_XYZ.sum(axis=1)
    working = linear @ np.linalg.inv(WORKING_TO_SRGB).T
    uniform = xyz_to_cam02ucs(100.0 * working @ WORKING_TO_XYZ.T, white)
    travelled = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(uniform, axis=0), axis=-1))))
    places = np.linspace(0.0, travelled[-1], entries)
    even = np.stack([np.interp(places, travelled, linear[:, i]) for i in range(3)], axis=-1)
    return np.asarray(np.round(255.0 * srgb_encode(even)), np.uint8)


CHANNELS: tuple[Channel, ...] = ("colour", "r", "g", "b", "luminance")

CHANNEL_CODES: dict[str, tuple[int, int, int]] = {
    "r": (214, 84, 66),
    "g": (62, 158, 88),
    "b": (74, 116, 214),
    "luminance": (190, 190, 190),
}
"""Red, green, blue, which differ in lightness too, and grey."""

_STEPS = 4096
_FULL = 0.9
"""Linear light of the brightest channel: a white highlight keeps some room for the shading's own."""


def scalar_of(values: Singles, channel: Channel) -> Singles:
    """Return what the radius shows (...) of values (..., 3): a channel, or the luminance (also for ``colour``)."""
    if channel in ("r", "g", "b"):
        return np.ascontiguousarray(values[..., "rgb".index(channel)])
    return np.asarray(values @ LUMINANCE.astype(np.float32))


def light_codes(values: Singles) -> Bytes:
    """Return the colour of light (..., 3), working space, at full brightness; grey where there is none."""
    linear = values @ WORKING_TO_SRGB.T.astype(np.float32)
    np.maximum(linear, 0.0, out=linear)
    brightest = np.maximum(np.maximum(linear[..., 0], linear[..., 1]), linear[..., 2])
    lit = brightest > 1e-20
    share = np.divide(_FULL * (_STEPS - 1), brightest, out=np.zeros_like(brightest), where=lit)
    linear *= share[..., None]
    codes = np.asarray(_encoded().take(linear.astype(np.intp)))
    if not lit.all():
        codes[~lit] = 128
    return codes


def mapped_codes(share: Singles) -> Bytes:
    """Return the value map's colours of shares (...): 0 is its least, 1 its most; beyond them the ends."""
    return _looked_up(value_map(), share)


def difference_codes(share: Singles) -> Bytes:
    """Return the difference map's colours of shares (...): -1, 0 (grey) to 1."""
    return _looked_up(difference_map(), 0.5 * (share + np.float32(1.0)))


def one_colour(code: tuple[float, float, float] | tuple[int, int, int], shape: tuple[int, ...]) -> Bytes:
    """Return a colour, sRGB codes 0 to 255, for every point of ``shape``."""
    return np.broadcast_to(np.asarray(code).round().astype(np.uint8), (*shape, 3))


def _looked_up(table: Bytes, share: Singles) -> Bytes:
    places = np.nan_to_num(share, nan=0.0, posinf=1.0, neginf=0.0)
    np.clip(places, 0.0, 1.0, out=places)
    places *= len(table) - 1
    places += 0.5
    return np.asarray(table.take(places.astype(np.intp), axis=0))


@lru_cache(maxsize=1)
def _encoded() -> Bytes:
    """Codes for linear light in even steps; below 16 of them the steps of dark codes are wider than one."""
    return np.asarray(np.round(255.0 * srgb_encode(np.arange(_STEPS) / (_STEPS - 1.0))), np.uint8)

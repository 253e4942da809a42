"""The colours of a surface's points: of the reflected light, of one channel or line, or from a map of values.

Colours are sRGB codes (..., 3) uint8. The light's colour is shown at full brightness: how bright it is, the radius
says already, and a dark flank of a lobe would else be black.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, WORKING_TO_SRGB, srgb_encode
from brdf_suite.arrays import Bytes, Singles
from brdf_suite.inspection.lobe_surface.colour_maps import difference_map, value_map

Channel = Literal["colour", "r", "g", "b", "luminance"]
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

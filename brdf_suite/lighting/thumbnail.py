"""Small pictures of lights, by which they are chosen."""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, srgb_encode
from brdf_suite.arrays import Bytes
from brdf_suite.lighting.environment import Environment

_HALF_WIDTH_DEG, _UPPER_DEG, _LOWER_DEG = 90.0, 75.0, -35.0
_KEY_QUANTILE, _KEY = 0.5, 0.45
_LEAST_KEY = 1e-6
"""Of the brightest: a light whose median is darker is black but for its lamps."""
_WHITE = 4.0
"""Radiance over the key's that becomes white."""


def light_thumbnail(environment: Environment, size: int) -> Bytes:
    """Return sRGB codes (size, size, 3), top row first, of the half of a light that is in front, above the ground.

    The crop has 180° of azimuth about the centre column, from 35° below to 75° above the horizon, area-averaged to
    ``size`` pixels each way (at least 8); its median becomes a middle tone, and brighter light is compressed towards
    white by the curve of Reinhard et al., *Photographic tone reproduction* (2002), equation 4.
    """
    radiance = np.asarray(environment.radiance, float)
    rows, columns = radiance.shape[:2]
    top, bottom = (round(rows * (90.0 - angle) / 180.0) for angle in (_UPPER_DEG, _LOWER_DEG))
    middle, half = columns // 2, round(columns * _HALF_WIDTH_DEG / 360.0)
    small = _shrunk(radiance[top:bottom, middle - half : middle + half], size)
    linear = np.maximum(small @ WORKING_TO_SRGB.T, 0.0)
    luminance = small.mean(axis=-1)
    key = float(np.quantile(luminance, _KEY_QUANTILE))
    scaled = linear * (_KEY / max(key, _LEAST_KEY * float(luminance.max()), 1e-12))
    toned = scaled * (1.0 + scaled / _WHITE**2) / (1.0 + scaled)
    return np.rint(255.0 * srgb_encode(np.clip(toned, 0.0, 1.0))).astype(np.uint8)


def _shrunk(pixels: np.ndarray, size: int) -> np.ndarray:
    """Average rows and columns (h, w, 3) to (size, size, 3); a smaller image repeats its pixels."""
    for axis in (0, 1):
        edges = np.arange(size) * pixels.shape[axis] // size
        ends = np.maximum(np.append(edges[1:], pixels.shape[axis]), edges + 1)
        sums = np.cumsum(np.insert(pixels, 0, 0.0, axis=axis), axis=axis)
        counts = (ends - edges).reshape((-1, 1, 1) if axis == 0 else (1, -1, 1))
        pixels = (np.take(sums, ends, axis=axis) - np.take(sums, edges, axis=axis)) / counts
    return pixels

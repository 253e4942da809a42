"""Orange peel: the waviness of a clearcoat, as a tile of slopes that repeats without a seam.

A sum of waves of random phase whose lengths lie in an octave around the typical one, in all directions: the height
field is then a stationary Gaussian one with a ring for a spectrum, as profiles of clearcoats have it between 1 and
10 mm. It depends on nothing but a seed, so every machine draws the same coat.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

TILE_WAVES = 32
"""Waves along an edge of the tile: repetition is too far away to be seen where single waves are."""
TILE_TEXELS = 512
"""16 texels a wave: interpolated linearly, slopes are right to 1 %."""
_OCTAVE = 0.5
_SEED = 20240917


def peel_slopes(waves: int = TILE_WAVES, texels: int = TILE_TEXELS) -> NDArray[np.float32]:
    """Return (texels, texels, 2) float32: dh/du and dh/dv of a tile, whose slopes have a mean square of 1 in all.

    Rows go along v. ``waves`` is how many of the typical length fit along an edge.
    """
    number = np.fft.fftfreq(texels, 1.0 / texels)
    along_u, along_v = number[None, :], number[:, None]
    frequency = np.hypot(along_u, along_v)
    with np.errstate(divide="ignore"):
        octaves = np.log2(frequency / waves)  # the mean height, at frequency 0, is infinitely many away
    # In slopes the ring is centred; heights are slopes over frequency.
    ring = np.exp(-0.5 * (octaves / (0.5 * _OCTAVE)) ** 2) / np.maximum(frequency, 1.0)
    noise = np.random.default_rng(_SEED).normal(size=(texels, texels))
    height = np.fft.fft2(noise) * ring
    slopes = np.stack(
        [np.fft.ifft2(2j * np.pi * along * height).real for along in (along_u, along_v)], axis=-1
    )
    slopes /= np.sqrt((slopes**2).sum(axis=-1).mean())
    return slopes.astype(np.float32)


def height_rms_um(slope_deg: float, wavelength_mm: float) -> float:
    """Return the root mean square height, µm, of waves of one length with a root mean square slope.

    >>> round(height_rms_um(0.1, 4.0), 2)
    1.11
    """
    return float(np.tan(np.radians(slope_deg)) * wavelength_mm * 1000.0 / (2.0 * np.pi))

"""The mean of the texture instrument's readings over all pictures, without a picture.

After the thought of Ferrero et al., "A single analytical model for sparkle and graininess patterns in texture of
effect coatings" (Optics Express 21, 2013): a paint's texture is the sum of the images of its flakes, so its
distribution follows from how many there are, how bright, and how wide their images. This derivation is our own.

X, the flakes' light over its mean, is a sum of images h g(r) of flakes strewn at random, g a Gaussian. By Campbell's
theorem its characteristic function is

    φ(ω) = exp(Λ/2 · J(2ω/Λ)),   J(z) = ∫₀ᶻ (ψ(t) - 1) / t dt,

Λ the flakes in the area 4πσ² of an image, ψ the characteristic function of a flake's brightness h over its mean. Its
variance is E h² / Λ. The distribution comes back by a Fourier transform; where images are too rare to meet, it is that
of one. A table of both is made at the first use, in about a second. In diffuse light flakes lie side by side, and the
variance is that of their brightness times the mean square of the part that one has of a place.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import scipy  # its special is loaded when it is used: 0.1 s that the start of Designer is spared

from brdf_suite.appearance.texture import (
    AREA_2,
    AREA_SHAPE,
    BRIGHTNESS_2,
    LIGHTS_DEG,
    VISIBLE_CONTRAST,
    Grain,
    PaintLight,
    Speckle,
    grain,
    speckle,
)
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes

LIGHT_2 = AREA_2 * BRIGHTNESS_2 * 9.0 / 5.0
"""Mean square of a lit flake's brightness h: of area, of depth, and of its tilt, 3 (1 - v)², v even."""

# The table's crowding and contrast over φ, by logarithms; no contrast is seen where flakes are more crowded.
_CROWDING_STEP, _LEAST_STEP = 0.15, 0.1
_CROWDING = np.exp(np.arange(math.log(1e-6), math.log(300.0), _CROWDING_STEP))
_LEAST = np.exp(np.arange(math.log(0.45), math.log(1e6), _LEAST_STEP))
_RARE = 0.02
"""Crowding below which images do not meet."""
# The range of X: in standard deviations, and in images of a flake of the mean brightness; 20 times that is the rarest.
_DEVIATIONS, _IMAGES = 24.0, 20.0
# A step of X, and what a Gaussian smooths away.
_STEP, _SMOOTH = 0.01, 0.02
_NOTHING = 1e-12


def expected_scales(paint: PaintLight, flakes: Flakes) -> Floats:
    """Return (4,) the expected grades in :data:`LIGHTS_DEG`, and graininess: of ``TextureReadings.scales``."""
    grades = [expected_sparkle(speckle(paint, flakes, light))[1] for light in LIGHTS_DEG]
    return np.array([*grades, expected_graininess(grain(paint, flakes))])


def expected_graininess(seen: Grain) -> float:
    """Return the expected standard deviation over the mean in diffuse light."""
    if seen.lit <= 0.0:
        return 0.0
    variance = BRIGHTNESS_2 / seen.lit - 1.0
    part = min(AREA_2 / (seen.cells_per_mm2 * 4.0 * math.pi * seen.spread_mm**2), 1.0)
    return seen.share * math.sqrt(variance * part)


def expected_contrast(seen: Speckle) -> float:
    """Return the standard deviation over the mean of the whole picture in directed light."""
    return seen.share * math.sqrt(LIGHT_2 / max(seen.crowding, 1e-12))


def expected_sparkle(seen: Speckle) -> tuple[float, float]:
    """Return the expected area and grade of a picture in directed light."""
    if seen.share <= 0.0 or not 0.0 < seen.crowding < _CROWDING[-1]:
        return 0.0, 0.0
    down = (math.log(max(seen.crowding, _CROWDING[0])) - math.log(_CROWDING[0])) / _CROWDING_STEP
    right = (math.log(VISIBLE_CONTRAST / seen.share) - math.log(_LEAST[0])) / _LEAST_STEP
    i, j = int(down), int(right)
    if j >= len(_LEAST) - 1:
        return 0.0, 0.0
    down, right = down - i, right - j
    (a, b), (c, d) = _tails()[i : i + 2, j : j + 2]
    between = (1.0 - down) * ((1.0 - right) * a + right * b) + down * ((1.0 - right) * c + right * d)
    area, squared = (value if value > 2.0 * _NOTHING else 0.0 for value in np.exp(between).tolist())
    return area, seen.share * math.sqrt(squared)


@lru_cache(maxsize=1)
def _tails() -> Floats:
    """Return the logarithms (Λ, t, 2) of P(X > 1 + t) and E((X - 1)²; X > 1 + t)."""
    rows = [_tails_of_one(c) if c < _RARE else _tails_of_sum(c) for c in _CROWDING.tolist()]
    return np.log(np.maximum(np.array(rows), _NOTHING))


def _tails_of_sum(crowding: float) -> Floats:
    """Return both tails (t, 2) at :data:`_LEAST`, by the characteristic function."""
    reach = max(_DEVIATIONS * math.sqrt(LIGHT_2 / crowding), 2.0 * _IMAGES / crowding)
    size = 1 << math.ceil(math.log2(reach / _STEP))
    step = reach / size
    omega = np.arange(size // 2 + 1, dtype=np.float64) * (2.0 * math.pi / reach)
    half = 0.5 * crowding
    phi = np.exp(half * _exponent(omega / half) - 0.5 * (_SMOOTH * omega) ** 2)
    chance = np.fft.irfft(np.conj(phi), size)
    # The last tenth of the range is what was smoothed below zero.
    chance[int(0.9 * size) :] = 0.0
    x = np.arange(size) * step
    above = np.cumsum(np.stack([chance, chance * (x - 1.0) ** 2])[:, ::-1], axis=1)[:, ::-1]
    return np.stack([np.interp(1.0 + _LEAST, x - 0.5 * step, tail, right=0.0) for tail in above], axis=-1)


def _tails_of_one(crowding: float) -> Floats:
    """Return both tails (t, 2) where a place lies in one image or none: X = 2 h y / Λ, and Λ dy / 2y of places at y."""
    h, sums = _brightness()
    scale = 2.0 / crowding
    least = (1.0 + _LEAST) / scale
    # Sums of the chance, of ln h, h and h² over all flakes that are bright enough.
    chance, logarithm, first, second = sums[:, np.searchsorted(h, least)]
    area = logarithm - chance * np.log(least)
    squared = 0.5 * scale**2 * (second - chance * least**2) - 2.0 * scale * (first - chance * least) + area
    return 0.5 * crowding * np.stack([area, squared], axis=-1)


@lru_cache(maxsize=1)
def _brightness() -> tuple[Floats, Floats]:
    """Return a lit flake's brightness (n,) by size, and sums (4, n + 1) from each: area, depth 2.5 u^1.5, tilt 3 w²."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    u, w = 0.5 * (nodes + 1.0), 0.5 * weights
    area = scipy.special.gammaincinv(AREA_SHAPE, u) / AREA_SHAPE
    h = (area[:, None, None] * (2.5 * u**1.5)[:, None] * (3.0 * u**2)).ravel()
    order = np.argsort(h)
    h, chance = h[order], (w[:, None, None] * w[:, None] * w).ravel()[order]
    parts = chance * np.stack([np.ones_like(h), np.log(h), h, h * h])
    sums = np.zeros((4, h.size + 1))
    sums[:, :-1] = np.cumsum(parts[:, ::-1], axis=1)[:, ::-1]
    return h, sums


@lru_cache(maxsize=1)
def _table() -> tuple[Floats, Floats]:
    """Return ln z (n,) and J(z) (n,), complex."""
    log_z = np.linspace(math.log(1e-4), math.log(1e5), 1600)
    z = np.exp(log_z)
    nodes, weights = np.polynomial.legendre.leggauss(32)
    u, w = 0.5 * (nodes + 1.0), 0.5 * weights
    # Of the area's gamma distribution it is (1 - i t / k)^-k.
    product = ((2.5 * u**1.5)[:, None] * (3.0 * u**2)).ravel()
    chances = (w[:, None] * w).ravel()
    psi = np.array([chances @ (1.0 - 1j * t * product / AREA_SHAPE) ** -AREA_SHAPE for t in z])
    integrand = psi - 1.0
    steps = 0.5 * (integrand[1:] + integrand[:-1]) * np.diff(log_z)
    # Below the table ψ(t) - 1 is i t.
    return log_z, np.concatenate([[0.0], np.cumsum(steps)]) + 1j * z[0]


def _exponent(z: Floats) -> Floats:
    """Return J (n,), complex, for z (n,) ≥ 0."""
    log_z, known = _table()
    at = np.log(np.maximum(z, 1e-300))
    real, imaginary = (np.interp(at, log_z, part) for part in (known.real, known.imag))
    below = np.exp(log_z[0])
    return np.asarray(np.where(z < below, 1j * z, real + 1j * imaginary))

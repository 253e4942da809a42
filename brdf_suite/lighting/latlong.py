"""Latitude-longitude maps: directions of texels and look-up.

Row 0 is up (+y). The centre column looks along +z and u grows to the right as seen from inside, which is
towards -x. ``theta`` is the angle from +y, ``phi = atan2(-x, z)`` the longitude, 0 at the centre column,
growing with u.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def ring_angles(rings: int) -> NDArray[np.float64]:
    """Return theta (rings,) of the rows' centres, in radians."""
    return np.asarray((np.arange(rings) + 0.5) * (np.pi / rings), dtype=np.float64)


def column_angles(columns: int) -> NDArray[np.float64]:
    """Return phi (columns,) of the columns' centres, in radians, -π…π."""
    return np.asarray((np.arange(columns) + 0.5) * (2.0 * np.pi / columns) - np.pi, dtype=np.float64)


def direction(theta: NDArray[np.float64], phi: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return unit directions (..., 3) of broadcast angles."""
    sine = np.sin(theta)
    x, y, z = np.broadcast_arrays(-sine * np.sin(phi), np.cos(theta), sine * np.cos(phi))
    return np.stack([x, y, z], axis=-1)


def angles(directions: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return theta (...) and phi (...) of directions (..., 3) of any length but 0."""
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    # arctan2 of the horizontal length keeps full precision near the poles, where arccos(y) has none.
    return np.arctan2(np.hypot(x, z), y), np.arctan2(-x, z)


def fejer_weights(rings: int) -> NDArray[np.float64]:
    """Return the weights (rings,) of Fejér's first rule: ∫ f sinθ dθ ≈ Σ w f(θ_j), exact for polynomials in
    cosθ.

    The weights sum to 2. Source: Waldvogel, "Fast construction of the Fejér and Clenshaw-Curtis quadrature
    rules", BIT 46 (2006).
    """
    k = np.arange(1, rings // 2 + 1)
    # cos(2kθ_j) with θ_j = (j + ½)π/n is a cosine transform; a real FFT of length 2n evaluates all j at once.
    spectrum = np.zeros(rings + 1, dtype=np.complex128)
    spectrum[0] = 1.0
    even = 2 * k
    spectrum[even] = -np.exp(1j * np.pi * even / (2.0 * rings)) / (4.0 * k * k - 1.0)
    weights: NDArray[np.float64] = np.fft.irfft(spectrum, 2 * rings)[:rings] * (2.0 * rings) * (2.0 / rings)
    return weights


def sample(pixels: NDArray[np.float32], directions: NDArray[np.float64]) -> NDArray[np.float32]:
    """Return radiance (..., 3) of a map (h, w, 3) along directions (..., 3): bilinear, over seam and poles."""
    height, width = pixels.shape[:2]
    theta, phi = angles(directions)
    row = theta * (height / np.pi) - 0.5
    column = (phi + np.pi) * (width / (2.0 * np.pi)) - 0.5
    # One ring more at each end: beyond the pole lies the same ring, half a turn further.
    padded = np.concatenate([np.roll(pixels[:1], width // 2, 1), pixels, np.roll(pixels[-1:], width // 2, 1)])
    flat = padded.reshape(-1, 3)
    j = np.floor(row).astype(np.int64)
    i = np.floor(column).astype(np.int64)
    fj = (row - j).astype(np.float32)[..., None]
    fi = (column - i).astype(np.float32)[..., None]
    above = np.clip(j + 1, 0, height + 1) * width
    below = np.clip(j + 2, 0, height + 1) * width
    left, right = i % width, (i + 1) % width
    top = flat[above + left] * (1.0 - fi) + flat[above + right] * fi
    bottom = flat[below + left] * (1.0 - fi) + flat[below + right] * fi
    result: NDArray[np.float32] = top * (1.0 - fj) + bottom * fj
    return result

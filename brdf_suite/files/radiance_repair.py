"""Repair pixels that cannot be radiance, and say what was done."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

MAX_RADIANCE = 1e15
"""Above this a value is taken as infinite: a million times the sun in cd/m², and safe to square in
float32."""


def repair_non_finite(pixels: NDArray[np.float32]) -> tuple[NDArray[np.float32], list[str]]:
    """Return pixels (h, w, 3) without NaN and infinity, and notes.

    NaN becomes the mean of the sound values among the eight neighbours (columns wrap round), 0 where there is
    none. Infinity becomes the largest sound value of the image, or 65504 (the largest half float) where that
    is less: it stands for a light that was too bright to store.
    """
    notes: list[str] = []
    is_nan = np.isnan(pixels)
    is_infinite = ~is_nan & (np.abs(pixels) > MAX_RADIANCE)
    if not is_nan.any() and not is_infinite.any():
        return pixels, notes
    sound = np.where(is_nan | is_infinite, np.float32(0.0), pixels)
    repaired = sound.copy()
    if is_infinite.any():
        ceiling = np.float32(max(float(sound.max()), 65504.0))
        repaired[is_infinite] = np.where(pixels[is_infinite] > 0.0, ceiling, np.float32(0.0))
        count = int(is_infinite.any(axis=2).sum())
        notes.append(f"{count:,} pixel(s) held infinite radiance; it was set to {ceiling:g}")
    if is_nan.any():
        repaired[is_nan] = _neighbour_mean(repaired, is_nan)[is_nan]
        count = int(is_nan.any(axis=2).sum())
        notes.append(f"{count:,} pixel(s) held no number (NaN); they were filled from their neighbours")
    return repaired, notes


def clip_negative(pixels: NDArray[np.float32]) -> tuple[NDArray[np.float32], list[str]]:
    """Return pixels (h, w, 3) with negative radiance set to 0, and a note that tells how much that was."""
    negative = pixels < 0.0
    if not negative.any():
        return pixels, []
    count = int(negative.any(axis=2).sum())
    share = 100.0 * count / (pixels.shape[0] * pixels.shape[1])
    lowest = float(pixels.min())
    note = f"{count:,} pixel(s) ({share:.2g} %) held negative radiance, down to {lowest:.3g}; it was set to 0"
    return np.maximum(pixels, np.float32(0.0)), [note]


def _neighbour_mean(values: NDArray[np.float32], missing: NDArray[np.bool_]) -> NDArray[np.float32]:
    weights = (~missing).astype(np.float32)
    known = values * weights
    total = np.zeros_like(values, dtype=np.float32)
    count = np.zeros_like(values)
    height = values.shape[0]
    for dy in (-1, 0, 1):
        rows = np.clip(np.arange(height) + dy, 0, height - 1)
        for dx in (-1, 0, 1):
            total += np.roll(known[rows], dx, axis=1)
            count += np.roll(weights[rows], dx, axis=1)
    np.divide(total, np.maximum(count, 1.0), out=total)
    return total

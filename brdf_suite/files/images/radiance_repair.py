"""Repair of invalid radiance values, with notices."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

MAX_RADIANCE = 1e15
"""Largest radiance that is kept: a million times the sun in cd/m², and safe to square in float32."""


def repair_non_finite(pixels: NDArray[np.float32]) -> tuple[NDArray[np.float32], list[str]]:
    """Return pixels (h, w, 3) without NaN, infinity and absurdly large values, and notes.

    NaN becomes the mean of the sound values among the eight neighbours (columns wrap round), 0 where there is
    none. Infinity, and what is above :data:`MAX_RADIANCE`, becomes the largest sound value of the image, or
    65504 (the largest half float) where that is less: it represents a light that was too bright to store.
    Minus infinity, and what is below -:data:`MAX_RADIANCE`, becomes 0.
    """
    notes: list[str] = []
    is_nan = np.isnan(pixels)
    too_bright = pixels > MAX_RADIANCE
    too_negative = pixels < -MAX_RADIANCE
    missing = is_nan | too_bright | too_negative
    if not missing.any():
        return pixels, notes
    repaired = np.where(missing, np.float32(0.0), pixels)
    ceiling = np.float32(max(float(repaired.max()), 65504.0))
    repaired[too_bright] = ceiling
    infinite = np.isinf(pixels)
    for where, held in (
        (too_bright & infinite, f"infinite radiance; it was set to {ceiling:g}"),
        (too_bright & ~infinite, f"radiance above {MAX_RADIANCE:g}; it was set to {ceiling:g}"),
        (too_negative & infinite, "minus infinity; it was set to 0"),
        (too_negative & ~infinite, f"radiance below -{MAX_RADIANCE:g}; it was set to 0"),
    ):
        if where.any():
            notes.append(f"{_pixels(where)} held {held}")
    if is_nan.any():
        mean, alone = _neighbour_mean(repaired, is_nan)
        repaired[is_nan] = mean[is_nan]
        alone &= is_nan
        filled = is_nan & ~alone
        if filled.any():
            notes.append(f"{_pixels(filled)} held no number (NaN); they were filled from their neighbours")
        if alone.any():
            reason = "no number (NaN), nor did their neighbours; they were set to 0"
            notes.append(f"{_pixels(alone)} held {reason}")
    return repaired, notes


def clip_negative(pixels: NDArray[np.float32]) -> tuple[NDArray[np.float32], list[str]]:
    """Return pixels (h, w, 3) with negative radiance set to 0, and a note that states how much that was."""
    negative = pixels < 0.0
    if not negative.any():
        return pixels, []
    count, total = int(negative.any(axis=2).sum()), pixels.shape[0] * pixels.shape[1]
    share = "all of them" if count == total else f"{min(100.0 * count / total, 99.0):.2g} %"
    lowest = float(pixels.min())
    note = f"{_pixels(negative)} ({share}) held negative radiance, down to {lowest:.3g}; clamped to 0"
    return np.maximum(pixels, np.float32(0.0)), [note]


def note_darkness(pixels: NDArray[np.float32]) -> list[str]:
    """Return a note where no pixel (h, w, 3) gives any light, which is rarely meant."""
    return [] if pixels.any() else ["every pixel is black: nothing is lit by this environment"]


def _pixels(where: NDArray[np.bool_]) -> str:
    return f"{int(where.any(axis=2).sum()):,} pixel(s)"


def _neighbour_mean(
    values: NDArray[np.float32], missing: NDArray[np.bool_]
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Return the mean of the sound neighbours, and where there is none."""
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
    return total, count == 0.0

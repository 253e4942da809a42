"""Environment images from files, in the working space; pictures to files.

``read_environment_image`` is the one way in, for environments of every layout: it looks at the content, not the
ending, reads OpenEXR and Radiance pictures, converts to the working space (linear Rec. 2020, D65) and repairs
what cannot be radiance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.exr.image import read_exr, write_exr, write_exr_strips
from brdf_suite.files.images.png import write_png, write_png_strips
from brdf_suite.files.images.primaries import REC2020, rgb_to_working
from brdf_suite.files.images.radiance import read_radiance
from brdf_suite.regular_files import open_regular, within_memory

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
    if float(pixels.min()) >= -MAX_RADIANCE and float(pixels.max()) <= MAX_RADIANCE:
        return pixels, notes  # not so where anything is NaN
    is_nan = np.isnan(pixels)
    too_bright = pixels > MAX_RADIANCE
    too_negative = pixels < -MAX_RADIANCE
    missing = is_nan | too_bright | too_negative
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
    if pixels.min() >= 0.0:
        return pixels, []
    negative = pixels < 0.0
    count, total = int(negative.any(axis=2).sum()), pixels.shape[0] * pixels.shape[1]
    share = "all of them" if count == total else f"{min(100.0 * count / total, 99.0):.2g} %"
    lowest = float(pixels.min())
    note = f"{_pixels(negative)} ({share}) held negative radiance, down to {lowest:.3g}; clamped to 0"
    return np.maximum(pixels, np.float32(0.0)), [note]


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


__all__ = [
    "ImageData",
    "read_environment_image",
    "write_exr",
    "write_exr_strips",
    "write_png",
    "write_png_strips",
]

MIN_SIDE = 2


@dataclass(frozen=True)
class ImageData:
    """An environment image as read.

    Attributes
    ----------
    pixels
        (h, w, 3) float32, linear Rec. 2020 with D65 white, finite and never negative, in the file's own layout.
    notes
        What was assumed or repaired, each a clause for the user; empty where nothing was.
    layout
        The layout that the file names (``exr_cube``); ``None`` where it follows from the shape alone.
    """

    pixels: NDArray[np.float32]
    notes: tuple[str, ...]
    layout: str | None = None


@within_memory
def read_environment_image(path: PathLike) -> ImageData:
    """Read an environment image from an OpenEXR or Radiance file, in whatever layout it has.

    Larger than 8,192 × 4,096 is reduced by area as it is read, in strips.

    Raises
    ------
    FileError
        The file is missing, damaged, too large or too small, or of another kind; the message says which.
    """
    with open_regular(path) as stream:
        start = stream.read(12)
    layout = None
    if start.startswith(b"\x76\x2f\x31\x01"):
        exr = read_exr(path)
        pixels, chromaticities, notes = exr.pixels, exr.chromaticities, exr.notes
        layout = "exr_cube" if exr.is_cube else None
    elif start.startswith(b"#?"):
        pixels, chromaticities, notes = read_radiance(path)
    else:
        raise FileError(path, _what_instead(start), "byte 0")
    height, width = pixels.shape[:2]
    if min(height, width) < MIN_SIDE:
        raise FileError(path, f"is {width} × {height} pixels, too small for an environment")
    if np.isnan(pixels[0, 0]).all() and np.isnan(pixels).all():
        raise FileError(path, "holds no number (NaN) in any pixel; there is nothing to repair it from")
    pixels, repairs = repair_non_finite(pixels)
    # Files hold chromaticities as float32 or as text: four digits decide.
    if not np.allclose(chromaticities, REC2020, atol=5e-5):
        try:
            matrix = rgb_to_working(chromaticities).astype(np.float32)
        except ValueError as error:
            raise FileError(path, f"has unusable primaries: {error}", "attribute chromaticities") from error
        for row in pixels:  # in place: both together may take most of the memory there is
            row[:] = row @ matrix.T
    # After the conversion: a saturated colour of narrower primaries is a sound one in the working space.
    pixels, clipped = clip_negative(pixels)
    dark = [] if pixels.any() else ["every pixel is black: nothing is lit by this environment"]
    notices = (*notes, *repairs, *clipped, *dark)
    return ImageData(np.ascontiguousarray(pixels), notices, layout)


def _what_instead(start: bytes) -> str:
    if not start:
        return "is empty"
    known = {
        b"\x89PNG": "a PNG picture",
        b"\xff\xd8\xff": "a JPEG picture",
        b"II*\0": "a TIFF",
        b"MM\0*": "a TIFF",
    }
    for magic, kind in known.items():
        if start.startswith(magic):
            return f"is {kind}; an environment must be an OpenEXR (.exr) or Radiance (.hdr) file"
    return "is neither an OpenEXR (.exr) nor a Radiance (.hdr) file, whatever its name says"

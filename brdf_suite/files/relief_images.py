"""Maps of normals and tangents, and masks, from image files: PNG and what else pillow reads, or OpenEXR.

Their numbers are not colours.

A normal map holds (n + 1)/2 in red, green and blue (signed in EXR files), x to the right, y up, z off the surface. What
comes back are slopes, which can be averaged: the normal is (-dh/du, -dh/dv, 1) over its length.
"""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError
from brdf_suite.files.exr import read_exr

IMAGE_ENDINGS = (".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".tga", ".webp")

LARGEST_SIDE = 4096
"""Texels; a larger image is averaged down by a whole number."""
_MOST_PIXELS = 1 << 28
_STEEPEST = 20.0
_EXR = b"\x76\x2f\x31\x01"


def read_normal_map(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    """Return slopes (h, w, 2) float32, dh/du and dh/dv, the first row at v = 0 (the lower edge of the image).

    Raises
    ------
    FileError
        The file cannot be read, has no three channels, or holds no normals: most of them must have about unit
        length and look off the surface.
    """
    pixels, signed = _read(path)
    if pixels.shape[2] < 3:
        raise FileError(path, "has one channel; a normal map has three (a height map is none)")
    normals = pixels[..., :3] if signed else 2.0 * pixels[..., :3] - 1.0
    length = np.linalg.norm(normals, axis=-1)
    sound = (np.abs(length - 1.0) < 0.25) & (normals[..., 2] > 0.0)
    if sound.mean() < 0.5:
        share = 100.0 * float(sound.mean())
        raise FileError(path, f"is no normal map: {share:.0f} % of its pixels are unit vectors off a surface")
    upright = np.maximum(normals[..., 2:], 1.0 / _STEEPEST)
    slopes = np.clip(-normals[..., :2] / upright, -_STEEPEST, _STEEPEST)
    return np.ascontiguousarray(_reduced(slopes)[::-1], np.float32)


def read_tangent_map(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    """Return directions in the surface (h, w, 2) float32, unit vectors over u and v, the first row at v = 0.

    Red and green hold (t + 1)/2, or t itself in EXR files with negative numbers (as glTF's anisotropy has it).

    Raises
    ------
    FileError
        The file cannot be read, has one channel, or holds no directions: most of them must be of about unit length.
    """
    pixels, signed = _read(path)
    if pixels.shape[2] < 2:
        raise FileError(path, "has one channel; a tangent map has two or more (directions along u and v)")
    along = pixels[..., :2] if signed else 2.0 * pixels[..., :2] - 1.0
    length = np.linalg.norm(along, axis=-1)
    sound = np.abs(length - 1.0) < 0.25
    if sound.mean() < 0.5:
        share = 100.0 * float(sound.mean())
        raise FileError(
            path, f"is no tangent map: {share:.0f} % of its pixels are unit vectors in the surface"
        )
    unit = along / np.maximum(length, 1e-6)[..., None]
    return np.ascontiguousarray(_reduced(unit)[::-1], np.float32)


def read_mask(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    """Return the mean of the colour channels, (h, w) float32, 0…1, the first row at the lower edge of the image.

    White is 1 and black 0, as the numbers stand in the file: a mask is a share, not a colour.

    Raises
    ------
    FileError
        The file cannot be read as an image.
    """
    pixels, _ = _read(path)
    grey = pixels[..., :3].mean(axis=-1) if pixels.shape[2] >= 3 else pixels[..., 0]
    return np.ascontiguousarray(np.clip(_reduced(grey[..., None])[::-1, :, 0], 0.0, 1.0), np.float32)


def _read(path: str | os.PathLike[str]) -> tuple[NDArray[Any], bool]:
    """Return pixels (h, w, channels), top row first, 0…1 where they are whole numbers; and whether they are signed."""
    try:
        with Path(path).open("rb") as stream:
            start = stream.read(4)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise FileError(path, f"cannot be read ({reason})") from error
    if start == _EXR:
        pixels = read_exr(path).pixels
        if not np.isfinite(pixels).all():
            raise FileError(path, "holds numbers that are not finite")
        return pixels, bool((pixels < 0.0).any())
    return _read_pillow(path), False


def _read_pillow(path: str | os.PathLike[str]) -> NDArray[Any]:
    from PIL import Image, UnidentifiedImageError

    try:
        with warnings.catch_warnings():
            # Pillow warns of a decompression bomb, and goes on. No other warning: other threads give theirs.
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(path) as image:
                if image.width * image.height > _MOST_PIXELS:
                    raise FileError(path, f"is {image.width} × {image.height} pixels, too large to be read")
                if image.mode.startswith("I"):
                    return np.asarray(image, np.float32)[..., None] / 65535.0
                if image.mode == "F":
                    return np.asarray(image, np.float32)[..., None]
                mode = "L" if image.mode in ("1", "L", "LA") else "RGB"
                return np.atleast_3d(np.asarray(image.convert(mode), np.float32) / 255.0)
    except UnidentifiedImageError as error:
        raise FileError(path, "is no image that can be read (PNG, EXR, JPEG, TIFF …)") from error
    except FileError:
        raise
    except Exception as error:  # its readers raise whatever a damaged file runs them into
        raise FileError(path, f"is damaged, or no image that can be read ({error})") from error


def _reduced(values: NDArray[Any]) -> NDArray[Any]:
    """Average blocks of whole numbers of texels until no side is over the limit."""
    step = -(-max(values.shape[:2]) // LARGEST_SIDE)
    if step <= 1:
        return values
    height, width = (side // step * step for side in values.shape[:2])
    blocks = values[:height, :width].reshape(height // step, step, width // step, step, -1)
    return np.asarray(blocks.mean(axis=(1, 3)))

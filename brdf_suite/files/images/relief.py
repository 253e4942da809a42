"""Normal maps, tangent maps and masks from image files: PNG and other common formats, or OpenEXR.

Their numbers are not colours.

A normal map holds (n + 1)/2 in red, green and blue (signed in EXR files), x to the right, y up, z off the surface. What
comes back are slopes, which can be averaged: the normal is (-dh/du, -dh/dv, 1) over its length.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.exr.image import read_exr
from brdf_suite.files.images.pictures import read_picture
from brdf_suite.regular_files import open_regular, within_memory

IMAGE_ENDINGS = (".png", ".exr", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".tga", ".webp")

LARGEST_SIDE = 4096
"""Texels; a larger image is averaged down by a whole number."""
_STRIP_PIXELS = 1 << 16
"""Pixels that are worked on at once: as numbers, all of a large map would take gigabytes, and few stay in the cache."""
_STEEPEST = 20.0
_LARGEST_NUMBER = 1e6
"""In an EXR file; the squares of larger ones would overflow."""
_EXR = b"\x76\x2f\x31\x01"
_SCALES = {"u1": 255.0, "u2": 65535.0, "i4": 65535.0}
"""What white is, by kind and size of the numbers; Pillow gives 16 bits as either of two."""


@within_memory
def read_normal_map(path: PathLike) -> NDArray[np.float32]:
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

    def slopes(shares: NDArray[Any]) -> tuple[NDArray[Any], int]:
        normals = shares[..., :3] if signed else 2.0 * shares[..., :3] - 1.0
        length = np.sqrt(np.einsum("...i,...i", normals, normals))  # several times as fast as linalg.norm
        sound = (np.abs(length - 1.0) < 0.25) & (normals[..., 2] > 0.0)
        upright = np.maximum(normals[..., 2:], 1.0 / _STEEPEST)
        return np.clip(-normals[..., :2] / upright, -_STEEPEST, _STEEPEST), int(sound.sum())

    reduced, sound = _reduced(pixels, slopes)
    if sound < 0.5:
        share = 100.0 * sound
        raise FileError(path, f"is no normal map: {share:.0f} % of its pixels are unit vectors off a surface")
    return reduced


@within_memory
def read_tangent_map(path: PathLike) -> NDArray[np.float32]:
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

    def directions(shares: NDArray[Any]) -> tuple[NDArray[Any], int]:
        along = shares[..., :2] if signed else 2.0 * shares[..., :2] - 1.0
        length = np.linalg.norm(along, axis=-1)
        return along / np.maximum(length, 1e-6)[..., None], int((np.abs(length - 1.0) < 0.25).sum())

    reduced, sound = _reduced(pixels, directions)
    if sound < 0.5:
        share = 100.0 * sound
        raise FileError(
            path, f"is no tangent map: {share:.0f} % of its pixels are unit vectors in the surface"
        )
    return reduced


@within_memory
def read_mask(path: PathLike) -> NDArray[np.float32]:
    """Return the mean of the colour channels, (h, w) float32, 0…1, the first row at the lower edge of the image.

    White is 1 and black 0, as the numbers stand in the file: a mask is a share, not a colour.

    Raises :class:`FileError`: the file cannot be read as an image.
    """
    pixels, _ = _read(path)

    def grey(shares: NDArray[Any]) -> tuple[NDArray[Any], int]:
        return (shares[..., :3] if shares.shape[2] >= 3 else shares[..., :1]).mean(axis=-1, keepdims=True), 0

    return np.clip(_reduced(pixels, grey)[0][..., 0], 0.0, 1.0)


def _read(path: PathLike) -> tuple[NDArray[Any], bool]:
    """Return pixels (h, w, channels) as in the file, the first row at the top; and whether they are signed."""
    with open_regular(path) as stream:
        start = stream.read(4)
    if start != _EXR:
        return read_picture(path), False
    pixels = read_exr(path).pixels
    if not np.isfinite(pixels).all():
        raise FileError(path, "holds numbers that are not finite")
    if np.abs(pixels).max() > _LARGEST_NUMBER:
        raise FileError(
            path, f"holds numbers over {_LARGEST_NUMBER:g}, which are neither shares nor directions"
        )
    return pixels, bool((pixels < 0.0).any())


def _reduced(
    pixels: NDArray[Any], convert: Callable[[NDArray[Any]], tuple[NDArray[Any], int]]
) -> tuple[NDArray[np.float32], float]:
    """Convert pixels and average blocks of whole numbers of texels until no side is over the limit.

    ``convert`` takes rows of pixels, 0…1 where they are whole numbers in the file, and returns the values of each
    (rows, w, n) and how many of them are sound. Returned are the values, the first row at the lower edge of the image,
    and the share of all pixels that are sound.
    """
    height, width = pixels.shape[:2]
    step = -(-max(height, width) // LARGEST_SIDE)
    down, across = min(step, height), min(step, width)
    rows = max(1, _STRIP_PIXELS // (width * down)) * down
    scale = _SCALES.get(pixels.dtype.kind + str(pixels.dtype.itemsize), 1.0)
    parts, sound = [], 0
    for top in range(0, height, rows):
        values, well = convert(np.asarray(pixels[top : top + rows], np.float32) / np.float32(scale))
        sound += well
        if step > 1:
            tall, wide = len(values) // down, width // across
            # Rows first, then columns added one by one: a mean along short axes takes several times as long.
            shape = (tall, down, wide, across, values.shape[2])
            blocks = values[: tall * down, : wide * across].reshape(shape).mean(axis=1)
            values = sum(blocks[:, :, k] for k in range(1, across)) + blocks[:, :, 0]
            values /= across
        parts.append(np.asarray(values, np.float32))
    return np.ascontiguousarray(np.concatenate(parts)[::-1]), sound / (height * width)

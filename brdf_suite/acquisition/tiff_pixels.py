"""The pixels of a TIFF: 8 or 16 bits or floats, grey or RGB, in strips or tiles, plain or deflated.

Written here because none of the imaging libraries that are always there reads 16-bit RGB. Other packings (LZW, JPEG
in TIFF) are left to OpenCV where it is installed.
"""

from __future__ import annotations

import os
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.acquisition.tiff_fields import Content, Fields, first_folder
from brdf_suite.errors import FileError

_Path = str | os.PathLike[str]

WIDTH, HEIGHT, BITS, COMPRESSION, PHOTOMETRIC = 256, 257, 258, 259, 262
_STRIPS, _CHANNELS, _ROWS, _STRIP_BYTES, _PLANES, _PREDICTOR = 273, 277, 278, 279, 284, 317
_TILE_WIDTH, _TILE_HEIGHT, _TILES, _TILE_BYTES, _FORMAT = 322, 323, 324, 325, 339

MOST_PIXELS = 1 << 28
_MOST_CHANNELS = 5
_PLAIN, _DEFLATED = (1,), (8, 32946)


def layout(fields: Fields, path: _Path) -> tuple[int, int, int, int, bool]:
    """Return width, height, channels, bits, and whether its numbers are floats."""
    width, height = (int(_one(fields, tag, path)) for tag in (WIDTH, HEIGHT))
    channels = int(_one(fields, _CHANNELS, path, 1))
    bits = int(_one(fields, BITS, path, 1))
    floats = _one(fields, _FORMAT, path, 1) == 3
    if width < 1 or height < 1 or width * height > MOST_PIXELS:
        raise FileError(path, f"is {width} × {height} pixels; up to {MOST_PIXELS:,} are read")
    if not 1 <= channels <= _MOST_CHANNELS:
        raise FileError(path, f"has {channels} channels; up to {_MOST_CHANNELS} are read")
    return width, height, channels, bits, floats


def check_whole(content: Content, fields: Fields, path: _Path) -> None:
    """Raise :class:`FileError` where the pixels reach beyond the file's end."""
    for places, sizes in ((_STRIPS, _STRIP_BYTES), (_TILES, _TILE_BYTES)):
        if places in fields:
            offsets, counts = _numbers(fields, places, path, ()), _numbers(fields, sizes, path, ())
            end = max((int(a + b) for a, b in zip(offsets, counts, strict=False)), default=0)
            if end > len(content):
                raise FileError(
                    path, f"ends at byte {len(content):,}, its pixels at {end:,}; it was not copied whole"
                )


def is_own(fields: Fields, path: _Path) -> bool:
    """Say whether the packing is one of those that are read here."""
    packing = _one(fields, COMPRESSION, path, 1)
    predictor = _one(fields, _PREDICTOR, path, 1)
    whole_bytes = layout(fields, path)[3] in (8, 16, 32)
    kind = _one(fields, PHOTOMETRIC, path, 2)
    return packing in (*_PLAIN, *_DEFLATED) and predictor in (1, 2) and whole_bytes and kind in (1, 2)


def tiff_pixels(content: Content, path: _Path) -> NDArray[Any]:
    """Return the pixels (h, w, channels) of the first picture, as they stand in the file.

    Raises
    ------
    FileError
        It is damaged, cut off, or packed in a way that is not read here.
    """
    fields, order = first_folder(content, path)
    if not is_own(fields, path):
        raise FileError(path, "is packed in a way that is read by OpenCV alone", "field Compression")
    check_whole(content, fields, path)
    width, height, channels, bits, floats = layout(fields, path)
    kind = np.dtype(
        {(8, False): "u1", (16, False): "u2", (32, True): "f4", (16, True): "f2"}.get((bits, floats), "V")
    )
    if kind.kind == "V":
        raise FileError(path, f"has {bits} bits a channel; 8, 16, or floats are read", "field BitsPerSample")
    apart = _one(fields, _PLANES, path, 1) == 2 and channels > 1
    tiled = _TILES in fields
    rows = int(_one(fields, _TILE_HEIGHT if tiled else _ROWS, path, height))
    columns = int(_one(fields, _TILE_WIDTH, path, width)) if tiled else width
    if rows < 1 or columns < 1:
        raise FileError(path, "has strips of no rows; it is damaged")
    if tiled and rows * columns > MOST_PIXELS:
        raise FileError(path, f"has tiles of {columns} × {rows} pixels; it is damaged")
    rows = min(rows, height) if not tiled else rows
    offsets = _numbers(fields, _TILES if tiled else _STRIPS, path)
    counts = _numbers(fields, _TILE_BYTES if tiled else _STRIP_BYTES, path)
    across, down = -(-width // columns), -(-height // rows)
    planes = channels if apart else 1
    if min(len(offsets), len(counts)) < across * down * planes:
        raise FileError(path, "names fewer strips than its pixels need; it is damaged")
    pixels = np.zeros((height, width, channels), kind)
    for index in range(across * down * planes):
        plane, place = divmod(index, across * down)
        top, left = (place // across) * rows, (place % across) * columns
        high = rows if tiled else min(rows, height - top)
        start = int(offsets[index])
        inner = 1 if apart else channels
        wanted = high * columns * inner
        packed = content[start : start + int(counts[index])]
        part = _unpacked(packed, wanted * kind.itemsize, fields, path)
        if len(part) < wanted * kind.itemsize:
            raise FileError(path, "has a strip that is too short; it is damaged", f"byte {start}")
        block = (
            np.frombuffer(part, np.dtype(order + kind.str[1:]), wanted)
            .reshape(high, columns, inner)
            .astype(kind)
        )
        if _one(fields, _PREDICTOR, path, 1) == 2:
            block = np.cumsum(block, axis=1, dtype=kind)
        target = pixels[top : top + high, left : left + columns]
        shown = block[: target.shape[0], : target.shape[1]]
        if apart:
            target[..., plane] = shown[..., 0]
        else:
            target[...] = shown
    return pixels


def _unpacked(raw: bytes, size: int, fields: Fields, path: _Path) -> bytes:
    if _one(fields, COMPRESSION, path, 1) in _PLAIN:
        return raw
    try:
        # No more than the strip holds: what unpacks to more is a bomb.
        return zlib.decompressobj().decompress(raw, size)
    except zlib.error as error:
        raise FileError(path, f"has a strip that cannot be unpacked ({error})") from error


def _numbers(
    fields: Fields, tag: int, path: _Path, default: tuple[float, ...] | None = None
) -> tuple[float, ...]:
    value = fields.get(tag, default)
    if not isinstance(value, tuple):
        raise FileError(path, f"lacks the field {tag}; it is damaged or no photograph")
    return value


def _one(fields: Fields, tag: int, path: _Path, default: float | None = None) -> float:
    value = _numbers(fields, tag, path, None if default is None else (default,))
    if not value:
        raise FileError(path, f"has an empty field {tag}; it is damaged")
    return value[0]

"""PNG reader: 8 or 16 bits, grey or RGB (W3C, Portable Network Graphics, third edition).

Written here because none of the imaging libraries that are always there reads 16-bit RGB.
"""

from __future__ import annotations

import os
import struct
import sys
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.compilation import Array, compiled
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import check_made

SIGNATURE = b"\x89PNG\r\n\x1a\n"
_CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}
MOST_PIXELS = 1 << 28
_PIECE_BYTES = 1 << 20


@compiled
def unfilter(rows: Array, filters: Array, step: int) -> None:
    """Turn filtered ``rows`` (h, bytes) uint8 into plain ones in place; ``step`` is the bytes of a pixel.

    Compiled, since each byte depends on earlier ones, so that numpy cannot vectorise it.
    """
    height, width = rows.shape
    for y in range(height):
        kind = filters[y]
        if kind == 0:
            continue
        for x in range(width):
            left = int(rows[y, x - step]) if x >= step else 0
            above = int(rows[y - 1, x]) if y > 0 else 0
            if kind == 1:
                guess = left
            elif kind == 2:
                guess = above
            elif kind == 3:
                guess = (left + above) >> 1
            else:
                corner = int(rows[y - 1, x - step]) if x >= step and y > 0 else 0
                # Paeth: whichever of the three lies nearest to left + above - corner.
                by_left, by_above = abs(above - corner), abs(left - corner)
                by_corner = abs(left + above - 2 * corner)
                if by_left <= by_above and by_left <= by_corner:
                    guess = left
                elif by_above <= by_corner:
                    guess = above
                else:
                    guess = corner
            rows[y, x] = (int(rows[y, x]) + guess) & 255


class FileContent:
    """The content of an open file, of which only what is asked for is read.

    It is not mapped into memory: the system ends a process that looks at a place of a mapped file that another process
    has cut off. Here such a place is empty.
    """

    def __init__(self, file: IO[bytes]) -> None:
        self._file, self._size = file, os.fstat(file.fileno()).st_size

    def __len__(self) -> int:
        return self._size

    def __getitem__(self, part: slice) -> bytes:
        start, stop, _ = part.indices(self._size)
        self._file.seek(start)
        return self._file.read(max(0, stop - start))


Content = bytes | FileContent


@dataclass(frozen=True)
class PngParts:
    """Parsed chunks of a PNG: ``packed`` locates the pixels, ``exif`` is that block or None."""

    width: int
    height: int
    channels: int
    bits: int
    interlaced: bool
    packed: tuple[slice, ...]
    exif: bytes | None


def png_parts(content: Content, path: PathLike) -> PngParts:
    """Return the parts of a PNG; that it is whole is seen from its chunks, before anything is unpacked.

    Raises
    ------
    FileError
        It is cut off, damaged, too large, or has a palette.
    """
    at, header, exif, ended = len(SIGNATURE), b"", None, False
    packed: list[slice] = []
    while at + 12 <= len(content) and not ended:
        start = content[at : at + 8]
        if len(start) < 8:  # another process has cut the file off
            break
        size, kind = struct.unpack(">I4s", start)
        end = at + 12 + size
        if end > len(content):
            break
        data = slice(at + 8, end - 4)
        if kind == b"IHDR":
            header = content[data]
        elif kind == b"IDAT":
            packed.append(data)
        elif kind == b"eXIf":
            exif = content[data]
        ended = kind == b"IEND"
        at = end
    if not ended:
        reason = f"ends within a chunk, after {len(content):,} bytes; it was not copied whole"
        raise FileError(path, reason, f"byte {at}")
    if len(header) != 13 or not packed:
        raise FileError(path, "has no header or no pixels; it is damaged", "byte 8")
    width, height, bits, colour, _, _, interlace = struct.unpack(">IIBBBBB", header)
    if colour not in _CHANNELS or bits not in (8, 16):
        reason = "has a palette or fewer than 8 bits; a photograph has 8 or 16 bits a channel"
        raise FileError(path, reason, "IHDR")
    if not 0 < width * height <= MOST_PIXELS:
        raise FileError(path, f"is {width} × {height} pixels; up to {MOST_PIXELS:,} are read", "IHDR")
    parts = PngParts(width, height, _CHANNELS[colour], bits, bool(interlace), tuple(packed), exif)
    check_made(path, _made_bytes(parts), "its pixels", "IHDR")
    return parts


def _made_bytes(parts: PngParts) -> int:
    """Return what reading takes: the rows, and beside them three channels where there are more or fewer."""
    item = parts.bits // 8
    copied = 0 if parts.channels == 3 else 3 * item
    return parts.height * (1 + parts.width * (parts.channels * item + copied))


def png_pixels(content: Content, path: PathLike) -> NDArray[Any]:
    """Return the pixels (h, w, channels) of a PNG, uint8 or uint16; errors as :func:`png_parts`."""
    parts = png_parts(content, path)
    if parts.interlaced:
        raise FileError(path, "is interlaced; write it without", "IHDR")
    step = parts.channels * parts.bits // 8
    plain, filters = _unpacked(content, parts, path)
    if filters.max() > 4:
        raise FileError(path, f"uses a filter {filters.max()} that there is not; it is damaged", "IDAT")
    if filters.any():
        unfilter(plain, filters, step)
    shape = (parts.height, parts.width, parts.channels)
    if parts.bits == 8:
        return plain.reshape(shape)
    pixels = plain.view(">u2").reshape(shape)
    # In place: a photograph fills much of the memory once already.
    return pixels.byteswap(inplace=True).view("<u2") if sys.byteorder == "little" else pixels.view("=u2")


def _unpacked(
    content: Content, parts: PngParts, path: PathLike
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return the filtered rows (h, bytes) of a PNG and the filter (h,) of each, unpacked piece by piece."""
    rows = np.empty((parts.height, parts.width * parts.channels * parts.bits // 8), np.uint8)
    filters = np.empty(parts.height, np.uint8)
    unpacker, at, length = zlib.decompressobj(), 0, rows.size + filters.size
    try:
        for piece in _pieces(content, parts.packed):
            while at < length:
                made = unpacker.decompress(piece, min(_PIECE_BYTES, length - at))
                _store(rows, filters, at, np.frombuffer(made, np.uint8))
                at += len(made)
                piece = unpacker.unconsumed_tail
                if len(made) < _PIECE_BYTES:
                    break  # all of the piece is unpacked
    except zlib.error as error:
        raise FileError(path, f"cannot be unpacked ({error}); it is damaged", "IDAT") from error
    if at < length:
        raise FileError(path, "holds fewer pixels than its header says; it is damaged", "IDAT")
    return rows, filters


def _pieces(content: Content, packed: tuple[slice, ...]) -> Iterator[bytes]:
    """Yield packed bytes in pieces of at most a megabyte."""
    for part in packed:
        for first in range(part.start, part.stop, _PIECE_BYTES):
            yield content[first : min(first + _PIECE_BYTES, part.stop)]


def _store(rows: NDArray[np.uint8], filters: NDArray[np.uint8], at: int, values: NDArray[np.uint8]) -> None:
    """Put unpacked ``values``, which follow the first ``at`` of all, into rows and filters."""
    length = rows.shape[1] + 1
    y, x = divmod(at, length)
    if x:  # the rest of a row that was begun
        rest = values[: length - x]
        rows[y, x - 1 : x - 1 + len(rest)] = rest
        values, y = values[len(rest) :], y + 1
    whole = len(values) // length
    block = values[: whole * length].reshape(whole, length)
    filters[y : y + whole], rows[y : y + whole] = block[:, 0], block[:, 1:]
    begun = values[whole * length :]
    if len(begun):
        filters[y + whole], rows[y + whole, : len(begun) - 1] = begun[0], begun[1:]

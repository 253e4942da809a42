"""PNG writer, optionally row by row, with colour space and origin stored in chunks.

Format: W3C, Portable Network Graphics, third edition. Written here and not by an imaging library because none of
those available writes 16-bit RGB, or a picture that is larger than memory.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterable, Mapping
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.spaces import DISPLAY_P3_SPACE, SRGB_SPACE, DisplaySpace
from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.icc import profile_bytes

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_CODE_POINTS = {SRGB_SPACE.title: (1, 13), DISPLAY_P3_SPACE.title: (12, 13)}
"""Primaries and transfer curve by the numbers of ITU-T H.273, for the chunk cICP."""

_COLOUR_TYPES = {1: 0, 3: 2, 4: 6}
_LEVEL = 4
"""Of zlib: a third of the time of its usual level, 6, for a file that is a tenth larger."""
_FILTERED_BYTES = 8 << 20
"""Of rows that are filtered and packed at a time."""


def write_png(
    path: PathLike,
    pixels: NDArray[np.uint8] | NDArray[np.uint16],
    metadata: Mapping[str, str] | None = None,
    space: DisplaySpace | None = None,
) -> None:
    """Write pixels (h, w, 1), (h, w, 3) or (h, w, 4), uint8 or uint16, encoded, top row first, whole or not at all.

    ``metadata`` becomes text (iTXt) entries, such as the paint's name and the settings of the picture; keys are 1
    to 79 Latin-1 characters. ``space`` is what the codes mean, sRGB or Display P3, and its ICC profile goes with the
    picture; without it the picture is tagged as sRGB by that word alone.

    >>> write_png("paint.png", np.zeros((480, 640, 3), np.uint8), {"Paint": "Deep Sea Blue"})

    Raises
    ------
    FileError
        The file cannot be written.
    ValueError
        ``pixels`` or a key has another shape or type.
    """
    array = np.asarray(pixels)
    if array.ndim != 3 or 0 in array.shape:
        raise ValueError(f"pixels must have the shape (h, w, 3) or (h, w, 4), not {array.shape}")
    write_png_strips(path, (array.shape[1], array.shape[0]), [array], metadata, space)


def write_png_strips(
    path: PathLike,
    size: tuple[int, int],
    strips: Iterable[NDArray[Any]],
    metadata: Mapping[str, str] | None = None,
    space: DisplaySpace | None = None,
) -> None:
    """Write a picture of ``size`` (width, height) from strips (rows, w, channels), the top one first.

    No more of it than a strip is held; whatever is raised while the strips are made, :class:`Cancelled` among it,
    leaves the old file. Otherwise as :func:`write_png`.
    """
    with replacing(path) as temporary:
        try:
            with temporary.open("wb") as file:
                _write(file, size, strips, metadata or {}, space)
        except OSError as error:
            raise FileError(path, f"cannot be written ({error.strerror or error})") from error


def _write(
    file: BinaryIO,
    size: tuple[int, int],
    strips: Iterable[NDArray[Any]],
    metadata: Mapping[str, str],
    space: DisplaySpace | None,
) -> None:
    packer = zlib.compressobj(_LEVEL)
    kind: tuple[np.dtype[Any], int] | None = None
    done, above = 0, np.zeros(0, np.uint8)
    for strip in strips:
        if strip.ndim != 3 or strip.shape[2] not in _COLOUR_TYPES or strip.shape[1] != size[0]:
            raise ValueError(
                f"pixels must have the shape (h, {size[0]}, 3) or (h, {size[0]}, 4), not {strip.shape}"
            )
        if strip.dtype not in (np.dtype(np.uint8), np.dtype(np.uint16)):
            raise ValueError(f"pixels must be uint8 or uint16, not {strip.dtype}")
        if kind is None:
            kind = (strip.dtype, strip.shape[2])
            file.write(_SIGNATURE + _header(size, strip.dtype, strip.shape[2], metadata, space))
        if kind != (strip.dtype, strip.shape[2]):
            raise ValueError("pixels must be of one type and number of channels in all strips")
        for packed, last in _packed(packer, strip, above):
            above = last
            if packed:
                file.write(_chunk(b"IDAT", packed))
        done += len(strip)
    if done != size[1]:
        raise ValueError(f"pixels must have {size[1]} rows, not {done}")
    file.write(_chunk(b"IDAT", packer.flush()) + _chunk(b"IEND", b""))


def _packed(
    packer: Any, strip: NDArray[Any], above: NDArray[np.uint8]
) -> Iterable[tuple[bytes, NDArray[np.uint8]]]:
    """Pack rows, each byte as the difference to the pixel above (filter type 2): smooth pictures halve."""
    width = strip.shape[1] * strip.shape[2] * strip.dtype.itemsize
    step = max(1, _FILTERED_BYTES // width)
    for first in range(0, len(strip), step):
        part = strip[first : first + step]
        rows = (
            np.ascontiguousarray(part.astype(part.dtype.newbyteorder(">")))
            .view(np.uint8)
            .reshape(len(part), width)
        )
        filtered = np.empty((len(rows), width + 1), dtype=np.uint8)
        filtered[:, 0] = 2
        filtered[0, 1:] = rows[0] - above if len(above) else rows[0]
        np.subtract(rows[1:], rows[:-1], out=filtered[1:, 1:])
        above = rows[-1].copy()
        yield packer.compress(filtered.tobytes()), above


def _header(
    size: tuple[int, int],
    dtype: np.dtype[Any],
    channels: int,
    metadata: Mapping[str, str],
    space: DisplaySpace | None,
) -> bytes:
    bits = 8 * dtype.itemsize
    chunks = [_chunk(b"IHDR", struct.pack(">IIBBBBB", *size, bits, _COLOUR_TYPES[channels], 0, 0, 0))]
    if space is None:
        chunks.append(_chunk(b"sRGB", b"\0"))
    else:
        # Readers of the third edition go by the numbers, all others by the profile.
        chunks.append(_chunk(b"cICP", bytes((*_CODE_POINTS[space.title], 0, 1))))
        profile = zlib.compress(profile_bytes(space), 9)
        chunks.append(_chunk(b"iCCP", space.title.encode("latin-1") + b"\0\0" + profile))
    chunks += [_chunk(b"iTXt", _text(key, value)) for key, value in metadata.items()]
    return b"".join(chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _text(key: str, value: str) -> bytes:
    name = key.encode("latin-1", errors="strict")
    if not 1 <= len(name) <= 79 or b"\0" in name:
        raise ValueError(f"the key {key!r} must have 1 to 79 characters")
    # Keyword, NUL, not compressed, NUL language, NUL translated keyword, UTF-8 text.
    return name + b"\0\0\0\0\0" + value.replace("\0", "").encode()

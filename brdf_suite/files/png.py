"""Write PNG pictures with their making told in text chunks."""

from __future__ import annotations

import os
import struct
import zlib
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def write_png(
    path: str | os.PathLike[str],
    pixels: NDArray[np.uint8] | NDArray[np.uint16],
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write pixels (h, w, 3) or (h, w, 4), uint8 or uint16, sRGB-encoded, top row first.

    The file is tagged as sRGB and is written whole or not at all. ``metadata`` becomes text (iTXt) entries,
    such as the paint's name and the settings of the picture; keys are 1 to 79 Latin-1 characters.

    Format: W3C, Portable Network Graphics, third edition. Written here and not by an imaging library because
    none of those at hand writes 16-bit RGB.

    >>> write_png("paint.png", np.zeros((480, 640, 3), np.uint8), {"Paint": "Deep Sea Blue"})

    Raises
    ------
    FileError
        The file cannot be written.
    ValueError
        ``pixels`` or a key has another shape or type.
    """
    array = np.asarray(pixels)
    if array.ndim != 3 or array.shape[2] not in (3, 4) or 0 in array.shape:
        raise ValueError(f"pixels must have the shape (h, w, 3) or (h, w, 4), not {array.shape}")
    if array.dtype not in (np.dtype(np.uint8), np.dtype(np.uint16)):
        raise ValueError(f"pixels must be uint8 or uint16, not {array.dtype}")
    height, width, channels = array.shape
    depth = 8 * array.dtype.itemsize
    rows = (
        np.ascontiguousarray(array.astype(array.dtype.newbyteorder(">"))).view(np.uint8).reshape(height, -1)
    )
    # Each byte as the difference to the pixel above (filter type 2): smooth pictures pack to about a half.
    filtered = np.empty((height, rows.shape[1] + 1), dtype=np.uint8)
    filtered[:, 0] = 2
    filtered[0, 1:] = rows[0]
    np.subtract(rows[1:], rows[:-1], out=filtered[1:, 1:])
    header = struct.pack(">IIBBBBB", width, height, depth, 2 if channels == 3 else 6, 0, 0, 0)
    chunks = [_chunk(b"IHDR", header), _chunk(b"sRGB", b"\0")]
    chunks += [_chunk(b"iTXt", _text(key, value)) for key, value in (metadata or {}).items()]
    chunks += [_chunk(b"IDAT", zlib.compress(filtered.tobytes(), 6)), _chunk(b"IEND", b"")]
    with replacing(path) as temporary:
        try:
            temporary.write_bytes(_SIGNATURE + b"".join(chunks))
        except OSError as error:
            raise FileError(path, f"cannot be written ({error.strerror})") from error


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _text(key: str, value: str) -> bytes:
    name = key.encode("latin-1", errors="strict")
    if not 1 <= len(name) <= 79 or b"\0" in name:
        raise ValueError(f"the key {key!r} must have 1 to 79 characters")
    # Keyword, NUL, not compressed, NUL language, NUL translated keyword, UTF-8 text.
    return name + b"\0\0\0\0\0" + value.replace("\0", "").encode()

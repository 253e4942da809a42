"""Writing OpenEXR files by the library, and checking that they are whole.

The library buffers what it writes last, up to some kilobytes and the table of offsets, and does not report where a full
disk refuses them: a small file ends up cut off without an error.
"""

from __future__ import annotations

import os
import struct
from io import BufferedReader
from typing import Any

from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import open_regular

_MULTIPART = 0x1000
_LINES = (1, 1, 1, 16, 32, 16, 32, 32, 32, 256)
"""Rows of a chunk by the number of its compression."""


def write_by_library(file: Any, path: PathLike, named: PathLike) -> None:
    """Write ``file``, an ``OpenEXR.File`` of scanlines, to ``path``; messages call it ``named``.

    Raises :class:`FileError`: the library refuses it, or the disk is full.
    """
    try:
        file.write(os.fspath(path))
        whole = _is_whole(path)
    except (RuntimeError, ValueError, OSError, struct.error) as error:
        raise FileError(named, f"cannot be written ({error})") from error
    if not whole:
        raise FileError(named, "cannot be written whole; the disk is full, or refuses it")


def _is_whole(path: PathLike) -> bool:
    """Return whether the last chunk that the table of offsets names ends with the file."""
    with open_regular(path) as stream:
        size = os.fstat(stream.fileno()).st_size
        start = stream.read(8)
        if len(start) < 8:
            return False
        is_multipart = bool(struct.unpack_from("<I", start, 4)[0] & _MULTIPART)
        chunks = _chunk_count(stream)
        while is_multipart and chunks is not None and stream.peek(1)[:1] != b"\0":
            more = _chunk_count(stream)
            chunks = None if more is None else chunks + more
        if chunks is None:
            return False
        stream.read(1 if is_multipart else 0)
        table = stream.read(8 * chunks)
        if len(table) < 8 * chunks:
            return False
        offsets = struct.unpack(f"<{chunks}Q", table)
        stream.seek(max(offsets))
        head = stream.read(12 if is_multipart else 8)
        if min(offsets) == 0 or len(head) < (12 if is_multipart else 8):
            return False
        return bool(stream.tell() + struct.unpack("<I", head[-4:])[0] == size)


def _chunk_count(stream: BufferedReader) -> int | None:
    """Read the attributes of a part; return how many chunks it has, None where the file ends before."""
    rows, lines = 0, 1
    while name := _word(stream):
        _word(stream)
        length = stream.read(4)
        if len(length) < 4:
            return None
        value = stream.read(struct.unpack("<I", length)[0])
        if name == b"dataWindow" and len(value) == 16:
            rows = struct.unpack_from("<i", value, 12)[0] - struct.unpack_from("<i", value, 4)[0] + 1
        elif name == b"compression" and len(value) == 1:
            lines = _LINES[value[0]]
    return -(-rows // lines) if rows > 0 else None


def _word(stream: BufferedReader) -> bytes:
    word = bytearray()
    while (letter := stream.read(1)) not in (b"", b"\0"):
        word += letter
    return bytes(word)

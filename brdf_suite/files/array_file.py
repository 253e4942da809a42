"""Files of named arrays with a JSON header and a checksum: our tables, and what the programs keep on disk.

All numbers are little-endian::

    0   8   magic, the kind of file
    8   4   u32, length of the header in bytes
    12  4   u32, version of the kind
    16  32  SHA-256
    48  …   header: a JSON object, UTF-8, padded with spaces to a multiple of 64 from the start
    …   …   arrays, C order, each padded with zero bytes to a multiple of 64

The header's ``"arrays"`` lists ``{"name", "dtype", "shape"}`` in the order of the arrays. The SHA-256 is that of all
bytes from 48 on in a table; in the other kinds that of the first 16 bytes and the header, whose ``"crc32"`` lists a
CRC-32 for each MiB of each array: twice to five times as fast, taken while the next MiB is read, and no change of up to
32 neighbouring bits escapes it. Deflated arrays (zlib) have their length in the file as ``"bytes"``.

Nothing in a file is ever executed or unpickled, and no size is believed that the file does not have.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import struct
import zlib
from collections.abc import Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from io import BufferedReader, FileIO
from typing import Any, NoReturn

import numpy as np

from brdf_suite.arrays import AnyArray, Bytes
from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import open_regular, within_memory

_SIZES = struct.Struct("<8sII")
_START = _SIZES.size + 32
_ALIGN = 64
_BLOCK = 1 << 20
_LARGEST = 1 << 30
_LARGEST_HEADER = 1 << 24
_MOST_AXES = 8
_THREADS = min(os.cpu_count() or 1, 8)


@dataclass(frozen=True)
class Layout:
    """A kind of file.

    ``name`` is what messages call it; ``dtypes`` are those of its arrays, ``smallest`` their shortest axis, and
    ``most`` their number at most. ``whole``: the SHA-256 covers the arrays too, not the first 16 bytes. ``level`` is
    that of zlib; 0: arrays stand as they are.
    """

    magic: bytes
    version: int
    name: str
    dtypes: tuple[str, ...]
    whole: bool = False
    level: int = 0
    smallest: int = 1
    most: int = 64


@dataclass(frozen=True)
class _Entry:
    """An array of a file; ``stored`` is its length there in bytes, without the padding."""

    name: str
    dtype: str
    shape: tuple[int, ...]
    stored: int


def encode_arrays(
    layout: Layout, path: PathLike, header: Mapping[str, Any], arrays: Mapping[str, AnyArray]
) -> list[bytes | memoryview]:
    """Return the parts of a file, to be written one after the other; ``path`` is for messages.

    ``header`` holds what JSON can hold, without ``"arrays"`` and ``"crc32"``.

    Raises
    ------
    FileError
        The header holds what JSON cannot, or is too long.
    ValueError
        An array has none of the layout's types.
    """
    if any(array.dtype.str not in layout.dtypes for array in arrays.values()):
        kinds = [array.dtype.str for array in arrays.values()]
        raise ValueError(f"arrays of {', '.join(layout.dtypes)} are held, not {kinds}")
    listed: list[dict[str, Any]] = []
    sums: list[int] = []
    parts: list[bytes | memoryview] = []
    for name, array in arrays.items():
        data: bytes | memoryview = np.ascontiguousarray(array).reshape(-1).view(np.uint8).data
        listed.append({"name": name, "dtype": array.dtype.str, "shape": list(array.shape)})
        if layout.level:
            data = zlib.compress(data, layout.level)
            listed[-1]["bytes"] = len(data)
        padding = bytes(-len(data) % _ALIGN)
        parts += [data, padding]
        if not layout.whole:
            sums += [zlib.crc32(block) for block in _blocks(data)]
            if padding:
                sums[-1] = zlib.crc32(padding, sums[-1])
    fields = {**header, "arrays": listed} | ({} if layout.whole else {"crc32": sums})
    try:
        text = json.dumps(fields, ensure_ascii=False, allow_nan=False).encode()
    except (TypeError, ValueError, RecursionError) as error:
        raise FileError(path, f"cannot be written: its facts are not plain values ({error})") from error
    text += b" " * (-(_START + len(text)) % _ALIGN)
    if len(text) > _LARGEST_HEADER:
        reason = f"cannot be written: its facts take {len(text):,} bytes, over {_LARGEST_HEADER:,}"
        raise FileError(path, reason)
    sizes = _SIZES.pack(layout.magic, len(text), layout.version)
    checksum = hashlib.sha256()
    for part in (text, *parts) if layout.whole else (sizes, text):
        checksum.update(part)
    return [sizes, checksum.digest(), text, *parts]


def write_arrays(
    layout: Layout, path: PathLike, header: Mapping[str, Any], arrays: Mapping[str, AnyArray]
) -> None:
    """Write a file, whole or not at all.

    Raises :class:`FileError`: as :func:`encode_arrays`, or the file cannot be written.
    """
    parts = encode_arrays(layout, path, header, arrays)
    with replacing(path) as temporary, temporary.open("wb") as stream:
        stream.writelines(parts)


def read_arrays(layout: Layout, path: PathLike) -> tuple[dict[str, Any], dict[str, AnyArray]]:
    """Return the header without ``"arrays"`` and ``"crc32"``, and the arrays, which are read-only.

    Raises
    ------
    FileError
        The file is missing, of another kind or version, truncated, changed, or its header is not as described above, or
        memory does not suffice for the arrays.
    """
    return _read_whole(path, layout)


@within_memory
def _read_whole(path: PathLike, layout: Layout) -> tuple[dict[str, Any], dict[str, AnyArray]]:
    with open_regular(path, _LARGEST) as stream:
        size = os.fstat(stream.fileno()).st_size
        found = read_next(layout, path, stream, size)
        if (end := stream.tell()) != size:
            raise FileError(path, f"has {size - end:,} bytes that belong to no array", f"byte {end}")
        return found


def read_header(layout: Layout, path: PathLike) -> dict[str, Any]:
    """Return the header alone, for listings; the arrays are not looked at. Errors as :func:`read_arrays`."""
    with open_regular(path, _LARGEST) as stream:
        return _checked_header(layout, path, stream, os.fstat(stream.fileno()).st_size)[0]


def read_next(
    layout: Layout, path: PathLike, stream: BufferedReader | FileIO, end: int
) -> tuple[dict[str, Any], dict[str, AnyArray]]:
    """Read as :func:`read_arrays` from a stream, which may go on behind; nothing beyond the byte ``end`` is read.

    Raises
    ------
    FileError
        As :func:`read_arrays`.
    OSError
        The stream cannot be read.
    """
    header, rest = _checked_header(layout, path, stream, end)
    entries = _listed(layout, path, header.pop("arrays", None))
    sums = header.pop("crc32", None)
    at = stream.tell() - len(rest)
    taken: list[Bytes] = []
    found: list[Future[int]] = []
    for entry in entries:
        length = entry.stored + -entry.stored % _ALIGN
        if entry.stored > end - at or length > end - at:
            raise FileError(path, f"has an array {entry.name[:40]!r} that does not fit into it", f"byte {at}")
        at += length
    with ThreadPoolExecutor(_THREADS) as pool:
        used = 0
        for entry in entries:
            length = entry.stored + -entry.stored % _ALIGN
            if layout.whole:
                taken.append(np.frombuffer(rest, np.uint8, length, used))
                used += length
                continue
            taken.append(np.empty(length, np.uint8))
            for block in _blocks(taken[-1].data):
                if stream.readinto(block) != len(block):
                    raise FileError(path, "is cut off", f"byte {stream.tell()}")
                found.append(pool.submit(zlib.crc32, block))
        if layout.whole:
            stream.seek(used - len(rest), os.SEEK_CUR)
        elif [one.result() for one in found] != sums:
            raise FileError(path, "is damaged: a checksum of its arrays does not fit", f"byte {_START}")
        # The largest first: one of them may be half of the work.
        order = sorted(range(len(entries)), key=lambda index: -entries[index].stored)
        made = {index: pool.submit(_array, layout, path, entries[index], taken[index]) for index in order}
        return header, {entry.name: made[index].result() for index, entry in enumerate(entries)}


def _checked_header(
    layout: Layout, path: PathLike, stream: BufferedReader | FileIO, end: int
) -> tuple[dict[str, Any], bytes]:
    """Return the header, whose checksum fits, and of a whole layout all that follows it."""
    at = stream.tell()
    start = stream.read(_START)
    if start[: len(layout.magic)] != layout.magic:
        word = layout.magic.decode("ascii")
        raise FileError(path, f"is no {layout.name} (it does not begin with {word})", f"byte {at}")
    if len(start) < _START:
        raise FileError(path, "is cut off within its first bytes", f"byte {at + len(start)}")
    _, length, version = _SIZES.unpack_from(start)
    if version != layout.version:
        raise FileError(
            path, f"is of version {version}; this program reads {layout.version}", f"byte {at + 12}"
        )
    begin = at + _START + length
    if length > _LARGEST_HEADER or (_START + length) % _ALIGN or begin > end:
        reason = f"is damaged or cut off: a header of {length:,} bytes is named"
        raise FileError(path, reason, f"byte {at + 8}")
    text = stream.read(length)
    rest = stream.read(end - begin) if layout.whole else b""
    checksum = hashlib.sha256(text if layout.whole else start[: _SIZES.size] + text)
    checksum.update(rest)
    if checksum.digest() != start[_SIZES.size :]:
        raise FileError(path, "is damaged: its checksum does not fit its content", f"byte {at + 16}")
    return _parsed(path, text), rest


def _blocks(data: bytes | memoryview) -> Iterator[memoryview]:
    """Return the parts of an array that have a checksum of their own; an empty array has one."""
    view = memoryview(data)
    return (view[at : at + _BLOCK] for at in range(0, max(len(view), 1), _BLOCK))


def _array(layout: Layout, path: PathLike, entry: _Entry, data: Bytes) -> AnyArray:
    content: bytes | memoryview = data[: entry.stored].data
    size = math.prod(entry.shape) * np.dtype(entry.dtype).itemsize
    if layout.level:
        try:
            content = zlib.decompressobj().decompress(content, size + 1)
        except zlib.error as error:
            raise FileError(path, f"cannot be unpacked ({error})", f"array {entry.name}") from error
        if len(content) != size:
            raise FileError(path, "unpacks to another size than its header says", f"array {entry.name}")
    array = np.frombuffer(content, entry.dtype).reshape(entry.shape)
    array.flags.writeable = False
    return array


def _parsed(path: PathLike, text: bytes) -> dict[str, Any]:
    def refuse(name: str) -> NoReturn:
        raise ValueError(f"{name} is no number of JSON")

    try:
        header = json.loads(text.decode("utf-8"), parse_constant=refuse)
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"has a header that is not JSON ({error})", f"byte {_START}") from error
    if not isinstance(header, dict):
        raise FileError(path, "has a header that is no JSON object", f"byte {_START}")
    return header


def _listed(layout: Layout, path: PathLike, entries: object) -> list[_Entry]:
    """Return what the header lists."""
    if not isinstance(entries, list) or len(entries) > layout.most:
        raise FileError(path, f"lists no arrays, or more than {layout.most}", "header, arrays")
    fields = {"name", "dtype", "shape", *(["bytes"] if layout.level else [])}
    found: list[_Entry] = []
    for number, entry in enumerate(entries):
        place = f"header, arrays[{number}]"
        if not isinstance(entry, dict) or set(entry) != fields:
            raise FileError(path, f"expected an object of {', '.join(sorted(fields))}", place)
        name, dtype, shape = entry["name"], entry["dtype"], entry["shape"]
        if not isinstance(name, str) or dtype not in layout.dtypes:
            raise FileError(path, f"expected a name and one of {', '.join(layout.dtypes)}", place)
        if any(name == other.name for other in found):
            raise FileError(path, f"lists {name[:40]!r} twice, which does not fit", place)
        if not isinstance(shape, list) or len(shape) > _MOST_AXES:
            raise FileError(path, f"expected a shape of at most {_MOST_AXES} numbers", place)
        # bool is an int to Python, and True no size.
        if not all(type(n) is int and layout.smallest <= n <= _LARGEST for n in shape):
            raise FileError(path, "expected a shape of positive whole numbers", place)
        size = math.prod(shape) * np.dtype(dtype).itemsize
        stored = entry.get("bytes", size)
        if type(stored) is not int or stored < 0 or (layout.level and size > _LARGEST):
            raise FileError(path, f"expected at most {_LARGEST:,} bytes of an array", place)
        found.append(_Entry(name, dtype, tuple(shape), stored))
    return found

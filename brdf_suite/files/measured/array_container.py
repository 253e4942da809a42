"""Container of named arrays and a JSON header with a checksum; the basis of ``.brdftable``.

All numbers are little-endian::

    0   8   BRDFTABL
    8   4   u32, length of the header in bytes
    12  4   u32, zero
    16  32  SHA-256 of everything from byte 48 on
    48  …   header: a JSON object, UTF-8, padded with spaces to a multiple of 64 from the start of the file
    …   …   arrays, C order, each padded with zero bytes to a multiple of 64

The header's ``"arrays"`` lists ``{"name", "dtype", "shape"}`` in the order of the arrays; dtypes are ``<f4``, ``<f8``
and ``|u1``. Nothing in a file is ever executed or unpickled, and no size is believed that the file does not have.
"""

from __future__ import annotations

import hashlib
import json
import math
import struct
from collections.abc import Mapping
from typing import Any, NoReturn

import numpy as np

from brdf_suite.arrays import AnyArray
from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.measured.bounded_reading import read_bytes

MAGIC = b"BRDFTABL"
DTYPES = ("<f4", "<f8", "|u1")

_START = struct.Struct("<8sII32s")
_ALIGN = 64
_LARGEST = 1 << 30
_LARGEST_HEADER = 1 << 20
_MOST_ARRAYS, _MOST_AXES = 64, 8


def write_container(path: PathLike, header: Mapping[str, Any], arrays: Mapping[str, AnyArray]) -> None:
    """Write ``header`` (what JSON can hold, without ``"arrays"``) and ``arrays``, whole or not at all.

    Raises
    ------
    FileError
        The header holds what JSON cannot, or the file cannot be written.
    """
    listed = [{"name": name, "dtype": a.dtype.str, "shape": list(a.shape)} for name, a in arrays.items()]
    if any(entry["dtype"] not in DTYPES for entry in listed):
        raise ValueError(f"arrays of {', '.join(DTYPES)} are held, not {[e['dtype'] for e in listed]}")
    try:
        text = json.dumps({**header, "arrays": listed}, ensure_ascii=False, allow_nan=False).encode()
    except (TypeError, ValueError, RecursionError) as error:
        raise FileError(path, f"cannot be written: its facts are not plain values ({error})") from error
    text += b" " * (-(_START.size + len(text)) % _ALIGN)
    if len(text) > _LARGEST_HEADER:
        raise FileError(
            path, f"cannot be written: its facts take {len(text):,} bytes, over {_LARGEST_HEADER:,}"
        )
    parts: list[bytes | memoryview] = [text]
    for array in arrays.values():
        parts += [np.ascontiguousarray(array).reshape(-1).view(np.uint8).data, bytes(-array.nbytes % _ALIGN)]
    checksum = hashlib.sha256()
    for part in parts:
        checksum.update(part)
    with replacing(path) as temporary, temporary.open("wb") as stream:
        stream.write(_START.pack(MAGIC, len(text), 0, checksum.digest()))
        for part in parts:
            stream.write(part)


def read_container(path: PathLike) -> tuple[dict[str, Any], dict[str, AnyArray]]:
    """Return the header without ``"arrays"``, and the arrays as read-only views of one block.

    Raises
    ------
    FileError
        The file is missing, of another kind, truncated, changed, or its header is not as described above.
    """
    data = read_bytes(path, _LARGEST)
    if data[: len(MAGIC)] != MAGIC:
        raise FileError(path, "is no .brdftable file (it does not begin with BRDFTABL)", "byte 0")
    if len(data) < _START.size:
        raise FileError(path, "is cut off within its first bytes", f"byte {len(data)}")
    _, length, zero, checksum = _START.unpack_from(data)
    start = _START.size + length
    if zero or length > _LARGEST_HEADER or start % _ALIGN or start > len(data):
        raise FileError(path, f"is damaged or cut off: a header of {length:,} bytes is named", "byte 8")
    body = memoryview(data)[_START.size :]
    if hashlib.sha256(body).digest() != checksum:
        raise FileError(path, "is damaged: its checksum does not fit its content", "byte 16")
    header = _header(path, bytes(body[:length]))
    arrays: dict[str, AnyArray] = {}
    at = start
    for name, dtype, shape in _listed(path, header.pop("arrays", None)):
        count = math.prod(shape)
        size = count * np.dtype(dtype).itemsize
        if size > len(data) - at or name in arrays:
            raise FileError(path, f"has an array {name[:40]!r} that does not fit into it", f"byte {at}")
        arrays[name] = np.frombuffer(data, dtype, count, at).reshape(shape)
        at += size + -size % _ALIGN
    if at != len(data):
        raise FileError(path, f"has {len(data) - at:,} bytes that belong to no array", f"byte {at}")
    return header, arrays


def _header(path: PathLike, text: bytes) -> dict[str, Any]:
    def refuse(name: str) -> NoReturn:
        raise ValueError(f"{name} is no number of JSON")

    try:
        header = json.loads(text.decode("utf-8"), parse_constant=refuse)
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"has a header that is not JSON ({error})", f"byte {_START.size}") from error
    if not isinstance(header, dict):
        raise FileError(path, "has a header that is no JSON object", f"byte {_START.size}")
    return header


def _listed(path: PathLike, entries: object) -> list[tuple[str, str, tuple[int, ...]]]:
    """Return name, dtype and shape of each array that the header lists."""
    if not isinstance(entries, list) or len(entries) > _MOST_ARRAYS:
        raise FileError(path, f"lists no arrays, or more than {_MOST_ARRAYS}", "header, arrays")
    found = []
    for number, entry in enumerate(entries):
        place = f"header, arrays[{number}]"
        if not isinstance(entry, dict) or set(entry) != {"name", "dtype", "shape"}:
            raise FileError(path, "expected an object of name, dtype and shape", place)
        name, dtype, shape = entry["name"], entry["dtype"], entry["shape"]
        if not isinstance(name, str) or dtype not in DTYPES:
            raise FileError(path, f"expected a name and one of {', '.join(DTYPES)}", place)
        if not isinstance(shape, list) or len(shape) > _MOST_AXES:
            raise FileError(path, f"expected a shape of at most {_MOST_AXES} numbers", place)
        # bool is an int to Python, and True no size.
        if not all(type(n) is int and 0 < n <= _LARGEST for n in shape):
            raise FileError(path, "expected a shape of positive whole numbers", place)
        found.append((name, dtype, tuple(shape)))
    return found

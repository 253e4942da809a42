"""The container of RGL's ``.bsdf`` files: named arrays, little-endian, each at its offset.

``tensor_file\\0``, two bytes of version (1, 0), u32 number of fields; for each field u16 length of the name, the
name, u16 number of dimensions, u8 type, u64 offset, u64 per dimension. The arrays are in C order.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from brdf_suite.errors import FileError, PathLike

MAGIC = b"tensor_file\0"
_VERSION = (1, 0)

_TYPES = {
    1: "<u1",
    2: "<i1",
    3: "<u2",
    4: "<i2",
    5: "<u4",
    6: "<i4",
    7: "<u8",
    8: "<i8",
    9: "<f2",
    10: "<f4",
    11: "<f8",
}
_CODES = {np.dtype(kind): code for code, kind in _TYPES.items()}

_MOST_FIELDS = 256
_MOST_DIMENSIONS = 16
_ALIGNMENT = 8

Arrays = dict[str, npt.NDArray[np.generic]]


def unpack(content: bytes, path: PathLike) -> Arrays:
    """Return the arrays of a tensor file, as read-only views into ``content``.

    Raises
    ------
    FileError
        The header is damaged, or an array lies outside the file; with the byte offset.
    """
    place = 0

    def take(layout: str, what: str) -> tuple[int, ...]:
        nonlocal place
        size = struct.calcsize(layout)
        if place + size > len(content):
            raise FileError(path, f"the file ends within {what}", f"byte {place}")
        found: tuple[int, ...] = struct.unpack_from(layout, content, place)
        place += size
        return found

    if not content.startswith(MAGIC):
        raise FileError(path, 'does not begin with "tensor_file"', "byte 0")
    place = len(MAGIC)
    version = take("<BB", "the version")
    if version[0] != _VERSION[0]:
        raise FileError(
            path, f"has version {version[0]}.{version[1]}; only 1.x is known", f"byte {len(MAGIC)}"
        )
    (count,) = take("<I", "the number of fields")
    if count > _MOST_FIELDS:
        raise FileError(
            path, f"names {count} fields, more than the {_MOST_FIELDS} allowed", f"byte {place - 4}"
        )
    arrays: Arrays = {}
    for _ in range(count):
        start = place
        (length,) = take("<H", "the name of a field")
        if place + length > len(content):
            raise FileError(path, "the file ends within the name of a field", f"byte {place}")
        name = content[place : place + length].decode("ascii", "replace")
        place += length
        shown = repr(name[:40])
        dimensions, kind, offset = take("<HBQ", f"the field {shown}")
        if kind not in _TYPES:
            raise FileError(path, f"the field {shown} has the unknown type {kind}", f"byte {start}")
        if dimensions > _MOST_DIMENSIONS:
            raise FileError(path, f"the field {shown} has {dimensions} dimensions", f"byte {start}")
        shape = take(f"<{dimensions}Q", f"the field {shown}")
        dtype = np.dtype(_TYPES[kind])
        size = dtype.itemsize
        for extent in shape:  # Python's integers: no overflow can make this small again
            size *= extent
        if 0 in shape or offset + size > len(content):
            reason = f"the field {shown} of shape {shape} does not fit into the file"
            raise FileError(path, reason, f"byte {start}")
        if name in arrays:
            raise FileError(path, f"the field {shown} is given twice", f"byte {start}")
        flat = np.frombuffer(content, dtype, size // dtype.itemsize, offset)
        arrays[name] = flat.reshape(shape)
    return arrays


def pack(arrays: Mapping[str, npt.NDArray[np.generic]]) -> bytes:
    """Return the content of a tensor file with ``arrays``, each beginning at a multiple of 8 bytes."""
    held = {name: np.ascontiguousarray(array) for name, array in arrays.items()}
    place = len(MAGIC) + 2 + 4
    place += sum(2 + len(name) + 2 + 1 + 8 + 8 * array.ndim for name, array in held.items())
    header = [MAGIC, struct.pack("<BBI", *_VERSION, len(held))]
    body: list[bytes] = []
    for name, array in held.items():
        gap = -place % _ALIGNMENT
        little = array.astype(array.dtype.newbyteorder("<"), copy=False)
        offset = place + gap
        header.append(struct.pack("<H", len(name)) + name.encode("ascii"))
        header.append(struct.pack("<HBQ", array.ndim, _CODES[little.dtype], offset))
        header.append(struct.pack(f"<{array.ndim}Q", *array.shape))
        body += [b"\0" * gap, little.tobytes()]
        place = offset + array.nbytes
    return b"".join(header + body)

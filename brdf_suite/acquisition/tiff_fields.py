"""The folders of fields in a TIFF, which EXIF blocks are too (TIFF 6.0, 1992; CIPA DC-008).

Offsets come from the file and are never trusted: what points outside of it is damage, told with its place.
"""

from __future__ import annotations

import math
import mmap
import os
import struct

from brdf_suite.errors import FileError

Value = tuple[float, ...] | bytes
Fields = dict[int, Value]
Content = bytes | mmap.mmap
"""Of a file: as bytes, or mapped, so that only what is asked for is read."""

EXPOSURE_TIME, EXIF_FOLDER, SHUTTER_SPEED = 0x829A, 0x8769, 0x9201

_MOST_FIELDS = 4096
_MOST_VALUES = 1 << 20
_SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8}
_CODES = {1: "B", 3: "H", 4: "I", 6: "b", 8: "h", 9: "i", 11: "f", 12: "d"}


def first_folder(content: Content, path: str | os.PathLike[str]) -> tuple[Fields, str]:
    """Return the fields of the first picture in a TIFF, and the order of its bytes as ``struct`` writes it.

    Raises
    ------
    FileError
        It is no TIFF, a BigTIFF, or damaged.
    """
    order = {b"II": "<", b"MM": ">"}.get(content[:2])
    if order is None or len(content) < 8:
        raise FileError(path, "is no TIFF", "byte 0")
    version, offset = struct.unpack(order + "HI", content[2:8])
    if version == 43:
        raise FileError(path, "is a BigTIFF; write it as a TIFF of less than 4 GB", "byte 2")
    if version != 42:
        raise FileError(path, "is no TIFF", "byte 2")
    return folder_at(content, offset, order, path), order


def folder_at(content: Content, offset: int, order: str, path: str | os.PathLike[str]) -> Fields:
    """Return the fields of the folder at an offset: numbers as a tuple, texts and unknown kinds as bytes."""
    if offset < 8 or offset + 2 > len(content):
        raise _cut(path, offset)
    (count,) = struct.unpack_from(order + "H", content, offset)
    if count > _MOST_FIELDS:
        raise FileError(path, f"has a folder of {count:,} fields; it is damaged", f"byte {offset}")
    if offset + 2 + 12 * count > len(content):
        raise _cut(path, offset)
    fields: Fields = {}
    for i in range(count):
        at = offset + 2 + 12 * i
        tag, kind, number = struct.unpack_from(order + "HHI", content, at)
        size = _SIZES.get(kind, 0) * number
        if kind not in _SIZES or number > _MOST_VALUES:
            continue
        place = at + 8 if size <= 4 else struct.unpack_from(order + "I", content, at + 8)[0]
        if place + size > len(content):
            raise _cut(path, place)
        fields[tag] = _values(content[place : place + size], kind, number, order)
    return fields


def exposure_of(content: Content, path: str | os.PathLike[str]) -> float | None:
    """Return the exposure time in seconds that an EXIF block or a TIFF names, or None where it names none."""
    fields, order = first_folder(content, path)
    where = fields.get(EXIF_FOLDER)
    if isinstance(where, tuple) and where:
        fields = {**fields, **folder_at(content, int(where[0]), order, path)}
    for tag in (EXPOSURE_TIME, SHUTTER_SPEED):
        value = fields.get(tag)
        if isinstance(value, tuple) and value and math.isfinite(value[0]):
            # The shutter's speed is the logarithm to base 2 of 1 over the time.
            seconds = value[0] if tag == EXPOSURE_TIME else 2.0 ** -min(max(value[0], -40.0), 40.0)
            if seconds > 0.0:
                return seconds
    return None


def _values(raw: bytes, kind: int, number: int, order: str) -> Value:
    if kind in (5, 10):
        parts = struct.unpack(f"{order}{2 * number}{'I' if kind == 5 else 'i'}", raw)
        return tuple(
            top / bottom if bottom else math.inf for top, bottom in zip(parts[::2], parts[1::2], strict=True)
        )
    if kind in _CODES:
        return struct.unpack(f"{order}{number}{_CODES[kind]}", raw)
    return raw


def _cut(path: str | os.PathLike[str], place: int) -> FileError:
    return FileError(path, "ends before its fields do; it was not copied whole", f"byte {place}")

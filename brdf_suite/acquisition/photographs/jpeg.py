"""JPEG reader: size and EXIF from the segments (ITU-T T.81, annex B), pixels by Pillow."""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import most_made_bytes
from brdf_suite.files.images.pictures import read_rgb

_EXIF = b"Exif\0\0"
_SCAN, _APP1 = 0xDA, 0xE1
_FRAMES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}


@dataclass(frozen=True)
class JpegParts:
    """Size of the picture, and its EXIF block, ``exif_at`` where it begins; b"" and 0 where there is none."""

    width: int
    height: int
    exif: bytes
    exif_at: int


def jpeg_parts(content: bytes, path: PathLike) -> JpegParts:
    """Return the parts of a JPEG picture.

    Raises
    ------
    FileError
        It is cut off or damaged.
    """
    # A thumbnail within has an end too, but near the file's beginning.
    if b"\xff\xd9" not in content[-65_536:]:
        raise FileError(path, "has no end of picture; it was not copied whole", f"byte {len(content)}")
    at, size, exif, exif_at = 2, None, b"", 0
    while at + 4 <= len(content):
        if content[at] != 0xFF:
            raise FileError(path, "has no marker where one belongs; it is damaged", f"byte {at}")
        kind = content[at + 1]
        if kind == 0xFF:  # fill bytes may stand before a marker
            at += 1
            continue
        (length,) = struct.unpack_from(">H", content, at + 2)
        data = content[at + 4 : at + 2 + length]
        if kind in _FRAMES and len(data) >= 5:
            _, height, width = struct.unpack_from(">BHH", data)
            size = (width, height)
        elif kind == _APP1 and data.startswith(_EXIF) and not exif:
            exif, exif_at = data[len(_EXIF) :], at + 4
        elif kind == _SCAN:
            break
        at += 2 + length
    if size is None or 0 in size:
        raise FileError(path, "has no size; it is a damaged JPEG picture")
    return JpegParts(*size, exif, exif_at)


def jpeg_pixels(content: bytes, path: PathLike) -> NDArray[np.uint8]:
    """Return the pixels (h, w, 3) uint8, as they are stored: not turned as EXIF might ask."""
    parts = jpeg_parts(content, path)
    if parts.exif_at:
        # Pillow would warn of a damaged block, which does not matter to the pixels.
        content = content[: parts.exif_at] + b"Left\0\0" + content[parts.exif_at + len(_EXIF) :]
    return read_rgb(path, ("JPEG",), content=content, most_bytes=most_made_bytes())

"""Photographs as a camera's software writes them: 8- or 16-bit RGB in PNG or TIFF, with their time in EXIF.

The files are quick to write, not small: photographs are noise to a packer.
"""

from __future__ import annotations

import os
import struct
import zlib
from fractions import Fraction
from pathlib import Path

import numpy as np

from brdf_suite.acquisition.simulator.sensor import Codes
from brdf_suite.errors import FileError

_EXPOSURE_TIME, _EXIF_FOLDER = 0x829A, 0x8769
_SHORT, _LONG, _RATIONAL = 3, 4, 5


def write_photograph(path: str | os.PathLike[str], codes: Codes, exposure_s: float) -> None:
    """Write codes (h, w, 3), uint8 or uint16, as PNG or, with the ending ``.tif``, as TIFF."""
    target = Path(path)
    content = _tiff(codes, exposure_s) if target.suffix == ".tif" else _png(codes, exposure_s)
    try:
        # Not forced to the disk: thousands of files, and the session that makes them count comes last.
        target.write_bytes(content)
    except OSError as error:
        raise FileError(path, f"cannot be written ({error.strerror})") from error


def _png(codes: Codes, exposure_s: float) -> bytes:
    height, width, _ = codes.shape
    big = np.ascontiguousarray(codes.astype(codes.dtype.newbyteorder(">")))
    rows = big.view(np.uint8).reshape(height, -1)
    packed = zlib.compress(np.pad(rows, ((0, 0), (1, 0))).tobytes(), 1)
    header = struct.pack(">IIBBBBB", width, height, 8 * codes.itemsize, 2, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"eXIf", exif(exposure_s)), (b"IDAT", packed), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )


def exif(exposure_s: float) -> bytes:
    """Return the EXIF block (a TIFF of no picture) that holds an exposure time."""
    # Header, one entry that leads to the EXIF folder, whose one entry leads to the fraction.
    head = b"II*\0" + struct.pack("<I", 8)
    leading = struct.pack("<HHHIII", 1, _EXIF_FOLDER, _LONG, 1, 26, 0)
    return (
        head
        + leading
        + struct.pack("<HHHIII", 1, _EXPOSURE_TIME, _RATIONAL, 1, 44, 0)
        + _fraction(exposure_s)
    )


def _fraction(seconds: float) -> bytes:
    found = Fraction(seconds).limit_denominator(10_000_000)
    return struct.pack("<II", found.numerator, found.denominator)


def _tiff(codes: Codes, exposure_s: float) -> bytes:
    height, width, _ = codes.shape
    entries = 11
    after = 8 + 2 + 12 * entries + 4
    bits_at, exif_at = after, after + 6
    data_at = exif_at + 18 + 8
    pixels = np.ascontiguousarray(codes.astype(codes.dtype.newbyteorder("<"))).tobytes()
    fields = [
        (256, _LONG, 1, width),
        (257, _LONG, 1, height),
        (258, _SHORT, 3, bits_at),
        (259, _SHORT, 1, 1),
        (262, _SHORT, 1, 2),
        (273, _LONG, 1, data_at),
        (277, _SHORT, 1, 3),
        (278, _LONG, 1, height),
        (279, _LONG, 1, len(pixels)),
        (284, _SHORT, 1, 1),
        (_EXIF_FOLDER, _LONG, 1, exif_at),
    ]
    folder = struct.pack("<H", entries) + b"".join(struct.pack("<HHII", *field) for field in fields)
    time = struct.pack("<HHHIII", 1, _EXPOSURE_TIME, _RATIONAL, 1, exif_at + 18, 0) + _fraction(exposure_s)
    bits = struct.pack("<HHH", *(8 * codes.itemsize,) * 3)
    return b"II*\0" + struct.pack("<I", 8) + folder + struct.pack("<I", 0) + bits + time + pixels

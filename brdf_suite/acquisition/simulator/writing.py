"""Writing of photographs as a camera's software does: 8- or 16-bit RGB in PNG or TIFF, with EXIF exposure times.

The files are quick to write, not small: photographs are noise to a packer.
"""

from __future__ import annotations

import os
import struct
import zlib
from fractions import Fraction
from pathlib import Path

import numpy as np
from PIL.Image import Exif
from PIL.TiffImagePlugin import IFDRational
from tifffile import imwrite

from brdf_suite.arrays import Codes
from brdf_suite.errors import FileError

_EXPOSURE_TIME, _EXIF_FOLDER = 0x829A, 0x8769
_RATIONAL = 5


def write_photograph(path: str | os.PathLike[str], codes: Codes, exposure_s: float) -> None:
    """Write codes (h, w, 3), uint8 or uint16, as PNG or, with the ending ``.tif``, as TIFF."""
    target = Path(path)
    try:
        # Not forced to the disk: thousands of files, and the session that makes them count comes last.
        if target.suffix == ".tif":
            _write_tiff(target, codes, exposure_s)
        else:
            target.write_bytes(_png(codes, exposure_s))
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
    block = Exif()
    block[_EXIF_FOLDER] = {_EXPOSURE_TIME: IFDRational(*_fraction(exposure_s))}
    return block.tobytes().removeprefix(b"Exif\0\0")


def _fraction(seconds: float) -> tuple[int, int]:
    found = Fraction(seconds).limit_denominator(10_000_000)
    return found.numerator, found.denominator


def _write_tiff(target: Path, codes: Codes, exposure_s: float) -> None:
    # The time stands beside the picture's size, as TIFF/EP has it, since tifffile writes no EXIF folder.
    time = (_EXPOSURE_TIME, _RATIONAL, 1, _fraction(exposure_s), True)
    imwrite(target, codes, photometric="rgb", metadata=None, software=False, extratags=[time])

"""TIFF reader by tifffile: 8 or 16 bits or floats, grey or RGB, strips or tiles, plain or deflated.

EXIF blocks are TIFF without pixels (CIPA DC-008). Other packings (LZW, JPEG in TIFF) are left to OpenCV where it is
installed. What tifffile lets pass is asked for here: strips that reach beyond the file's end or hold less than their
pixels, and sizes that no memory holds.
"""

from __future__ import annotations

import logging
import math
import os
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tifffile import TiffFile, TiffPage

from brdf_suite.errors import ExtraError, FileError, PathLike
from brdf_suite.extras import import_extra
from brdf_suite.files.bounded_reading import check_made
from brdf_suite.regular_files import read_bytes

MOST_PIXELS = 1 << 28
_MOST_CHANNELS = 5
_PLAIN, _DEFLATED = 1, (8, 32946)
_NEEDED = (256, 257, 258)
# Width, length, depth, channels, rows of a strip, and width, length and depth of a tile.
_SIZES = (256, 257, 32997, 277, 278, 322, 323, 32998)
_PHOTOMETRIC = 262
_DEFLATE_RATIO = 1032
"""That deflate packs at most to 1."""
_FREE_SIZE = 1 << 28
"""Bytes that a strip may unpack to without a look at what it does."""
_EXPOSURE_TIME, _SHUTTER_SPEED, _EXIF = 33434, 37377, 34665


def tiff_facts(path: PathLike) -> tuple[int, int, int | None, float | None]:
    """Return width, height, bits (None of floats), and the exposure time in seconds or None.

    Raises
    ------
    FileError
        It is damaged, cut off, too large, or no photograph.
    """
    with first_page(path, path) as page:
        _check_layout(page, path)
        try:
            time = read_exposure(page)
        except (ArithmeticError, LookupError, TypeError, ValueError):
            time = None  # a damaged block has none, as the pixels do not depend on it
        bits = None if int(page.sampleformat) == 3 else int(page.bitspersample)
        return page.imagewidth, page.imagelength, bits, time


def tiff_pixels(path: PathLike) -> NDArray[Any]:
    """Return the pixels (h, w, channels) of the first picture, as they stand in the file.

    Raises
    ------
    FileError
        As :func:`tiff_facts`, and where it is packed in a way that needs OpenCV, which is not installed.
    """
    with first_page(path, path) as page:
        _check_layout(page, path)
        own = page.compression in (_PLAIN, *_DEFLATED) and page.predictor in (1, 2)
        own = own and page.bitspersample in (8, 16, 32)
        if own and page.tags.valueof(_PHOTOMETRIC, default=2) in (1, 2):
            return _unpacked(page, path)
    return _by_opencv(path)


def _check_layout(page: TiffPage, path: PathLike) -> None:
    """Raise :class:`FileError` where the picture is no photograph's size, or its pixels are not all in the file."""
    # Of depth, too: tifffile leaves out a field that is cut off, and would take the depth for a single bit.
    if any(tag not in page.tags for tag in _NEEDED):
        raise FileError(path, "lacks the fields of its size and depth; it is damaged or no photograph")
    for code in _SIZES:
        value = page.tags.valueof(code)
        if isinstance(value, tuple | bytes | str):
            # Python would repeat such a value instead of multiplying with it.
            reason = f"holds {len(value):,} values where one number belongs; the file is damaged"
            raise FileError(path, reason, f"field {page.tags[code].name}")
    width, height, channels = page.imagewidth, page.imagelength, page.samplesperpixel
    if not 0 < width * height <= MOST_PIXELS or min(width, height) < 1:
        raise FileError(path, f"is {width} × {height} pixels; up to {MOST_PIXELS:,} are read")
    if not 1 <= channels <= _MOST_CHANNELS:
        raise FileError(path, f"has {channels} channels; up to {_MOST_CHANNELS} are read")
    size = width * height * channels * -(-page.bitspersample // 8)
    check_made(path, size, "its pixels", "field ImageWidth")
    if page.imagedepth != 1:
        raise FileError(path, f"is a volume of {page.imagedepth} pictures; a photograph is one")
    needed, size = math.prod(page.chunked), page.parent.filehandle.size
    if min(len(page.dataoffsets), len(page.databytecounts)) < needed:
        raise FileError(path, "names fewer strips than its pixels need; it is damaged")
    end = max(at + count for at, count in zip(page.dataoffsets, page.databytecounts, strict=False))
    if end > size:
        raise FileError(path, f"ends at byte {size:,}, its pixels at {end:,}; it was not copied whole")


def _unpacked(page: TiffPage, path: PathLike) -> NDArray[Any]:
    if page.dtype is None or page.dtype.str[1:] not in ("u1", "u2", "f2", "f4"):
        reason = f"has numbers of {page.bitspersample} bits in a form that is not read; write 8 or 16 bits, or floats"
        raise FileError(path, reason, "field SampleFormat")
    if math.prod(page.chunks) > MOST_PIXELS * _MOST_CHANNELS:
        raise FileError(path, f"has tiles of {page.tilewidth} × {page.tilelength} pixels; it is damaged")
    # A strip of no bytes is a hole to tifffile, and plain strips in a row are read without regard to their ends.
    short = page.compression == _PLAIN and sum(page.databytecounts) < page.nbytes
    if short or min(page.databytecounts) < 1 or min(page.dataoffsets) < 8:
        raise FileError(path, "has a strip that is too short; it is damaged")
    if page.compression in _DEFLATED:
        _check_unpacked_size(page, path)
    try:
        stored = page.asarray(squeeze=False)  # (planes, 1, h, w, channels in a plane)
    except (ValueError, NotImplementedError, zlib.error) as error:
        raise FileError(path, f"has a strip that cannot be unpacked ({error}); it is damaged") from error
    return np.moveaxis(stored[:, 0], 0, -1).reshape(page.imagelength, page.imagewidth, -1)


def _check_unpacked_size(page: TiffPage, path: PathLike) -> None:
    """Raise :class:`FileError` at a strip that unpacks to more than its pixels, where that could fill the memory.

    Without imagecodecs tifffile unpacks whatever a strip holds.
    """
    assert page.dtype is not None
    wanted = math.prod(page.chunks) * page.dtype.itemsize
    for at, count in zip(page.dataoffsets, page.databytecounts, strict=False):
        if count * _DEFLATE_RATIO <= max(_FREE_SIZE, wanted):
            continue
        page.parent.filehandle.seek(at)
        try:
            packed = page.parent.filehandle.read(count)
            length = len(zlib.decompressobj().decompress(packed, wanted + _FREE_SIZE))
        except zlib.error as error:
            raise FileError(path, f"has a strip that cannot be unpacked ({error}); it is damaged") from error
        if length == wanted + _FREE_SIZE:
            reason = "has a strip that unpacks to more than its pixels; it is damaged"
            raise FileError(path, reason, f"byte {at}")


def _by_opencv(path: PathLike) -> NDArray[Any]:
    try:
        cv2 = import_extra(
            "cv2", purpose="this packing of a TIFF", instead="a TIFF without compression needs nothing more"
        )
    except ExtraError as error:
        raise FileError(path, error.reason) from error
    # OpenCV would report damage on the standard error as well; it is reported once, below.
    level = cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
    try:
        packed = np.frombuffer(read_bytes(path), np.uint8)
        pixels = cv2.imdecode(packed, cv2.IMREAD_UNCHANGED)
    except cv2.error as error:
        raise FileError(path, "is a TIFF that OpenCV cannot unpack; write it without compression") from error
    finally:
        cv2.utils.logging.setLogLevel(level)
    if pixels is None:
        raise FileError(path, "is a TIFF that cannot be unpacked; write it without compression")
    return np.asarray(pixels[..., None] if pixels.ndim == 2 else pixels[..., 2::-1])


# What tifffile misses in a file goes to its log: damage, which the error reports once, and every field that
# an EXIF block, being no image, has not. A session of thousands of photographs would fill the programs' logs with it.
logging.getLogger("tifffile").setLevel(logging.CRITICAL)


@contextmanager
def first_page(source: PathLike | bytes, path: PathLike) -> Iterator[TiffPage]:
    """Yield the first page of the file, or block of bytes, ``source``; ``path`` is what errors name.

    Whatever goes wrong in the ``with`` block is taken as damage of the file.

    Raises
    ------
    FileError
        It is no TIFF, damaged, or cut off.
    """
    opened = BytesIO(source) if isinstance(source, bytes) else os.fspath(source)
    try:
        # By its name alone tifffile would take a file as NDPI, whose offsets are read otherwise.
        with TiffFile(opened, is_ndpi=False) as tiff:
            try:
                page = tiff.pages.first
            except IndexError as error:
                reason = "ends before its fields do; it was not copied whole"
                raise FileError(path, reason, "byte 4") from error
            yield page
    except FileError:
        raise
    except Exception as error:
        # A parser of many dialects meets damage anywhere: as a key, a type, a division, a size of memory.
        raise FileError(path, f"is a damaged TIFF; its fields contradict each other ({error})") from error


def read_exposure(page: TiffPage) -> float | None:
    """Return the exposure time in seconds that a page or its EXIF folder names, or None where they name none."""
    folder = page.tags.valueof(_EXIF)
    named: dict[str, Any] = folder if isinstance(folder, dict) else {}
    time = _number(page.tags.valueof(_EXPOSURE_TIME, default=named.get("ExposureTime")))
    if time is not None and time > 0.0:
        return time
    speed = _number(page.tags.valueof(_SHUTTER_SPEED, default=named.get("ShutterSpeedValue")))
    # The shutter's speed is the logarithm to base 2 of 1 over the time.
    return None if speed is None else 2.0 ** -min(max(speed, -40.0), 40.0)


def _number(value: object) -> float | None:
    """Return the value of a rational, stored as a pair by tifffile, or a plain number; None for anything else."""
    if isinstance(value, tuple) and len(value) == 2 and all(isinstance(part, int) for part in value):
        return value[0] / value[1] if value[1] else None
    return float(value) if isinstance(value, int | float) and abs(value) < 1e30 else None

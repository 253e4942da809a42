"""First page of a TIFF and its exposure time, by tifffile; EXIF blocks are TIFF without pixels (CIPA DC-008)."""

from __future__ import annotations

import logging
import os
from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from typing import TYPE_CHECKING, Any

from tifffile import TiffFile

from brdf_suite.errors import FileError, PathLike

if TYPE_CHECKING:
    from tifffile import TiffPage


_EXPOSURE_TIME, _SHUTTER_SPEED, _EXIF = 33434, 37377, 34665

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

"""Bounds on what is made of files that may be damaged or hostile, and the stamp by which a changed file is noticed."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from pathlib import Path

from brdf_suite import variables
from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import open_regular

LONGEST_LINE = 1 << 20
"""Bytes; a row of two thousand bands with twenty digits each is 40 KB."""

MOST_SAMPLES = 1_000_000
"""Directions of a scattered measurement; a gonioreflectometer makes a few thousand."""

MOST_BANDS = 2048
"""Wavelengths of a spectrum; the finest array spectrometers have about that."""


def numbered_lines(path: PathLike, largest: int) -> Iterator[tuple[int, str]]:
    """Yield (line number from 1, text without its ending) of a text file.

    Raises
    ------
    FileError
        As :func:`open_regular`; a line is over :data:`LONGEST_LINE` bytes, or the file holds a NUL byte or is
        not UTF-8 (Latin-1 in comments is let through: old instruments write it).
    """
    number = 0
    with open_regular(path, largest) as stream:
        while True:
            line = stream.readline(LONGEST_LINE + 1)
            if not line:
                return
            number += 1
            if len(line) > LONGEST_LINE:
                raise FileError(path, f"the line is longer than {LONGEST_LINE:,} bytes", f"line {number}")
            if b"\0" in line:
                raise FileError(path, "holds a NUL byte, so it is not text", f"line {number}")
            try:
                text = line.decode("utf-8-sig" if number == 1 else "utf-8")
            except UnicodeDecodeError:
                text = line.decode("latin-1")
            # Old Mac files end their lines with CR alone; those are not met in this trade and count as one.
            yield number, text.rstrip("\r\n")


def number_in(path: PathLike, text: str, line: int, what: str) -> float:
    """Return the finite number in ``text``, or raise :class:`FileError` naming the line and ``what``."""
    try:
        # Python also takes 1_000, which no instrument means.
        value = math.nan if "_" in text else float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        shown = text if len(text) <= 40 else text[:37] + "..."
        raise FileError(path, f"expected a finite number for {what}, not {shown!r}", f"line {line}")
    return value


def file_stamp(asked: object) -> tuple[int, int] | None:
    """Return time of change (ns) and size (bytes) of the file that a text names; None for what names no file."""
    if not isinstance(asked, str):
        return None
    try:
        status = Path(asked).stat()
    except (OSError, ValueError):  # a shipped name, or a file whose reader will report that it is missing
        return None
    return status.st_mtime_ns, status.st_size


MOST_MADE_BYTES = 1 << 30
"""Largest array of pixels or mesh data, in bytes, that is made of one file unless ``BRDF_SUITE_READ_MB`` says more."""


def most_made_bytes() -> int:
    """Return how many bytes may be made of one file: 1 GiB, or ``BRDF_SUITE_READ_MB`` (10⁶ bytes) if that is more."""
    text = os.environ.get(variables.READ_MB, "").strip()
    return max(MOST_MADE_BYTES, int(text[:9]) * 1_000_000 if text.isdecimal() else 0)


MADE_OF_HELD = 32
"""Bytes that may be made of each byte that a file holds, where that is more than the limit for small files.

An indexed triangle with its half a vertex takes 12 bytes of a compact file, and at most 32 times as much while it is
read and repaired, so that a mesh is read whose triangles are all in its file. What goes beyond is made of few bytes, as
instances are.
"""


def check_made(path: PathLike, size: int, what: str, place: str | None = None, held: int = 0) -> None:
    """Raise :class:`FileError` where ``what``, to be made of the file ``path``, takes more than the limit.

    ``size`` is in bytes; ``place`` says where in the file it is announced. The limit is :func:`most_made_bytes`, or
    :data:`MADE_OF_HELD` times the bytes ``held`` in the file, if that is more.
    """
    allowed = max(most_made_bytes(), MADE_OF_HELD * held)
    if size > allowed:
        taken = f"{size / 2**30:,.1f} GiB" if size < 1 << 60 else "more memory than there is"
        most = f"{allowed / 2**30:,.3g}"
        reason = f"{what} would take {taken}; {most} GiB is allowed ({variables.READ_MB} can allow more)"
        raise FileError(path, reason, place)

"""Images larger than the lobes can resolve, reduced by area while they are read."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import check_made

MOST_ROWS = 4096
"""The largest prefiltered face has 2,048 texels on 90°; a map of 8,192 × 4,096 holds as many."""

STRIP_ROWS = 256
_STRIP_BYTES = 1 << 28
_BYTES_A_PIXEL = 40
"""That decoding takes at most: what is stored, and three numbers as they are, scaled and converted."""
ReadRows = Callable[[int, int], NDArray[np.float32]]
"""Returns rows first … last - 1 of an image, (rows, w, 3); asked for from the top, each once."""


def reduction(height: int, width: int) -> int:
    """Return by what whole number an image is reduced along each side: 1 up to 8,192 × 4,096."""
    return max(1, -(-height // MOST_ROWS), -(-width // (2 * MOST_ROWS)))


def check_reducible(path: PathLike, height: int, width: int, place: str) -> None:
    """Raise :class:`FileError`, naming ``place``, where an image is too thin or too wide to be reduced in strips."""
    by = reduction(height, width)
    if min(height, width) < by:
        reason = (
            f"is {width:,} × {height:,} pixels, too thin to be reduced to {2 * MOST_ROWS:,} × {MOST_ROWS:,}"
        )
        raise FileError(path, reason, place)
    check_made(path, by * width * _BYTES_A_PIXEL, f"{by} rows of {width:,} pixels", place)


def read_reduced(
    height: int, width: int, read_rows: ReadRows, strip_rows: int = STRIP_ROWS
) -> tuple[NDArray[np.float32], tuple[str, ...]]:
    """Return an image (h, w, 3) in strips, reduced by :func:`reduction` by the mean of each block, and a note.

    Rows and columns that do not fill a block are left out (fewer than the reduction). NaN and infinity go
    through the mean and are repaired with the others.
    """
    by = reduction(height, width)
    rows, columns = height // by, width // by
    result = np.empty((rows, columns, 3), np.float32)
    strip = max(1, min(strip_rows, _STRIP_BYTES // (width * _BYTES_A_PIXEL)) // by)
    for first in range(0, rows, strip):
        last = min(first + strip, rows)
        block = read_rows(first * by, last * by)
        if by > 1:
            cells = block[:, : columns * by].reshape(last - first, by, columns, by, 3)
            with np.errstate(invalid="ignore", over="ignore"):  # repaired and reported with all else
                # Rows first, then columns added one by one: a mean along short axes takes several times as long.
                summed = cells.sum(axis=1)
                block = sum(summed[:, :, column] for column in range(by)) / np.float32(by * by)
        result[first:last] = block
    if by == 1:
        return result, ()
    sizes = f"{width:,} × {height:,} pixels were reduced by area to {columns:,} × {rows:,}"
    return result, (f"{sizes}, which is all that the lobes resolve",)

"""Read and write OpenEXR images as linear RGB arrays."""

from __future__ import annotations

import contextlib
import io
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import open_plain
from brdf_suite.files.images.area_reduction import check_reducible, read_reduced
from brdf_suite.files.images.exr.channels import ExrLight, choose_light, to_rgb
from brdf_suite.files.images.exr.header import ExrHeader, parse_headers
from brdf_suite.files.images.primaries import REC709, REC2020, Chromaticities
from brdf_suite.files.memory_limit import MOST_MADE_BYTES

MOST_WHOLE_BYTES = MOST_MADE_BYTES
"""Largest content, unpacked, of a file that is read as a whole: of a later part, or of luminance and chroma."""

_DAMAGE = (OSError, RuntimeError, ValueError, TypeError, IndexError, MemoryError)


@dataclass(frozen=True, eq=False)
class ExrImage:
    """Content of an EXR file: pixels (h, w, 3) float32 in ``chromaticities``; a cube map of OpenEXR or not."""

    pixels: NDArray[np.float32]
    chromaticities: Chromaticities
    notes: tuple[str, ...]
    is_cube: bool


def read_exr(path: PathLike) -> ExrImage:
    """Read the first part of an EXR file that holds light.

    Scan-line and tiled files of one or several parts, half or float, all compressions; channels R, G, B in any
    order with or without others or in a layer, Y alone, or Y with RY and BY. A data window that differs from the
    display window is placed in it; what it does not cover is black. Files without chromaticities are Rec. 709, as
    the format says. What is larger than 8,192 × 4,096 is reduced by area as it is read.

    Raises
    ------
    FileError
        The file is damaged or of a kind that is not read.
    """
    with open_plain(path) as stream:
        headers = parse_headers(path, stream)
    light = choose_light(path, headers)
    header, notes = light.header, list(light.notes)
    if header.part > 0 or light.kind == "chroma":
        _check_whole(path, headers)
    # Of several parts all share the attribute, which some writers put into the first alone.
    chromaticities = header.chromaticities or headers[0].chromaticities or REC709
    if header.data_window != header.display_window and not header.is_cube:
        notes.append(
            f"the data window {header.data_window} was placed in {header.display_window}; what lies outside is black"
        )
    rows = _Rows(path, light, chromaticities)
    left, top, right, bottom = _window(header)
    height, width = bottom - top + 1, right - left + 1
    check_reducible(
        path, height, width, "attribute dataWindow" if header.is_cube else "attribute displayWindow"
    )
    try:
        pixels, reduced = read_reduced(height, width, rows.read)
    finally:
        rows.close()
    return ExrImage(pixels, chromaticities, (*notes, *reduced), header.is_cube)


def _window(header: ExrHeader) -> tuple[int, int, int, int]:
    """Return the window that the image is: of a cube map the data's, otherwise the display's."""
    return header.data_window if header.is_cube else header.display_window


def _check_whole(path: PathLike, headers: Sequence[ExrHeader]) -> None:
    """Refuse a file whose parts are too large together: but for the first, the library reads all of them at once."""
    total = 0
    for header in headers:
        left, top, right, bottom = header.data_window
        deep = 2 if header.deep else 1  # at least a pointer and a count for each pixel
        sample = sum(2 if channel.kind == "half" else 4 for channel in header.channels)
        total += (right - left + 1) * (bottom - top + 1) * sample * deep
    if total > MOST_WHOLE_BYTES:
        reason = f"its parts hold {total >> 20:,} MB together; {MOST_WHOLE_BYTES >> 20:,} MB are read"
        raise FileError(path, f"{reason}. Write the part that is the light as a file of its own", "headers")


class _Rows:
    """Rows of the display window of one part, decoded on demand."""

    def __init__(self, path: PathLike, light: ExrLight, chromaticities: Chromaticities) -> None:
        self._path, self._light, self._chromaticities = path, light, chromaticities
        self._file: Any = None
        self._planes: dict[str, NDArray[np.floating]] | None = None

    def read(self, first: int, last: int) -> NDArray[np.float32]:
        """Return rows (last - first, w, 3) of the display window, black where there is no data."""
        left, top, right, _ = _window(self._light.header)
        x_min, y_min, x_max, y_max = self._light.header.data_window
        placed = np.zeros((last - first, right - left + 1, 3), np.float32)
        y0, y1 = max(top + first, y_min), min(top + last, y_max + 1)
        before = (y0 - y_min) % 2 if self._light.kind == "chroma" else 0  # chroma lies on even rows
        x0, x1 = max(left, x_min), min(right, x_max) + 1
        if y0 < y1 and x0 < x1:
            decoded = to_rgb(self._light, self._decode(y0 - before, y1), self._chromaticities)[before:]
            placed[y0 - top - first : y1 - top - first, x0 - left : x1 - left] = decoded[
                :, x0 - x_min : x1 - x_min
            ]
        return placed

    def close(self) -> None:
        """Close the file."""
        if self._file is not None:
            self._file.close()

    def _decode(self, y0: int, y1: int) -> dict[str, NDArray[np.floating]]:
        """Return the planes of data rows y0 … y1 - 1 by channel name."""
        header = self._light.header
        try:
            if header.part > 0 or self._light.kind == "chroma":
                return self._from_part(y0, y1)
            return self._from_first_part(y0, y1)
        except _DAMAGE as error:
            raise FileError(self._path, f"is damaged or cut off ({error})", "pixel data") from error

    def _from_first_part(self, y0: int, y1: int) -> dict[str, NDArray[np.floating]]:
        # Imported here: no other task needs the library. InputFile where it can be, and not File: File prints
        # a damaged chunk as a warning and returns what it has, InputFile raises; and it reads rows as asked.
        import OpenEXR

        if self._file is None:
            self._file = OpenEXR.InputFile(os.fspath(self._path))
        width = self._light.header.data_window[2] - self._light.header.data_window[0] + 1
        names = [channel.name for channel in self._light.channels]
        stored = self._file.channels(names, scanLine1=y0, scanLine2=y1 - 1)
        planes: dict[str, NDArray[np.floating]] = {}
        for channel, raw in zip(self._light.channels, stored, strict=True):
            kind = np.dtype(np.float16 if channel.kind == "half" else np.float32)
            planes[channel.name] = np.frombuffer(raw, kind).reshape(y1 - y0, width)
        return planes

    def _from_part(self, y0: int, y1: int) -> dict[str, NDArray[np.floating]]:
        """Read rows of a later part, or of half-resolution chroma, which only the whole-file reader supports."""
        import OpenEXR

        header = self._light.header
        if self._planes is None:
            # The library prints what it could not decode and hands out whatever was in memory; here that is damage.
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                part = OpenEXR.File(os.fspath(self._path), separate_channels=True).parts[header.part]
            for line in printed.getvalue().splitlines():
                if line.startswith(f"Warning: Exception raised reading pixel data for part {header.part} "):
                    raise RuntimeError(line.partition(" - ")[2])
            self._planes = {c.name: np.asarray(part.channels[c.name].pixels) for c in self._light.channels}
        first = y0 - header.data_window[1]
        chosen = {}
        for channel in self._light.channels:
            plane, step = self._planes[channel.name], channel.y_sampling
            # One sample more of chroma, for the interpolation of the last row.
            end = first + y1 - y0 if step == 1 else -(-(first + y1 - y0) // step) + 1
            chosen[channel.name] = plane[first // step : end]
        return chosen


def write_exr(
    path: PathLike,
    pixels: NDArray[np.floating],
    chromaticities: Chromaticities = REC2020,
    metadata: Mapping[str, str] | None = None,
) -> None:
    """Write pixels (h, w, 3), linear RGB of ``chromaticities``, as a ZIP-compressed EXR; half stays half.

    The file is written whole or not at all. ``metadata`` becomes text attributes.

    >>> write_exr("sky.exr", np.ones((512, 1024, 3), np.float32), metadata={"comments": "a white sky"})
    """
    import OpenEXR

    array = np.asarray(pixels)
    if array.ndim != 3 or array.shape[2] != 3 or 0 in array.shape:
        raise ValueError(f"pixels must have the shape (h, w, 3), not {array.shape}")
    kind = np.float16 if array.dtype == np.float16 else np.float32
    channels = {name: np.ascontiguousarray(array[..., i], dtype=kind) for i, name in enumerate("RGB")}
    header = {
        **(metadata or {}),
        "compression": OpenEXR.ZIP_COMPRESSION,
        "type": OpenEXR.scanlineimage,
        "chromaticities": chromaticities,
    }
    with replacing(path) as temporary:
        try:
            OpenEXR.File(header, channels).write(str(temporary))
        except (RuntimeError, ValueError) as error:
            raise FileError(path, f"cannot be written ({error})") from error

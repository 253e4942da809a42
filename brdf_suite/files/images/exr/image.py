"""Read and write OpenEXR images as linear RGB arrays; those larger than memory are written in strips.

Strips follow "OpenEXR File Layout" of the OpenEXR project: one part of scan lines, sixteen to a chunk, ZIP. They are
written here because the library's writer takes whole pictures, and its one for rows is to be removed.
"""

from __future__ import annotations

import contextlib
import io
import os
import struct
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.documents.exr_writing import write_by_library
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import MOST_MADE_BYTES
from brdf_suite.files.images.area_reduction import check_reducible, read_reduced
from brdf_suite.files.images.exr.header import ExrHeader, ExrLight, choose_light, parse_headers, to_rgb
from brdf_suite.files.images.primaries import REC709, REC2020, Chromaticities
from brdf_suite.regular_files import open_regular

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

    Raises :class:`FileError`: the file is damaged or of a kind that is not read.
    """
    with open_regular(path) as stream:
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
    *,
    dwa_level: float = 0.0,
) -> None:
    """Write pixels (h, w, 3), linear RGB of ``chromaticities``, as a ZIP-compressed EXR; half stays half.

    The file is written whole or not at all. ``metadata`` becomes text attributes. ``dwa_level`` above 0
    compresses by DWA instead: with a fifth of the size and errors that grow with the level (the library's own is 45).
    Values above 65,504 cannot be kept then.

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
        "compression": OpenEXR.DWAB_COMPRESSION if dwa_level else OpenEXR.ZIP_COMPRESSION,
        "type": OpenEXR.scanlineimage,
        "chromaticities": chromaticities,
    } | ({"dwaCompressionLevel": float(dwa_level)} if dwa_level else {})
    with replacing(path) as temporary:
        write_by_library(OpenEXR.File(header, channels), temporary, path)


_LINES = 16
_ZIP = 3
_LARGEST_HALF = 65504.0
_NAMES = {3: "RGB", 4: "RGBA"}


def write_exr_strips(
    path: PathLike,
    size: tuple[int, int],
    strips: Iterable[NDArray[Any]],
    chromaticities: Chromaticities,
    metadata: Mapping[str, str] | None = None,
    *,
    half: bool = False,
) -> None:
    """Write linear RGB or RGBA of ``chromaticities`` from strips (rows, w, 3 or 4), the top one first.

    No more of it than a strip is held; whatever is raised while the strips are made leaves the old file. Alpha is
    what the colours are multiplied by, as the format has it. ``metadata`` becomes text attributes, their names of
    at most 31 letters. ``half`` holds values at 65,504.

    Raises
    ------
    FileError
        The file cannot be written.
    ValueError
        The strips are not of the size, or of other channels.
    """
    with replacing(path) as temporary:
        try:
            with temporary.open("wb") as file:
                _write(file, size, strips, chromaticities, metadata or {}, "<f2" if half else "<f4")
        except OSError as error:
            raise FileError(path, f"cannot be written ({error.strerror or error})") from error


def _write(
    file: BinaryIO,
    size: tuple[int, int],
    strips: Iterable[NDArray[Any]],
    chromaticities: Chromaticities,
    metadata: Mapping[str, str],
    kind: str,
) -> None:
    table = 0
    offsets: list[int] = []
    for first, block in _blocks(size, strips):
        if not offsets:
            file.write(_header(size, _NAMES[block.shape[2]], chromaticities, metadata, kind))
            table = file.tell()
            file.write(bytes(8 * -(-size[1] // _LINES)))  # where the chunks begin, known only at the end
        offsets.append(file.tell())
        packed = _packed(block, kind)
        file.write(struct.pack("<ii", first, len(packed)) + packed)
    file.seek(table)
    file.write(struct.pack(f"<{len(offsets)}Q", *offsets))


def _blocks(size: tuple[int, int], strips: Iterable[NDArray[Any]]) -> Iterator[tuple[int, NDArray[Any]]]:
    """Yield the number of its first line and a block of sixteen lines, the last one of what is left."""
    width, height = size
    first, rest = 0, None
    for strip in strips:
        if strip.ndim != 3 or strip.shape[1] != width or strip.shape[2] not in _NAMES:
            raise ValueError(f"strips must have the shape (rows, {width}, 3 or 4), not {strip.shape}")
        rows = strip if rest is None else np.concatenate([rest, strip])
        while len(rows) >= _LINES:
            yield first, rows[:_LINES]
            first, rows = first + _LINES, rows[_LINES:]
        rest = rows
    left = 0 if rest is None else len(rest)
    if first + left != height:
        raise ValueError(f"strips must have {height} rows in all, not {first + left}")
    if rest is not None and left:
        yield first, rest


def _packed(block: NDArray[Any], kind: str) -> bytes:
    """Return data compressed as ZIP in OpenEXR: low and high bytes apart, each as difference to the previous one."""
    if kind == "<f2":
        block = np.clip(block, -_LARGEST_HALF, _LARGEST_HALF)
    # Channels in the order of the alphabet (A, B, G, R), line by line.
    planes = np.moveaxis(block[..., ::-1], 2, 1)
    raw = np.ascontiguousarray(planes.astype(kind)).view(np.uint8).reshape(-1)
    apart = np.concatenate([raw[0::2], raw[1::2]])
    stepped = apart.copy()
    np.subtract(apart[1:], apart[:-1], out=stepped[1:])
    stepped[1:] += np.uint8(128)
    packed = zlib.compress(stepped.tobytes(), 4)
    return packed if len(packed) < len(raw) else raw.tobytes()


def _header(
    size: tuple[int, int], names: str, chromaticities: Chromaticities, metadata: Mapping[str, str], kind: str
) -> bytes:
    pixel = 1 if kind == "<f2" else 2
    channels = b"".join(
        name.encode() + b"\0" + struct.pack("<iB3xii", pixel, 0, 1, 1) for name in sorted(names)
    )
    window = struct.pack("<4i", 0, 0, size[0] - 1, size[1] - 1)
    entries = [
        _attribute("channels", "chlist", channels + b"\0"),
        _attribute("chromaticities", "chromaticities", struct.pack("<8f", *chromaticities)),
        _attribute("compression", "compression", bytes([_ZIP])),
        _attribute("dataWindow", "box2i", window),
        _attribute("displayWindow", "box2i", window),
        _attribute("lineOrder", "lineOrder", b"\0"),
        _attribute("pixelAspectRatio", "float", struct.pack("<f", 1.0)),
        _attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0.0, 0.0)),
        _attribute("screenWindowWidth", "float", struct.pack("<f", 1.0)),
        *(_attribute(name, "string", text.encode()) for name, text in metadata.items()),
    ]
    return struct.pack("<II", 20000630, 2) + b"".join(entries) + b"\0"


def _attribute(name: str, kind: str, value: bytes) -> bytes:
    word = name.encode("ascii")
    if not 1 <= len(word) <= 31 or b"\0" in word:
        raise ValueError(f"the attribute {name!r} must have 1 to 31 letters")
    return word + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

"""Read and write OpenEXR images as linear RGB arrays."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError
from brdf_suite.files.exr_header import ExrChannel, ExrHeader, parse_header
from brdf_suite.files.primaries import REC709, REC2020, Chromaticities


def read_exr(
    path: str | os.PathLike[str],
) -> tuple[NDArray[np.float32], Chromaticities, tuple[str, ...]]:
    """Return pixels (h, w, 3) float32 in the file's own primaries, those primaries, and notes.

    Scan-line and tiled single-part files, half or float, all compressions, channels R, G, B in any order with
    or without others, or Y alone. A data window that differs from the display window is placed in it; what it
    does not cover is black. Files without chromaticities are Rec. 709, as the format says.

    Raises
    ------
    FileError
        The file is damaged or of a kind that is not read.
    """
    try:
        with Path(path).open("rb") as stream:
            header = parse_header(path, stream)
    except OSError as error:
        raise FileError(path, f"cannot be read ({error.strerror})") from error
    if header.is_cube:
        raise FileError(path, "holds a cube map; a latitude-longitude map is wanted", "attribute envmap")
    chosen, notes = _choose_channels(path, header)
    pixels = _decode(path, header, chosen)
    window_note = "" if header.data_window == header.display_window else "; what lies outside is black"
    if window_note:
        pixels = _place(header, pixels)
        notes.append(
            f"the data window {header.data_window} was placed in {header.display_window}{window_note}"
        )
    return pixels, header.chromaticities or REC709, tuple(notes)


def _choose_channels(path: str | os.PathLike[str], header: ExrHeader) -> tuple[list[ExrChannel], list[str]]:
    """Return the three channels to read (one channel three times for Y) and notes."""
    by_name = {channel.name: channel for channel in header.channels}
    prefixes = ["", *sorted({name[:-1] for name in by_name if name.endswith(".R")})]
    for prefix in prefixes:
        names = [prefix + letter for letter in "RGB"]
        if all(name in by_name for name in names):
            chosen, notes = [by_name[name] for name in names], []
            if prefix:
                notes.append(f"layer {prefix.rstrip('.')!r} was read")
            break
    else:
        if "Y" not in by_name or "RY" in by_name:
            known = ", ".join(by_name)
            raise FileError(path, f"has the channels {known}; R, G and B, or Y alone, are wanted", "channels")
        chosen, notes = [by_name["Y"]] * 3, ["one channel, Y: the light is taken as neutral"]
    for channel in chosen:
        if channel.kind == "uint":
            raise FileError(path, "holds integers, not radiance", f"channel {channel.name}")
        if (channel.x_sampling, channel.y_sampling) != (1, 1):
            raise FileError(
                path, "is stored at reduced resolution, which is not read", f"channel {channel.name}"
            )
    return chosen, notes


def _decode(path: str | os.PathLike[str], header: ExrHeader, chosen: list[ExrChannel]) -> NDArray[np.float32]:
    # Imported here: no other task needs the library. InputFile and not File: File prints a damaged chunk as a
    # warning and returns what it has, InputFile raises.
    import OpenEXR

    x_min, y_min, x_max, y_max = header.data_window
    shape = (y_max - y_min + 1, x_max - x_min + 1)
    pixels = np.empty((*shape, 3), dtype=np.float32)
    names = list(dict.fromkeys(channel.name for channel in chosen))
    try:
        source = OpenEXR.InputFile(os.fspath(path))
        planes = dict(zip(names, source.channels(names), strict=True))
        source.close()
    except (OSError, RuntimeError, ValueError, TypeError, IndexError, MemoryError) as error:
        raise FileError(path, f"is damaged or cut off ({error})", "pixel data") from error
    for index, channel in enumerate(chosen):
        kind = np.float16 if channel.kind == "half" else np.float32
        plane = np.frombuffer(planes[channel.name], dtype=kind)
        if plane.size != shape[0] * shape[1]:
            raise FileError(path, "holds fewer pixels than its header says", f"channel {channel.name}")
        pixels[..., index] = plane.reshape(shape)
    return pixels


def _place(header: ExrHeader, pixels: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the display window's pixels, black where the data window does not reach."""
    left, top, right, bottom = header.display_window
    x_min, y_min, x_max, y_max = header.data_window
    placed = np.zeros((bottom - top + 1, right - left + 1, 3), dtype=np.float32)
    x0, x1 = max(left, x_min), min(right, x_max) + 1
    y0, y1 = max(top, y_min), min(bottom, y_max) + 1
    if x0 < x1 and y0 < y1:
        placed[y0 - top : y1 - top, x0 - left : x1 - left] = pixels[
            y0 - y_min : y1 - y_min, x0 - x_min : x1 - x_min
        ]
    return placed


def write_exr(
    path: str | os.PathLike[str],
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

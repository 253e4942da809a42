"""Check of an OpenEXR header before the library reads the file, and selection of the channels of light.

The library believes the header: it allocates what the header asks for. Here the header is parsed first (a few
hundred bytes) and everything that we do not read, or that cannot be true, is refused with its place in the
file. Layout: the OpenEXR file layout document of the Academy Software Foundation.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import BinaryIO, Literal

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.primaries import Chromaticities, rgb_to_xyz

MAX_PIXELS = 16384 * 8192
"""Largest image that is read: about 1.6 GB as float32 RGB."""

_MAGIC = b"\x76\x2f\x31\x01"
_TILED, _NON_IMAGE, _MULTI_PART = 0x200, 0x800, 0x1000
_MAX_PARTS = 256
_HEADER_LIMIT = 2 * 1024 * 1024  # more than any header with its table of chunks for the largest image
_REQUIRED = ("channels", "compression", "dataWindow", "displayWindow", "lineOrder")
_LINES_PER_CHUNK = {0: 1, 1: 1, 2: 1, 3: 16, 4: 32, 5: 16, 6: 32, 7: 32, 8: 32, 9: 256, 10: 256, 11: 32}

Window = tuple[int, int, int, int]
"""First and last column and row, both included: x_min, y_min, x_max, y_max."""


@dataclass(frozen=True)
class ExrChannel:
    """One channel of an EXR file: its name, type ("uint", "half", "float") and subsampling."""

    name: str
    kind: str
    x_sampling: int
    y_sampling: int


@dataclass(frozen=True)
class ExrHeader:
    """Header of one part of an EXR file; a plain file has one, number 0 of 1."""

    channels: tuple[ExrChannel, ...]
    data_window: Window
    display_window: Window
    chromaticities: Chromaticities | None
    is_cube: bool
    part: int = 0
    parts: int = 1
    name: str = ""
    deep: bool = False
    white_luminance: float | None = None


def parse_headers(path: PathLike, stream: BinaryIO) -> tuple[ExrHeader, ...]:
    """Parse the headers of the open file ``stream``, one per part; ``path`` is for the messages.

    Raises :class:`FileError`: not an EXR file, truncated, of a kind that is not read, or with impossible sizes.
    """
    reader = _Reader(path, stream.read(_HEADER_LIMIT))
    if reader.take(4) != _MAGIC:
        raise FileError(
            path, "is not an OpenEXR file (its first four bytes are not the magic number)", "byte 0"
        )
    flags = reader.int32()
    if flags & 0xFF != 2:
        raise FileError(path, f"has OpenEXR version {flags & 0xFF}; only version 2 is read", "byte 4")
    several = bool(flags & _MULTI_PART)
    if flags & _NON_IMAGE and not several:
        raise FileError(path, "is a deep OpenEXR file; flatten it to an ordinary image first", "byte 4")
    found: list[dict[str, tuple[int, bytes]]] = []
    while not found or (several and not reader.at_end_of_headers()):
        if len(found) >= _MAX_PARTS:
            raise FileError(path, f"has more than {_MAX_PARTS} parts", f"byte {reader.at}")
        found.append(reader.attributes())
    headers = tuple(_header(path, a, reader, i, len(found)) for i, a in enumerate(found))
    for header, attributes in zip(headers, found, strict=True):
        tiled = _text(attributes, "type").startswith("tiled") if several else bool(flags & _TILED)
        if header.deep:
            reader.take(8 * _chunk_count(path, attributes))
        elif tiled and ("tiles" not in attributes or len(attributes["tiles"][1]) != 9):
            raise FileError(path, "is tiled but lacks a sound 'tiles' attribute", f"byte {reader.at}")
        elif several:
            _check_chunks(path, reader, _chunk_count(path, attributes), stream, 12 if not tiled else 24)
        elif not tiled:
            lines = _LINES_PER_CHUNK[attributes["compression"][1][0]]
            rows = header.data_window[3] - header.data_window[1] + 1
            _check_chunks(path, reader, -(-rows // lines), stream, 8)
    return headers


def _header(
    path: PathLike,
    attributes: dict[str, tuple[int, bytes]],
    reader: _Reader,
    part: int,
    parts: int,
) -> ExrHeader:
    deep = _text(attributes, "type").startswith("deep")
    for name in _REQUIRED:
        if name not in attributes:
            raise FileError(path, f"lacks the header attribute {name!r}", f"byte {reader.at}")
    compression = attributes["compression"][1][:1]
    if not compression or compression[0] not in _LINES_PER_CHUNK:
        raise FileError(path, "has a compression that is not known", f"byte {attributes['compression'][0]}")
    chromaticities = attributes.get("chromaticities")
    primaries: Chromaticities | None = None
    if chromaticities is not None and len(chromaticities[1]) == 32:
        primaries = struct.unpack("<8f", chromaticities[1])
    luminance = attributes.get("whiteLuminance")
    return ExrHeader(
        _channels(path, *attributes["channels"]),
        _window(path, "dataWindow", *attributes["dataWindow"]),
        _window(path, "displayWindow", *attributes["displayWindow"]),
        primaries,
        attributes.get("envmap", (0, b"\0"))[1] == b"\1",
        part,
        parts,
        _text(attributes, "name"),
        deep,
        struct.unpack("<f", luminance[1])[0] if luminance is not None and len(luminance[1]) == 4 else None,
    )


def _text(attributes: dict[str, tuple[int, bytes]], name: str) -> str:
    return attributes.get(name, (0, b""))[1].decode("utf-8", errors="replace")


def _chunk_count(path: PathLike, attributes: dict[str, tuple[int, bytes]]) -> int:
    place, value = attributes.get("chunkCount", (0, b""))
    count = struct.unpack("<i", value)[0] if len(value) == 4 else 0
    if count < 1:
        raise FileError(path, "has a part without a sound 'chunkCount' attribute", f"byte {place}")
    return int(count)


class _Reader:
    """Sequential reader of little-endian values; an error names the place of truncation."""

    def __init__(self, path: PathLike, data: bytes) -> None:
        self.path, self.data, self.at = path, data, 0

    def take(self, count: int) -> bytes:
        if count < 0 or self.at + count > len(self.data):
            raise FileError(self.path, "is cut off within its header", f"byte {len(self.data)}")
        self.at += count
        return self.data[self.at - count : self.at]

    def int32(self) -> int:
        return int(struct.unpack("<i", self.take(4))[0])

    def name(self) -> str:
        end = self.data.find(b"\0", self.at, self.at + 256)
        if end < 0:
            raise FileError(self.path, "is cut off or damaged within a name of its header", f"byte {self.at}")
        text = self.take(end - self.at).decode("utf-8", errors="replace")
        self.at += 1
        return text

    def at_end_of_headers(self) -> bool:
        """Consume the empty header that ends a multi-part file's headers, if it is next; return whether it was."""
        if self.take(1) == b"\0":
            return True
        self.at -= 1
        return False

    def attributes(self) -> dict[str, tuple[int, bytes]]:
        """Return the attributes as name -> (place, value)."""
        found: dict[str, tuple[int, bytes]] = {}
        while name := self.name():
            self.name()  # the type; our attributes have one each
            size = self.int32()
            found[name] = (self.at, self.take(size))
        return found


def _channels(path: PathLike, place: int, value: bytes) -> tuple[ExrChannel, ...]:
    reader = _Reader(path, value)
    found = []
    while name := reader.name():
        kind, _, x_sampling, y_sampling = struct.unpack("<iiii", reader.take(16))
        if kind not in (0, 1, 2) or x_sampling < 1 or y_sampling < 1:
            raise FileError(
                path, f"has a damaged description of channel {name!r}", f"byte {place + reader.at}"
            )
        found.append(ExrChannel(name, ("uint", "half", "float")[kind], x_sampling, y_sampling))
    if not found:
        raise FileError(path, "has no channels", f"byte {place}")
    return tuple(found)


def _window(path: PathLike, name: str, place: int, value: bytes) -> Window:
    if len(value) != 16:
        raise FileError(path, f"has a damaged {name}", f"byte {place}")
    x_min, y_min, x_max, y_max = struct.unpack("<iiii", value)
    width, height = x_max - x_min + 1, y_max - y_min + 1
    if width < 1 or height < 1:
        raise FileError(path, f"has a {name} of {width} × {height} pixels", f"byte {place}")
    if width * height > MAX_PIXELS:
        limit = f"the limit is {MAX_PIXELS:,} pixels"
        raise FileError(path, f"has a {name} of {width:,} × {height:,} pixels; {limit}", f"byte {place}")
    return x_min, y_min, x_max, y_max


def _check_chunks(path: PathLike, reader: _Reader, count: int, stream: BinaryIO, head: int) -> None:
    """Check that the table of ``count`` chunk offsets is whole, and that the last chunk lies within the file.

    ``head``: bytes of a chunk before its data, the last four of which hold the data's size.
    """
    place = reader.at
    offsets = struct.unpack(f"<{count}Q", reader.take(8 * count))
    if 0 in offsets:
        raise FileError(path, "is incomplete: its writer was stopped before the end", f"byte {place}")
    last = max(offsets)
    end = stream.seek(0, os.SEEK_END)
    packed = 0
    if last + head < end:
        stream.seek(last + head - 4)
        # It ends before where another process cuts it off just now.
        packed = int.from_bytes(stream.read(4).ljust(4, b"\xff"), "little", signed=True)
    if packed < 0 or last + head + packed > end or last + head >= end:
        raise FileError(path, f"is cut off: pixel data is expected at byte {last:,}", f"byte {end:,}")


@dataclass(frozen=True)
class ExrLight:
    """The part and channels of the light: ``rgb``, ``grey`` (Y alone) or ``chroma`` (Y, RY, BY)."""

    header: ExrHeader
    kind: Literal["rgb", "grey", "chroma"]
    channels: tuple[ExrChannel, ...]
    notes: tuple[str, ...]


def choose_light(path: PathLike, headers: Sequence[ExrHeader]) -> ExrLight:
    """Return the first part that holds R, G and B (also in a layer), or else Y with or without its chroma.

    Raises :class:`FileError`: no part does, or what does is deep, of integers, or stored at reduced resolution.
    """
    flat = [header for header in headers if not header.deep]
    if not flat:
        raise FileError(path, "holds deep data only; flatten it to an ordinary image first", "headers")
    for find in (_rgb, _luminance):
        for header in flat:
            light = find(header)
            if light is not None:
                _check(path, light)
                return light
    known = _shown(", ".join(channel.name for header in flat for channel in header.channels))
    wanted = "R, G and B, or Y with or without RY and BY"
    raise FileError(path, f"has the channels {known}; expected {wanted}", "channels")


def _shown(text: str) -> str:
    """Return a text of the file as it can stand in a message: short, and of characters that show."""
    seen = "".join(character if character.isprintable() else "\ufffd" for character in text)
    return seen if len(seen) <= 200 else f"{seen[:200]}…"


def _part_note(header: ExrHeader) -> tuple[str, ...]:
    if header.parts == 1:
        return ()
    called = f" ({header.name!r})" if header.name else ""
    return (f"part {header.part + 1} of {header.parts}{called} was read",)


def _rgb(header: ExrHeader) -> ExrLight | None:
    by_name = {channel.name: channel for channel in header.channels}
    for prefix in ["", *sorted({name[:-1] for name in by_name if name.endswith(".R")})]:
        names = [prefix + letter for letter in "RGB"]
        if all(name in by_name for name in names):
            layer = (f"layer {prefix.rstrip('.')!r} was read",) if prefix else ()
            channels = tuple(by_name[name] for name in names)
            return ExrLight(header, "rgb", channels, _part_note(header) + layer)
    return None


def _luminance(header: ExrHeader) -> ExrLight | None:
    by_name = {channel.name: channel for channel in header.channels}
    if "Y" not in by_name:
        return None
    if "RY" in by_name and "BY" in by_name:
        note = "stored as luminance and chroma"
        return ExrLight(
            header, "chroma", (by_name["Y"], by_name["RY"], by_name["BY"]), (*_part_note(header), note)
        )
    note = "one channel, Y: the light is taken as neutral"
    return ExrLight(header, "grey", (by_name["Y"],), (*_part_note(header), note))


def _check(path: PathLike, light: ExrLight) -> None:
    for channel in light.channels:
        if channel.kind == "uint":
            raise FileError(path, "holds integers, not radiance", f"channel {_shown(channel.name)}")
        allowed = ((1, 1), (2, 2)) if channel.name in ("RY", "BY") else ((1, 1),)
        if (channel.x_sampling, channel.y_sampling) not in allowed:
            raise FileError(
                path, "is stored at reduced resolution, which is not read", f"channel {_shown(channel.name)}"
            )


def to_rgb(
    light: ExrLight, planes: Mapping[str, NDArray[np.floating]], chromaticities: Chromaticities
) -> NDArray[np.float32]:
    """Return pixels (h, w, 3) float32 of the planes by channel name.

    Luminance and chroma are RY = (R - Y)/Y, BY = (B - Y)/Y with the Y of the file's primaries ("Luminance/Chroma
    Images", technical introduction to OpenEXR); chroma at half resolution is interpolated linearly.
    """
    first = planes[light.channels[0].name].astype(np.float32)
    if light.kind == "grey":
        return np.repeat(first[..., None], 3, axis=2)
    if light.kind == "rgb":
        rest = [planes[channel.name].astype(np.float32) for channel in light.channels[1:]]
        return np.stack([first, *rest], axis=2)
    shape = first.shape
    weights = rgb_to_xyz(chromaticities)[1].astype(np.float32)
    with np.errstate(
        invalid="ignore", over="ignore"
    ):  # what is not finite is repaired, and reported with all else
        red = (_full(planes["RY"], shape) + 1.0) * first
        blue = (_full(planes["BY"], shape) + 1.0) * first
        green = (first - weights[0] * red - weights[2] * blue) / weights[1]
    return np.stack([red, green, blue], axis=2).astype(np.float32)


def _full(plane: NDArray[np.floating], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return a plane at full resolution; samples of one at half lie on even rows and columns."""
    values = plane.astype(np.float32)
    for axis in (0, 1):
        if values.shape[axis] == shape[axis]:
            continue
        at = np.minimum(np.arange(shape[axis]) / 2.0, values.shape[axis] - 1.0)
        low = at.astype(np.int64)
        high = np.minimum(low + 1, values.shape[axis] - 1)
        part = (at - low).astype(np.float32)
        part = part[:, None] if axis == 0 else part[None, :]
        values = np.take(values, low, axis) * (1.0 - part) + np.take(values, high, axis) * part
    return values

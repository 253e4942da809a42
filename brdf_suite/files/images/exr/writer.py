"""OpenEXR writer in strips, for pictures larger than memory.

Format: "OpenEXR File Layout" of the OpenEXR project: one part of scan lines, sixteen to a chunk, ZIP. Written here
because the library's writer takes whole pictures, and its one for rows is to be removed.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.primaries import Chromaticities

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
            raise FileError(path, f"cannot be written ({error.strerror})") from error


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

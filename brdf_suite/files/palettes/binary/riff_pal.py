"""PAL of Windows: a RIFF file of form ``PAL``, whose chunk ``data`` has R, G, B and flags in a byte each.

Little-endian, as all of RIFF. Chunks of other kinds are skipped by their lengths.
"""

from __future__ import annotations

import struct

from brdf_suite.documents.palette import Foreign, Palette
from brdf_suite.errors import PathLike, SuiteError
from brdf_suite.files.palettes.binary.byte_cursor import ByteCursor
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import convert_to_rgb8
from brdf_suite.files.palettes.format import PaletteFormat

_VERSION = 0x0300
_FLAGS = "pal.flags"


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a RIFF file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    cursor, collector = ByteCursor(content, path), Collector(path)
    cursor.take(4, "the signature")
    length = int.from_bytes(cursor.take(4, "the length of the file"), "little")
    if length > cursor.left:
        raise cursor.fail(f"{length:,} bytes are said to follow, {cursor.left:,} do", 4)
    if cursor.take(4, "the form") != b"PAL ":
        raise cursor.fail("is a RIFF file, but holds no palette", 8)
    found = False
    while cursor.left >= 8:
        start = cursor.at
        kind = cursor.take(4, "the kind of a chunk")
        size = int.from_bytes(cursor.take(4, "the length of a chunk"), "little")
        if size > cursor.left:
            raise cursor.fail(f"a chunk of {size:,} bytes goes beyond the end of the file", start)
        if kind == b"data" and not found:
            found = True
            _read_data(ByteCursor(content, path, cursor.at, cursor.at + size), collector)
        else:
            collector.note("{n} further part[|s] of the file skipped.")
        cursor.at = min(len(content), cursor.at + size + size % 2)
    if not found:
        raise cursor.fail("ends without a chunk of colours")
    return collector.finish()


def _read_data(chunk: ByteCursor, collector: Collector) -> None:
    start = chunk.at
    version, count = struct.unpack("<HH", chunk.take(4, "the version and the count"))
    if version != _VERSION:
        raise chunk.fail(f"version {version:#06x} is not known; 0x0300 is", start)
    if 4 * count > chunk.left:
        raise chunk.fail(f"{count:,} colours cannot lie in a chunk of {chunk.left:,} bytes", start + 2)
    collector.check_count(count, f"byte {start + 2}")
    for _ in range(count):
        place = f"byte {chunk.at}"
        red, green, blue, flags = chunk.take(4, "a colour")
        foreign: Foreign = ((_FLAGS, str(flags)),) if flags else ()
        colour = collector.colour(place, "", "RGB", (red / 255.0, green / 255.0, blue / 255.0))
        collector.add(place, colour, foreign=foreign)


def write(palette: Palette) -> bytes:
    """Return the content of a RIFF palette; :class:`SuiteError` where there are more than 65,535 entries."""
    if len(palette) > 0xFFFF:
        raise SuiteError(f"A RIFF palette holds 65,535 colours, and this one has {len(palette):,}.")
    rows = []
    for entry in palette:
        flags = dict(entry.foreign).get(_FLAGS, "0")
        rows.append(bytes((*convert_to_rgb8(entry), int(flags) & 0xFF if flags.isdecimal() else 0)))
    data = struct.pack("<HH", _VERSION, len(rows)) + b"".join(rows)
    body = b"PAL data" + struct.pack("<I", len(data)) + data
    return b"RIFF" + struct.pack("<I", len(body)) + body


FORMAT = PaletteFormat(
    name="riff",
    title="Windows palette (RIFF)",
    endings=(".pal",),
    models=("RGB",),
    holds="sRGB in 8 bits, without names.",
    sniff=lambda head, _size: head.startswith(b"RIFF") and head[8:12] == b"PAL ",
    read=read,
    write=write,
)

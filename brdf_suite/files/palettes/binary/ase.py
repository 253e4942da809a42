"""ASE (Adobe Swatch Exchange): blocks of groups and colours, big-endian.

``ASEF``, version 1.0, how many blocks; each has a type, a length and as many bytes: a group begins (0xC001, with its
name), ends (0xC002), or a colour (0x0001: name, model of four letters, 32-bit floats, kind). L* is stored from 0 to 1.
Nothing says of which white a Lab colour is; layout programs take D50 and 2°.
"""

from __future__ import annotations

import struct

from brdf_suite.documents.flat_colour import Model
from brdf_suite.documents.palette import Palette, Usage
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.binary.byte_cursor import ByteCursor, packed_utf16
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import convert_to_plain, nested_sections
from brdf_suite.files.palettes.format import PaletteFormat

_BEGIN, _END, _COLOUR = 0xC001, 0xC002, 0x0001
_MODELS: dict[bytes, tuple[Model, int]] = {
    b"RGB ": ("RGB", 3),
    b"CMYK": ("CMYK", 4),
    b"LAB ": ("Lab", 3),
    b"Gray": ("Gray", 1),
    b"GRAY": ("Gray", 1),  # some writers shout
}
_TAGS: dict[str, bytes] = {model: tag for tag, (model, _) in _MODELS.items() if tag != b"GRAY"}
_USAGES: tuple[Usage, ...] = ("global", "spot", "process")
_LONGEST = 65_000
"""Units of UTF-16 in a name, so that its count of two bytes holds it."""


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of an ASE file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    cursor, collector = ByteCursor(content, path), Collector(path)
    cursor.take(4, "the signature")
    major, minor = cursor.words(2, "the version")
    if (major, minor) != (1, 0):
        raise cursor.fail(f"version {major}.{minor} is not known; 1.0 is", 4)
    count = cursor.u32("the count of blocks")
    # A block has six bytes at least: a larger count is a damaged one.
    if 6 * count > cursor.left:
        raise cursor.fail(f"{count:,} blocks cannot lie in the {cursor.left:,} bytes that follow", 8)
    collector.check_count(count // 3, "byte 8")
    group: tuple[str, ...] = ()
    for _ in range(count):
        start = cursor.at
        kind, length = cursor.u16("the type of a block"), cursor.u32("the length of a block")
        end = cursor.at + length
        if end > len(content):
            raise cursor.fail(f"a block of {length:,} bytes goes beyond the end of the file", start)
        block = ByteCursor(content, path, cursor.at, end)
        if kind == _BEGIN:
            group = collector.group(f"byte {start}", group, _name(block))
        elif kind == _END:
            if not group:
                collector.note("{n} end[|s] of groups that never began skipped.")
            group = group[:-1]
        elif kind == _COLOUR:
            _read_colour(block, collector, group)
        else:
            collector.note("{n} block[|s] of a kind that is not known skipped.")
        cursor.at = end
    if cursor.left:
        collector.note(f"{cursor.left:,} bytes behind the last block are skipped.")
    return collector.finish()


def _name(block: ByteCursor) -> str:
    return block.utf16(block.u16("the length of a name"), "a name")


def _read_colour(block: ByteCursor, collector: Collector, group: tuple[str, ...]) -> None:
    place = f"byte {block.at}"
    name = collector.name(_name(block))
    at = block.at
    tag = block.take(4, "the model of a colour")
    if tag not in _MODELS:
        raise block.fail(f"the colour model {tag.decode('latin-1')!r} is not known", at)
    model, count = _MODELS[tag]
    values = block.floats(count, f"a colour in {model}")
    kind = block.u16("the kind of a colour")
    if kind >= len(_USAGES):
        collector.note(
            "{n} colour[|s] of a kind that is not known [counts as a process colour|count as process colours]."
        )
        kind = 2
    white = {"illuminant": "D50", "observer_deg": 2} if model == "Lab" else {}
    if model == "Lab":
        # 32 bits of L*/100: the nearest number of so many bits times 100 is what went in.
        values = (values[0] * 100.0, *values[1:])
    colour = collector.colour(place, name, model, values, **white)
    collector.add(place, colour, group=group, usage=_USAGES[kind])


def write(palette: Palette) -> bytes:
    """Return the content of an ASE file; groups within groups go within each other."""
    blocks: list[bytes] = []
    for _, entries, ended, begun in nested_sections(palette):
        blocks += [_block(_END, b"") for _ in ended]
        blocks += [_block(_BEGIN, _packed(path[-1])) for path in begun]
        for entry in entries:
            colour = convert_to_plain(entry, _TAGS)
            values = colour.values
            if colour.model == "Lab":
                values = (values[0] / 100.0, *values[1:])
            numbers = struct.pack(f">{len(values)}fH", *values, _USAGES.index(entry.usage))
            blocks.append(_block(_COLOUR, _packed(entry.name) + _TAGS[colour.model] + numbers))
    return b"ASEF" + struct.pack(">HHI", 1, 0, len(blocks)) + b"".join(blocks)


def _packed(name: str) -> bytes:
    text = packed_utf16(name[: _LONGEST // 2])
    return struct.pack(">H", len(text) // 2) + text


def _block(kind: int, content: bytes) -> bytes:
    return struct.pack(">HI", kind, len(content)) + content


FORMAT = PaletteFormat(
    name="ase",
    title="Adobe Swatch Exchange",
    endings=(".ase",),
    models=("RGB", "CMYK", "Lab", "Gray"),
    groups="nested",
    holds="Names in any script, groups, RGB, CMYK, Lab and Gray in 32-bit floats, global, spot and process colours.",
    sniff=lambda head, _size: head.startswith(b"ASEF"),
    read=read,
    write=write,
    order="by groups",
)

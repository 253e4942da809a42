"""GPL (GIMP palette): a line of text per colour, three numbers from 0 to 255 and a name.

``GIMP Palette``, then ``Name:``, ``Columns:`` and comments, then the colours. ``Channels: RGBA`` (Aseprite) adds a
fourth number, the opacity.
"""

from __future__ import annotations

import re

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_lines
from brdf_suite.files.palettes.conversions import convert_to_rgb8
from brdf_suite.files.palettes.format import PaletteFormat

_HEAD = "GIMP Palette"
_COLOUR = re.compile(r"\s*([+-]?\d{1,9})\s+([+-]?\d{1,9})\s+([+-]?\d{1,9})(?:\s+(.*?))?\s*")
_LONGEST_LINE = 1 << 20


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a GPL file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    lines = decode_lines(content, path, collector)
    if lines[0].strip() != _HEAD:
        raise collector.fail(f"does not begin with {_HEAD!r}", "line 1")
    # Counted before any is made; the head may have three lines that are neither.
    collector.check_count(sum(bool(line) and line[0] != "#" for line in lines) - 4, f"line {len(lines)}")
    name, columns, comments, opacity = "", 0, [], False
    for number, line in enumerate(lines[1:], 2):
        place = f"line {number}"
        if not line.strip():
            continue
        if len(line) > _LONGEST_LINE + 100:
            raise collector.fail(f"the line has more than {_LONGEST_LINE:,} characters", place)
        if line.startswith("#"):
            comments.append(line[1:].removeprefix(" "))
        elif not collector.entries and line.startswith("Name:"):
            name = line[5:].strip()
        elif not collector.entries and line.startswith("Columns:"):
            text = line[8:].strip()
            if text.isascii() and text.isdigit() and len(text) < 5:
                columns = int(text)
            else:
                collector.note("The count of columns is none and was skipped.")
        elif not collector.entries and line.startswith("Channels:"):
            opacity = line[9:].strip().upper() == "RGBA"
        else:
            _read_colour(line, place, collector, opacity=opacity)
    notes = collector.lines("\n".join(comments).strip("\n"))
    return collector.finish(name, notes=notes, columns=columns)


def _read_colour(line: str, place: str, collector: Collector, *, opacity: bool) -> None:
    found = _COLOUR.fullmatch(line)
    if found is None:
        raise collector.fail(f"expected three numbers and a name, not {line.strip()[:40]!r}", place)
    values = [int(found[i]) for i in (1, 2, 3)]
    if not all(0 <= value <= 255 for value in values):
        collector.note("{n} colour[|s] [has|have] numbers beyond 0 to 255, which were brought to its edge.")
        values = [min(255, max(0, value)) for value in values]
    name = found[4] or ""
    if opacity:
        first, _, rest = name.partition("\t") if "\t" in name else name.partition(" ")
        if first.isascii() and first.isdigit():
            name = rest.strip()
            if first != "255":
                collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
    collector.add(
        place, collector.colour(place, collector.name(name), "RGB", [value / 255.0 for value in values])
    )


def write(palette: Palette) -> bytes:
    """Return the content of a GPL file."""
    lines = [_HEAD, f"Name: {palette.name}"]
    if palette.columns:
        # GIMP knows no more than 255.
        lines.append(f"Columns: {min(palette.columns, 255)}")
    lines += [f"# {line}".rstrip() for line in palette.notes.split("\n")]
    for entry in palette:
        red, green, blue = convert_to_rgb8(entry)
        lines.append(f"{red:3d} {green:3d} {blue:3d}\t{entry.name}".rstrip())
    return ("\n".join(lines) + "\n").encode("utf-8", "replace")


FORMAT = PaletteFormat(
    name="gpl",
    title="GIMP palette",
    endings=(".gpl",),
    models=("RGB",),
    holds="Names in any script, sRGB in 8 bits, columns, comments; no groups.",
    sniff=lambda head, _size: head.removeprefix(b"\xef\xbb\xbf").startswith(_HEAD.encode("ascii")),
    read=read,
    write=write,
)

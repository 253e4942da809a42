"""PAL of Paint Shop Pro: ``JASC-PAL``, ``0100``, a count, and a line of three numbers per colour."""

from __future__ import annotations

import re

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_lines
from brdf_suite.files.palettes.conversions import convert_to_rgb8
from brdf_suite.files.palettes.format import PaletteFormat

_HEAD = "JASC-PAL"
_COLOUR = re.compile(r"\s*(\d{1,3})\s+(\d{1,3})\s+(\d{1,3})(?:\s+(\d{1,3}))?\s*")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a JASC file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    lines = decode_lines(content, path, collector)
    if lines[0].strip() != _HEAD:
        raise collector.fail(f"does not begin with {_HEAD!r}", "line 1")
    if len(lines) < 3 or lines[1].strip() != "0100":
        raise collector.fail("expected version 0100", "line 2")
    text = lines[2].strip()
    if not re.fullmatch(r"\d{1,7}", text, re.ASCII):
        raise collector.fail(f"expected a count of colours, not {text[:40]!r}", "line 3")
    count = int(text)
    collector.check_count(count, "line 3")
    for number, line in enumerate(lines[3:], 4):
        place = f"line {number}"
        if not line.strip():
            continue
        if len(collector.entries) == count:
            collector.note("{n} line[|s] beyond the count that the file says skipped.")
            continue
        found = _COLOUR.fullmatch(line)
        values = [int(found[i]) for i in (1, 2, 3)] if found else [256]
        if found is None or max(values) > 255:
            raise collector.fail(f"expected three numbers from 0 to 255, not {line.strip()[:40]!r}", place)
        if found[4] not in (None, "255"):
            collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
        collector.add(place, collector.colour(place, "", "RGB", [value / 255.0 for value in values]))
    if len(collector.entries) < count:
        raise collector.fail(
            f"{count:,} colours are said to follow, {len(collector.entries):,} do", f"line {len(lines)}"
        )
    return collector.finish()


def write(palette: Palette) -> bytes:
    """Return the content of a JASC palette; lines end as its program ends them."""
    rows = ["{} {} {}".format(*convert_to_rgb8(entry)) for entry in palette]
    return "".join(f"{line}\r\n" for line in (_HEAD, "0100", str(len(rows)), *rows)).encode("ascii")


FORMAT = PaletteFormat(
    name="jasc",
    title="Paint Shop Pro palette (JASC)",
    endings=(".pal", ".psppalette"),
    models=("RGB",),
    holds="sRGB in 8 bits, without names.",
    sniff=lambda head, _size: head.removeprefix(b"\xef\xbb\xbf").startswith(_HEAD.encode("ascii")),
    read=read,
    write=write,
)

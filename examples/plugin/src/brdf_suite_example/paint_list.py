"""``.paintlist``: a line ``paintlist 1``, and then a line ``RRGGBB name`` for each colour, in UTF-8."""

from __future__ import annotations

import re

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_lines
from brdf_suite.files.palettes.conversions import convert_to_rgb8
from brdf_suite.files.palettes.format import PaletteFormat

_HEAD = "paintlist 1"
_COLOUR = re.compile(r"([0-9A-Fa-f]{6})(?: (.*))?")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a paint list; a :class:`FileError` with the line where it is damaged."""
    collector = Collector(path)
    lines = decode_lines(content, path, collector)
    if lines[0].strip() != _HEAD:
        raise collector.fail(f"does not begin with {_HEAD!r}", "line 1")
    for number, line in enumerate(lines[1:], 2):
        if not line.strip():
            continue
        found = _COLOUR.fullmatch(line.strip())
        if found is None:
            raise collector.fail(f"expected RRGGBB and a name, not {line.strip()[:40]!r}", f"line {number}")
        rgb = [int(found[1][place : place + 2], 16) / 255.0 for place in (0, 2, 4)]
        name = (found[2] or "").strip()
        collector.add(f"line {number}", collector.colour(f"line {number}", name, "RGB", rgb))
    return collector.finish()


def write(palette: Palette) -> bytes:
    """Return the content of a paint list."""
    rows = ("{:02x}{:02x}{:02x} {}".format(*convert_to_rgb8(entry), entry.name).strip() for entry in palette)
    return "".join(f"{line}\n" for line in (_HEAD, *rows)).encode()


FORMAT = PaletteFormat(
    name="paint_list",
    title="Paint list (example plug-in)",
    endings=(".paintlist",),
    models=("RGB",),
    holds="Names and sRGB in 8 bits.",
    sniff=lambda head, _size: head.startswith(_HEAD.encode()),
    read=read,
    write=write,
)

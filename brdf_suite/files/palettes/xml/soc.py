"""SOC (the colour table of LibreOffice and OpenOffice): XML, a name and ``#rrggbb`` per colour.

Namespaces changed over the years, so elements are known by their local names. LibreOffice lists no colour without a
name, so equal and missing names are written with a number.
"""

from __future__ import annotations

import re

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.hardened_xml import attribute, mentions, read_root
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import convert_to_rgb8, unique_names
from brdf_suite.files.palettes.format import PaletteFormat

_HEX = re.compile("#?([0-9a-fA-F]{2})([0-9a-fA-F]{2})([0-9a-fA-F]{2})")
_NAMESPACES = (
    'xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0" '
    'xmlns:draw="urn:oasis:names:tc:opendocument:xmlns:drawing:1.0" '
    'xmlns:xlink="http://www.w3.org/1999/xlink" '
    'xmlns:svg="urn:oasis:names:tc:opendocument:xmlns:svg-compatible:1.0" '
    'xmlns:ooo="http://openoffice.org/2004/office"'
)


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a colour table; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    root = read_root(content, path, "color-table")
    collector.check_count(len(root.children), f"line {root.line}")
    for element in root.children:
        place = f"line {element.line}"
        if element.name != "color":
            collector.note("{n} element[ that is no colour|s that are no colours] skipped.")
            continue
        text = element.attributes.get("color", "")
        found = _HEX.fullmatch(text.strip())
        if found is None:
            raise collector.fail(f"expected a colour as in #336699, not {text[:40]!r}", place)
        name = collector.name(element.attributes.get("name", ""))
        collector.add(
            place, collector.colour(place, name, "RGB", [int(part, 16) / 255.0 for part in found.groups()])
        )
    return collector.finish()


def write(palette: Palette) -> bytes:
    """Return the content of a colour table."""
    rows = "".join(
        f'  <draw:color draw:name={attribute(name)} draw:color="#{bytes(convert_to_rgb8(entry)).hex()}"/>\n'
        for entry, name in zip(palette, unique_names(palette), strict=True)
    )
    text = (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<ooo:color-table {_NAMESPACES}>\n{rows}</ooo:color-table>\n'
    )
    return text.encode("utf-8")


FORMAT = PaletteFormat(
    name="soc",
    title="LibreOffice colour table",
    endings=(".soc",),
    models=("RGB",),
    holds="Names in any script, sRGB in 8 bits.",
    sniff=lambda head, _size: mentions(head, "color-table"),
    read=read,
    write=write,
    unique_names=True,
)

"""ACB of AutoCAD (a colour book in XML, not Adobe's), read only: pages of named colours in RGB.

``colorBook`` > ``bookName`` and ``colorPage`` > ``colorEntry`` > ``colorName`` and ``RGB8`` > ``red``, ``green``,
``blue``. Books of makers have ``RGB8Encrypt`` in its place, which only AutoCAD can read; such entries are left out.
Pages become groups where there are several and they have names of colours in them. Layout from a book of Resene.
"""

from __future__ import annotations

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.cxf_specification import child_number
from brdf_suite.files.hardened_xml import Element, mentions, read_root
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.format import PaletteFormat

_ENCRYPTED = "RGB8Encrypt"
_LOCKED = (
    "{n} colour[ is|s are] encrypted by the book's maker, which only AutoCAD can read, and [is|are] left out."
)


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a book; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    root = read_root(content, path, "colorBook")
    entries = [entry for page in root.all("colorPage") for entry in page.all("colorEntry")]
    collector.check_count(len(entries), f"line {root.line}")
    for entry in entries:
        _add(entry, collector)
    if not collector.entries:
        why = "all of its colours are encrypted by the book's maker" if entries else "it has no colorEntry"
        raise collector.fail(f"holds no colour that can be read: {why}", f"line {root.line}")
    name = root.first("bookName")
    return collector.finish(name.text if name is not None else "")


def _add(entry: Element, collector: Collector) -> None:
    place = f"line {entry.line}"
    rgb = entry.first("RGB8")
    if rgb is None:
        collector.note(
            _LOCKED if entry.first(_ENCRYPTED) else "{n} colour[|s] without numbers [is|are] left out."
        )
        return
    values = [child_number(rgb, name, collector.path) for name in ("red", "green", "blue")]
    if not all(0.0 <= value <= 255.0 for value in values):
        raise collector.fail("expected red, green and blue from 0 to 255", place)
    name = entry.first("colorName")
    label = collector.name(name.text if name is not None else "")
    collector.add(
        place, collector.colour(place, label, "RGB", [value / 255.0 for value in values]), usage="spot"
    )


FORMAT = PaletteFormat(
    name="autocad",
    title="AutoCAD colour book (XML)",
    endings=(".acb",),
    models=("RGB",),
    holds="Read only. Names, RGB in 8 bits; not the encrypted books of some makers.",
    sniff=lambda head, _size: mentions(head, "<colorBook"),
    read=read,
)

"""XML of instruments and of spreadsheets: colours and samples by the names of their elements or their headings.

See :mod:`brdf_suite.files.tables.xml_rows`. The layouts of instruments are not published, which the notice says.
"""

from __future__ import annotations

import re

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.hardened_xml import mentions, parse_xml
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.text.table import MOST_ROWS, add_rows
from brdf_suite.files.tables.grid import decode_head
from brdf_suite.files.tables.xml_rows import SPREADSHEET, xml_rows

_ANGLES = re.compile(r"\d{1,2}as(?:-|_|minus)?\d{2}|aspecular|\bangle|geometry|winkel", re.IGNORECASE)
_COLOURS = re.compile(r"<L\b|\bL(?:_?star)?=|<CIE_?L|Lab\b|spectr|reflect|<L\*?_?\d", re.IGNORECASE)


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of an XML file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    rows, notes = xml_rows(parse_xml(content, path), path, MOST_ROWS)
    for note in notes:
        collector.note(note)
    if not rows:
        raise collector.fail("holds no element with a colour and an angle that are known here", "line 1")
    return add_rows(rows, collector)


def _sniff(head: bytes, _size: int) -> bool:
    if mentions(head, SPREADSHEET):
        return True
    text = decode_head(head)
    return text.lstrip()[:1] == "<" and bool(_ANGLES.search(text)) and bool(_COLOURS.search(text))


FORMAT = PaletteFormat(
    name="instrument",
    title="Instrument's or spreadsheet's XML",
    endings=(".xml",),
    models=(),
    holds="Read only. Names, L*a*b*, LCh, XYZ or spectra at several angles, gloss; sparkle and graininess as notes.",
    sniff=_sniff,
    read=read,
    paints=True,
)

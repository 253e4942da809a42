"""Paints in drags and on the clipboard: whole between the programs, as text and colours for others."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QMimeData, QUrl
from PySide6.QtGui import QColor

from brdf_suite.appearance.colour.flat_colours import lab_to_hex, to_paint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette, new_id
from brdf_suite.documents.palette_store import palette_to_json
from brdf_suite.documents.store import paint_to_json
from brdf_suite.foreign_text import guard_cell
from brdf_suite.palettes.swatches.look import Content, measured_labs
from brdf_suite.regular_files import is_file

MIME = "application/x-brdf-swatches"
SOURCE_MIME = "application/x-brdf-swatches-source"
"""Run of the program and palette that swatches come from, without the swatches: read at every move of a drag."""
PAINT_MIME = "application/x-brdf-paint"

_MIDDLE_DEG = 45.0
_UNKNOWN = "#777777"


def carry(entries: Sequence[Entry], hexes: Sequence[str], source: str, owner: str) -> QMimeData:
    """Return what is put on the clipboard or dragged; ``hexes`` are ``#rrggbb`` of the 45° colours."""
    data = QMimeData()
    whole = {"owner": owner, "source": source, "palette": palette_to_json(Palette("carried", tuple(entries)))}
    data.setData(MIME, json.dumps(whole).encode())
    data.setData(SOURCE_MIME, f"{owner}\n{source}".encode("utf-8", "surrogateescape"))
    lines = [
        "\t".join((colour, _cell(entry.name), _cell(entry.code))).rstrip()
        for entry, colour in zip(entries, hexes, strict=True)
    ]
    data.setText("\n".join(lines))
    if len(entries) == 1:
        data.setColorData(QColor(hexes[0]))
        content = entries[0].content
        if not isinstance(content, FlatColour):
            data.setData(PAINT_MIME, json.dumps(paint_to_json(content), ensure_ascii=False).encode("utf-8"))
    return data


def carry_paint(content: Content, key: str) -> QMimeData:
    """Return one paint as it is dragged; where ``key`` is a file of its own, the file goes with it."""
    lab = measured_labs(to_paint(content), (_MIDDLE_DEG,))[0]
    data = carry([Entry(content, id=new_id())], [_UNKNOWN if lab is None else lab_to_hex(lab)], "", "")
    if Path(key).is_absolute() and is_file(key):
        data.setUrls([QUrl.fromLocalFile(key)])
    return data


def _cell(text: str) -> str:
    """Return a text as one cell of a table: on one line, and no formula to a spreadsheet."""
    return guard_cell(" ".join(text.split()))

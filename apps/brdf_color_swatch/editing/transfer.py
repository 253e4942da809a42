"""Swatches on the clipboard and in drags: whole between our own windows, as text and colours for other programs."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from brdf_qt.choosing.drag import MIME, PAINT_MIME, SOURCE_MIME
from brdf_qt.program.translation import tr
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QColor

from brdf_suite.appearance.colour.flat_colours import lab_to_hex
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, new_id
from brdf_suite.documents.palette_store import palette_from_json
from brdf_suite.documents.store import PAINT_ENDING, any_paint_from_json
from brdf_suite.errors import SuiteError
from brdf_suite.foreign_text import unguard_formula

_TEXT, _COLOUR, _URIS = "text/plain", "application/x-color", "text/uri-list"
TAKEN = (MIME, PAINT_MIME, _TEXT, _COLOUR, _URIS)
_MOST_LINES = 100_000
_MOST_CHARACTERS = 4_000_000
"""Of a text, which is read on the thread of the window."""
_HEX = re.compile(r"(?<![0-9A-Za-z])(?:#|0x)([0-9a-fA-F]{6}|[0-9a-fA-F]{3})(?![0-9A-Za-z])")
_RGB = re.compile(r"rgba?\(\s*(\d+)\s*[, ]\s*(\d+)\s*[, ]\s*(\d+)[^)]*\)")
_LAB = re.compile(
    # A word of its own: neither the last letter of "RAL 090 80 20", which is no L*a*b*, nor oklab's.
    r"(?<!\w)(?:(?:cie)?lab\(|L\*?\s*[=:]?\s*)(-?\d+(?:\.\d+)?)%?[\s,;]+(?:a\*?\s*[=:]?\s*)?(-?\d+(?:\.\d+)?)[\s,;]+"
    r"(?:b\*?\s*[=:]?\s*)?(-?\d+(?:\.\d+)?)(?:\s*\))?",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class Carried:
    """What a drag or the clipboard holds. ``source`` and ``ids`` say where from, for a move within this program.

    ``paints`` are files of paints, which are not read yet; ``files`` are all others.
    """

    entries: tuple[Entry, ...] = ()
    paints: tuple[Path, ...] = ()
    files: tuple[Path, ...] = ()
    source: str = ""
    owner: str = ""

    @property
    def ids(self) -> tuple[str, ...]:
        """The entries' ids in the palette that they come from."""
        return tuple(entry.id for entry in self.entries)


def can_take(data: QMimeData) -> bool:
    """Whether there may be swatches in it."""
    return any(data.hasFormat(kind) for kind in TAKEN)


def source_of(data: QMimeData) -> tuple[str, str]:
    """Return the run of the program and the palette that swatches come from; empty where they come from elsewhere."""
    text = bytes(data.data(SOURCE_MIME).data()).decode(
        "utf-8", "surrogateescape"
    )  # the name of a file may be no text
    owner, _, source = text.partition("\n")
    return owner, source


def read_data(data: QMimeData | None) -> Carried:
    """Return what a drag or the clipboard holds; nothing where it holds no colour. An empty clipboard is None.

    Raises
    ------
    SuiteError
        It says that it holds swatches or a paint, and they are not valid.
    """
    if data is None:
        return Carried()
    if data.hasFormat(MIME):
        return _whole(bytes(data.data(MIME).data()))
    if data.hasFormat(PAINT_MIME):
        return Carried((_of_paint(_json(bytes(data.data(PAINT_MIME).data()))),))
    if data.hasUrls():
        files = [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]
        paints = tuple(path for path in files if path.suffix.lower() == PAINT_ENDING)
        return Carried(paints=paints, files=tuple(path for path in files if path not in paints))
    found = entries_of_text(data.text()) if data.hasText() else []
    if found:
        return Carried(tuple(found))
    if data.hasColor():
        colour = QColor(data.colorData())
        values = (colour.redF(), colour.greenF(), colour.blueF())
        name = colour.name()
        return Carried((Entry(FlatColour(name, "RGB", values, space="sRGB"), id=new_id()),))
    return Carried()


def entries_of_text(text: str) -> list[Entry]:
    """Return the colours that a text names, a line each: ``#rrggbb``, ``rgb(…)``, ``L a b``; or a paint's file.

    What else is on the line is the name.

    >>> [(entry.name, entry.content.model) for entry in entries_of_text("#ff8800 Sunset")]
    [('Sunset', 'RGB')]

    Raises
    ------
    SuiteError
        The text is too long, or begins as a document and is not a valid one.
    """
    if len(text) > _MOST_CHARACTERS:
        what = tr(
            "The text on the clipboard has {count} characters; at most {most} are read. Save it as a file."
        )
        raise SuiteError(what.format(count=f"{len(text):,}", most=f"{_MOST_CHARACTERS:,}"))
    stripped = text.strip()
    if stripped.startswith("{"):
        value = _json(stripped.encode("utf-8"))
        if isinstance(value, dict) and value.get("format") == "brdfpalette":
            palette = palette_from_json(value, "the clipboard")
            return [replace(entry, id=new_id()) for entry in palette.entries]
        return [_of_paint(value)]
    found = (_of_line(line[:2000]) for line in stripped.splitlines()[:_MOST_LINES])
    return [entry for entry in found if entry is not None]


def _of_line(line: str) -> Entry | None:
    match = _HEX.search(line)
    if match:
        digits = match.group(1)
        digits = "".join(2 * digit for digit in digits) if len(digits) == 3 else digits
        values = tuple(int(digits[at : at + 2], 16) / 255.0 for at in (0, 2, 4))
        return _flat(line, match, "RGB", values, space="sRGB")
    match = _RGB.search(line)
    if match:
        values = tuple(min(255, int(part)) / 255.0 for part in match.groups())
        return _flat(line, match, "RGB", values, space="sRGB")
    match = _LAB.search(line)
    if match:
        lightness, a, b = (float(part) for part in match.groups())
        if 0.0 <= lightness <= 200.0 and max(abs(a), abs(b)) <= 250.0:
            return _flat(line, match, "Lab", (lightness, a, b), illuminant="D65", observer_deg=10)
    return None


def _flat(line: str, match: re.Match[str], model: str, values: tuple[float, ...], **more: object) -> Entry:
    rest = line[: match.start()] + " " + line[match.end() :]
    # Our own tables guard what a spreadsheet would take for a formula.
    rest = " ".join(unguard_formula(cell.strip()) for cell in rest.split("\t"))
    name = " ".join(re.sub(r"[;,:|]+", " ", rest).split()).strip(" -–")[:200]
    name = "".join(character for character in name if character.isprintable())
    return Entry(FlatColour(name or match.group(0), model, values, **more), id=new_id())  # type: ignore[arg-type]  # checked there


def _whole(content: bytes) -> Carried:
    value = _json(content)
    if not isinstance(value, dict) or not {"owner", "source", "palette"} <= set(value):
        raise SuiteError(tr("The swatches on the clipboard are damaged."))
    palette = palette_from_json(value["palette"], "the clipboard")
    return Carried(palette.entries, source=str(value["source"]), owner=str(value["owner"]))


def _of_paint(value: object) -> Entry:
    return Entry(any_paint_from_json(value, "the clipboard"), id=new_id())


def _json(content: bytes) -> object:
    try:
        return json.loads(content.decode("utf-8"))
    except (ValueError, RecursionError) as error:
        text = tr("The text on the clipboard is not a valid paint ({reason}).").format(reason=error)
        raise SuiteError(text) from error


def hexes_of(lab: Sequence[Sequence[float]]) -> list[str]:
    """Return ``#rrggbb`` of L*a*b* (n, 3)."""
    return [lab_to_hex(one) for one in lab]

"""CSV: a row per entry, as spreadsheets and paint formulation systems take it.

The columns of a paint are those of :mod:`brdf_suite.files.exports.csv_table` (``L_15``, ``a_15``, ``b_15`` … by angle,
``G20``, settings); before them stand what a palette adds: ``group``, ``code``, ``tags``, ``usage``, ``date`` and
``entry_notes``. A flat colour has its ``model``, ``values`` and ``space`` instead, and under ``L_45`` … what it looks
like under D65 to the 10° observer, for readers of the table.
"""

from __future__ import annotations

import csv
import io
import json
import re

from brdf_suite.appearance.colour.flat_colours import flat_labs, within_paint
from brdf_suite.documents.flat_colour import MODELS, FlatColour
from brdf_suite.documents.palette import USAGES, Entry, Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.bounded_reading import number_in
from brdf_suite.files.exports.csv_table import (
    COLUMN,
    DELIMITERS,
    Table,
    format_row,
    is_table,
    known_settings,
    table_text,
)
from brdf_suite.files.palettes.collecting import Collector, decode_text
from brdf_suite.files.palettes.conversions import as_readings
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.foreign_text import guard_formula, unguard_formula

_FIRST = ("name", "group", "code", "tags", "usage", "date", "entry_notes")
_FLAT = ("model", "values", "space", "illuminant", "observer_deg", "wavelengths")
_LAST = ("source", "notes")
_FACE = ("L_45", "a_45", "b_45")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a table; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    text = decode_text(content, path, collector)
    if not text.strip():
        raise collector.fail("is empty", "line 1")
    delimiter = max(DELIMITERS, key=text.split("\n", 1)[0].count)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    try:
        columns = [name.strip() for name in next(reader)]
        rows = _Rows(columns, collector, comma=delimiter != ",")
        # Rows are counted before any is made: a million of them are refused at once.
        lines = []
        for cells in reader:
            if any(cells):
                lines.append((reader.line_num, cells))
                collector.check_count(len(lines), f"line {reader.line_num}")
    except csv.Error as error:
        raise collector.fail(f"is not valid CSV ({error})", f"line {reader.line_num}") from error
    for line, cells in lines:
        rows.add(cells, line)
    rows.report()
    return collector.finish()


class _Rows:
    def __init__(self, columns: list[str], collector: Collector, *, comma: bool) -> None:
        self._columns, self._collector = columns, collector
        twice = [""] if len(columns) >= 10_000 else sorted({c for c in columns if columns.count(c) > 1})
        if twice:
            reason = f"the column {twice[0][:80]!r} is there twice, or there are too many"
            raise collector.fail(reason, "line 1")
        angles = [name for name in columns if COLUMN.fullmatch(name)]
        if "name" not in columns or not (angles or "model" in columns):
            raise collector.fail("has no column 'name', or none of readings as 'L_45'", "line 1")
        self._angles = angles
        self._table = Table(collector.path, angles, comma=comma)

    def report(self) -> None:
        """Record a notice about the unused columns."""
        readings = {axis + name[1:] for name in self._angles for axis in "Lab"}
        known = {*_FIRST, *_FLAT, *_LAST, "G20", "G60"} | readings | known_settings()
        for name in self._columns:
            if name not in known:
                self._collector.note(f"The column {name[:80]!r} is none of a palette's and was skipped.")
        if "G20" not in self._columns and not all(entry.is_flat for entry in self._collector.entries):
            self._collector.note("The table says nothing of gloss; the paints get 90 GU at 20°.")

    def add(self, cells: list[str], line: int) -> None:
        """Add the entry of a row."""
        collector, place = self._collector, f"line {line}"
        if len(cells) > len(self._columns):
            raise collector.fail(f"has more than {len(self._columns)} cells", place)
        row = dict(zip(self._columns, cells, strict=False))
        usage = row.get("usage", "") or "process"
        if usage not in USAGES:
            reason = f"expected one of {', '.join(USAGES)}, not {usage[:40]!r}"
            raise collector.fail(reason, f"{place}, column usage")
        collector.add(
            place,
            self._flat(row, line) if row.get("model") else self._paint(row, line),  # type: ignore[arg-type]  # paints too
            group=collector.declare(place, _parts(row.get("group", ""), "/")),
            code=unguard_formula(row.get("code", "")),
            tags=self._tags(row.get("tags", "")),
            notes=collector.lines(unguard_formula(row.get("entry_notes", ""))),
            usage=usage,
            date=row.get("date", "").strip(),
        )

    def _tags(self, text: str) -> tuple[str, ...]:
        given = _parts(text, ";")
        # People end a list with its mark, and write a tag twice.
        kept = tuple(dict.fromkeys(tag for tag in given if tag.strip()))
        if len(kept) < len(given):
            self._collector.note("In {n} row[|s] empty or repeated tags were left out.")
        return kept

    def _flat(self, row: dict[str, str], line: int) -> FlatColour:
        collector, place = self._collector, f"line {line}"
        model = row["model"].strip()
        if model not in MODELS:
            reason = f"expected one of {', '.join(MODELS)}, not {model[:40]!r}"
            raise collector.fail(reason, f"{place}, column model")
        # Spreadsheets make 10.0 or 10,0 of 10.
        degrees = row.get("observer_deg", "").strip().replace(",", ".")
        observer = number_in(collector.path, degrees or "0", line, "observer_deg")
        if observer not in (0.0, 2.0, 10.0):
            reason = f"expected 2, 10 or nothing, not {observer:g}"
            raise collector.fail(reason, f"{place}, column observer_deg")
        return collector.colour(
            place,
            collector.name(unguard_formula(row.get("name", ""))),
            model,  # type: ignore[arg-type]  # one of its words
            [number_in(collector.path, word, line, "a value") for word in row.get("values", "").split()],
            space=unguard_formula(row.get("space", "")),
            illuminant=row.get("illuminant", ""),
            observer_deg=int(observer),
            wavelengths_nm=tuple(
                number_in(collector.path, word, line, "a wavelength")
                for word in row.get("wavelengths", "").split()
            ),
        )

    def _paint(self, row: dict[str, str], line: int) -> object:
        read_at = [
            name for name in self._angles if any(row.get(axis + name[1:], "").strip() for axis in "Lab")
        ]
        if len(read_at) >= 3:
            return self._table.paint(row, line)
        if not read_at:
            raise self._collector.fail("has neither readings nor a model", f"line {line}")
        # One or two angles make no paint, but they are a colour.
        self._collector.note("{n} row[|s] [has|have] fewer than three angles and became flat colours.")
        face = "L_45" if "L_45" in read_at else read_at[0]
        lab = [number_in(self._collector.path, row.get(axis + face[1:], "").replace(",", "."), line, axis + face[1:])
               for axis in "Lab"]  # fmt: skip
        name = self._collector.name(unguard_formula(row.get("name", "")))
        return self._collector.colour(f"line {line}", name, "Lab", lab, illuminant="D65", observer_deg=10)


def write(palette: Palette) -> bytes:
    """Return a table with a row for each entry, in UTF-8 with the mark by which spreadsheets know it."""
    flat = [entry.content for entry in palette if isinstance(entry.content, FlatColour)]
    labs = dict(zip(map(id, flat), flat_labs(flat), strict=True))
    rows = [_row(entry, labs) for entry in palette]
    names = {name for row in rows for name in row}
    used = [name for name in (*_FIRST, *_FLAT) if name in names or name == "name"]
    return table_text(rows, used, _FACE).encode("utf-8-sig", "replace")


def _row(entry: Entry, labs: dict[int, object]) -> dict[str, str]:
    content = entry.content
    if isinstance(content, FlatColour):
        face = within_paint(labs[id(content)])  # type: ignore[arg-type]  # three numbers
        row = {
            "name": guard_formula(content.name),
            "model": content.model,
            "values": " ".join(map(repr, content.values)),
            **dict(zip(_FACE, map(repr, face), strict=True)),
        }
        own = {
            "space": guard_formula(content.space),
            "illuminant": content.illuminant,
            "observer_deg": str(content.observer_deg or ""),
            "wavelengths": " ".join(map(repr, content.wavelengths_nm)),
        }
    else:
        row, own = format_row(as_readings(content)), {}
    own |= {
        "group": _joined(entry.group, "/"),
        "code": guard_formula(entry.code),
        "tags": _joined(entry.tags, ";"),
        "usage": "" if entry.usage == "process" else entry.usage,
        "date": entry.date,
        "entry_notes": guard_formula(entry.notes),
    }
    return {**row, **{name: text for name, text in own.items() if text}}


def _joined(parts: tuple[str, ...], mark: str) -> str:
    """Return several texts as one cell: joined by a separator, or as JSON where one contains it or would be lost.

    The JSON has no semicolon, after which a formula could begin.
    """
    plain = mark.join(parts)
    lossless = tuple(_parts(plain, mark)) == parts and guard_formula(plain) == plain and plain[:1] != "'"
    return plain if lossless else json.dumps(list(parts), ensure_ascii=False).replace(";", "\\u003b")


def _parts(text: str, mark: str) -> tuple[str, ...]:
    if not text:
        return ()
    if text.startswith("["):
        try:
            found = json.loads(text)
        except (ValueError, RecursionError):
            found = None
        if isinstance(found, list) and all(isinstance(part, str) for part in found):
            return tuple(found)
    return tuple(part.strip() for part in re.split(re.escape(mark), text))


FORMAT = PaletteFormat(
    name="csv",
    title="CSV table with angles",
    endings=(".csv",),
    models=MODELS,
    groups="nested",
    paints=True,
    holds="Paints with L*a*b* at every angle (D65, 10°), gloss, flakes and settings; flat colours in every model; "
    "groups, codes, tags, usage, dates and notes.",
    sniff=lambda head, _size: is_table(head),
    read=read,
    write=write,
)

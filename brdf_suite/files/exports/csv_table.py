"""CSV: one row per paint, as paint formulation systems and spreadsheets take it.

Columns are ``name``, ``illuminant``, ``observer_deg``, then ``L_15``, ``a_15``, ``b_15`` … for each aspecular angle in
degrees with the light at 45° (another light is named after an ``i``: ``L_15_i20``), ``G20`` and ``G60`` in gloss units,
then the paint's settings by their names in its file, ``source`` and ``notes``. UTF-8 with the mark by which
spreadsheets know it. Numbers have every digit, so a paint read back is the same to the last bit.

Tables that a spreadsheet has saved are read, too: with semicolons or tabs, and with decimal commas then. A text that a
spreadsheet would take for a formula has an apostrophe before it.
"""

from __future__ import annotations

import csv
import dataclasses
import io
import math
import re
import types
import typing
from collections.abc import Mapping, Sequence
from functools import cache

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.paint import Gloss, Paint, solid_paint
from brdf_suite.errors import DocumentError, FileError, PathLike, SuiteError
from brdf_suite.files.exports.format import ExportFormat, ExportItem, ImportedPaints, readings_loss
from brdf_suite.files.paint_fields import Reading, build_paint, flatten_paint, setting_from_text, setting_text
from brdf_suite.files.tables.grid import decode, decode_head
from brdf_suite.foreign_text import guard_formula, unguard_formula
from brdf_suite.progress import Progress
from brdf_suite.regular_files import read_bytes

_LARGEST = 64 << 20
_MOST_ROWS = 100_000
_USUAL_LIGHT_DEG = 45.0
COLUMN = re.compile(r"L_(-?\d+(?:\.\d+)?)(?:_i(\d+(?:\.\d+)?))?")
_TEXTS = ("name", "source", "notes")
_FIRST = ("name", "illuminant", "observer_deg")
DELIMITERS = (",", ";", "\t")


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what a row cannot hold of a paint."""
    spectra = ("The spectra are left out.",) if item.spectra is not None else ()
    return (*readings_loss(item), *spectra)


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write a row per paint; raise :class:`FileError` where the disk refuses."""
    write_atomically(path, table_text([format_row(item.paint) for item in items], _FIRST).encode("utf-8-sig"))
    return ()


def table_text(rows: Sequence[Mapping[str, str]], first: Sequence[str], more: Sequence[str] = ()) -> str:
    """Return rows by their columns as CSV: ``first``, readings (``more`` among them), gloss, settings, texts."""
    names = {*more, *(name for row in rows for name in row)}
    angles = sorted((column for column in names if COLUMN.fullmatch(column)), key=parse_angles)
    colours = [axis + column[1:] for column in angles for axis in "Lab"]
    settings = sorted(names - {*colours, *first, *_TEXTS, "G20", "G60"})
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, [*first, *colours, "G20", "G60", *settings, "source", "notes"], restval="")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def format_row(paint: Paint) -> dict[str, str]:
    """Return the cells of a paint by their columns."""
    row = {
        "name": guard_formula(paint.name),
        "illuminant": paint.illuminant,
        "observer_deg": str(paint.observer_deg),
        "G20": repr(paint.gloss.gu_20),
        "G60": "" if paint.gloss.gu_60 is None else repr(paint.gloss.gu_60),
        "source": guard_formula(paint.source),
        "notes": guard_formula(paint.notes),
    }
    for reading in paint.measurements:
        at = f"_{_plain(reading.aspecular_deg)}"
        if reading.illumination_deg != _USUAL_LIGHT_DEG:
            at += f"_i{_plain(reading.illumination_deg)}"
        row.update({axis + at: repr(value) for axis, value in zip("Lab", reading.lab, strict=True)})
    row.update({name: setting_text(value) for name, value in flatten_paint(paint).items()})
    return row


def _plain(angle_deg: float) -> str:
    """Return an angle without an exponent, with every digit."""
    return f"{angle_deg:.17f}".rstrip("0").rstrip(".") if angle_deg % 1 else f"{angle_deg:.0f}"


def parse_angles(column: str) -> tuple[float, float]:
    """Return (light, aspecular) of a lightness column, degrees; the usual light first."""
    found = COLUMN.fullmatch(column)
    assert found is not None  # only such columns are asked about
    light = _USUAL_LIGHT_DEG if found[2] is None else float(found[2])
    return (-1.0 if light == _USUAL_LIGHT_DEG else light, float(found[1]))


def is_table(head: bytes) -> bool:
    """Return whether the first bytes of a file are those of a table of paints."""
    lines = decode_head(head).splitlines()
    line = lines[0] if lines else ""
    return any(
        "name" in (cells := [cell.strip().strip('"') for cell in line.split(delimiter)])
        and any(COLUMN.fullmatch(cell) for cell in cells)
        for delimiter in DELIMITERS
    )


def read(path: PathLike) -> ImportedPaints:
    """Return the paints of a table.

    Raises
    ------
    FileError
        It is no such table, or a row is no paint; with the line and the column. Nothing is partly read.
    """
    content = read_bytes(path, _LARGEST)
    found = decode(content)
    if found is None or found[1]:
        raise FileError(path, "is not text in UTF-8 or UTF-16", "byte 0")
    text = found[0]
    header = text.split("\n", 1)[0]
    delimiter = max(DELIMITERS, key=header.count)
    # A larger cell is met in no table of paints; the module's own bound raises an error of its own kind.
    reader = csv.DictReader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    try:
        columns = [name.strip() for name in reader.fieldnames or []]
    except csv.Error as error:
        raise FileError(path, f"is not valid CSV ({error})", f"line {reader.line_num}") from error
    reader.fieldnames = columns
    if len(set(columns)) < len(columns):
        twice = next(name for name in columns if columns.count(name) > 1)
        raise FileError(path, f"the column {twice[:80]!r} is there twice", "line 1")
    angles = [name for name in columns if COLUMN.fullmatch(name)]
    if "name" not in columns or not angles:
        raise FileError(
            path, "has no columns name and L_15 (or of another angle), so it is no table of paints", "line 1"
        )
    paints: list[Paint] = []
    table = Table(path, angles, comma=delimiter != ",")
    try:
        for row in reader:
            if len(paints) >= _MOST_ROWS:
                raise FileError(path, f"has more than {_MOST_ROWS:,} rows", f"line {reader.line_num}")
            if None in row:  # where the module puts what stands beyond the last column
                raise FileError(path, f"has more than {len(columns)} cells", f"line {reader.line_num}")
            if any(row.values()):
                paints.append(table.paint(row, reader.line_num))
    except csv.Error as error:
        raise FileError(path, f"is not valid CSV ({error})", f"line {reader.line_num}") from error
    if not paints:
        raise FileError(path, "holds no paint", "line 2")
    known = {*_FIRST, *_TEXTS, "G20", "G60", *(axis + name[1:] for name in angles for axis in "Lab")}
    unknown = [name for name in columns if name not in known | table.settings]
    notes = [f"The column {name[:80]!r} is none of a paint's and was skipped." for name in unknown]
    if "G20" not in columns:
        notes.append("The table says nothing of gloss; the paints get 90 GU at 20°.")
    return ImportedPaints(tuple(paints), tuple(notes))


class Table:
    """Converter from rows to paints; ``settings`` are the columns recognised as a paint's."""

    def __init__(self, path: PathLike, angles: list[str], *, comma: bool) -> None:
        self._path, self._angles, self._comma = path, angles, comma
        self.settings: set[str] = set()

    def paint(self, row: Mapping[str, str | None], line: int) -> Paint:
        """Return the paint of one row."""
        self._check_light(row, line)
        readings: list[Reading] = []
        for column in self._angles:
            cells = [axis + column[1:] for axis in "Lab"]
            if not any((row.get(cell) or "").strip() for cell in cells):
                continue  # this paint was not read at the angle
            found = COLUMN.fullmatch(column)
            assert found is not None
            light = _USUAL_LIGHT_DEG if found[2] is None else float(found[2])
            lightness, a, b = (self._number(row, cell, line) for cell in cells)
            readings.append((light, float(found[1]), (lightness, a, b)))
        known = known_settings()
        texts = {name: (row.get(name) or "").strip() for name in known}
        settings = {name: setting_from_text(self._dotted(text)) for name, text in texts.items() if text}
        self.settings |= known & row.keys()
        try:
            gloss = Gloss(
                self._number(row, "G20", line) if (row.get("G20") or "").strip() else 90.0,
                self._number(row, "G60", line) if (row.get("G60") or "").strip() else None,
            )
            name, source, notes = (unguard_formula(row.get(text) or "") for text in _TEXTS)
            return build_paint(name, readings, gloss, settings, notes, source, path=str(self._path))
        except DocumentError as error:
            raise FileError(self._path, error.reason, f"line {line}, {error.place}") from error
        except FileError:
            raise
        except SuiteError as error:
            raise FileError(self._path, str(error).rstrip("."), f"line {line}") from error

    def _check_light(self, row: Mapping[str, str | None], line: int) -> None:
        illuminant = (row.get("illuminant") or "D65").strip()
        observer = (row.get("observer_deg") or "10").strip()
        if illuminant != "D65" or observer not in ("10", "10.0", "10°"):
            raise FileError(
                self._path,
                f"colours of {illuminant[:20]} and the {observer[:20]}° observer cannot become those of D65 and 10° "
                "without a spectrum",
                f"line {line}",
            )

    def _dotted(self, text: str) -> str:
        return text.replace(",", ".") if self._comma and re.fullmatch(r"[-+]?\d+,\d+", text) else text

    def _number(self, row: Mapping[str, str | None], column: str, line: int) -> float:
        text = (row.get(column) or "").strip()
        try:
            value = math.nan if "_" in text else float(self._dotted(text))
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise FileError(
                self._path, f"expected a finite number, not {text[:40]!r}", f"line {line}, column {column}"
            )
        return value


@cache
def known_settings() -> frozenset[str]:
    """Return the names of every setting that a paint can have."""
    found = set(flatten_paint(solid_paint("any", (50.0, 0.0, 0.0))))
    for name, hint in typing.get_type_hints(Paint).items():
        # A part that may be absent: Flakes | None, and whatever else paints get.
        for kind in typing.get_args(hint) if isinstance(hint, types.UnionType) else ():
            if dataclasses.is_dataclass(kind):
                found |= {f"{name}.{part.name}" for part in dataclasses.fields(kind)}
    return frozenset(found)


FORMAT = ExportFormat(
    name="csv",
    title="CSV table, one row per paint",
    ending=".csv",
    holds="L*a*b* at every angle (D65, 10°), gloss, flakes and every other setting of a designed paint, texts.",
    losses=losses,
    write=write,
    read=read,
    sniff=is_table,
    many=True,
)

"""Plain tables, CSV and TSV: colours in the columns that people have, and samples read at several angles.

A column is known by its heading (:mod:`brdf_suite.files.tables.columns`), in any order; where a table has no headings,
a hex code, or a name and three numbers from 0 to 255, is enough. Separators are tabs, semicolons, bars, commas or wide
spaces; decimals may have a comma. Of several models in one row, the one that says most about the look comes first:
spectrum, L*a*b*, RGB, and CMYK last.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from brdf_suite.appearance.colour.flat_colours import WHITES
from brdf_suite.documents.flat_colour import FlatColour, Model
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.palettes.collecting import MOST_COLOURS, Collector, decode_text
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.sample_entries import add_samples
from brdf_suite.files.palettes.text.css import parse_colour
from brdf_suite.files.palettes.text.hex_list import find_opacity
from brdf_suite.files.tables.columns import WHOLE, plain_word
from brdf_suite.files.tables.finding import WANTED, Table, check_cells, find_table
from brdf_suite.files.tables.grid import TableRow, decode_head, parse_number, read_rows
from brdf_suite.files.tables.readings import read_samples

_ORDER: tuple[Model, ...] = ("spectrum", "Lab", "LCh", "XYZ", "RGB", "HSL", "HSB", "Gray", "CMYK", "CMY")
_WITH_WHITE = ("Lab", "LCh", "XYZ")
_CHANNELS = {"Gray": "g", "HSB": "hsb"}
_BARE_HEX = re.compile(r"(?:0x)?([0-9a-fA-F]{6}|[0-9a-fA-F]{8})")
_THREE_DIGITS = re.compile(r"[0-9a-fA-F]{3}")
_SHORT_NUMBER = re.compile(r"\d{1,5}")
_IN_CELL = re.compile(r"\d+(?:\.\d+)?%?")
_SIGNED_IN_CELL = re.compile(r"[-+\u2212]?\d+(?:\.\d+)?")
MOST_ROWS = 12 * MOST_COLOURS
_MOST_XYZ = 1.3
_RANGE = {"RGB": 255.0, "CMYK": 100.0, "CMY": 100.0, "HSL": 100.0, "HSB": 100.0, "Gray": 255.0}
"""What is full where no value is a fraction of 1; of HSL and HSB all but the hue."""


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a table; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    rows = read_rows(decode_text(content, path, collector), path, MOST_ROWS)
    if not rows:
        raise collector.fail("is empty", "line 1")
    return add_rows(rows, collector)


def add_rows(rows: Sequence[TableRow], collector: Collector) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of the rows of a table, whose notices so far are the collector's.

    Raises :class:`FileError`: the rows are no such table, or a cell is damaged; with the line.
    """
    table = find_table(rows)
    if table is None:
        shown = ", ".join(repr(cell[:30]) for cell in rows[0].cells[:8])
        raise collector.fail(
            f"has the columns {shown}; wanted are name (or none) and {WANTED}", f"line {rows[0].line}"
        )
    check_cells(table, collector.path)
    if table.is_of_angles:
        add_samples(collector, read_samples(table, collector.path), f"line {rows[0].line}")
        return collector.finish(table.about.get("group", ""))
    collector.check_count(len(table.rows), f"line {rows[-1].line}")
    _FlatRows(table, collector).add_all()
    if not collector.entries:
        raise collector.fail("holds no colour below its headings", f"line {rows[-1].line}")
    return collector.finish(table.about.get("group", ""))


@dataclass
class _Part:
    """The columns of one model: its channels' places, or the place of a cell with all of them."""

    model: Model
    channels: dict[str, int] = field(default_factory=dict)
    whole: int | None = None
    white: tuple[str, int] = ("", 0)
    full: float = 1.0
    turn: float = 1.0  # what a hue of 1 is in degrees


class _FlatRows:
    def __init__(self, table: Table, collector: Collector) -> None:
        self._table, self._collector = table, collector
        self._parts = self._find_parts()
        self._short = {index for index in table.of("hex") if self._is_short(index)}
        self._decimal = {
            index
            for index in self._short
            if all(_code(row, index).isdecimal() for row in table.rows if _code(row, index))
        }
        self._hex = {index: self._opacity(index) for index in table.of("hex")}
        if not table.headed:
            collector.note("The table has no headings; its columns were recognised by what is in them.")
        for column in table.columns:
            if not column.what and column.heading:
                collector.note(f"The column {column.heading[:80]!r} is none of a palette's and was skipped.")

    def add_all(self) -> None:
        """Add an entry for each row that has a colour."""
        for row in self._table.rows:
            colours = [colour for part in self._parts if (colour := self._colour(part, row)) is not None]
            colours += [colour for index in self._hex if (colour := self._from_hex(row, index)) is not None]
            if not colours:
                self._collector.note("{n} row[|s] without a colour [was|were] skipped.")
                continue
            self._add(row, colours)

    def _add(self, row: TableRow, colours: list[FlatColour]) -> None:
        collector, text, place = self._collector, self._table.text, f"line {row.line}"
        colours.sort(key=lambda colour: _ORDER.index(colour.model))
        first, *others = colours
        # RGB and its hex code are one colour.
        others = [
            one for one in others if not (one.model == first.model and _close(one.values, first.values))
        ]
        group = text(row, "group")
        name, code = text(row, "name"), text(row, "code")
        collector.add(
            place,
            collector.colour(
                place, collector.name(name or code), first.model, first.values, space=first.space,
                illuminant=first.illuminant, observer_deg=first.observer_deg, wavelengths_nm=first.wavelengths_nm,
                others=tuple(others[:16]),
            ),
            group=collector.declare(place, [group]) if group else (),
            code=collector.name(code, 200) if name else "",
            notes=collector.lines(text(row, "notes")),
        )  # fmt: skip

    def _find_parts(self) -> list[_Part]:
        found: dict[tuple[object, ...], _Part] = {}
        for index, column in enumerate(self._table.columns):
            model, dot, channel = column.what.partition(".")
            if column.what in WHOLE.values():
                found[column.what, index] = _Part(column.what, whole=index, white=column.white)  # type: ignore[arg-type]  # one of its words
            elif dot or column.nm:
                key = (model, column.geometry, column.white)
                part = found.setdefault(key, _Part(model if dot else "spectrum", white=column.white))  # type: ignore[arg-type]  # one of its words
                name = channel if dot else f"{column.nm:g}"
                if name in part.channels:
                    raise self._collector.fail(
                        f"the column {column.heading[:80]!r} is there twice, and no heading says what each is",
                        "the header",
                    )
                part.channels[name] = index
        whole = [part for part in found.values() if self._is_whole(part)]
        for part in whole:
            part.full = self._full(part)
            self._check_first(part)
        return whole

    @staticmethod
    def _is_whole(part: _Part) -> bool:
        wanted = 3 if part.model == "spectrum" else len(_CHANNELS.get(part.model, part.model))
        return part.whole is not None or len(part.channels) >= wanted

    def _texts(self, part: _Part, row: TableRow) -> list[str]:
        if part.whole is not None:
            cell = row.cell(part.whole)
            # With semicolons between the numbers, commas are their decimal marks.
            cell = cell.replace(",", ".") if ";" in cell and "." not in cell else cell
            # Between shares a hyphen is a mark, as in 205-186-136.
            return (_SIGNED_IN_CELL if part.model in _WITH_WHITE else _IN_CELL).findall(cell)
        if part.model == "spectrum":
            return [row.cell(part.channels[name]) for name in sorted(part.channels, key=float)]
        return [row.cell(part.channels[name]) for name in _CHANNELS.get(part.model, part.model.lower())]

    def _check_first(self, part: _Part) -> None:
        """Take hues for shares of the circle, or say that lightness is nearly 0, where no number is above 1."""
        texts = [found[0] for row in self._table.rows if (found := self._texts(part, row))]
        numbers = [abs(value) for text in texts if (value := parse_number(text)) is not None]
        if not 0.0 < max(numbers, default=0.0) <= 1.0:
            return
        if part.model in ("Lab", "LCh"):
            self._collector.note(
                "No L* is above 1, which is nearly black; Oklab, and L from 0 to 1, are not known from CIELAB here."
            )
        place = part.channels.get("h", part.whole)
        heading = "" if place is None else self._table.columns[place].heading
        degrees = "°" in "".join((heading, *texts)) or "deg" in heading.lower() or "360" in heading
        if part.model in ("HSL", "HSB") and part.full == 1.0 and not degrees:
            self._collector.note(
                f"No number of {part.model} is above 1; hues are taken for shares of the circle."
            )
            part.turn = 360.0

    def _full(self, part: _Part) -> float:
        """Return what is full in a model's columns: 1, 100 or 255, by the whole table."""
        columns = self._table.columns
        places = list(part.channels.values()) if part.whole is None else [part.whole]
        if part.model in ("Lab", "LCh"):
            return 1.0
        start = 1 if part.model in ("HSL", "HSB") else 0
        texts = [text for row in self._table.rows for text in self._texts(part, row)[start:]]
        numbers = [value for text in texts if (value := parse_number(text)) is not None]
        most = max(map(abs, numbers), default=0.0)
        if any(columns[i].percent for i in places) or (texts and all("%" in text for text in texts if text)):
            return 100.0
        if part.model == "XYZ":
            small = 0.0 < most <= _MOST_XYZ
            if small:
                self._collector.note("X, Y and Z are taken for those of a white of 1.")
            return 0.01 if small else 1.0
        if part.model == "spectrum":
            # Reflectance of a flat colour passes 1 by fluorescence at most.
            return 1.0 if most <= 1.5 else 100.0
        if any("0-1" in columns[i].heading or "0..1" in columns[i].heading for i in places):
            return 1.0
        if most > 1.0 or any("255" in columns[i].heading or "100" in columns[i].heading for i in places):
            return _RANGE[part.model]
        if most == 1.0 and all(value in (0.0, 1.0) for value in numbers):
            self._collector.note(f"{part.model} has no number but 0 and 1; 1 is taken for full.")
        return 1.0

    def _colour(self, part: _Part, row: TableRow) -> FlatColour | None:
        collector, place = self._collector, f"line {row.line}"
        texts = self._texts(part, row)
        if not any(texts):
            return None
        values = [parse_number(text) for text in texts]
        wanted = (
            len(part.channels) if part.model == "spectrum" else len(_CHANNELS.get(part.model, part.model))
        )
        if None in values or len(values) != wanted:
            shown = (
                row.cell(part.whole)
                if part.whole is not None
                else texts[values.index(None)]
                if None in values
                else ""
            )
            raise collector.fail(f"expected {wanted} numbers of {part.model}, not {shown[:40]!r}", place)
        numbers = [value for value in values if value is not None]
        if part.model == "spectrum":
            bands = tuple(float(name) for name in sorted(part.channels, key=float))
            return collector.colour(
                place, "", "spectrum", [n / part.full for n in numbers], wavelengths_nm=bands
            )
        if part.model in _WITH_WHITE:
            light, observer = self._white(part, row)
            if part.model == "XYZ":
                numbers = [n / part.full for n in numbers]
            return collector.colour(place, "", part.model, numbers, illuminant=light, observer_deg=observer)
        scaled = [n / part.full for n in numbers]
        if part.model in ("HSL", "HSB"):
            scaled[0] = numbers[0] * part.turn
        shares = scaled[1:] if part.model in ("HSL", "HSB") else scaled
        if max(shares) > 1.0 + 1e-9 or min(shares) < 0.0:
            raise collector.fail(
                f"expected {part.model} from 0 to {part.full:g}, not {' '.join(texts)[:40]}", place
            )
        return collector.colour(place, "", part.model, scaled)

    def _white(self, part: _Part, row: TableRow) -> tuple[str, int]:
        light, observer = part.white
        said = self._table.text(row, "illuminant") or self._table.about.get("illuminant", "")
        if not light and said:
            word = said.replace(" ", "").upper()
            light, _, degrees = word.replace("-", "/").partition("/")
            observer = int(digits) if (digits := degrees.strip("°")) in ("2", "10") else 0
        watched = (self._table.text(row, "observer") or self._table.about.get("observer", "")).strip(" °")
        if not observer and watched.partition(".")[0] in ("2", "10"):
            observer = int(watched.partition(".")[0])
        if light and (light, observer or 2) not in WHITES:
            self._collector.note(
                f"The light {light[:40]!r} is not known here; its colours count as those of D50 and 2°."
            )
            return "", 0
        return light[:50], observer

    def _is_short(self, index: int) -> bool:
        """Return whether all codes of a column have three digits, which are then no numbers that lost their zeros."""
        codes = [code for row in self._table.rows if (code := _code(row, index))]
        return bool(codes) and all(map(_THREE_DIGITS.fullmatch, codes))

    def _opacity(self, index: int) -> str:
        """Return where the codes of a column have their opacity, ``first`` or ``last``."""
        heading = plain_word(self._table.columns[index].heading)
        if "argb" in heading or "rgba" in heading:
            return "first" if "argb" in heading else "last"
        codes = (_BARE_HEX.fullmatch(_code(row, index).removeprefix("#")) for row in self._table.rows)
        return find_opacity((code[1] for code in codes if code), self._collector)

    def _from_hex(self, row: TableRow, index: int) -> FlatColour | None:
        text = _code(row, index)
        if not text:
            return None
        bare = _BARE_HEX.fullmatch(text)
        if index in self._short:
            if index in self._decimal:
                self._collector.note(
                    "{n} hex code[|s] of three digits [is|are] taken for [a short one|short ones], as #369 for "
                    "#336699, and not for [a number that has lost its|numbers that have lost their] zeros."
                )
            text = f"#{text}"
        elif _SHORT_NUMBER.fullmatch(text):
            self._collector.note(
                "{n} hex code[|s] had lost [its|their] zeros, as spreadsheets take them; they are put back."
            )
            text = f"#{text:0>6}"
        elif bare:
            text = f"#{bare[1]}"
        if len(text) == 9 and self._hex[index] == "first":
            text = f"#{text[3:]}{text[1:3]}"
        found = parse_colour(text)
        if found is None:
            raise self._collector.fail(
                f"expected a hex code as in #336699, not {text[:40]!r}", f"line {row.line}"
            )
        if found[1] != 1.0:
            self._collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
        return found[0]


def _code(row: TableRow, index: int) -> str:
    return row.cell(index).strip("\"' ")


def _close(one: Sequence[float], other: Sequence[float]) -> bool:
    return len(one) == len(other) and all(
        math.isclose(a, b, abs_tol=0.003) for a, b in zip(one, other, strict=True)
    )


def _sniff(head: bytes, _size: int) -> bool:
    """Return whether the first lines have headings of colours; prose and tables of anything else have none."""
    text = decode_head(head)
    if not text or text.lstrip()[:1] in ("<", "{", "["):
        return False
    try:
        rows = read_rows("\n".join(text.splitlines()[:80]), "", 100)
        return bool(rows) and find_table(rows) is not None
    except (FileError, ValueError):
        return False


FORMAT = PaletteFormat(
    name="table",
    title="Plain table (CSV, TSV)",
    endings=(".tsv", ".csv", ".txt"),
    models=(),
    holds="Read only. Names, codes, groups and notes; hex, RGB, L*a*b*, LCh, XYZ, CMYK, HSL, HSB, spectra; samples of "
    "instruments at several angles.",
    sniff=_sniff,
    read=read,
    paints=True,
)

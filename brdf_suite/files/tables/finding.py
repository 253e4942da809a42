"""Where in the rows of a file its table begins, what its columns are, and what the lines before it say."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.tables.columns import (
    TEXTS,
    WHOLE,
    Geometry,
    TableColumn,
    interpret,
    parse_geometry,
    plain_word,
)
from brdf_suite.files.tables.grid import TableRow, parse_number

_HEAD_ROWS = 60
_FEWEST_ANGLES = 2
_LEAST_BANDS = 3
_HEX = re.compile(r"(?:#|0x)?(?:[0-9a-fA-F]{6}|[0-9a-fA-F]{8})|#[0-9a-fA-F]{3,4}")
_CSS = re.compile(r"(?:rgba?|hsla?|hwb|(?:ok)?(?:lab|lch)|color)\([^()]{1,80}\)", re.IGNORECASE)
_WAVELENGTH = re.compile(r"(?:wavelengths?|wellenlängen?|lambda|wl|λ)?(?:nm|innm)?")
_UNIT = re.compile(r"[\W_]*|[(\[]?(?:nm|deg|gu|units?|einheit|per ?cent)[)\]]?", re.IGNORECASE)
_READ_AT_ANGLES = ("Lab.", "LCh.", "XYZ.", "spectrum")
_LONE = ("Gray.g", "hex", *WHOLE.values())
WANTED = (
    "hex, or R G B, L a b, L C h, X Y Z, C M Y K, H S L or H S B, or L15 a15 b15 and so on for several angles, or "
    "wavelengths as 400 410 420"
)
"""What a heading must name, for messages."""


@dataclass(frozen=True)
class Table:
    """A table: its columns, its rows, and the texts by kind (:data:`TEXTS`) that stand before it.

    ``headed`` is False where there are no headings and the columns are known by what is in them.
    """

    columns: tuple[TableColumn, ...]
    rows: tuple[TableRow, ...]
    about: dict[str, str] = field(default_factory=dict)
    headed: bool = True

    def of(self, what: str) -> list[int]:
        """Return the places of the columns of one kind."""
        return self._places.get(what, [])

    @cached_property
    def _places(self) -> dict[str, list[int]]:
        found: dict[str, list[int]] = {}
        for index, column in enumerate(self.columns):
            found.setdefault(column.what, []).append(index)
        return found

    def text(self, row: TableRow, what: str) -> str:
        """Return the first cell of a kind that is not empty."""
        return next((row.cell(i) for i in self.of(what) if row.cell(i)), "")

    @property
    def is_of_angles(self) -> bool:
        """Whether its colours were read at several angles."""
        angles = {c.geometry for c in self.columns if c.geometry and c.what.startswith(_READ_AT_ANGLES)}
        at = self.of("geometry")
        if at and not angles:
            angles = {angle for row in self.rows if (angle := parse_geometry(row.cell(at[0]))) is not None}
        return len(angles) >= _FEWEST_ANGLES


def check_cells(table: Table, path: PathLike) -> None:
    """Refuse rows with more cells than headings, and headings that number readings in the place of angles.

    The first are rows whose decimal commas were taken for separators; raises :class:`FileError` with the line.
    """
    width = len(table.columns)
    for row in table.rows:
        if any(row.cells[width:]):
            count = len(row.cells)
            reason = f"has {count} cells under {width} headings; a decimal comma may have been taken for a separator"
            raise FileError(path, reason, f"line {row.line}")
    angles = {c.geometry[1] for c in table.columns if c.geometry and c.what.startswith(_READ_AT_ANGLES)}
    if len(angles) > 1 and angles <= set(range(10)):
        numbers = ", ".join(f"{angle:g}" for angle in sorted(angles))
        raise FileError(
            path, f"the headings number readings {numbers}; wanted are angles, as 15, 25, 45", "the header"
        )


def find_table(rows: Sequence[TableRow]) -> Table | None:
    """Return the table in the rows of a file; None where there is none that is known here."""
    for index, row in enumerate(rows[:_HEAD_ROWS]):
        columns = interpret(row.cells)
        if has_whole_colour(columns) or _hex_columns(columns, rows[index + 1 :]):
            return _table(columns, rows, index, index + 1)
        following = rows[index + 1] if index + 1 < len(rows) else None
        # Of lines above a heading that has its angles, numbers are none.
        if following is not None and _is_upper(row, following) and not _has_angles(following):
            columns = interpret(_joined(row, following))
            if has_whole_colour(columns):
                return _table(columns, rows, index, index + 2)
        if _is_turned(rows, index):
            return _turned(rows)
    return _without_headings(rows)


def _has_angles(row: TableRow) -> bool:
    """Return whether a row is the whole heading of colours at angles."""
    columns = interpret(row.cells)
    return has_whole_colour(columns) and any(
        column.what == "geometry" or column.geometry for column in columns
    )


def _table(columns: tuple[TableColumn, ...], rows: Sequence[TableRow], before: int, first: int) -> Table:
    columns = _settled(columns, rows[first : first + _HEAD_ROWS])
    data = list(rows[first:])
    # A row of units below the headings.
    if data and all(_UNIT.fullmatch(cell) for cell in data[0].cells):
        data = data[1:]
    return Table(columns, tuple(data), _said(rows[:before]))


def _settled(columns: tuple[TableColumn, ...], rows: Sequence[TableRow]) -> tuple[TableColumn, ...]:
    """Say of a column ``Color`` whether it has hex codes or names; an unknown first column of texts has names."""
    found = list(columns)
    codes = _hex_columns(columns, rows)
    for index, column in enumerate(columns):
        if column.what == "colour":
            other = "code" if _is_called_code(column) else "name"
            found[index] = TableColumn(column.heading, "hex" if index in codes else other)
    if not any(column.what == "name" for column in found):
        for index, column in enumerate(found):
            cells = [row.cell(index) for row in rows if row.cell(index)]
            texts = bool(cells) and not any(parse_number(cell) is not None for cell in cells)
            if not column.what and texts and not any(map(_HEX.fullmatch, cells)):
                found[index] = TableColumn(column.heading, "name")
                break
    return tuple(found)


def _said(rows: Sequence[TableRow]) -> dict[str, str]:
    """Return what lines of a word and a text before a table say, as ``Illuminant: D65``."""
    found: dict[str, str] = {}
    for row in rows:
        cells = [cell for cell in row.cells if cell]
        if len(cells) == 1 and ":" in cells[0]:
            word, _, text = cells[0].partition(":")
            cells = [word, text.strip()]
        if len(cells) >= 2 and cells[1]:
            what = TEXTS.get(plain_word(cells[0]))
            if what is not None:
                found.setdefault(what, cells[1])
    return found


def has_whole_colour(columns: Sequence[TableColumn]) -> bool:
    """Return whether all channels of a model are there, at one angle and in one light, or a spectrum."""
    parts: dict[object, set[str]] = {}
    bands: dict[object, int] = {}
    for column in columns:
        model, dot, channel = column.what.partition(".")
        if column.what in _LONE:
            return True
        if dot:
            parts.setdefault((model, column.geometry, column.white), set()).add(channel)
        if column.what == "spectrum":
            bands[column.geometry] = bands.get(column.geometry, 0) + 1
    return any(len(found) == len(key[0]) for key, found in parts.items() if isinstance(key, tuple)) or any(
        count >= _LEAST_BANDS for count in bands.values()
    )


def _hex_columns(columns: Sequence[TableColumn], rows: Sequence[TableRow]) -> list[int]:
    """Return the places of columns called colour that have hex codes, or colours as CSS writes them, below them.

    One that is called code has numbers of articles where all are digits, or where another column gives the colour.
    """
    found: dict[bool, list[int]] = {False: [], True: []}
    for index, column in enumerate(columns):
        if column.what == "colour":
            cells = [row.cell(index) for row in rows[:_HEAD_ROWS] if row.cell(index)]
            numbers = _is_called_code(column) and all(map(str.isdecimal, cells))
            if cells and not numbers and all(map(_is_code, cells)):
                found[_is_called_code(column)].append(index)
    if any(column.what == "hex" for column in columns):
        return []
    return found[False] or ([] if has_whole_colour(columns) else found[True])


def _is_called_code(column: TableColumn) -> bool:
    return plain_word(column.heading).endswith("code")


def _is_code(cell: str) -> bool:
    return bool(_HEX.fullmatch(cell) or _CSS.fullmatch(cell))


def _is_upper(row: TableRow, following: TableRow) -> bool:
    """Return whether a row has the angles over the channels of the next one."""
    angles = sum(
        interpret([cell])[0].geometry is not None or parse_geometry(cell) is not None
        for cell in row.cells
        if cell
    )
    numbers = [parse_number(cell) for cell in following.cells]
    # Wavelengths are numbers, too.
    return angles >= _FEWEST_ANGLES and all(number is None or number >= 300.0 for number in numbers)


def _joined(row: TableRow, following: TableRow) -> list[str]:
    above, texts = "", []
    for index in range(max(len(row.cells), len(following.cells))):
        cell = row.cell(index)
        above = cell or above
        angle = parse_geometry(above)
        shown = f"{angle[1]:g}°" if angle and not re.search("[aA][sS]", above) else above
        plain = TEXTS.get(plain_word(following.cell(index)))
        texts.append(
            following.cell(index) if plain or (not angle and not cell) else f"{shown} {following.cell(index)}"
        )
    return texts


def _is_turned(rows: Sequence[TableRow], index: int) -> bool:
    """Return whether a row has the angles, and the rows below it a quantity each."""
    found = _angles(rows[index])
    if len(found) <= _FEWEST_ANGLES:
        return False
    words = [interpret([row.cell(0)])[0] for row in rows[index + 1 : index + 9]]
    labels = [plain_word(row.cell(0)) for row in rows[index + 1 : index + 9]]
    bands = sum(bool(re.fullmatch(r"r?[3-9]\d\d(nm)?", label)) for label in labels)
    return {"l", "a", "b"} <= set(labels) or bands > 3 or any(word.what.startswith("Lab") for word in words)


def _angles(row: TableRow) -> dict[int, Geometry]:
    found = {i: parse_geometry(cell) for i, cell in enumerate(row.cells) if i and cell}
    good = {i: geometry for i, geometry in found.items() if geometry is not None}
    first = plain_word(row.cell(0))
    sure = (
        _WAVELENGTH.fullmatch(first) or TEXTS.get(first) in ("geometry", "name") or "as" in "".join(row.cells)
    )
    return good if len(good) == len(found) and len(set(good.values())) == len(good) and sure else {}


def _turned(rows: Sequence[TableRow]) -> Table | None:
    """Return blocks of a column per angle as a table of a row per angle."""
    about: dict[str, str] = {}
    labels: list[str] = []
    made: list[tuple[int, str, str, dict[str, str]]] = []
    angles: dict[int, Geometry] = {}
    block: list[tuple[int, str, str, dict[str, str]]] = []
    name = ""
    for row in rows:
        new = _angles(row)
        if len(new) > _FEWEST_ANGLES:
            angles, block = new, []
            first = row.cell(0)
            word = plain_word(first)
            name = name if _WAVELENGTH.fullmatch(word) or TEXTS.get(word) == "geometry" else first
            for i in angles:
                block.append((row.line, name, row.cell(i), {}))
            made += block
            continue
        said = _said([row])
        if said and not (block and len([c for c in row.cells if c]) > 2):
            name = said.get("name", name)
            about |= {what: text for what, text in said.items() if what != "name"}
            angles = {}
            continue
        label = row.cell(0)
        if angles and label:
            if label not in labels:
                labels.append(label)
            for (_, _, _, cells), i in zip(block, angles, strict=True):
                cells[label] = row.cell(i)
    columns = interpret(["Name", "Geometry", *labels])
    found = [
        TableRow(line, (name, angle, *(cells.get(label, "") for label in labels)))
        for line, name, angle, cells in made
    ]
    return Table(columns, tuple(found), about) if found and has_whole_colour(columns) else None


def _without_headings(rows: Sequence[TableRow]) -> Table | None:
    """Return a table whose every row has a hex code in one place, or a name and three numbers from 0 to 255."""
    if not rows:
        return None
    width = max(len(row.cells) for row in rows)
    if not 1 < width <= 12:
        return None
    kinds = []
    for index in range(width):
        cells = [row.cell(index) for row in rows]
        if all(
            _HEX.fullmatch(cell) and (cell.startswith(("#", "0x")) or not cell.isdecimal()) for cell in cells
        ):
            kinds.append("hex")
        elif all(cell.isascii() and cell.isdecimal() and int(cell[:9]) <= 255 for cell in cells):
            kinds.append("number")
        else:
            kinds.append("text")
    numbers = [i for i, kind in enumerate(kinds) if kind == "number"]
    codes = [i for i, kind in enumerate(kinds) if kind == "hex"]
    texts = [
        i
        for i, kind in enumerate(kinds)
        if kind == "text" and any(c.isalpha() for row in rows for c in row.cell(i))
    ]
    whats = [""] * width
    if len(codes) == 1:
        whats[codes[0]] = "hex"
    elif len(numbers) == 3 and numbers[2] - numbers[0] == 2 and texts:
        for index, channel in zip(numbers, "rgb", strict=True):
            whats[index] = f"RGB.{channel}"
    else:
        return None
    if not texts and width == 2 and codes:
        texts = [1 - codes[0]]  # the numbers of the colours
    if texts:
        whats[texts[0]] = "name"
    columns = tuple(TableColumn("", what) for what in whats)
    return Table(columns, tuple(rows), headed=False)

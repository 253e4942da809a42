"""Rows of a table out of XML: worksheets of spreadsheets, and any tree whose elements hold colours at angles.

Of a worksheet (XML Spreadsheet 2003) the cells are taken as they stand. Of any other tree each element becomes a row
that has a whole colour, or sparkle or graininess, in its attributes and its plain children; names and angles may stand
in the elements around it. The trees of instruments are not published, so their elements are known by their names, as
the headings of tables are. Elements of differences, tolerances and statistics are passed over.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.hardened_xml import Element
from brdf_suite.files.tables.columns import (
    EFFECTS,
    TEXTS,
    interpret,
    is_statistic,
    parse_geometry,
    plain_word,
)
from brdf_suite.files.tables.finding import has_whole_colour
from brdf_suite.files.tables.grid import TableRow, parse_number

SPREADSHEET = "urn:schemas-microsoft-com:office:spreadsheet"
_PLAIN_KEYS = ("value", "val", "text")
_NAMING_KEYS = ("name", "id", "notation", "label", "title")
_STARTS = ("start", "startwl", "startwavelength", "first", "from")
_STEPS = ("step", "increment", "interval", "delta")
_WAVES = ("wl", "wavelength", "nm", "lambda")
_FEWEST_BANDS = 3
_DIGITS = re.compile(r"\d+")
_MOST_COLUMNS = 600
_MOST_SKIPPED = 1000


def xml_rows(root: Element, path: PathLike, most_rows: int) -> tuple[list[TableRow], tuple[str, ...]]:
    """Return the rows of a file's table and notices; of a tree that is no worksheet the first one has the headings.

    Raises :class:`FileError`: it has more than ``most_rows`` rows, or too many different fields.
    """
    if root.namespace == SPREADSHEET:
        return list(_sheet(root, path, most_rows)), ()
    records: list[tuple[int, dict[str, str]]] = []
    headings: dict[str, None] = {}
    left_out = 0
    for line, fields in _records(root):
        if fields is None:
            left_out += 1
            continue
        records.append((line, fields))
        headings |= dict.fromkeys(fields)
        if len(records) > most_rows or len(headings) > _MOST_COLUMNS:
            raise FileError(path, f"has more than {most_rows:,} readings, or too many fields", f"line {line}")
    if not records:
        return [], ()
    names = list(headings)
    rows = [TableRow(line, tuple(fields.get(name, "") for name in names)) for line, fields in records]
    note = f"Elements of differences, tolerances or statistics are left out: {left_out}."
    return [TableRow(root.line, tuple(names)), *rows], (note,) if left_out else ()


def _sheet(root: Element, path: PathLike, most_rows: int) -> Iterator[TableRow]:
    """Yield the rows of the first worksheet."""
    table = root.first("Worksheet", "Table")
    for number, row in enumerate(table.all("Row") if table is not None else []):
        cells: list[str] = []
        for cell in row.all("Cell"):
            index = cell.attributes.get("Index", "")
            if index.isascii() and index.isdecimal() and len(cells) < int(index[:9]) - 1 < _MOST_SKIPPED:
                cells += [""] * (int(index) - 1 - len(cells))
            data = cell.first("Data")
            cells.append(" ".join(data.text.split()) if data is not None else "")
        if number >= most_rows or len(cells) > _MOST_COLUMNS:
            raise FileError(path, f"has more than {most_rows:,} rows, or too many cells", f"line {row.line}")
        if any(cells):
            yield TableRow(row.line, tuple(cells))


def _records(root: Element) -> Iterator[tuple[int, dict[str, str] | None]]:
    """Yield line and fields of each element with a colour or an effect; the depth is that of the parser's bound.

    There are no fields where the element is passed over: it is a difference, a tolerance or a deviation, or a mean
    beside other readings.
    """
    waiting: list[tuple[Element, Mapping[str, str]]] = [(root, {})]
    while waiting:
        element, outer = waiting.pop()
        own = _fields(element)
        columns = interpret(list(own))
        whole = has_whole_colour(columns)
        if whole or any(column.what in EFFECTS.values() for column in columns):
            yield element.line, {**outer, **own}
        if whole:
            continue
        # What stands around a colour says whose it is and where it was read.
        said = {heading: text for heading, text in own.items() if plain_word(heading) in TEXTS}
        inner = {**outer, **said}
        kept: list[tuple[Element, Mapping[str, str]]] = []
        means: list[Element] = []
        for child in element.children:
            if not (child.children or child.attributes):
                continue
            name = _DIGITS.sub("", child.name)  # a paint's name is no element's
            if is_statistic(name, means=False):
                yield child.line, None
            elif is_statistic(name):
                means.append(child)
            else:
                kept.append((child, inner))
        if means and any(_holds_colour(child) for child, _ in kept):
            for child in means:
                yield child.line, None
        else:
            kept += [(child, inner) for child in means]
        waiting.extend(reversed(kept))


def _holds_colour(element: Element) -> bool:
    """Return whether an element, or one in it that is no statistic, has a whole colour."""
    waiting = [element]
    while waiting:
        one = waiting.pop()
        if is_statistic(_DIGITS.sub("", one.name)):
            continue
        if has_whole_colour(interpret(list(_fields(one)))):
            return True
        waiting += one.children
    return False


def _fields(element: Element) -> dict[str, str]:
    """Return an element's attributes and plain children by headings."""
    found: dict[str, str] = {}
    if (at := _angle_of(element.name)) is not None:
        found["Geometry"] = at
    for key, text in element.attributes.items():
        _put(found, element.name, key, text)
    spectrum = _spectrum(element)
    for child in element.children:
        if child.children:
            if not spectrum and _is_spectral(child):
                spectrum = _spectrum(child)
            continue
        bands = _spectrum(child)
        if bands:
            spectrum = spectrum or bands
        elif child.text:
            label = child.attributes.get("Name") or child.attributes.get("name") or child.name
            _put(found, child.name, label, child.text)
        elif value := next(
            (child.attributes[k] for k in ("value", "Value", "val") if k in child.attributes), ""
        ):
            _put(
                found,
                child.name,
                child.attributes.get("name", child.attributes.get("Name", child.name)),
                value,
            )
    return {**found, **spectrum}


def _put(found: dict[str, str], element: str, key: str, text: str) -> None:
    plain, text = plain_word(key), " ".join(text.split())
    if (
        plain in _NAMING_KEYS
        and parse_geometry(text) is not None
        and plain_word(element) not in ("sample", "standard")
    ):
        found.setdefault("Geometry", text)
    elif plain in _PLAIN_KEYS:
        found.setdefault(element, text)
    else:
        found.setdefault(key, text)


def _angle_of(name: str) -> str | None:
    """Return the angle in the name of an element, as in ``Angle15``, ``as-15`` or ``_45as110``."""
    found = re.search(r"(\d{1,2}as(?:-|_|minus)?\d{1,3})$", name, re.IGNORECASE)
    if found is None:
        found = re.fullmatch(
            r"(?:angle|geometry|as|deg|gonio)[_-]?(minus|m|-|_-)?(\d{1,3})", name, re.IGNORECASE
        )
        return None if found is None else f"{'-' if found[1] else ''}{found[2]}"
    return found[1]


def _is_spectral(element: Element) -> bool:
    return any(word in element.name.lower() for word in ("spectr", "reflect", "curve"))


def _spectrum(element: Element) -> dict[str, str]:
    """Return the bands of an element by their wavelengths: a list with a start and a step, or an element for each."""
    attributes = {plain_word(key): text for key, text in element.attributes.items()}
    start = next((parse_number(attributes[key]) for key in _STARTS if key in attributes), None)
    step = next((parse_number(attributes[key]) for key in _STEPS if key in attributes), None)
    words = re.split(r"[\s;,]+", element.text)[:_MOST_COLUMNS]
    if start is not None and step and len(words) >= _FEWEST_BANDS:
        return {f"{start + step * index:g}": word for index, word in enumerate(words)}
    found = {}
    for child in element.children[:_MOST_COLUMNS]:
        keys = {plain_word(key): text for key, text in child.attributes.items()}
        nm = next((parse_number(keys[key]) for key in _WAVES if key in keys), None)
        if nm is not None:
            found[f"{nm:g}"] = child.text or keys.get("value", "")
    return found if len(found) >= _FEWEST_BANDS else {}

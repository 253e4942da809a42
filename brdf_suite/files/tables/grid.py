"""Cells of a delimited text file, whatever its encoding, separator and decimal mark."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from brdf_suite.errors import FileError, PathLike

SEPARATORS = ("\t", ";", "|", ",")
"""In this order; a comma may also be the decimal mark of a table whose cells are separated otherwise."""

_OFTEN = 0.6
_LOOKED_AT = 60
_EXCEL_SEPARATOR = re.compile(r"sep=(.)\s*", re.IGNORECASE)
_COLUMNS_OF_SPACES = re.compile(r"\s{2,}")
_NUMBER = re.compile(r"[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d{1,3})?")
MOST_CELLS = 2_000_000


@dataclass(frozen=True)
class TableRow:
    """The cells of a row without white space around them, and the number of the line, from 1."""

    line: int
    cells: tuple[str, ...]

    def cell(self, index: int) -> str:
        """Return a cell; empty where the row is shorter."""
        return self.cells[index] if index < len(self.cells) else ""


def decode(content: bytes) -> tuple[str, bool] | None:
    """Return the text of a file, and whether its encoding was only assumed; None where it is no text.

    UTF-8 with or without a mark, UTF-16 with or without one, else Windows-1252 or Latin-1, which are the assumption.
    """
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        try:
            return content.decode("utf-16"), False
        except UnicodeDecodeError:
            return None
    if b"\0" in content:
        code = _wide_code(content)
        try:
            text = content.decode(code) if code else "\0"
        except UnicodeDecodeError:
            return None
        return None if "\0" in text else (text, False)
    try:
        return content.decode("utf-8-sig"), False
    except UnicodeDecodeError:
        pass
    try:
        return content.decode("cp1252"), True
    except UnicodeDecodeError:
        return content.decode("latin-1"), True


def _wide_code(content: bytes) -> str:
    """Return which UTF-16 without a mark this is: letters of ASCII have a NUL on one side only."""
    head = content[:2000]
    first, second = head[::2].count(0), head[1::2].count(0)
    if second > 0.3 * len(head) / 2 and first == 0:
        return "utf-16-le"
    return "utf-16-be" if first > 0.3 * len(head) / 2 and second == 0 else ""


def decode_head(head: bytes) -> str:
    """Return the whole lines of a file's first bytes as text; empty where they are none."""
    wide = head[:2] in (b"\xff\xfe", b"\xfe\xff") or b"\0" in head[:200]
    end = len(head) - len(head) % 2 if wide else (head.rfind(b"\n") + 1 or len(head))
    # A short file is whole; of a long one the last line may be cut off, in UTF-16 even within a letter.
    if len(head) < 1 << 15:
        end = len(head)
    found = decode(head[:end])
    if found is None:
        return ""
    text = found[0]
    return text.rpartition("\n")[0] if wide and end >= 1 << 15 else text


def find_separator(text: str) -> str:
    """Return what separates cells: the first of :data:`SEPARATORS` in most lines, or an empty text for wide spaces."""
    lines = [line for line in text[: 1 << 16].splitlines()[:_LOOKED_AT] if line.strip()]
    if lines and (said := _EXCEL_SEPARATOR.fullmatch(lines[0])):
        return said[1]
    for separator in SEPARATORS:
        if sum(separator in line for line in lines) >= _OFTEN * max(1, len(lines)):
            return separator
    many = sum(len(_COLUMNS_OF_SPACES.split(line.strip())) > 1 for line in lines)
    return "" if many >= _OFTEN * max(1, len(lines)) else ","


def read_rows(text: str, path: PathLike, most_rows: int) -> list[TableRow]:
    """Return the rows of a table that are not empty.

    Raises :class:`FileError`: it has more than ``most_rows`` rows or too many cells, or a quotation does not end.
    """
    separator = find_separator(text)
    if text.lstrip().lower().startswith("sep="):
        text = "\n" + text.lstrip().partition("\n")[2]
    rows: list[TableRow] = []
    cells = 0
    for line, values in _split(text, separator, path):
        found = tuple(_plain_cell(value) for value in values)
        if any(found):
            rows.append(TableRow(line, found))
            cells += len(found)
        if len(rows) > most_rows or cells > MOST_CELLS:
            raise FileError(path, f"has more than {most_rows:,} rows, or too many cells", f"line {line}")
    return rows


def _plain_cell(value: str) -> str:
    """Return a cell without white space around it, and without quotation marks that it begins and ends with."""
    text = " ".join(value.replace("\xa0", " ").split())
    return text[1:-1].strip() if len(text) > 1 and text[0] == text[-1] == '"' else text


def _split(text: str, separator: str, path: PathLike) -> Iterator[tuple[int, Sequence[str]]]:
    if not separator:
        for number, line in enumerate(text.splitlines(), 1):
            yield number, _COLUMNS_OF_SPACES.split(line.strip())
        return
    reader = csv.reader(
        io.StringIO(text, newline=""), delimiter=separator, skipinitialspace=separator != "\t"
    )
    try:
        for values in reader:
            yield reader.line_num, values
    except csv.Error as error:
        raise FileError(
            path, f"is not a table that can be read ({error})", f"line {reader.line_num}"
        ) from error


def parse_number(text: str) -> float | None:
    """Return the finite number in a cell, with a point or a comma as decimal mark; None where it is none.

    A percent sign and a degree sign behind it are passed over.

    >>> parse_number("−12,5 %"), parse_number("x")
    (-12.5, None)
    """
    plain = text.replace("\u2212", "-").rstrip("%° ").strip()
    if len(plain) > 60 or not _NUMBER.fullmatch(plain) or not plain.isascii():
        return None
    value = float(plain.replace(",", "."))
    return value if math.isfinite(value) else None

"""A contact sheet as pages of PDF: A4, the pictures as they are drawn, the text as text."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from reportlab.pdfgen.canvas import Canvas

from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report
from brdf_suite.reports.contact_sheet.pictures import SheetItem
from brdf_suite.reports.pdf_pen import Pen
from brdf_suite.reports.sheet_text import broken

Size = tuple[int, int]
Draw = Callable[[SheetItem], tuple[NDArray[np.uint8], list[str]]]

WIDTH, HEIGHT = 595.276, 841.89
"""A4 upright, points."""
MARGIN = 36.0
DEFAULT_COLUMNS = 4
_GAP = 10.0
_NAME, _TEXT, _LINE = 8.0, 6.5, 1.25
_CAPTION_LINES = 4
_BLACK, _SOFT = "#000000", "#404040"
_TITLE_SIZE, _HEADING_SIZE = 16.0, 11.0


def pdf_sheet(
    title: str,
    subtitle: str,
    items: Sequence[SheetItem],
    cell: Size,
    columns: int,
    draw: Draw,
    problems: list[str],
    progress: Progress | None = None,
) -> tuple[bytes, int, str]:
    """Return the file, its number of pages, and the letters that no font has.

    ``cell`` is the size of a picture in pixels, drawn as wide as a column is; ``problems`` gets those of paints that
    cannot be drawn, whose reason stands in the picture's place.
    """
    packed = io.BytesIO()
    canvas = Canvas(packed, pagesize=(WIDTH, HEIGHT), pageCompression=1)
    canvas.setTitle(title)
    canvas.setCreator("BRDF Suite")
    canvas.setSubject(subtitle)
    pages = _Pages(canvas, title, subtitle, cell, columns)
    done = 0
    for group in dict.fromkeys(item.group for item in items):
        members = [item for item in items if item.group == group]
        for start in range(0, len(members), columns):
            heading = group if start == 0 else ""
            pages.make_room(heading)
            for column, item in enumerate(members[start : start + columns]):
                report(progress, done / len(items), f"{item.name}, {done + 1} of {len(items)}")
                done += 1
                try:
                    pixels, lines = draw(item)
                except SuiteError as error:
                    problems.append(str(error))
                    pages.put(column, item.name, None, [f"could not be drawn: {error}"])
                else:
                    pages.put(column, item.name, pixels, lines)
            pages.y += pages.row
            pages.fresh = False
    pages.end_page()
    canvas.save()
    return packed.getvalue(), pages.number, pages.pen.missing


class _Pages:
    """Rows of cells from the top of a page downwards, and onto the next where there is no room."""

    def __init__(self, canvas: Canvas, title: str, subtitle: str, cell: Size, columns: int) -> None:
        self.canvas, self.pen = canvas, Pen(canvas, HEIGHT)
        self.title, self.subtitle, self.columns = title, subtitle, columns
        self.width = (WIDTH - 2.0 * MARGIN - (columns - 1) * _GAP) / columns
        self.picture = self.width * cell[1] / cell[0]
        # A picture that is far higher than it is wide takes at most half a page.
        self.shrunk = min(1.0, 0.5 * (HEIGHT - 2.0 * MARGIN) / self.picture)
        self.row = self.picture * self.shrunk + _LINE * (_NAME + _CAPTION_LINES * _TEXT) + _GAP
        self.number = 0
        self.y = HEIGHT
        self.fresh = False

    def make_room(self, heading: str) -> None:
        """Begin a page where the next row, with its heading, has no room; then write the heading."""
        needed = self.row + (_LINE * _HEADING_SIZE + 4.0 if heading else 0.0)
        if self.number == 0 or (self.y + needed > HEIGHT - MARGIN - 12.0 and not self.fresh):
            self._begin_page()
        if heading:
            self.y += _HEADING_SIZE
            room = WIDTH - 2.0 * MARGIN
            text = self.pen.shortened(heading, _HEADING_SIZE, room, bold=True)
            self.pen.text(MARGIN, self.y, text, _HEADING_SIZE, bold=True, colour=_BLACK)
            self.y += 4.0 + (_LINE - 1.0) * _HEADING_SIZE
            self.fresh = False

    def put(self, column: int, name: str, pixels: NDArray[np.uint8] | None, lines: list[str]) -> None:
        """Draw one cell of the row."""
        x, y = MARGIN + column * (self.width + _GAP), self.y
        if pixels is not None:
            self.pen.picture(x, y, self.width * self.shrunk, self.picture * self.shrunk, pixels)
        y += self.picture * self.shrunk + _LINE * _NAME
        self.pen.text(
            x, y, self.pen.shortened(name, _NAME, self.width, bold=True), _NAME, bold=True, colour=_BLACK
        )
        if pixels is None:
            lines = broken(
                " ".join(lines), lambda text: self.pen.width(text, _TEXT), self.width, _CAPTION_LINES
            )
        for line in lines[:_CAPTION_LINES]:
            y += _LINE * _TEXT
            self.pen.text(x, y, self.pen.shortened(line, _TEXT, self.width), _TEXT, colour=_SOFT)

    def end_page(self) -> None:
        """Write the page's number and hand it over."""
        if self.number:
            self.pen.text(
                WIDTH - MARGIN, HEIGHT - MARGIN + 8.0, f"{self.number}", _TEXT, anchor="end", colour=_SOFT
            )
            self.canvas.showPage()

    def _begin_page(self) -> None:
        self.end_page()
        self.number += 1
        self.y = MARGIN
        room = WIDTH - 2.0 * MARGIN
        if self.number == 1:
            self.y += _TITLE_SIZE
            text = self.pen.shortened(self.title, _TITLE_SIZE, room, bold=True)
            self.pen.text(MARGIN, self.y, text, _TITLE_SIZE, bold=True, colour=_BLACK)
            self.y += _LINE * _NAME + 4.0
            text = self.pen.shortened(self.subtitle, _TEXT, room)
        else:
            self.y += _NAME
            text = self.pen.shortened(self.title, _TEXT, room)
        self.pen.text(MARGIN, self.y, text, _TEXT, colour=_SOFT)
        self.y += 10.0
        self.fresh = True

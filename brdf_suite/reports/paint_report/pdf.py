"""The report as one page of PDF (A4), with the paint attached as a file of JSON, which is what is read back.

Text is set in Helvetica, which every viewer has; letters that it lacks come from a font of the system and are embedded.
The attachment is not compressed, so that it is found without a library for PDF; a program that writes the file anew may
hide it from us, not from viewers.
"""

from __future__ import annotations

import io
import json
import textwrap
from typing import Any

from reportlab.lib.utils import ImageReader
from reportlab.pdfbase import pdfdoc
from reportlab.pdfgen.canvas import Canvas

from brdf_suite.files.exports import json_document
from brdf_suite.reports.paint_report.document import Report
from brdf_suite.reports.paint_report.html import (
    HEADINGS,
    cells,
    conventions,
    standard_cells,
    standard_headings,
)
from brdf_suite.reports.paint_report.plots import GRID, INK, SOFT, STYLES, Mark, Plot, PlotLine, plots_of
from brdf_suite.reports.pdf_pen import Pen

ATTACHMENT = "paint.json"
_WIDTH, _HEIGHT, _MARGIN = 595.276, 841.89, 36.0
_MOST_ROWS = 8


def page(made: Report) -> tuple[bytes, tuple[str, ...]]:
    """Return the page as a file, and notes about letters that no font has."""
    packed = io.BytesIO()
    canvas = Canvas(packed, pagesize=(_WIDTH, _HEIGHT), pageCompression=1)
    canvas.setTitle(made.title)
    canvas.setCreator("BRDF Suite")
    canvas.setSubject("Paint report")
    pen = Pen(canvas, _HEIGHT)
    _Page(made, pen).draw()
    _attach(canvas, json.dumps(json_document.document([made.item]), allow_nan=False).encode("ascii") + b"\n")
    canvas.showPage()
    canvas.save()
    notes = (f"No font of this system has the letters {pen.missing}.",) if pen.missing else ()
    return packed.getvalue(), notes


def _attach(canvas: Canvas, content: bytes) -> None:
    """Attach a file by the name tree of the catalogue (ISO 32000-1, 7.11.4); the library has no call for it."""
    document: Any = canvas._doc
    stream = pdfdoc.PDFStream(
        dictionary=pdfdoc.PDFDictionary({"Type": pdfdoc.PDFName("EmbeddedFile")}),
        content=content,
        filters=[],
    )
    file = pdfdoc.PDFDictionary(
        {
            "Type": pdfdoc.PDFName("Filespec"),
            "F": pdfdoc.PDFString(ATTACHMENT),
            "UF": pdfdoc.PDFString(ATTACHMENT),
            "Desc": pdfdoc.PDFString("The paint of this report, for programs"),
            "EF": pdfdoc.PDFDictionary({"F": document.Reference(stream)}),
        }
    )
    names = pdfdoc.PDFArray([pdfdoc.PDFString(ATTACHMENT), document.Reference(file)])
    tree = pdfdoc.PDFDictionary({"EmbeddedFiles": pdfdoc.PDFDictionary({"Names": names})})
    document.Catalog.Names = document.Reference(tree)


class _Page:
    """Lays the report out from the top of the page downwards."""

    def __init__(self, made: Report, pen: Pen) -> None:
        self.made, self.pen = made, pen
        self.left, self.right = _MARGIN, _WIDTH - _MARGIN
        self.room = self.right - self.left
        self.y = _MARGIN

    def draw(self) -> None:
        """Draw everything."""
        self._head()
        self._pictures()
        self._colours()
        if self.made.verdict:
            self._sentence(self.made.verdict, 8.5, bold=True)
        self._table()
        self._plots()
        self._figures()
        self._remarks()
        self._foot()

    def _head(self) -> None:
        made, pen = self.made, self.pen
        date = f"{made.when:%d %B %Y}"
        room = self.room - pen.width(date, 9.0) - 12.0
        self.y += 20.0
        pen.text(self.left, self.y, pen.shortened(made.title, 24.0, room, bold=True), 24.0, bold=True)
        pen.text(self.right, self.y, date, 9.0, anchor="end", colour=SOFT)
        self.y += 8.0
        pen.line(PlotLine(((self.left, self.y), (self.right, self.y)), INK, 1.2))
        self.y += 10.0

    def _pictures(self) -> None:
        pictures = self.made.pictures
        if not pictures:
            return
        gap = 8.0
        shares = [picture.width / picture.height for picture in pictures]
        height = min((self.room - gap * (len(pictures) - 1)) / sum(shares), 218.0)
        x = self.left
        for picture, share in zip(pictures, shares, strict=True):
            image = ImageReader(io.BytesIO(picture.png))
            self.pen.canvas.drawImage(image, x, _HEIGHT - self.y - height, height * share, height)
            self.pen.text(x, self.y + height + 8.0, picture.title, 6.5, colour=SOFT)
            x += height * share + gap
        self.y += height + 18.0

    def _colours(self) -> None:
        pen, strip = self.pen, self.made.strip
        each = self.room / len(strip)
        for index, (_, code) in enumerate(strip):
            # A hair wider than its share, or a viewer shows the paper between two.
            pen.rectangle(
                self.left + index * each, self.y, each + (0.4 if index < len(strip) - 1 else 0.0), 13.0, code
            )
        self.y += 19.0
        rows = self.made.rows[:_MOST_ROWS]
        width = (self.room - 6.0 * (len(rows) - 1)) / len(rows)
        for index, row in enumerate(rows):
            x = self.left + index * (width + 6.0)
            pen.rectangle(x, self.y, width, 44.0, row.code)
            pen.text(x, self.y + 53.0, row.label, 8.0, bold=True)
            if not row.in_gamut:
                pen.text(x + width, self.y + 53.0, "outside sRGB", 6.0, anchor="end", colour=SOFT)
        self.y += 66.0

    def _sentence(
        self, text: str, size: float, *, bold: bool = False, most: int = 2, colour: str = INK
    ) -> None:
        letters = max(20, int(self.room / (size * (0.53 if bold else 0.49))))
        lines = textwrap.wrap(text, letters)
        for line in lines[:most] if len(lines) <= most else [*lines[: most - 1], lines[most - 1] + " …"]:
            self.pen.text(
                self.left,
                self.y,
                self.pen.shortened(line, size, self.room, bold=bold),
                size,
                bold=bold,
                colour=colour,
            )
            self.y += 1.3 * size
        self.y += 2.0

    def _table(self) -> None:
        pen, made = self.pen, self.made
        against = made.batch is not None
        headings = [*HEADINGS, *(standard_headings(made) if against else ())]
        first = 78.0
        step = (self.room - first) / (len(headings) - 1)
        ends = [self.left, *(self.left + first + step * index for index in range(1, len(headings)))]
        self.y += 4.0
        for index, heading in enumerate(headings):
            pen.text(ends[index], self.y, heading, 7.0, anchor="end" if index else "start", colour=SOFT)
        self.y += 3.0
        for row in made.rows[:_MOST_ROWS]:
            pen.line(PlotLine(((self.left, self.y), (self.right, self.y)), GRID, 0.5))
            self.y += 9.5
            found = [*cells(row), *(standard_cells(row) if against else ())][: len(headings)]
            for index, (text, computed) in enumerate(found):
                pen.text(
                    ends[index],
                    self.y,
                    text,
                    8.0,
                    anchor="end" if index else "start",
                    italic=computed,
                    bold=text == "fail",
                )
            self.y += 3.5
        pen.line(PlotLine(((self.left, self.y), (self.right, self.y)), GRID, 0.5))
        more = len(made.rows) - _MOST_ROWS
        if more > 0:
            self.y += 9.0
            pen.text(self.left, self.y, f"{more} more readings are in the attached data.", 7.0, colour=SOFT)
        self.y += 10.0

    def _plots(self) -> None:
        width = (self.room - 16.0) / 3.0
        for index, plot in enumerate(plots_of(self.made, width, 112.0)):
            self._plot(plot, self.left + index * (width + 8.0), self.y)
        self.y += 120.0
        x = self.left + 2.0
        for curve in self.made.curves:
            self.pen.line(PlotLine(((x, self.y - 2.2), (x + 20.0, self.y - 2.2)), *STYLES[curve.title]))
            self.pen.text(x + 24.0, self.y, curve.title, 6.5, colour=SOFT)
            x += 34.0 + self.pen.width(curve.title, 6.5)
        self.pen.mark(Mark(x + 3.0, self.y - 2.2, INK, True), 0.0, 0.0)
        self.pen.text(x + 9.0, self.y, "readings", 6.5, colour=SOFT)
        if self.made.batch is not None:
            self.pen.mark(Mark(x + 45.0, self.y - 2.2, STYLES["standard"][0], False), 0.0, 0.0)
            self.pen.text(x + 51.0, self.y, "standard", 6.5, colour=SOFT)
        self.y += 16.0

    def _plot(self, plot: Plot, x: float, y: float) -> None:
        for stroke in plot.strokes:
            if isinstance(stroke, PlotLine):
                self.pen.line(stroke, x, y)
            elif isinstance(stroke, Mark):
                self.pen.mark(stroke, x, y)
            else:
                self.pen.text(
                    x + stroke.x, y + stroke.y, stroke.text, stroke.size, anchor=stroke.anchor, colour=stroke.colour,
                    bold=stroke.bold,
                )  # fmt: skip

    def _figures(self) -> None:
        pen, groups = self.pen, self.made.figures
        width = (self.room - 20.0 * (len(groups) - 1)) / len(groups)
        top = self.y
        lowest = top
        for index, (title, figures) in enumerate(groups):
            x, y = self.left + index * (width + 20.0), top
            pen.text(x, y, title, 8.0, bold=True)
            for name, value in figures:
                y += 10.5
                pen.text(x, y, name, 7.5, colour=SOFT)
                pen.text(x + width, y, value, 7.5, anchor="end")
            lowest = max(lowest, y)
        self.y = lowest + 16.0

    def _remarks(self) -> None:
        bottom = _HEIGHT - _MARGIN - 26.0
        for text in self.made.remarks:
            most = min(3, int((bottom - self.y) / 9.1))
            if most < 1:
                break
            self._sentence(text, 7.0, most=most)

    def _foot(self) -> None:
        bottom = _HEIGHT - _MARGIN
        self.pen.line(PlotLine(((self.left, bottom - 20.0), (self.right, bottom - 20.0)), GRID, 0.5))
        self.y = bottom - 11.0
        self._sentence(conventions(self.made), 6.5, colour=SOFT)

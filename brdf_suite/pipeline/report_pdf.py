"""The report as one page of PDF (A4), with the paint attached as a file of JSON, which is what is read back.

Text is set in Helvetica, which every viewer has; letters that it lacks come from a font of the system and are embedded.
The attachment is not compressed, so that it is found without a library for PDF; a program that writes the file anew may
hide it from us, not from viewers.
"""

from __future__ import annotations

import io
import json
import textwrap
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from brdf_suite.errors import FileError
from brdf_suite.files.exports import json_document
from brdf_suite.files.exports.format import ExportFormat, Imported, PathLike
from brdf_suite.files.measured.bounded_reading import read_bytes
from brdf_suite.pipeline.report import Report, ReportOptions, report_losses, write_report
from brdf_suite.pipeline.report_html import HEADINGS, cells, conventions, standard_cells, standard_headings
from brdf_suite.pipeline.report_plots import GRID, INK, SOFT, STYLES, Line, Mark, Plot, plots_of

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

ATTACHMENT = "paint.json"
_WIDTH, _HEIGHT, _MARGIN = 595.276, 841.89, 36.0
_MOST_ROWS = 8
_LARGEST = 64 << 20
_MARK = f'{{"format": "{json_document.NAME}"'.encode()


def format_with(options: ReportOptions) -> ExportFormat:
    """Return the format, its reports made with these options."""
    return ExportFormat(
        name="pdf",
        title="Report, PDF",
        ending=".pdf",
        holds="One page with pictures, plots and numbers; the paint itself is attached as a file.",
        losses=report_losses,
        write=partial(write_report, options, sheet),
        read=read,
        sniff=lambda head: head.startswith(b"%PDF-"),
    )


def sheet(made: Report) -> tuple[bytes, tuple[str, ...]]:
    """Return the page as a file, and notes about letters that no font has."""
    # Much to import, and only this form draws with it.
    from reportlab.pdfgen.canvas import Canvas

    packed = io.BytesIO()
    canvas = Canvas(packed, pagesize=(_WIDTH, _HEIGHT), pageCompression=1)
    canvas.setTitle(made.title)
    canvas.setCreator("BRDF Suite")
    canvas.setSubject("Paint report")
    pen = _Pen(canvas)
    _Page(made, pen).draw()
    _attach(
        canvas, json.dumps(json_document.document([made.subject]), allow_nan=False).encode("ascii") + b"\n"
    )
    canvas.showPage()
    canvas.save()
    notes = (f"No font of this system has the letters {pen.missing}.",) if pen.missing else ()
    return packed.getvalue(), notes


def _attach(canvas: Canvas, content: bytes) -> None:
    """Attach a file by the name tree of the catalogue (ISO 32000-1, 7.11.4); the library has no call for it."""
    from reportlab.pdfbase import pdfdoc

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


class _Pen:
    """Draws with y down from the upper edge, and finds a font for every letter; ``missing`` are those without."""

    def __init__(self, canvas: Canvas) -> None:
        self.canvas = canvas
        self.missing = ""
        self._fonts: dict[str, str] = {}

    def text(
        self,
        x: float,
        y: float,
        text: str,
        size: float,
        *,
        anchor: str = "start",
        colour: str = INK,
        bold: bool = False,
        italic: bool = False,
    ) -> None:
        """Draw a text whose baseline is at ``y``."""
        runs = list(self._runs(text, bold, italic))
        width = sum(self.canvas.stringWidth(run, font, size) for run, font in runs)
        x -= {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor] * width
        self.canvas.setFillColor(colour)
        for run, font in runs:
            self.canvas.setFont(font, size)
            self.canvas.drawString(x, _HEIGHT - y, run)
            x += self.canvas.stringWidth(run, font, size)

    def width(self, text: str, size: float, *, bold: bool = False) -> float:
        """Return the width of a text."""
        return float(
            sum(self.canvas.stringWidth(run, font, size) for run, font in self._runs(text, bold, False))
        )

    def shortened(self, text: str, size: float, room: float, *, bold: bool = False) -> str:
        """Return as much of a text as fits, with three dots where it is cut."""
        while text and self.width(text, size, bold=bold) > room:
            text = text.removesuffix("…")[:-1].rstrip() + "…"
        return text

    def rectangle(self, x: float, y: float, width: float, height: float, colour: str) -> None:
        """Fill a rectangle whose upper left corner is at ``x``, ``y``."""
        self.canvas.setFillColor(colour)
        self.canvas.rect(x, _HEIGHT - y - height, width, height, stroke=0, fill=1)

    def line(self, stroke: Line, x: float = 0.0, y: float = 0.0) -> None:
        """Draw a line, moved by ``x``, ``y``."""
        self.canvas.setStrokeColor(stroke.colour)
        self.canvas.setLineWidth(stroke.width)
        self.canvas.setDash(*((list(stroke.dashes),) if stroke.dashes else ([], 0)))
        path = self.canvas.beginPath()
        for index, (px, py) in enumerate(stroke.points):
            (path.lineTo if index else path.moveTo)(x + px, _HEIGHT - y - py)
        self.canvas.drawPath(path)

    def mark(self, mark: Mark, x: float, y: float) -> None:
        """Draw a reading, moved by ``x``, ``y``."""
        self.canvas.setDash([], 0)
        if mark.filled:
            self.canvas.setFillColor(mark.colour)
            self.canvas.circle(x + mark.x, _HEIGHT - y - mark.y, 2.2, stroke=0, fill=1)
            return
        self.canvas.setFillColor("#ffffff")
        self.canvas.setStrokeColor(mark.colour)
        self.canvas.setLineWidth(1.0)
        self.canvas.rect(x + mark.x - 2.2, _HEIGHT - y - mark.y - 2.2, 4.4, 4.4, stroke=1, fill=1)

    def _runs(self, text: str, bold: bool, italic: bool) -> Iterator[tuple[str, str]]:
        """Yield stretches of a text and the font that has all their letters."""
        plain = "Helvetica-Bold" if bold else "Helvetica-Oblique" if italic else "Helvetica"
        run, font = "", plain
        for letter in text:
            found = self._font_of(letter, plain)
            if found != font and run:
                yield run, font
                run = ""
            run, font = run + (letter if found else "?"), found or plain
        if run:
            yield run, font

    def _font_of(self, letter: str, plain: str) -> str:
        """The font of a letter; empty where none has it."""
        try:
            letter.encode("cp1252")
        except UnicodeEncodeError:
            pass
        else:
            return plain
        if letter not in self._fonts:
            self._fonts[letter] = "Symbol" if letter in "Δαγθ" else self._embedded(letter)
            if not self._fonts[letter] and letter not in self.missing:
                self.missing += letter
        return self._fonts[letter]

    def _embedded(self, letter: str) -> str:
        from reportlab.pdfbase import pdfmetrics
        from reportlab.pdfbase.ttfonts import TTFError, TTFont

        from brdf_suite.pipeline.sheet_text import font_for

        font, missing = font_for([letter], 12)
        if missing or not isinstance(font.path, str):
            return ""
        try:
            if font.path not in pdfmetrics.getRegisteredFontNames():
                pdfmetrics.registerFont(TTFont(font.path, font.path))
        except TTFError:  # outlines of a kind that cannot be embedded
            return ""
        return font.path


class _Page:
    """Lays the report out from the top of the page downwards."""

    def __init__(self, made: Report, pen: _Pen) -> None:
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
        pen.line(Line(((self.left, self.y), (self.right, self.y)), INK, 1.2))
        self.y += 10.0

    def _pictures(self) -> None:
        from reportlab.lib.utils import ImageReader

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
            pen.line(Line(((self.left, self.y), (self.right, self.y)), GRID, 0.5))
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
        pen.line(Line(((self.left, self.y), (self.right, self.y)), GRID, 0.5))
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
            self.pen.line(Line(((x, self.y - 2.2), (x + 20.0, self.y - 2.2)), *STYLES[curve.title]))
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
            if isinstance(stroke, Line):
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
        self.pen.line(Line(((self.left, bottom - 20.0), (self.right, bottom - 20.0)), GRID, 0.5))
        self.y = bottom - 11.0
        self._sentence(conventions(self.made), 6.5, colour=SOFT)


def read(path: PathLike) -> Imported:
    """Return the paint attached to a page of ours; raise :class:`FileError` where there is none, or it is damaged."""
    content = read_bytes(path, _LARGEST)
    start = content.find(_MARK)
    end = content.find(b"endstream", start)
    if start < 0 or end < 0:
        raise FileError(
            path, "holds no paint of this suite that can be found; another program may have packed it"
        )
    return json_document.imported_text(content[start:end], path)

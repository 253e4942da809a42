"""Text, lines and pictures on the pages of a PDF.

Text is set in Helvetica, which every viewer has; letters that it lacks come from a font of the system and are embedded.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from reportlab.lib.utils import ImageReader
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFError, TTFont

from brdf_suite.foreign_text import make_visible
from brdf_suite.reports.paint_report.plots import INK, Mark, PlotLine
from brdf_suite.reports.sheet_text import font_for

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas


class Pen:
    """Draws on pages of a height, points, with y down from the upper edge, and finds a font for every letter.

    ``missing`` are those that no font has.
    """

    def __init__(self, canvas: Canvas, height: float) -> None:
        self.canvas, self.height = canvas, height
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
            self.canvas.drawString(x, self.height - y, run)
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
        self.canvas.rect(x, self.height - y - height, width, height, stroke=0, fill=1)

    def picture(self, x: float, y: float, width: float, height: float, pixels: NDArray[np.uint8]) -> None:
        """Draw pixels (h, w, 3) of sRGB over a rectangle, losslessly."""
        image = ImageReader(Image.fromarray(np.ascontiguousarray(pixels)))
        self.canvas.drawImage(image, x, self.height - y - height, width, height)

    def line(self, stroke: PlotLine, x: float = 0.0, y: float = 0.0) -> None:
        """Draw a line, moved by ``x``, ``y``."""
        self.canvas.setStrokeColor(stroke.colour)
        self.canvas.setLineWidth(stroke.width)
        self.canvas.setDash(*((list(stroke.dashes),) if stroke.dashes else ([], 0)))
        path = self.canvas.beginPath()
        for index, (px, py) in enumerate(stroke.points):
            (path.lineTo if index else path.moveTo)(x + px, self.height - y - py)
        self.canvas.drawPath(path)

    def mark(self, mark: Mark, x: float, y: float) -> None:
        """Draw a reading, moved by ``x``, ``y``."""
        self.canvas.setDash([], 0)
        if mark.filled:
            self.canvas.setFillColor(mark.colour)
            self.canvas.circle(x + mark.x, self.height - y - mark.y, 2.2, stroke=0, fill=1)
            return
        self.canvas.setFillColor("#ffffff")
        self.canvas.setStrokeColor(mark.colour)
        self.canvas.setLineWidth(1.0)
        self.canvas.rect(x + mark.x - 2.2, self.height - y - mark.y - 2.2, 4.4, 4.4, stroke=1, fill=1)

    def _runs(self, text: str, bold: bool, italic: bool) -> Iterator[tuple[str, str]]:
        """Yield stretches of a text and the font that has all their letters."""
        plain = "Helvetica-Bold" if bold else "Helvetica-Oblique" if italic else "Helvetica"
        run, font = "", plain
        for letter in make_visible(text):
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
        font, missing = font_for([letter], 12)
        if missing or not isinstance(font.path, str):
            return ""
        try:
            if font.path not in pdfmetrics.getRegisteredFontNames():
                pdfmetrics.registerFont(TTFont(font.path, font.path))
        except TTFError:  # outlines of a kind that cannot be embedded
            return ""
        return font.path

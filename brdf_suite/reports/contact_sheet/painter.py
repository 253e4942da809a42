"""Lays out and draws a contact sheet that is one picture, strip by strip, so that only a line of cells is in memory."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from brdf_suite.errors import SuiteError
from brdf_suite.foreign_text import make_visible
from brdf_suite.progress import Progress, report
from brdf_suite.reports.contact_sheet.pictures import ItemPictures, SheetItem
from brdf_suite.reports.sheet_text import broken, font_for, shortened

Size = tuple[int, int]
MARGIN = 16
"""Between cells and around the sheet, in pixels."""
_MOST_HEAD_LINES = 8
_FIGURES = "flop L*a*b* 0123456789.,-+°: ()"


@dataclass(frozen=True, eq=False)
class SheetLayout:
    """Where everything stands, in pixels; rows are headings and lines of cells."""

    title: str
    subtitle: str
    cell: Size
    columns: int
    rows: tuple[str | tuple[SheetItem, ...], ...]
    fonts: dict[str, Any]
    missing: str

    @staticmethod
    def of(title: str, subtitle: str, items: Sequence[SheetItem], cell: Size, columns: int) -> SheetLayout:
        """Return where items stand, so many in a row, group by group under their headings."""
        text_px = int(min(22, max(10, cell[0] / 18)))
        texts = [
            title,
            subtitle,
            *(text for item in items for text in (item.name, item.group, item.problem)),
            _FIGURES,
        ]
        texts = list(map(make_visible, texts))
        font, missing = font_for(texts, text_px)
        fonts = {
            "text": font,
            "name": font_for(texts, round(1.2 * text_px))[0],
            "title": font_for(texts, round(1.8 * text_px))[0],
        }
        rows: list[str | tuple[SheetItem, ...]] = []
        for group in dict.fromkeys(item.group for item in items):
            members = [item for item in items if item.group == group]
            if group:
                rows.append(group)
            rows += [tuple(members[i : i + columns]) for i in range(0, len(members), columns)]
        return SheetLayout(title, subtitle, cell, columns, tuple(rows), fonts, missing)

    def line(self, kind: str) -> int:
        """Return the height of a line of text."""
        return round(1.35 * float(self.fonts[kind].size))

    @property
    def head_lines(self) -> list[tuple[str, str, int]]:
        """Title and subtitle, each on as many lines as it takes: text, kind and height from the top."""
        width, y = self.width - 2 * MARGIN, MARGIN
        found = []
        for text, kind in ((self.title, "title"), (self.subtitle, "text")):
            for line in wrapped(text, self.fonts[kind], width, _MOST_HEAD_LINES):
                found.append((line, kind, y))
                y += self.line(kind)
        return found

    @property
    def head(self) -> int:
        """Height of title and subtitle."""
        _, kind, y = self.head_lines[-1]
        return y + self.line(kind) + MARGIN

    def height(self, row: str | tuple[SheetItem, ...]) -> int:
        """Return the height of a heading or of a line of cells, with the room below."""
        if isinstance(row, str):
            return self.line("name") + MARGIN // 2
        return self.cell[1] + 4 + self.line("name") + 4 * self.line("text") + MARGIN

    @property
    def width(self) -> int:
        """Of the whole sheet."""
        return MARGIN + self.columns * (self.cell[0] + MARGIN)

    @property
    def size(self) -> Size:
        """Of the whole sheet."""
        return self.width, self.head + sum(self.height(row) for row in self.rows)


def wrapped(text: str, font: Any, width: int, lines: int) -> list[str]:
    """Return a text as it is drawn, broken into so many lines at most, the last one shortened."""
    return [shortened(line, font, width) for line in broken(make_visible(text), font.getlength, width, lines)]


def _on_one_line(text: str, font: Any, width: int) -> str:
    return shortened(make_visible(text), font, width)


_GREY = 119
"""L* 50, the grey against which paint is judged."""
_BLACK, _SOFT = 0, 40


class SheetPainter:
    """Draws the sheet's strips; one paint after the other is shown in the one scene."""

    def __init__(self, pictures: ItemPictures, layout: SheetLayout, problems: list[str]) -> None:
        self._pictures, self._layout, self._problems = pictures, layout, problems
        self._done = 0

    def strips(self, progress: Progress | None) -> Iterator[NDArray[np.uint8]]:
        """Yield the head, then a strip for each heading and each line of cells."""
        layout = self._layout
        yield self._text_strip(layout.head, layout.head_lines)
        paints = sum(len(row) for row in layout.rows if not isinstance(row, str))
        for row in layout.rows:
            if isinstance(row, str):
                yield self._text_strip(layout.height(row), [(row, "name", 0)])
            else:
                yield self._cells(row, paints, progress)

    def _text_strip(self, height: int, lines: list[tuple[str, str, int]]) -> NDArray[np.uint8]:
        width = self._layout.size[0]
        image = Image.new("RGB", (width, height), (_GREY,) * 3)
        draw = ImageDraw.Draw(image)
        for text, kind, y in lines:
            font = self._layout.fonts[kind]
            draw.text((MARGIN, y), _on_one_line(text, font, width - 2 * MARGIN), (_BLACK,) * 3, font)
        return np.asarray(image)

    def _cells(self, row: tuple[SheetItem, ...], paints: int, progress: Progress | None) -> NDArray[np.uint8]:
        layout = self._layout
        image = Image.new("RGB", (layout.size[0], layout.height(row)), (_GREY,) * 3)
        draw = ImageDraw.Draw(image)
        for column, item in enumerate(row):
            report(progress, self._done / paints, f"{item.name}, {self._done + 1} of {paints}")
            left = MARGIN + column * (layout.cell[0] + MARGIN)
            lines = self._draw_item(item, image, left)
            y = layout.cell[1] + 4
            for number, text in enumerate([item.name, *lines]):
                kind, shade = ("name", _BLACK) if number == 0 else ("text", _SOFT)
                font = layout.fonts[kind]
                draw.text((left, y), _on_one_line(text, font, layout.cell[0]), (shade,) * 3, font)
                y += layout.line(kind)
            self._done += 1
        return np.asarray(image)

    def _draw_item(self, item: SheetItem, image: Any, left: int) -> list[str]:
        """Put the paint's picture into the sheet and return the lines below its name."""
        try:
            pixels, text = self._pictures.draw(item)
        except SuiteError as error:
            self._problems.append(str(error))
            return [
                "could not be drawn:",
                *wrapped(str(error), self._layout.fonts["text"], self._layout.cell[0], 3),
            ]
        image.paste(Image.fromarray(pixels), (left, 0))
        return text.lines

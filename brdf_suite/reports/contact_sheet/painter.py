"""Draws a contact sheet that is one picture, strip by strip, so that no more than a line of cells is in memory."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report
from brdf_suite.reports.contact_sheet.layout import MARGIN, SheetLayout, wrapped
from brdf_suite.reports.contact_sheet.pictures import ItemPictures, SheetItem
from brdf_suite.reports.sheet_text import shortened

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
            draw.text((MARGIN, y), shortened(text, font, width - 2 * MARGIN), (_BLACK,) * 3, font)
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
                draw.text((left, y), shortened(text, font, layout.cell[0]), (shade,) * 3, font)
                y += layout.line(kind)
            self._done += 1
        return np.asarray(image)

    def _draw_item(self, item: SheetItem, image: Any, left: int) -> list[str]:
        """Put the paint's picture into the sheet and return the lines below its name."""
        try:
            pixels, lines = self._pictures.draw(item)
        except SuiteError as error:
            self._problems.append(str(error))
            return [
                "could not be drawn:",
                *wrapped(str(error), self._layout.fonts["text"], self._layout.cell[0], 3),
            ]
        image.paste(Image.fromarray(pixels), (left, 0))
        return lines

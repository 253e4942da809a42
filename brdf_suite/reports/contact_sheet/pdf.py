"""A contact sheet as pages of PDF: the pictures as they are drawn, the text as text."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from datetime import date

import numpy as np
from numpy.typing import NDArray
from reportlab.pdfgen.canvas import Canvas

from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report
from brdf_suite.reports.contact_sheet.page_layout import CellText, Marks, PageLayout, PageStyle
from brdf_suite.reports.contact_sheet.pictures import SheetItem
from brdf_suite.reports.pdf_pen import Pen

Size = tuple[int, int]
Draw = Callable[[SheetItem], tuple[NDArray[np.uint8], CellText]]


def pdf_sheet(
    title: str,
    subtitle: str,
    items: Sequence[SheetItem],
    cell: Size,
    style: PageStyle,
    draw: Draw,
    problems: list[str],
    progress: Progress | None = None,
) -> tuple[bytes, int, str]:
    """Return the file, its number of pages, and the letters that no font has.

    ``cell`` is the size of a picture in pixels, drawn as wide as a column is; ``problems`` gets those of paints that
    cannot be drawn, whose reason stands in the picture's place.
    """
    groups = list(dict.fromkeys(item.group for item in items))
    items = sorted(items, key=lambda item: groups.index(item.group))
    style = style.for_codes([item.code for item in items])
    today = f"{date.today():%d %B %Y}"
    layout = PageLayout.of(title, subtitle, today, [i.group for i in items], style, cell[1] / cell[0])
    width, height = style.size
    packed = io.BytesIO()
    canvas = Canvas(packed, pagesize=(width, height), pageCompression=1)
    canvas.setTitle(title)
    canvas.setCreator("BRDF Suite")
    canvas.setSubject(subtitle)
    pen = Pen(canvas, height)

    def measure(text: str, size: float, bold: bool) -> float:
        return pen.width(text, size, bold=bold)

    for place, (item, slot) in enumerate(zip(items, layout.slots, strict=True)):
        report(progress, place / len(items), f"{item.name}, {place + 1} of {len(items)}")
        if place == 0 or slot.page != layout.slots[place - 1].page:
            if place:
                canvas.showPage()
            _put(pen, layout.frame(slot.page, measure))
        try:
            pixels, text = draw(item)
        except SuiteError as error:
            problems.append(str(error))
            text = CellText(item.name, item.code, problem=f"could not be drawn: {error}")
        else:
            pen.picture(slot.x, slot.y, slot.width, slot.height, pixels)
        _put(pen, layout.cell(place, text, measure))
    canvas.showPage()
    canvas.save()
    return packed.getvalue(), layout.pages, pen.missing


def _put(pen: Pen, marks: Marks) -> None:
    for patch in marks.patches:
        pen.rectangle(patch.x, patch.y, patch.width, patch.height, patch.colour)
    for label in marks.labels:
        pen.text(
            label.x,
            label.y,
            label.text,
            label.size,
            anchor=label.anchor,
            colour=label.colour,
            bold=label.bold,
        )

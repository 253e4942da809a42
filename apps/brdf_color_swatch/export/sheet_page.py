"""Pages of a contact sheet on the screen and on a printer: the marks of the layout that the PDF has too."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPalette, QPixmap
from PySide6.QtWidgets import QWidget

from brdf_color_swatch.grid.rows import ANGLES_DEG, Rows
from brdf_suite.reports.contact_sheet.page_layout import CellText, Marks, PageLayout

PictureOf = Callable[[int], QPixmap | None]
_FAMILIES = ["Helvetica", "Arial", "Liberation Sans", "DejaVu Sans"]
_FONT_PX = 100
_PENDING = "#9c9c9c"
_EDGE_PX = 12


def cell_texts(rows: Rows, places: Sequence[int]) -> tuple[CellText, ...]:
    """Return what stands below the pictures of these places of a list."""
    texts = []
    for place in places:
        entry, flop, gloss = rows.entries[place], rows.columns.flop[place], rows.columns.gloss[place]
        figures = [f"flop {flop:.1f}"] if np.isfinite(flop) else []
        figures += [f"{gloss:g} GU at 20°"] if np.isfinite(gloss) else []
        labs = tuple(
            (angle, (float(lab[0]), float(lab[1]), float(lab[2])))
            for angle, lab in zip(ANGLES_DEG, rows.lab[place], strict=True)
            if np.isfinite(lab).all()
        )
        texts.append(CellText(entry.name, entry.code, ", ".join(figures), labs))
    return tuple(texts)


def measure(text: str, size: float, bold: bool) -> float:
    """Return the width of a text in points, as :func:`paint_page` draws it."""
    return QFontMetricsF(_font(bold)).horizontalAdvance(text) * size / _FONT_PX


def paint_page(
    painter: QPainter, layout: PageLayout, page: int, texts: Sequence[CellText], picture_of: PictureOf
) -> None:
    """Draw a page, counted from 0; one unit of the painter is a point of the paper."""
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    _paint_marks(painter, layout.frame(page, measure))
    for place, slot in enumerate(layout.slots):
        if slot.page != page:
            continue
        picture = picture_of(place)
        box = QRectF(slot.x, slot.y, slot.width, slot.height)
        if picture is None:
            painter.fillRect(box, QColor(_PENDING))
        else:
            painter.drawPixmap(box, picture, QRectF(picture.rect()))
        _paint_marks(painter, layout.cell(place, texts[place], measure))


def _paint_marks(painter: QPainter, marks: Marks) -> None:
    for patch in marks.patches:
        painter.fillRect(QRectF(patch.x, patch.y, patch.width, patch.height), QColor(patch.colour))
    for label in marks.labels:
        wide = measure(label.text, label.size, label.bold)
        painter.save()
        painter.translate(label.x - wide * {"start": 0.0, "middle": 0.5, "end": 1.0}[label.anchor], label.y)
        painter.scale(label.size / _FONT_PX, label.size / _FONT_PX)
        painter.setFont(_font(label.bold))
        painter.setPen(QColor(label.colour))
        painter.drawText(QPointF(0.0, 0.0), label.text)
        painter.restore()


def _font(bold: bool) -> QFont:
    font = QFont(_FAMILIES)
    font.setPixelSize(_FONT_PX)
    font.setBold(bold)
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    return font


class SheetPreview(QWidget):
    """A page as it will be on paper, as large as there is room."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._layout: PageLayout | None = None
        self._page = 0
        self._texts: tuple[CellText, ...] = ()
        self._picture_of: PictureOf = lambda _place: None
        self.setMinimumSize(280, 320)

    def sizeHint(self) -> QSize:
        return QSize(460, 620)

    def show_page(
        self, layout: PageLayout, page: int, texts: tuple[CellText, ...], picture_of: PictureOf
    ) -> None:
        self._layout, self._page, self._texts, self._picture_of = layout, page, texts, picture_of
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Mid))
        if self._layout is None:
            return
        width, height = self._layout.style.size
        room = self.rect().adjusted(_EDGE_PX, _EDGE_PX, -_EDGE_PX, -_EDGE_PX)
        scale = min(room.width() / width, room.height() / height)
        left, top = room.center().x() - 0.5 * scale * width, room.center().y() - 0.5 * scale * height
        painter.translate(left, top)
        painter.scale(scale, scale)
        painter.fillRect(QRectF(0.0, 0.0, width, height), Qt.GlobalColor.white)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        paint_page(painter, self._layout, self._page, self._texts, self._picture_of)

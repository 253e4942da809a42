"""A layer over a picture: painted by Qt at the size of the screen, and in no exported picture."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter
from PySide6.QtWidgets import QWidget

from brdf_suite.foreign_text import make_visible

PAPER, INK = QColor(0, 0, 0, 168), QColor(255, 255, 255)
"""Neutral, like all of the interface, and readable on any picture."""
PADDING = 6.0


class PictureLayer(QWidget):
    """Covers ``picture`` and follows its size; takes no mouse event."""

    def __init__(self, picture: QWidget) -> None:
        super().__init__(picture)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self._picture = picture
        picture.installEventFilter(self)
        self._follow()
        self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Show, QEvent.Type.ChildAdded):
            self._follow()
        return super().eventFilter(watched, event)

    def _follow(self) -> None:
        self.setGeometry(self._picture.rect())
        self.raise_()


def draw_chip(painter: QPainter, corner: QPointF, lines: tuple[str, ...], room: float) -> QRectF:
    """Write lines on a rounded paper whose upper left is at ``corner``, at most ``room`` wide; return its box."""
    metrics = QFontMetricsF(painter.font())
    inside = room - 2 * PADDING
    shown = [metrics.elidedText(make_visible(line), Qt.TextElideMode.ElideRight, inside) for line in lines]
    wide = max(metrics.horizontalAdvance(line) for line in shown) + 2 * PADDING
    box = QRectF(corner.x(), corner.y(), wide, len(shown) * metrics.height() + 2 * PADDING)
    draw_paper(painter, box)
    for row, line in enumerate(shown):
        base = box.top() + PADDING + row * metrics.height() + metrics.ascent()
        painter.drawText(QPointF(box.left() + PADDING, base), line)
    return box


def draw_paper(painter: QPainter, box: QRectF) -> None:
    """Draw the paper of a chip, and leave the pen for its text."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(PAPER)
    painter.drawRoundedRect(box, 4.0, 4.0)
    painter.setPen(INK)

"""Lamps drawn over the picture as round handles on a map of all directions around the object."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from brdf_qt.gl.layer import PictureLayer, draw_chip

RADIUS = 10.0
"""Of a handle, in logical pixels."""
_DARK, _LIGHT, _FAINT = QColor(0, 0, 0, 190), QColor(255, 255, 255, 240), QColor(255, 255, 255, 90)
_GAP = 10.0


@dataclass(frozen=True)
class LampHandle:
    """Where a lamp's handle is (logical pixels), the lamp's number and colour, and how it is shown."""

    number: int
    place: QPointF
    colour: QColor
    behind: bool
    chosen: bool


class LampLayer(PictureLayer):
    """Draws the handles; while one is dragged, also the circle between front and back, and words."""

    def __init__(self, picture: QWidget) -> None:
        super().__init__(picture)
        self.setObjectName("lamp_layer")
        self.handles: tuple[LampHandle, ...] = ()
        self.centre, self.reach = QPointF(), 0.0
        self.words = ""
        self.dragged = False

    def show_handles(self, handles: tuple[LampHandle, ...], centre: QPointF, reach: float) -> None:
        """Show handles around a centre; ``reach`` (logical pixels) is the radius of the circle to the back."""
        self.handles, self.centre, self.reach = handles, centre, reach
        self._changed()

    def show_words(self, words: str, *, dragged: bool = False) -> None:
        """Say something at the upper edge; empty: nothing."""
        self.words, self.dragged = words, dragged
        self._changed()

    def _changed(self) -> None:
        self.setAccessibleName(self.words)
        self.setVisible(bool(self.handles or self.words))
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self.handles and self.dragged:
            _circle(painter, self.centre, self.reach)
        # The chosen one last, over the others.
        for handle in sorted(self.handles, key=lambda handle: handle.chosen):
            _draw(painter, handle)
        if self.words:
            metrics = QFontMetricsF(painter.font())
            wide = metrics.horizontalAdvance(self.words) + 12.0
            left = max(_GAP, 0.5 * (self.width() - wide))
            draw_chip(painter, QPointF(left, _GAP), (self.words,), self.width() - 2 * _GAP)


def _circle(painter: QPainter, centre: QPointF, radius: float) -> None:
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for colour, width in ((QColor(0, 0, 0, 90), 3.0), (_FAINT, 1.0)):
        painter.setPen(QPen(colour, width))
        painter.drawEllipse(centre, radius, radius)


def _draw(painter: QPainter, handle: LampHandle) -> None:
    radius = RADIUS + (2.0 if handle.chosen else 0.0)
    painter.setPen(QPen(_DARK, 4.0))
    painter.setBrush(_DARK)
    painter.drawEllipse(handle.place, radius, radius)
    painter.setPen(QPen(_LIGHT, 2.5 if handle.chosen else 1.5))
    painter.setBrush(QColor(0, 0, 0, 120) if handle.behind else handle.colour)
    painter.drawEllipse(handle.place, radius, radius)
    painter.setPen(handle.colour if handle.behind else QColor(0, 0, 0))
    font = painter.font()
    font.setBold(handle.chosen)
    painter.setFont(font)
    box = QRectF(handle.place.x() - radius, handle.place.y() - radius, 2 * radius, 2 * radius)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(handle.number))

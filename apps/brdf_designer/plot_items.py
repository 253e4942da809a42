"""The parts of the plot that are pyqtgraph's; imported only when the plot is built."""

from __future__ import annotations

import pyqtgraph as pg
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QPen
from PySide6.QtWidgets import QGraphicsItem


class ReadingPoint(pg.TargetItem):
    """A reading: drawn in its own colour, dragged up and down only."""

    started = Signal(int)
    moved = Signal(int, float)
    finished = Signal()

    def __init__(self, highest: float) -> None:
        super().__init__(size=13, symbol="o", movable=True)
        self._highest = highest
        self._angle = 0.0
        self._index = 0
        self.dragging = False
        self.setZValue(10)
        self.setCursor(Qt.CursorShape.SizeVerCursor)

    def show_reading(self, index: int, angle_deg: float, lightness: float, colour: QColor) -> None:
        """Put the point at its reading; nothing is emitted."""
        self._index, self._angle = index, angle_deg
        super().setPos(QPointF(angle_deg, lightness))
        dark = colour.lightness() < 128
        edge = QColor(255, 255, 255) if dark else QColor(0, 0, 0)
        self.setPen(line(edge, 2.0))
        self.setHoverPen(line(edge, 3.5))
        self.setBrush(QBrush(colour))
        self.setHoverBrush(QBrush(colour))

    def mouseDragEvent(self, event: object) -> None:
        """Turn a drag into an L* between 0 and the highest allowed."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        event.accept()
        if event.isStart():
            self.dragging = True
            self._grip = self.pos().y() - self.mapToParent(event.buttonDownPos()).y()
            self.started.emit(self._index)
        lightness = self.mapToParent(event.pos()).y() + self._grip
        self.moved.emit(self._index, round(min(self._highest, max(0.0, lightness)), 2))
        if event.isFinish():
            self.dragging = False
            self.finished.emit()


def make_plot() -> pg.PlotWidget:
    """Return an empty plot with named axes, on which only the points move."""
    plot = pg.PlotWidget()
    plot.setAntialiasing(True)
    plot.setMenuEnabled(False)
    plot.hideButtons()
    plot.setMouseEnabled(x=False, y=False)
    plot.setFrameShape(plot.Shape.NoFrame)
    plot.setLabel("bottom", "Aspecular angle (degrees)")
    plot.setLabel("left", "L*")
    plot.getAxis("left").setWidth(44)
    # Playing an axis with its grid back costs 3 ms a frame; as a kept picture it costs nothing.
    for side in ("bottom", "left"):
        plot.getAxis(side).setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)
    plot.getPlotItem().vb.setDefaultPadding(0)
    return plot


def dress_plot(plot: pg.PlotWidget, text: QColor, base: QColor) -> None:
    """Give ``plot`` the greys of the theme."""
    plot.setBackground(base)
    for side in ("bottom", "left"):
        axis = plot.getAxis(side)
        axis.setPen(line(text, 1.0))
        axis.setTextPen(line(text, 1.0))
    plot.showGrid(x=True, y=True, alpha=0.12)


def line(colour: QColor, width: float, style: Qt.PenStyle = Qt.PenStyle.SolidLine) -> QPen:
    """Return a pen whose width is in pixels."""
    pen = QPen(colour, width, style)
    pen.setCosmetic(True)
    return pen


def hatch(colour: QColor) -> QBrush:
    """Return the hatching of what was not measured."""
    faint = QColor(colour)
    faint.setAlpha(90)
    return QBrush(faint, Qt.BrushStyle.BDiagPattern)

"""The parts of the plots that are pyqtgraph's; imported only when the plots are built."""

from __future__ import annotations

import math
from typing import Protocol

import pyqtgraph as pg
from brdf_qt.program.translation import decimal
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QPen
from PySide6.QtWidgets import QGraphicsItem

_EDGE, _HOVER_EDGE = 2.0, 3.5
_DECADE_ROOM, _NAMED_ROOM = 24.0, 90.0
"""Pixels that a decade wants to be named, and to have ticks named within it."""


class _DragEvent(Protocol):
    """The methods of pyqtgraph's ``MouseDragEvent`` that are used here."""

    def button(self) -> Qt.MouseButton: ...
    def accept(self) -> None: ...
    def isStart(self) -> bool: ...
    def isFinish(self) -> bool: ...
    def buttonDownPos(self) -> QPointF: ...
    def pos(self) -> QPointF: ...


class ReadingPoint(pg.TargetItem):  # type: ignore[misc]  # pyqtgraph has no types
    """A reading: drawn in its own colour, dragged up and down only; :meth:`set_chosen` marks it for the keyboard."""

    started = Signal(int)
    moved = Signal(int, float)
    finished = Signal()

    def __init__(self, lowest: float, highest: float) -> None:
        super().__init__(size=13, symbol="o", movable=True)
        self._lowest, self._highest = lowest, highest
        self._angle = 0.0
        self._colour = QColor()
        self._chosen = QColor()
        self.index = 0
        self.dragging = False
        self.setZValue(10)
        self.setCursor(Qt.CursorShape.OpenHandCursor)

    def show_reading(self, index: int, angle_deg: float, value: float, colour: QColor) -> None:
        """Put the point at its reading; nothing is emitted."""
        self.index, self._angle = index, angle_deg
        if self.pos() != QPointF(angle_deg, value):
            super().setPos(QPointF(angle_deg, value))
        if colour != self._colour:
            self._colour = colour
            self._dress()

    def set_chosen(self, accent: QColor | None) -> None:
        """Ring the point in ``accent``: keys move it; None: they move another one."""
        ring = QColor() if accent is None else accent
        if ring != self._chosen:
            self._chosen = ring
            self._dress()

    def _dress(self) -> None:
        dark = self._colour.lightness() < 128
        edge = QColor(255, 255, 255) if dark else QColor(0, 0, 0)
        if self._chosen.isValid():
            edge = self._chosen
        self.setPen(line(edge, _HOVER_EDGE if self._chosen.isValid() else _EDGE))
        self.setHoverPen(line(edge, _HOVER_EDGE))
        self.setBrush(QBrush(self._colour))
        self.setHoverBrush(QBrush(self._colour))

    def mouseDragEvent(self, event: _DragEvent) -> None:
        """Turn a drag into a value within the range."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        event.accept()
        if event.isStart():
            self.dragging = True
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
            self._grip = self.pos().y() - self.mapToParent(event.buttonDownPos()).y()
            self.started.emit(self.index)
        value = self.mapToParent(event.pos()).y() + self._grip
        self.moved.emit(self.index, round(min(self._highest, max(self._lowest, value)), 2))
        if event.isFinish():
            self.dragging = False
            self.setCursor(Qt.CursorShape.OpenHandCursor)
            self.finished.emit()


class NumberAxis(pg.AxisItem):  # type: ignore[misc]  # pyqtgraph has no types
    """An axis whose numbers have the decimal sign of the program's language."""

    def tickStrings(self, values: list[float], scale: float, spacing: float) -> list[str]:
        """Return the number at each tick."""
        return [decimal(text) for text in super().tickStrings(values, scale, spacing)]


class TurnAxis(pg.AxisItem):  # type: ignore[misc]  # pyqtgraph has no types
    """An axis of hues that run on over 360°; its numbers do not."""

    def tickStrings(self, values: list[float], _scale: float, _spacing: float) -> list[str]:
        """Return each hue between 0 and 360."""
        return [decimal(f"{value % 360.0:g}") for value in values]


class DecadeAxis(pg.AxisItem):  # type: ignore[misc]  # pyqtgraph has no types
    """A logarithmic axis that names its decades, and 2 and 5 within them where there is room; never all nine."""

    def tickValues(self, low: float, high: float, size: float) -> list[tuple[float | None, list[float]]]:
        """Return where the ticks are, as logarithms to base 10."""
        first, last = math.floor(low), math.ceil(high)
        room = size / max(high - low, 1e-9)
        every = max(1, math.ceil(_DECADE_ROOM / max(room, 1e-9)))
        decades = [float(k) for k in range(first, last + 1) if k % every == 0 and low <= k <= high]
        within = [k + math.log10(m) for k in range(first, last + 1) for m in range(2, 10)]
        within = [at for at in within if low <= at <= high]
        named = [at for at in within if round(10.0 ** (at % 1.0)) in (2, 5)]
        if every > 1 or room < _NAMED_ROOM:
            return [(1.0, decades), (None, within if every == 1 else [])]
        return [(1.0, decades), (0.5, named), (None, [at for at in within if at not in named])]

    def tickStrings(self, values: list[float], _scale: float, spacing: float | None) -> list[str]:
        """Return the number at each tick; those between have none."""
        if spacing is None:
            return [""] * len(values)
        return [
            decimal(f"{10.0**at:g}") if -4.0 <= at < 6.0 else f"1e{round(at)}" if at == round(at) else ""
            for at in values
        ]


def make_plot(name: str, *, turns: bool = False, decades: tuple[str, ...] = ()) -> pg.PlotWidget:
    """Return an empty plot with named axes, on which only the points move.

    ``turns`` for hues; ``decades`` names the sides (``left``, ``bottom``) whose axis is logarithmic.
    """
    axes: dict[str, pg.AxisItem] = {
        side: DecadeAxis(side) if side in decades else NumberAxis(side) for side in ("left", "bottom")
    }
    if turns:
        axes["left"] = TurnAxis("left")
    plot = pg.PlotWidget(axisItems=axes)
    plot.setAntialiasing(True)
    plot.setMenuEnabled(False)
    plot.hideButtons()
    plot.setMouseEnabled(x=False, y=False)
    plot.setFrameShape(plot.Shape.NoFrame)
    plot.setLabel("left", name)
    plot.getAxis("left").setWidth(48)
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

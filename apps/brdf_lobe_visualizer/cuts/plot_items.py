"""The parts of plots that are pyqtgraph's; imported only when a plot is built, for pyqtgraph takes 0.15 s to import."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pyqtgraph as pg
from brdf_qt.program.translation import decimal
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPainterPath, QPalette, QPen, QResizeEvent
from PySide6.QtWidgets import (
    QGraphicsItem,
    QGraphicsSceneResizeEvent,
    QGraphicsView,
    QStyleOptionGraphicsItem,
    QWidget,
)

from brdf_lobe_visualizer.cuts.lines import Line
from brdf_lobe_visualizer.cuts.pens import colour_of, grey_pen, hatching_brush, pen_of
from brdf_suite.arrays import Floats

SPOKE_STEP_DEG = 15
_FEW_DECADES = 0.7
"""Below so many there are few numbers, and all have room."""


class LineItem(pg.GraphicsObject):  # type: ignore[misc]  # pyqtgraph has no types
    """A line whose bounds are the plot's: a plot that frames itself need not ask its lines for theirs.

    That, and one path for one change, is a third of the time that pyqtgraph's own curve takes in a drag.
    """

    def __init__(self) -> None:
        super().__init__()
        self._path = QPainterPath()
        self._pen = QPen()

    def set_pen(self, pen: QPen) -> None:
        self._pen = pen
        self.update()

    def set_data(self, x: Floats, y: Floats) -> None:
        """Draw through x (n,) and y (n,); where y is NaN there is a gap."""
        whole = bool(np.isfinite(y).all())
        self._path = pg.arrayToQPath(x, y, connect="all" if whole else "finite", finiteCheck=not whole)
        self.update()

    def boundingRect(self) -> QRectF:
        view = self.viewRect()
        return QRectF() if view is None else view

    def paint(
        self, painter: QPainter, _option: QStyleOptionGraphicsItem, _widget: QWidget | None = None
    ) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(self._pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(self._path)


class ThinnedAxis(pg.AxisItem):  # type: ignore[misc]  # pyqtgraph has no types
    """An axis whose logarithmic numbers keep apart: 1, 2 and 5 of each decade where pyqtgraph would write all nine.

    The numbers have the decimal sign of the program's language. A title that is longer than the axis is not shown
    rather than cut off.
    """

    def resizeEvent(self, event: QGraphicsSceneResizeEvent | None = None) -> None:
        super().resizeEvent(event)
        self._show_title()

    def setLabel(self, *words: Any, **more: Any) -> None:
        super().setLabel(*words, **more)
        self._show_title()

    def _show_title(self) -> None:
        if self.label is not None:  # it is, once the plot is closed
            upright = self.orientation in ("left", "right")
            room = self.size().height() if upright else self.size().width()
            self.label.setOpacity(1.0 if self.label.boundingRect().width() <= room else 0.0)

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        return [decimal(word) for word in super().tickStrings(values, scale, spacing)]

    def logTickStrings(self, values: Sequence[float], scale: float, spacing: float | None) -> list[str]:
        words = super().logTickStrings(values, scale, spacing)
        low, high = sorted(self.range)
        if high - low < _FEW_DECADES:
            return list(words)
        leading = [round(10.0 ** ((value + 1e-9) % 1.0)) for value in values]
        return [word if lead in (1, 2, 5) else "" for word, lead in zip(words, leading, strict=True)]


class SlicePlot(pg.PlotWidget):  # type: ignore[misc]  # pyqtgraph has no types
    """A plot of lines: drag moves it, the wheel zooms, a double click frames all again.

    Signals: ``moved_over(x, y)`` in the plot's own numbers while the mouse is over it, ``left()``; ``framed()`` after a
    double click, ``zoomed()`` when the user has moved or zoomed.
    """

    moved_over = Signal(float, float)
    left = Signal()
    framed = Signal()
    zoomed = Signal()
    resized = Signal()

    def __init__(self, *, with_axes: bool) -> None:
        super().__init__(axisItems={side: ThinnedAxis(side) for side in ("bottom", "left")})
        self.setAntialiasing(True)
        self.setMenuEnabled(False)
        self.hideButtons()
        self.setFrameShape(self.Shape.NoFrame)
        self.getPlotItem().vb.setDefaultPadding(0)
        self.getPlotItem().vb.disableAutoRange()
        self.getPlotItem().vb.sigRangeChangedManually.connect(lambda _mask: self.zoomed.emit())
        # All lines move at once: to work out what of the plot they leave free costs more than to draw it.
        self.setViewportUpdateMode(QGraphicsView.ViewportUpdateMode.FullViewportUpdate)
        self.setMouseTracking(True)
        self.viewport().setMouseTracking(True)
        if with_axes:
            self.getAxis("left").setWidth(64)
            for side in ("bottom", "left"):
                # Playing an axis with its grid back costs 3 ms a frame; as a kept picture it costs nothing.
                self.getAxis(side).setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)
                self.getAxis(side).enableAutoSIPrefix(False)
        else:
            self.hideAxis("left")
            self.hideAxis("bottom")
        self._lines: list[LineItem] = []
        self._pens: list[tuple[object, ...]] = []
        self._points: list[pg.ScatterPlotItem] = []

    def dress(self) -> None:
        palette = self.palette()
        self.setBackground(palette.color(QPalette.ColorRole.Base))
        for side in ("bottom", "left"):
            axis = self.getAxis(side)
            axis.setPen(grey_pen(palette, 1.0))
            axis.setTextPen(grey_pen(palette, 1.0))
        self._pens.clear()

    def show_lines(self, drawn: Sequence[tuple[Line, Floats, Floats]]) -> None:
        """Draw lines at x (n,) and y (n,), NaN being gaps; those before are taken away."""
        while len(self._lines) < len(drawn):
            item = LineItem()
            self.addItem(item, ignoreBounds=True)
            self._lines.append(item)
        base = self.palette().color(QPalette.ColorRole.Base)
        for number, (line, x, y) in enumerate(drawn):
            item = self._lines[number]
            look = (line.colour, line.dash, line.kind, line.is_front, base.rgb())
            if number >= len(self._pens):
                self._pens.append(())
            if self._pens[number] != look:
                item.set_pen(pen_of(line, base))
                self._pens[number] = look
            item.set_data(x, y)
            item.setVisible(True)
        for item in self._lines[len(drawn) :]:
            item.setVisible(False)

    def show_points(self, drawn: Sequence[tuple[Line, Floats, Floats]]) -> None:
        """Draw measured samples as rings at x (n,) and y (n,), in their line's colour."""
        while len(self._points) < len(drawn):
            item = rings()
            item.setZValue(5)
            self.addItem(item)
            self._points.append(item)
        base = self.palette().color(QPalette.ColorRole.Base)
        for item, (line, x, y) in zip(self._points, drawn, strict=False):
            pen = QPen(colour_of(line.colour, base), 1.2)
            # In pixels: a symbol is drawn scaled.
            pen.setCosmetic(True)
            item.setData(x=x, y=y, pen=pen, brush=None)
            item.setVisible(True)
        for item in self._points[len(drawn) :]:
            item.setVisible(False)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        point = self.getPlotItem().vb.mapSceneToView(self.mapToScene(event.position().toPoint()))
        self.moved_over.emit(point.x(), point.y())

    def resizeEvent(self, event: QResizeEvent | None) -> None:
        super().resizeEvent(event)
        if event is not None:  # pyqtgraph calls it without one, too
            self.resized.emit()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.left.emit()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            event.accept()
            self.framed.emit()
        else:
            super().mouseDoubleClickEvent(event)


class HoleBands(pg.GraphicsObject):  # type: ignore[misc]  # pyqtgraph has no types
    """Hatched from top to bottom over spans of x."""

    def __init__(self) -> None:
        super().__init__()
        self._bands: list[tuple[float, float]] = []
        self._brush = hatching_brush(QPalette())
        self.setZValue(-20)

    def show_bands(self, bands: Sequence[tuple[float, float]], palette: QPalette) -> None:
        self._brush = hatching_brush(palette)
        if list(bands) != self._bands:
            self._bands = list(bands)
            self.prepareGeometryChange()
        self.setVisible(bool(self._bands))
        self.update()

    def boundingRect(self) -> QRectF:
        view = self.viewRect()
        return QRectF() if view is None else view

    def paint(
        self, painter: QPainter, _option: QStyleOptionGraphicsItem, _widget: QWidget | None = None
    ) -> None:
        view = self.viewRect()
        if view is None:
            return
        # Hatched in pixels: in the plot's numbers the lines would be stretched with it.
        to_device = painter.transform()
        painter.save()
        painter.resetTransform()
        for low, high in self._bands:
            corner = to_device.map(QPointF(low, view.top()))
            other = to_device.map(QPointF(high, view.bottom()))
            painter.fillRect(QRectF(corner, other).normalized(), self._brush)
        painter.restore()


class PolarRings(pg.GraphicsObject):  # type: ignore[misc]  # pyqtgraph has no types
    """Rings of radii up to 1 and spokes of a half disc, the normal upwards; drawn once and kept."""

    def __init__(self) -> None:
        super().__init__()
        self._radii: tuple[float, ...] = ()
        self._palette = QPalette()
        self.setZValue(-20)
        # Drawn anew it takes 2 ms a frame; as a kept picture nothing.
        self.setCacheMode(self.CacheMode.DeviceCoordinateCache)

    def show_rings(self, radii: Sequence[float], palette: QPalette) -> None:
        self._radii, self._palette = tuple(radii), QPalette(palette)
        self.update()

    def boundingRect(self) -> QRectF:
        return QRectF(-1.02, -0.02, 2.04, 1.06)

    def paint(
        self, painter: QPainter, _option: QStyleOptionGraphicsItem, _widget: QWidget | None = None
    ) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        rings, edge = QPainterPath(), QPainterPath()
        for radius in self._radii:
            path = edge if radius > 0.999 else rings
            path.arcMoveTo(QRectF(-radius, -radius, 2 * radius, 2 * radius), 0.0)
            # The plot's y grows upwards, Qt's downwards: the upper half is below for it.
            path.arcTo(QRectF(-radius, -radius, 2 * radius, 2 * radius), 0.0, -180.0)
        for spoke in range(-90, 91, SPOKE_STEP_DEG):
            path = edge if abs(spoke) == 90 or spoke == 0 else rings
            path.moveTo(0.0, 0.0)
            path.lineTo(float(np.sin(np.radians(spoke))), float(np.cos(np.radians(spoke))))
        painter.setPen(grey_pen(self._palette, 0.16))
        painter.drawPath(rings)
        painter.setPen(grey_pen(self._palette, 0.4))
        painter.drawPath(edge)


def upright() -> pg.InfiniteLine:
    """Return a line from top to bottom that stands for an angle."""
    line = pg.InfiniteLine(angle=90, movable=False)
    line.setZValue(-5)
    return line


def level(value: float) -> pg.InfiniteLine:
    """Return a line from side to side that stands for a value."""
    return pg.InfiniteLine(pos=value, angle=0, movable=False)


def text(words: str = "", anchor: tuple[float, float] = (0.5, 0.5)) -> pg.TextItem:
    """Return words whose place ``anchor`` lies at a point of the plot."""
    return pg.TextItem(words, anchor=anchor)


def rings() -> pg.ScatterPlotItem:
    """Return points that are drawn as rings."""
    return pg.ScatterPlotItem(size=7, pxMode=True, symbol="o")


def band() -> pg.LinearRegionItem:
    """Return a band behind the lines that stands for a value."""
    item = pg.LinearRegionItem((0.0, 0.0), movable=False)
    item.setZValue(-10)
    return item

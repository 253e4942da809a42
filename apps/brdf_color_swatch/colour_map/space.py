"""The map in three dimensions: every swatch a point in a*, b* and L*. Left drag orbits, a lasso selects."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from brdf_qt.gl.items import BEFORE, OPAQUE, DiscItem, SegmentItem
from brdf_qt.gl.segments import polyline, segments
from brdf_qt.gl.space import SpaceView, project
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPalette, QVector3D
from PySide6.QtWidgets import QWidget

from brdf_color_swatch.colour_map.plane import draw_line, draw_name, mode_of, outline_colour
from brdf_color_swatch.colour_map.points import LassoLine, MapPoints, inside, nearest

_REACH = 80.0
_TOP = 100.0
_SIZE, _SIZE_CHOSEN = 11.0, 17.0
_MANY = 2000
_CENTRE = QVector3D(0.0, 0.0, 50.0)


class SpaceMap(SpaceView):
    """Signal ``chosen(ids, mode)`` as :class:`~brdf_color_swatch.colour_map.plane.PlaneMap` has it.

    ``lasso``: a left drag draws one instead of turning the view; with Ctrl it always does.
    """

    chosen = Signal(object, str)
    mousePos: QPointF  # noqa: N815 - the name is pyqtgraph's

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(tr("Three-dimensional colour map"))
        self.lasso = False
        self.line = LassoLine()
        self._points: MapPoints | None = None
        self.hovered = -1
        """The point under the pointer, whose name is shown; -1: none."""
        self._press: QPointF | None = None
        self._chosen: set[str] = set()
        self.opts["fov"] = 45
        self._size_before = self._distance()
        self.frame()
        self.make_items()

    def make_items(self) -> None:
        self._axes = SegmentItem()
        self._cloud, self._ring, self._front = DiscItem(OPAQUE), DiscItem(BEFORE), DiscItem(BEFORE)
        # Larger than the points, of their depth and drawn first, it is seen around them alone. What is selected is
        # seen through the others.
        self._outline = DiscItem(OPAQUE)
        items: list[Any] = [self._outline, self._cloud, self._axes, self._ring, self._front]
        for order, item in enumerate(items):
            item.setDepthValue(order)
            self.addItem(item)
        self._dress()
        if self._points is not None:
            chosen = self._chosen
            self.show_points(self._points)
            self.show_chosen(chosen)

    def paint_words(self, painter: QPainter, _size: QSize) -> None:
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        marks = [
            ("+a*", (_REACH + 8, 0, 0)), ("−a*", (-_REACH - 8, 0, 0)), ("+b*", (0, _REACH + 8, 0)),
            ("−b*", (0, -_REACH - 8, 0)), ("L* 100", (0, 0, _TOP + 6)), ("L* 0", (0, 0, -6)),
        ]  # fmt: skip
        at, _depth = self.project(np.array([place for _, place in marks], float))
        for (text, _place), (x, y) in zip(marks, at, strict=True):
            if np.isfinite(x):
                wide = painter.fontMetrics().horizontalAdvance(text)
                painter.drawText(QPointF(x - wide / 2, y + 4), text)
        if self.line.is_drawn:
            draw_line(painter, self.line, self.palette())
        elif self._points is not None and self.hovered >= 0:
            x, y = self.pixels()[0][self.hovered]
            name = self._points.names[self.hovered]
            draw_name(painter, QPointF(x, y), name, QRectF(self.rect()), self.palette())

    def show_points(self, points: MapPoints) -> None:
        self._points, self.hovered = points, -1
        known = np.isfinite(points.lab).all(axis=1)
        side = _SIZE if known.sum() < _MANY else 0.55 * _SIZE
        self._cloud.setData(pos=_at(points.lab[known]), color=_colours(points.codes[known]), size=side)
        ring = np.tile(np.array(outline_colour(self.palette()).getRgbF(), np.float32), (int(known.sum()), 1))
        self._outline.setVisible(0 < known.sum() < _MANY)
        if known.any():
            self._outline.setData(pos=_at(points.lab[known]), color=ring, size=side + 2.0)
        self.show_chosen(set())

    def sizeHint(self) -> QSize:
        return QSize(420, 420)

    def show_chosen(self, ids: set[str]) -> None:
        """Show which are selected: larger, in a ring of the accent, and before the others."""
        self._chosen = set(ids)
        if self._points is None:
            return
        known = np.isfinite(self._points.lab).all(axis=1)
        chosen = known & np.fromiter((key in ids for key in self._points.ids), bool, len(self._points))
        accent = self.palette().color(QPalette.ColorRole.Highlight)
        at, count = _at(self._points.lab[chosen]), int(chosen.sum())
        for item, colours, size in (
            (self._ring, accent.getRgbF(), _SIZE_CHOSEN),
            (self._front, _colours(self._points.codes[chosen]), _SIZE),
        ):
            item.setVisible(count > 0)
            if count:
                item.setData(pos=at, color=colours, size=size)

    def frame(self) -> None:
        """Turn back to where the view begins."""
        self.setCameraPosition(pos=_CENTRE, distance=self._distance(), elevation=18, azimuth=-60)
        self.update()

    def _distance(self) -> float:
        """How far away the whole body of colours fits into the view; the angle of view is that of the width."""
        share = min(1.0, self.height() / max(1, self.width()))
        fov_deg = float(self.opts["fov"])
        distance: float = 1.22 * _REACH / (math.tan(math.radians(0.5 * fov_deg)) * max(0.2, share))
        return distance

    def project(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return where points (n, 3) of a*, b*, L* are in this widget (n, 2), and how far away (n,)."""
        area = self.getViewport()
        matrix = self.projectionMatrix(area, area) * self.viewMatrix()
        return project(matrix, points, QRectF(self.rect()))

    def pixels(self) -> tuple[np.ndarray, np.ndarray]:
        """Return where the swatches (n, 2) are in this widget, and how far away (n,)."""
        lab = self._points.lab if self._points is not None else np.zeros((0, 3))
        return self.project(lab[:, [1, 2, 0]])

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        self._press = at if event.button() is Qt.MouseButton.LeftButton else None
        draws = self.lasso or bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if event.button() is Qt.MouseButton.LeftButton and draws:
            self.line.begin(at.x(), at.y())
            return
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if self.line.is_drawn:
            self.line.extend(at.x(), at.y())
        elif event.buttons():
            if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
                step = at - self.mousePos
                self.mousePos = at
                self.pan(step.x(), step.y(), 0, relative="view")
            else:
                super().mouseMoveEvent(event)
        else:
            found = nearest(self.pixels()[0], (at.x(), at.y()), self.pixels()[1])
            self.hovered = -1 if found is None else found
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        press, self._press = self._press, None
        at, depth = self.pixels()
        points = self._points
        if self.line.is_drawn:
            line, click = self.line.points, self.line.is_click
            self.line.end()
            self.update()
            if points is not None and not click:
                ids = tuple(points.ids[place] for place in np.flatnonzero(inside(at, line)))
                mode = "set" if mode_of(event) == "add" and not self.lasso else mode_of(event)
                self.chosen.emit(ids, mode)
                return
        if press is None or points is None or math.dist(press.toTuple(), event.position().toTuple()) > 4.0:
            super().mouseReleaseEvent(event)
            return
        found = nearest(at, press.toTuple(), depth)
        self.chosen.emit(() if found is None else (points.ids[found],), mode_of(event))

    def wheelEvent(self, event: object) -> None:
        super().wheelEvent(event)
        self.update()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_F:
            self.frame()
            return
        super().keyPressEvent(event)
        self.update()

    def resizeEvent(self, event: object) -> None:
        before = self._size_before
        super().resizeEvent(event)
        self._size_before = self._distance()
        # What filled the view goes on to fill it.
        self.opts["distance"] *= self._size_before / before

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._dress()

    def _dress(self) -> None:
        self.setBackgroundColor(self.palette().color(QPalette.ColorRole.Window))
        red, green, blue, _ = self.palette().color(QPalette.ColorRole.PlaceholderText).getRgbF()
        colour = (red, green, blue, 0.6)
        turn = np.linspace(0.0, 2.0 * np.pi, 73)
        circle = 0.75 * _REACH * np.stack((np.cos(turn), np.sin(turn), np.zeros_like(turn)), axis=1)
        ends = np.array([[_REACH, 0.0, 0.0], [0.0, _REACH, 0.0], [0.0, 0.0, _TOP]])
        axes = segments(ends * (-1.0, -1.0, 0.0), ends, (1.0, 1.0), colour)
        circles = [polyline(np.add(circle, (0.0, 0.0, height)), 1.0, colour) for height in (0.0, 50.0)]
        self._axes.set_segments(np.concatenate((axes, *circles)))


def _at(lab: np.ndarray) -> np.ndarray:
    return np.ascontiguousarray(lab[:, [1, 2, 0]], np.float32)


def _colours(codes: np.ndarray) -> np.ndarray:
    return np.concatenate([codes / 255.0, np.ones((len(codes), 1))], axis=1).astype(np.float32)

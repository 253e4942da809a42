"""The map in three dimensions: every swatch a point in a*, b* and L*. Left drag orbits, a lasso selects."""

from __future__ import annotations

import math

import numpy as np
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import tr
from OpenGL import GL
from pyqtgraph.opengl import GLLinePlotItem, GLScatterPlotItem, GLViewWidget  # pyqtgraph has no types
from PySide6.QtCore import QEvent, QPointF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPalette, QVector3D
from PySide6.QtOpenGL import QOpenGLVertexArrayObject
from PySide6.QtWidgets import QToolTip, QWidget

from brdf_color_swatch.map.lasso import LassoLine, inside, nearest
from brdf_color_swatch.map.plane import draw_line, mode_of
from brdf_color_swatch.map.points import MapPoints

_REACH = 80.0
_TOP = 100.0
_SIZE, _SIZE_CHOSEN = 9.0, 15.0
_MANY = 2000
_BLEND = (GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
_CENTRE = QVector3D(0.0, 0.0, 50.0)


class _Words(QWidget):
    """Names of the axes, and the lasso, over the points."""

    def __init__(self, view: SpaceMap) -> None:
        super().__init__(view)
        self._view = view
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        marks = [
            ("+a*", (_REACH + 8, 0, 0)), ("−a*", (-_REACH - 8, 0, 0)), ("+b*", (0, _REACH + 8, 0)),
            ("−b*", (0, -_REACH - 8, 0)), ("L* 100", (0, 0, _TOP + 6)), ("L* 0", (0, 0, -6)),
        ]  # fmt: skip
        at, _depth = self._view.project(np.array([place for _, place in marks], float))
        for (text, _place), (x, y) in zip(marks, at, strict=True):
            if np.isfinite(x):
                wide = painter.fontMetrics().horizontalAdvance(text)
                painter.drawText(QPointF(x - wide / 2, y + 4), text)
        if self._view.line.is_drawn:
            draw_line(painter, self._view.line, self.palette())


class SpaceMap(GLViewWidget):  # type: ignore[misc]  # pyqtgraph has no types
    """Signal ``chosen(ids, mode)`` as :class:`~brdf_color_swatch.map.plane.PlaneMap` has it.

    ``lasso``: a left drag draws one instead of turning the view; with Ctrl it always does.
    """

    chosen = Signal(object, str)
    mousePos: QPointF  # noqa: N815 - the name is pyqtgraph's

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(tr("Three-dimensional colour map"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.lasso = False
        self.line = LassoLine()
        self._points: MapPoints | None = None
        self._press: QPointF | None = None
        self._has_context = False
        self._chosen: set[str] = set()
        self._make_items()
        self._words = _Words(self)
        self._size_before = self._distance()
        self.frame()
        self._dress()

    def _make_items(self) -> None:
        self._axes = GLLinePlotItem(mode="lines", antialias=True, width=1.0)
        self._cloud = GLScatterPlotItem(pxMode=True)
        self._ring = GLScatterPlotItem(pxMode=True)
        self._front = GLScatterPlotItem(pxMode=True)
        for item in (self._axes, self._cloud, self._ring, self._front):
            item.setGLOptions("translucent")
            self.addItem(item)
        for item in (self._ring, self._front):
            # What is selected is seen through the others.
            item.setGLOptions({GL.GL_DEPTH_TEST: False, GL.GL_BLEND: True, "glBlendFunc": _BLEND})
        self._ring.setDepthValue(1)
        self._front.setDepthValue(2)

    def initializeGL(self) -> None:
        # pyqtgraph keeps its programs for the process, and its buffers for the item; both belong to a context, which
        # is another one where the panel has been floated or docked.
        GLScatterPlotItem._shaderProgram = GLLinePlotItem._shaderProgram = None
        if self._has_context:
            self.items.clear()
            self.default_vao = QOpenGLVertexArrayObject(self)
            self._make_items()
        self._has_context = True
        super().initializeGL()
        self._dress()
        if self._points is not None:
            chosen = self._chosen
            self.show_points(self._points)
            self.show_chosen(chosen)

    # What is shown.

    def show_points(self, points: MapPoints) -> None:
        """Show the points."""
        self._points = points
        known = np.isfinite(points.lab).all(axis=1)
        side = _SIZE if known.sum() < _MANY else 0.55 * _SIZE
        self._cloud.setData(
            pos=_at(points.lab[known]), color=_colours(points.codes[known]), size=np.full(known.sum(), side)
        )
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
        ring = np.tile([accent.redF(), accent.greenF(), accent.blueF(), 1.0], (count, 1)).astype(np.float32)
        for item, colours, size in (
            (self._ring, ring, _SIZE_CHOSEN),
            (self._front, _colours(self._points.codes[chosen]), _SIZE),
        ):
            item.setVisible(count > 0)
            if count:
                item.setData(pos=at, color=colours, size=np.full(count, size))

    def frame(self) -> None:
        """Turn back to where the view begins."""
        self.setCameraPosition(pos=_CENTRE, distance=self._distance(), elevation=18, azimuth=-60)
        self._words.update()

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
        rows = np.array([[value.x(), value.y(), value.z(), value.w()] for value in map(matrix.row, range(4))])
        whole = np.concatenate([points, np.ones((len(points), 1))], axis=1) @ rows.T
        w = np.where(whole[:, 3] > 1e-6, whole[:, 3], np.nan)
        x = (whole[:, 0] / w * 0.5 + 0.5) * self.width()
        y = (0.5 - whole[:, 1] / w * 0.5) * self.height()
        return np.stack([x, y], axis=1), whole[:, 3]

    def pixels(self) -> tuple[np.ndarray, np.ndarray]:
        """Return where the swatches (n, 2) are in this widget, and how far away (n,)."""
        lab = self._points.lab if self._points is not None else np.zeros((0, 3))
        return self.project(lab[:, [1, 2, 0]])

    # The mouse.

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
            text = "" if found is None or self._points is None else self._points.names[found][:120]
            QToolTip.showText(event.globalPosition().toPoint(), plain_tip(text), self)
        self._words.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        press, self._press = self._press, None
        at, depth = self.pixels()
        points = self._points
        if self.line.is_drawn:
            line, click = self.line.points, self.line.is_click
            self.line.end()
            self._words.update()
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
        self._words.update()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_F:
            self.frame()
            return
        super().keyPressEvent(event)
        self._words.update()

    def resizeEvent(self, event: object) -> None:
        before = self._size_before
        super().resizeEvent(event)
        self._words.setGeometry(self.rect())
        self._size_before = self._distance()
        # What filled the view goes on to fill it.
        self.opts["distance"] *= self._size_before / before

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_words"):
            self._dress()

    def _dress(self) -> None:
        self.setBackgroundColor(self.palette().color(QPalette.ColorRole.Window))
        grey = self.palette().color(QPalette.ColorRole.PlaceholderText)
        self.opts["fov"] = 45
        lines = [(-_REACH, 0, 0), (_REACH, 0, 0), (0, -_REACH, 0), (0, _REACH, 0), (0, 0, 0), (0, 0, _TOP)]
        for centre in (0.0, 50.0):
            for number in range(72):
                for step in (number, number + 1):
                    angle = 2 * math.pi * step / 72
                    lines.append((0.75 * _REACH * math.cos(angle), 0.75 * _REACH * math.sin(angle), centre))
        self._axes.setData(
            pos=np.array(lines, np.float32), color=(grey.redF(), grey.greenF(), grey.blueF(), 0.6)
        )


def _at(lab: np.ndarray) -> np.ndarray:
    return np.ascontiguousarray(lab[:, [1, 2, 0]], np.float32)


def _colours(codes: np.ndarray) -> np.ndarray:
    return np.concatenate([codes / 255.0, np.ones((len(codes), 1))], axis=1).astype(np.float32)

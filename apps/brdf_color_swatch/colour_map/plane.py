"""The map in two dimensions: flop over lightness, b* over a*, gloss over flop. Left drag draws a lasso."""

from __future__ import annotations

import math

import numpy as np
import pyqtgraph as pg  # pyqtgraph has no types
from brdf_qt.program.translation import decimal, mark, tr
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, QSizeF, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPalette, QPen, QPolygonF, QTransform
from PySide6.QtWidgets import QWidget

from brdf_color_swatch.colour_map.points import LassoLine, MapPoints, inside, nearest
from brdf_suite.foreign_text import make_visible

_AXES = {
    "flop": (mark("Lightness L* at 45°"), mark("Flop index")),
    "ab": (mark("a* at 45°, green to red"), mark("b* at 45°, blue to yellow")),
    "gloss": (mark("Flop index"), mark("Gloss at 20° (GU)")),
}
_SIDE, _SIDE_CHOSEN = 13, 17
_OUTLINE_ALPHA, _GRID_ALPHA = 170, 0.22
_TICK_PX = 64.0
"""From label to label at least."""
_LEAST_RANGE = 5.0
_MANY = 3000
_MOST_RINGED = 2000
"""Of more that are selected, the rest is drawn without a ring: rings alone would be seen."""


class _Cloud(pg.GraphicsObject):  # type: ignore[misc]  # pyqtgraph has no types
    """The points, painted as they are seen: in pixels of their own, whatever the scale."""

    def __init__(self) -> None:
        super().__init__()
        self._at = np.zeros((0, 2))
        self._colours: list[QColor] = []
        self._chosen: np.ndarray = np.zeros(0, bool)
        self.box = QRectF()
        """Around the points, without their own size."""
        self.palette = QPalette()

    def show_points(self, at: np.ndarray, codes: np.ndarray) -> None:
        self.prepareGeometryChange()
        self._at = at
        self._colours = [QColor(*code) for code in codes.tolist()]
        self._chosen = np.zeros(len(at), bool)
        known = at[np.isfinite(at).all(axis=1)]
        self.box = QRectF()
        if len(known):
            low, high = known.min(axis=0), known.max(axis=0)
            self.box = QRectF(QPointF(*low), QPointF(*np.maximum(high, low + 1e-6)))
        self.informViewBoundsChanged()
        self.update()

    def show_chosen(self, chosen: np.ndarray) -> None:
        self._chosen = chosen
        self.update()

    def boundingRect(self) -> QRectF:
        # Points reach over the edges by their own size.
        across = self.pixelVectors()
        wide = abs(across[0].x()) * _SIDE_CHOSEN if across[0] is not None else 0.0
        high = abs(across[1].y()) * _SIDE_CHOSEN if across[1] is not None else 0.0
        return self.box.adjusted(-wide, -high, wide, high)

    def dataBounds(
        self,
        ax: int,
        frac: float = 1.0,  # noqa: ARG002 - pyqtgraph calls it by these names
        orthoRange: object = None,  # noqa: ARG002 - as above
    ) -> tuple[float, float] | None:
        if self.box.isNull():
            return None
        if ax == 0:
            return self.box.left(), self.box.right()
        return self.box.top(), self.box.bottom()

    def pixels(self) -> np.ndarray:
        """Return where the points (n, 2) are on the screen."""
        return _mapped(self.sceneTransform(), self._at)

    def paint(self, painter: QPainter, *_: object) -> None:
        if not len(self._at):
            return
        at = _mapped(painter.transform(), self._at)
        painter.save()
        painter.resetTransform()
        many = len(at) > _MANY
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, not many)
        ring = outline_colour(self.palette)
        ratio = painter.device().devicePixelRatioF()
        side = _SIDE * ratio * (0.55 if many else 1.0)
        known = np.isfinite(at).all(axis=1)
        painter.setPen(QPen(ring, ratio) if not many else Qt.PenStyle.NoPen)
        ringed = np.flatnonzero(known & self._chosen)[:_MOST_RINGED]
        plain = known.copy()
        plain[ringed] = False
        for place in np.flatnonzero(plain).tolist():
            box = QRectF(QPointF(*(at[place] - side / 2)), QSizeF(side, side))
            if many:
                painter.fillRect(box, self._colours[place])
            else:
                painter.setBrush(self._colours[place])
                painter.drawEllipse(box)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=True)
        # What is selected has a ring in the accent, and lies over the rest.
        painter.setPen(QPen(self.palette.color(QPalette.ColorRole.Highlight), 2.5 * ratio))
        side = _SIDE_CHOSEN * ratio
        for place in ringed.tolist():
            painter.setBrush(self._colours[place])
            painter.drawEllipse(QRectF(QPointF(*(at[place] - side / 2)), QSizeF(side, side)))
        painter.restore()


class _Axis(pg.AxisItem):  # type: ignore[misc]  # pyqtgraph has no types
    """An axis whose labels are far enough apart to be read at a glance, with a line of the grid for each."""

    def tickSpacing(self, minVal: float, maxVal: float, size: float) -> list[tuple[float, float]]:
        least = abs(maxVal - minVal) * _TICK_PX / max(1.0, size)
        unit = 10.0 ** math.floor(math.log10(least)) if least > 0.0 else 1.0
        step = next((unit * factor for factor in (1.0, 2.0, 5.0) if unit * factor >= least), 10.0 * unit)
        return [(step, 0.0)]

    def tickStrings(self, values: list[float], scale: float, spacing: float) -> list[str]:
        return [decimal(text.replace("-", "−")) for text in super().tickStrings(values, scale, spacing)]


class PlaneMap(pg.PlotWidget):  # type: ignore[misc]  # pyqtgraph has no types
    """One plane. Signal ``chosen(ids, mode)`` where a lasso or a click has chosen; mode ``set``, ``add``, ``drop``."""

    chosen = Signal(object, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent, axisItems={side: _Axis(side) for side in ("bottom", "left")})
        self._points: MapPoints | None = None
        self._which = "flop"
        self._line = LassoLine()
        self.hovered = -1
        """The point under the pointer, whose name is shown; -1: none."""
        self._zeros = [pg.InfiniteLine(angle=angle) for angle in (0, 90)]
        for line in self._zeros:
            self.addItem(line)
        self.cloud = _Cloud()
        self.addItem(self.cloud)
        self.setMenuEnabled(False)
        self.hideButtons()
        self.setAccessibleName(tr("Two-dimensional colour map"))
        self.getViewBox().setMouseEnabled(x=True, y=True)
        self.viewport().installEventFilter(self)
        self.viewport().setMouseTracking(True)
        self.viewport().setCursor(Qt.CursorShape.CrossCursor)
        self._dress()

    def show_points(self, points: MapPoints, which: str) -> None:
        """Show the points of a plane; another palette or plane is framed."""
        again = self._which != which or self._points is None or points.ids != self._points.ids
        self._points, self._which, self.hovered = points, which, -1
        for line in self._zeros:
            line.setVisible(which == "ab")
        self.cloud.show_points(points.plane(which), points.codes)
        for side, text in zip(("bottom", "left"), _AXES[which], strict=True):
            self.setLabel(side, tr(text))
            # No powers of ten in these units: "Flop index (x1e-06)".
            self.getAxis(side).enableAutoSIPrefix(False)
        self.setAspectLocked(which == "ab")
        if again:
            self.frame()

    def show_chosen(self, ids: set[str]) -> None:
        if self._points is not None:
            self.cloud.show_chosen(
                np.fromiter((key in ids for key in self._points.ids), bool, len(self._points))
            )

    def frame(self) -> None:
        """Show all points, and at least a range of five: a difference of nothing fills no plane."""
        box = self.cloud.box
        wide, high = max(_LEAST_RANGE, box.width()), max(_LEAST_RANGE, box.height())
        # What begins at 0 goes up from there; the rest is in the middle.
        left = box.left() if box.left() == 0.0 else box.center().x() - wide / 2
        top = box.top() if box.top() == 0.0 else box.center().y() - high / 2
        self.getViewBox().setRange(QRectF(left, top, wide, high), padding=0.08)

    def pixels(self) -> np.ndarray:
        """Return where the points (n, 2) are in this widget."""
        return _mapped(self.viewportTransform(), self.cloud.pixels())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.viewport() and isinstance(event, QMouseEvent) and self._mouse(event):
            return True
        return bool(super().eventFilter(watched, event))

    def _mouse(self, event: QMouseEvent) -> bool:
        at = event.position()
        kind, left = event.type(), Qt.MouseButton.LeftButton
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if kind == QEvent.Type.MouseButtonDblClick and event.button() is left:
            self.frame()
        elif kind == QEvent.Type.MouseButtonPress and event.button() is left and not shift:
            self._line.begin(at.x(), at.y())
        elif kind == QEvent.Type.MouseMove and self._line.is_drawn:
            self._line.extend(at.x(), at.y())
            self.viewport().update()
        elif kind == QEvent.Type.MouseButtonRelease and self._line.is_drawn:
            self._close(event)
        else:
            if kind == QEvent.Type.MouseMove and not event.buttons():
                self._hover((at.x(), at.y()))
            elif kind == QEvent.Type.Wheel:
                self._hover(None)
            return False
        return True

    def _close(self, event: QMouseEvent) -> None:
        points, click = self._line.points, self._line.is_click
        self._line.end()
        self.viewport().update()
        if self._points is None:
            return
        at = self.pixels()
        if click:
            found = nearest(at, points[0])
            ids: tuple[str, ...] = () if found is None else (self._points.ids[found],)
        else:
            ids = tuple(self._points.ids[place] for place in np.flatnonzero(inside(at, points)))
        self.chosen.emit(ids, mode_of(event))

    def _hover(self, at: tuple[float, float] | None) -> None:
        found = nearest(self.pixels(), at) if self._points is not None and at is not None else None
        hovered = -1 if found is None else found
        if hovered != self.hovered:
            self.hovered = hovered
            self.viewport().update()

    def paintEvent(self, event: object) -> None:
        super().paintEvent(event)
        painter = QPainter(self.viewport())
        if self._points is not None and self.hovered >= 0 and not self._line.is_drawn:
            x, y = self.pixels()[self.hovered]
            name = self._points.names[self.hovered]
            draw_name(painter, QPointF(x, y), name, QRectF(self.viewport().rect()), self.palette())
        if self._line.is_drawn:
            draw_line(painter, self._line, self.palette())
        painter.end()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "cloud"):
            self._dress()

    def _dress(self) -> None:
        colours = self.palette()
        self.setBackground(colours.color(QPalette.ColorRole.Window))
        self.cloud.palette = colours
        text = colours.color(QPalette.ColorRole.WindowText)
        for side in ("bottom", "left"):
            axis = self.getAxis(side)
            axis.setPen(text)
            axis.setTextPen(text)
        self.showGrid(x=True, y=True, alpha=_GRID_ALPHA)
        zero = QColor(text)
        zero.setAlpha(110)
        for line in self._zeros:
            line.setPen(zero)


def _mapped(transform: QTransform, at: np.ndarray) -> np.ndarray:
    """Return where an affine transform takes points (n, 2)."""
    turn = np.array([[transform.m11(), transform.m12()], [transform.m21(), transform.m22()]])
    return np.asarray(at @ turn + (transform.dx(), transform.dy()))


def outline_colour(palette: QPalette) -> QColor:
    """Return the colour around every point: that of text, so that no paint vanishes in the ground."""
    colour = QColor(palette.color(QPalette.ColorRole.WindowText))
    colour.setAlpha(_OUTLINE_ALPHA)
    return colour


def draw_name(painter: QPainter, at: QPointF, name: str, room: QRectF, palette: QPalette) -> None:
    """Draw the name of a point beside it, within ``room``, and a ring around the point."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    text = painter.fontMetrics().elidedText(
        make_visible(name[:120]), Qt.TextElideMode.ElideMiddle, int(room.width()) - 16
    )
    width, height = painter.fontMetrics().horizontalAdvance(text) + 12, painter.fontMetrics().height() + 6
    reach = 0.5 * _SIDE_CHOSEN + 3.0
    right = at.x() + reach + width <= room.right()
    left = at.x() + reach if right else max(room.left(), at.x() - reach - width)
    top = min(max(room.top(), at.y() - height / 2), room.bottom() - height)
    painter.setPen(QPen(palette.color(QPalette.ColorRole.WindowText), 1.5))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawEllipse(at, reach - 2.0, reach - 2.0)
    box = QRectF(left, top, width, height)
    painter.setPen(palette.color(QPalette.ColorRole.Mid))
    painter.setBrush(palette.color(QPalette.ColorRole.ToolTipBase))
    painter.drawRoundedRect(box, 3, 3)
    painter.setPen(palette.color(QPalette.ColorRole.ToolTipText))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


def mode_of(event: QMouseEvent) -> str:
    """Return whether a lasso chooses anew (``set``), more with Ctrl (``add``) or fewer with Alt (``drop``)."""
    if event.modifiers() & Qt.KeyboardModifier.AltModifier:
        return "drop"
    return "add" if event.modifiers() & Qt.KeyboardModifier.ControlModifier else "set"


def draw_line(painter: QPainter, line: LassoLine, palette: QPalette) -> None:
    """Draw a lasso while it is drawn."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    accent = palette.color(QPalette.ColorRole.Highlight)
    painter.setPen(QPen(accent, 1.5, Qt.PenStyle.DashLine))
    fill = QColor(accent)
    fill.setAlpha(40)
    painter.setBrush(fill)
    painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in line.points]))

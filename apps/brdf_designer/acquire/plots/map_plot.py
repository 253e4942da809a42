"""A map over two angles in greys, with its scale beside it: how well a table is covered.

Drawn by a painter: a hundred cells by a hundred, axes with names and units, hatched where nothing was measured.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from brdf_qt.program.translation import tr
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QFontMetricsF, QImage, QMouseEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QSizePolicy, QWidget

from brdf_designer.acquire.plots.marks import hatch_area
from brdf_designer.acquire.plots.tone import area_of, image_of

_BAR = 14.0
_GAP = 8.0
_CENTRE = Qt.AlignmentFlag.AlignCenter


@dataclass(frozen=True, eq=False)
class AngleMap:
    """``values`` (rows, columns), NaN where there is none; edges of columns and rows as shares of the axis 0…1.

    ``x_ticks`` and ``y_ticks`` are (share, text). ``low`` and ``high`` are the ends of the scale, ``scale`` its name.
    """

    values: NDArray[np.floating]
    x_name: str
    y_name: str
    x_ticks: tuple[tuple[float, str], ...]
    y_ticks: tuple[tuple[float, str], ...]
    scale: str
    low: float
    high: float
    scale_ticks: tuple[tuple[float, str], ...] = ()


class MapPlot(QWidget):
    """One map; ``hovered(row, column)`` gives the cell under the cursor, (−1, −1) none."""

    hovered = Signal(int, int)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self.setMouseTracking(True)
        self.setMinimumSize(220, 180)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.map: AngleMap | None = None
        self._image, self._unknown = QImage(), QImage()

    def sizeHint(self) -> QSize:
        return QSize(520, 420)

    def clear(self, text: str) -> None:
        """Show no map, and say why."""
        self.map, self._empty = None, text
        self.setAccessibleDescription(text)
        self.update()

    _empty = ""

    def show_map(self, shown: AngleMap) -> None:
        """Show this one."""
        self.map = shown
        values = np.asarray(shown.values, dtype=float)
        unknown = ~np.isfinite(values)
        share = np.clip((np.nan_to_num(values) - shown.low) / max(shown.high - shown.low, 1e-12), 0.0, 1.0)
        # Upright: the first row at the foot.
        self._image = image_of(np.rint(30.0 + 210.0 * share).astype(np.uint8)[::-1])
        self._unknown = area_of(unknown[::-1])
        self.setAccessibleDescription(
            tr("{share:.0f} % of the cells contain data").format(share=100.0 * float(1.0 - unknown.mean()))
        )
        self.update()

    def _place(self) -> QRectF:
        metrics = QFontMetricsF(self.font())
        assert self.map is not None
        left = (
            max((metrics.horizontalAdvance(t) for _, t in self.map.y_ticks), default=0.0)
            + metrics.height()
            + 16.0
        )
        right = max((metrics.horizontalAdvance(t) for _, t in self.map.scale_ticks), default=0.0)
        right += _BAR + metrics.height() + 2.0 * _GAP + 16.0
        foot = 2.0 * metrics.height() + 16.0
        room = QRectF(self.rect()).adjusted(left, 12.0, -right, -foot)
        side = min(room.width(), room.height() * 1.35)
        return QRectF(room.left() + 0.5 * (room.width() - side), room.top(), side, room.height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        role = QPalette.ColorRole
        painter.fillRect(self.rect(), self.palette().color(role.Base))
        ink = self.palette().color(role.WindowText)
        if self.map is None:
            painter.setPen(ink)
            room = self.rect().adjusted(24, 24, -24, -24)
            painter.drawText(room, _CENTRE | Qt.TextFlag.TextWordWrap, self._empty)
            return
        metrics = QFontMetricsF(self.font())
        place = self._place()
        if place.width() < 8.0 or place.height() < 8.0:
            return
        painter.drawImage(place, self._image)
        faint = self.palette().color(role.PlaceholderText)
        hatching = QBrush(faint, Qt.BrushStyle.BDiagPattern)
        ground = self.palette().color(role.Base)
        hatch_area(painter, self._unknown, place, place.toAlignedRect(), ground, hatching)
        painter.setPen(ink)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(place)
        line = metrics.height()
        for share, text in self.map.x_ticks:
            x = place.left() + share * place.width()
            painter.drawLine(QPointF(x, place.bottom()), QPointF(x, place.bottom() + 4.0))
            painter.drawText(QRectF(x - 40.0, place.bottom() + 5.0, 80.0, line), _CENTRE, text)
        painter.drawText(
            QRectF(place.left() - 60.0, place.bottom() + line + 8.0, place.width() + 120.0, line),
            _CENTRE,
            self.map.x_name,
        )
        widest, above = 0.0, 1e9
        for share, text in self.map.y_ticks:
            y = place.bottom() - share * place.height()
            wide = metrics.horizontalAdvance(text)
            widest = max(widest, wide)
            if y > above - 0.9 * line:
                continue  # it would lie on the one below
            above = y
            painter.drawLine(QPointF(place.left() - 4.0, y), QPointF(place.left(), y))
            painter.drawText(QPointF(place.left() - wide - 6.0, y + 0.35 * metrics.ascent()), text)
        self._upright(painter, self.map.y_name, place.left() - widest - 10.0 - 0.5 * line, place)
        self._scale(painter, place, metrics)

    def _scale(self, painter: QPainter, place: QRectF, metrics: QFontMetricsF) -> None:
        assert self.map is not None
        bar = QRectF(place.right() + 2.0 * _GAP, place.top(), _BAR, place.height())
        steps = np.rint(30.0 + 210.0 * np.linspace(1.0, 0.0, 256)).astype(np.uint8)[:, None]
        painter.drawImage(bar, image_of(steps))
        painter.drawRect(bar)
        widest = 0.0
        for share, text in self.map.scale_ticks:
            y = bar.bottom() - share * bar.height()
            painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 4.0, y))
            painter.drawText(QPointF(bar.right() + 6.0, y + 0.35 * metrics.ascent()), text)
            widest = max(widest, metrics.horizontalAdvance(text))
        self._upright(painter, self.map.scale, bar.right() + widest + 10.0 + 0.5 * metrics.height(), bar)

    def _upright(self, painter: QPainter, text: str, x: float, beside: QRectF) -> None:
        painter.save()
        painter.translate(x, beside.center().y())
        painter.rotate(-90.0)
        long = beside.height()
        shown = painter.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, int(long))
        painter.drawText(QRectF(-0.5 * long, -12.0, long, 24.0), _CENTRE, shown)
        painter.restore()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.map is None:
            return
        place, at = self._place(), event.position()
        if not place.contains(at):
            self.hovered.emit(-1, -1)
            return
        rows, columns = self.map.values.shape
        column = min(columns - 1, int((at.x() - place.left()) / place.width() * columns))
        row = min(rows - 1, int((place.bottom() - at.y()) / place.height() * rows))
        self.hovered.emit(row, column)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.hovered.emit(-1, -1)

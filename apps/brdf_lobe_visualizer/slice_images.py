"""Images side by side, in rows and columns, with a scale bar, and the value under the mouse: what the slices share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QMouseEvent, QPainter, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.slice_pens import hatching
from brdf_suite.geometry.directions import Floats
from brdf_suite.pipeline.slices import Bools
from brdf_suite.pipeline.slices_tone import Bytes

_GAP = 8.0
_BAR = 12.0
_POINT = 3.0


@dataclass(frozen=True, eq=False)
class Picture:
    """One image: ``codes`` (rows, columns, 3) sRGB, ``value`` (rows, columns) what the readout tells.

    ``nothing`` (rows, columns): where there is nothing to be seen, below the horizon; ``holes``: where nothing was
    measured. ``points`` (k, 2) are shares of width and height at which samples lie. ``note`` is told below it.
    """

    codes: Bytes
    value: Floats
    nothing: Bools | None = None
    holes: Bools | None = None
    points: npt.NDArray[np.float64] | None = None
    note: str = ""


@dataclass(frozen=True)
class ScaleBar:
    """The bar at the right: ``codes`` (n, 3) from the bottom up, and what stands at places 0…1 beside it."""

    codes: Bytes
    ticks: tuple[tuple[float, str], ...]
    title: str


@dataclass(frozen=True)
class Axes:
    """Names and ticks of every image's axes; ``ticks`` are (share, text), from the left and from the bottom."""

    x: str = ""
    y: str = ""
    x_ticks: tuple[tuple[float, str], ...] = ()
    y_ticks: tuple[tuple[float, str], ...] = ()


@dataclass(frozen=True, eq=False)
class Grid:
    """Rows of pictures, with their titles."""

    rows: tuple[str, ...] = ()
    columns: tuple[str, ...] = ()
    pictures: dict[tuple[int, int], Picture] = field(default_factory=dict)
    bar: ScaleBar | None = None
    axes: Axes = field(default_factory=Axes)


class ImageGrid(QWidget):
    """Draws a :class:`Grid`. ``hovered(row, column, x, y)``: shares of a picture's width and height; ``left()``."""

    hovered = Signal(int, int, float, float)
    left = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumSize(180, 120)
        self.setMouseTracking(True)
        self.grid = Grid()
        self._images: dict[tuple[int, int], QImage] = {}
        self._cross: tuple[float, float] | None = None

    def show_grid(self, grid: Grid) -> None:
        """Draw another grid."""
        self.grid = grid
        self._images = {at: _image(picture) for at, picture in grid.pictures.items()}
        self.update()

    def place_of(self, row: int, column: int) -> QRectF:
        """Return where a picture is drawn."""
        grid, metrics = self.grid, QFontMetricsF(self.font())
        line = metrics.height()
        axes = grid.axes
        left = (line + 4.0 if any(grid.rows) else 0.0) + self._y_axis_width(metrics)
        top = line + 4.0 if any(grid.columns) else 4.0
        right = self._bar_width(metrics)
        under = (line + 2.0 if axes.x_ticks else 0.0) + (line if axes.x else 0.0)
        notes = line if any(picture.note for picture in grid.pictures.values()) else 0.0
        rows, columns = max(1, len(grid.rows)), max(1, len(grid.columns))
        wide = (self.width() - left - right - _GAP * (columns - 1)) / columns
        high = (self.height() - top - under - rows * notes - _GAP * (rows - 1)) / rows
        side = max(8.0, min(wide, high))
        return QRectF(left + column * (side + _GAP), top + row * (side + _GAP + notes), side, side)

    def at(self, position: QPointF) -> tuple[int, int, float, float] | None:
        """Return the picture and the place in it, shares from the left and the top, at a position."""
        for row, column in self.grid.pictures:
            place = self.place_of(row, column)
            if place.contains(position):
                return (
                    row,
                    column,
                    (position.x() - place.left()) / place.width(),
                    (position.y() - place.top()) / place.height(),
                )
        return None

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        found = self.at(event.position())
        self._cross = None if found is None else found[2:]
        self.update()
        if found is None:
            self.left.emit()
        else:
            self.hovered.emit(*found)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._cross = None
        self.update()
        self.left.emit()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        palette = self.palette()
        painter.fillRect(self.rect(), palette.color(QPalette.ColorRole.Base))
        text = palette.color(QPalette.ColorRole.Text)
        painter.setPen(text)
        metrics = QFontMetricsF(self.font())
        for (row, column), image in self._images.items():
            place = self.place_of(row, column)
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, place.width() < image.width())
            painter.drawImage(place, image)
            self._draw_over(painter, self.grid.pictures[row, column], place)
        self._draw_titles(painter, metrics, text)
        self._draw_axes(painter, metrics, text)
        self._draw_bar(painter, metrics, text)

    def _draw_over(self, painter: QPainter, picture: Picture, place: QRectF) -> None:
        """Hatch holes, draw samples and the crosshair."""
        palette = self.palette()
        if picture.holes is not None and picture.holes.any():
            painter.save()
            painter.setClipRect(place)
            brush = hatching(palette)
            shape = picture.holes.shape
            for row, first, last in _runs(picture.holes):
                painter.fillRect(
                    QRectF(
                        place.left() + place.width() * first / shape[1],
                        place.top() + place.height() * row / shape[0],
                        place.width() * (last - first) / shape[1],
                        place.height() / shape[0] + 0.5,
                    ),
                    brush,
                )
            painter.restore()
        if picture.points is not None:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            for x, y in picture.points.tolist():
                centre = QPointF(place.left() + x * place.width(), place.top() + y * place.height())
                painter.setPen(QPen(QColor(0, 0, 0), 2.2))
                painter.drawEllipse(centre, _POINT, _POINT)
                painter.setPen(QPen(QColor(255, 255, 255), 1.0))
                painter.drawEllipse(centre, _POINT, _POINT)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        if self._cross is not None:
            x, y = self._cross
            for colour, width in ((QColor(0, 0, 0, 130), 3.0), (QColor(255, 255, 255, 200), 1.0)):
                painter.setPen(QPen(colour, width))
                across, down = place.left() + x * place.width(), place.top() + y * place.height()
                painter.drawLine(QPointF(across, place.top()), QPointF(across, place.bottom()))
                painter.drawLine(QPointF(place.left(), down), QPointF(place.right(), down))

    def _draw_titles(self, painter: QPainter, metrics: QFontMetricsF, text: QColor) -> None:
        painter.setPen(text)
        for column, title in enumerate(self.grid.columns):
            place = self.place_of(0, column)
            shown = metrics.elidedText(title, Qt.TextElideMode.ElideRight, place.width())
            painter.drawText(
                QRectF(place.left(), 0.0, place.width(), place.top()), Qt.AlignmentFlag.AlignCenter, shown
            )
        for row, title in enumerate(self.grid.rows):
            place = self.place_of(row, 0)
            painter.save()
            painter.translate(metrics.height() / 2.0 + 2.0, place.center().y())
            painter.rotate(-90.0)
            shown = metrics.elidedText(title, Qt.TextElideMode.ElideRight, place.height())
            painter.drawText(
                QRectF(-place.height() / 2.0, -metrics.height() / 2.0, place.height(), metrics.height()),
                Qt.AlignmentFlag.AlignCenter,
                shown,
            )
            painter.restore()
        for (row, column), picture in self.grid.pictures.items():
            if picture.note:
                place = self.place_of(row, column)
                shown = metrics.elidedText(picture.note, Qt.TextElideMode.ElideRight, place.width() + _GAP)
                painter.drawText(
                    QRectF(place.left(), place.bottom() + 1.0, place.width() + _GAP, metrics.height()),
                    Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
                    shown,
                )

    def _draw_axes(self, painter: QPainter, metrics: QFontMetricsF, text: QColor) -> None:
        axes, rows = self.grid.axes, len(self.grid.rows)
        if not self.grid.pictures or not (axes.x_ticks or axes.y_ticks):
            return
        painter.setPen(text)
        line = metrics.height()
        for column in range(len(self.grid.columns)):
            place = self.place_of(rows - 1, column)
            noted = any(p.note for p in self.grid.pictures.values())
            base = place.bottom() + (line if noted else 0.0) + 2.0
            right = -1e9
            for share, label in axes.x_ticks:
                wide = metrics.horizontalAdvance(label)
                x = place.left() + share * place.width()
                painter.drawLine(QPointF(x, place.bottom()), QPointF(x, place.bottom() + 3.0))
                if x - wide / 2.0 > right + 3.0:
                    painter.drawText(QPointF(x - wide / 2.0, base + metrics.ascent()), label)
                    right = x + wide / 2.0
            name = metrics.elidedText(axes.x, Qt.TextElideMode.ElideRight, place.width())
            painter.drawText(
                QRectF(place.left(), base + line - 2.0, place.width(), line),
                Qt.AlignmentFlag.AlignCenter,
                name,
            )
        for row in range(rows):
            place = self.place_of(row, 0)
            for share, label in axes.y_ticks:
                y = place.bottom() - share * place.height()
                wide = metrics.horizontalAdvance(label)
                painter.drawLine(QPointF(place.left() - 3.0, y), QPointF(place.left(), y))
                painter.drawText(QPointF(place.left() - wide - 5.0, y + 0.35 * metrics.ascent()), label)
            if axes.y:
                painter.save()
                painter.translate(place.left() - self._y_axis_width(metrics) + line / 2.0, place.center().y())
                painter.rotate(-90.0)
                painter.drawText(
                    QRectF(-place.height() / 2.0, -line / 2.0, place.height(), line),
                    Qt.AlignmentFlag.AlignCenter,
                    metrics.elidedText(axes.y, Qt.TextElideMode.ElideRight, place.height()),
                )
                painter.restore()

    def _draw_bar(self, painter: QPainter, metrics: QFontMetricsF, text: QColor) -> None:
        bar = self.grid.bar
        if bar is None or not self.grid.pictures:
            return
        last_column = max(column for _, column in self.grid.pictures)
        first, last = self.place_of(0, last_column), self.place_of(len(self.grid.rows) - 1, last_column)
        place = QRectF(first.right() + _GAP, first.top(), _BAR, last.bottom() - first.top())
        strip = np.ascontiguousarray(bar.codes[::-1, None, :])
        image = QImage(strip.data, 1, len(strip), 3, QImage.Format.Format_RGB888)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, False)
        painter.drawImage(place, image)
        painter.setPen(text)
        painter.drawRect(place)
        for share, label in bar.ticks:
            y = place.bottom() - share * place.height()
            painter.drawLine(QPointF(place.right(), y), QPointF(place.right() + 3.0, y))
            painter.drawText(QPointF(place.right() + 5.0, y + 0.35 * metrics.ascent()), label)
        painter.save()
        painter.translate(
            place.right() + 8.0 + self._tick_width(metrics) + metrics.height() / 2.0, place.center().y()
        )
        painter.rotate(-90.0)
        painter.drawText(
            QRectF(-place.height() / 2.0, -metrics.height() / 2.0, place.height(), metrics.height()),
            Qt.AlignmentFlag.AlignCenter,
            metrics.elidedText(bar.title, Qt.TextElideMode.ElideRight, place.height()),
        )
        painter.restore()

    def _tick_width(self, metrics: QFontMetricsF) -> float:
        bar = self.grid.bar
        return (
            0.0
            if bar is None
            else max((metrics.horizontalAdvance(text) for _, text in bar.ticks), default=0.0)
        )

    def _bar_width(self, metrics: QFontMetricsF) -> float:
        if self.grid.bar is None:
            return 4.0
        return _GAP + _BAR + 10.0 + self._tick_width(metrics) + metrics.height()

    def _y_axis_width(self, metrics: QFontMetricsF) -> float:
        axes = self.grid.axes
        if not axes.y_ticks:
            return 0.0
        widest = max(metrics.horizontalAdvance(text) for _, text in axes.y_ticks)
        return widest + 8.0 + (metrics.height() if axes.y else 0.0)


def _image(picture: Picture) -> QImage:
    """Return a picture's codes with transparency where there is nothing."""
    height, width = picture.codes.shape[:2]
    rgba = np.full((height, width, 4), 255, np.uint8)
    rgba[..., :3] = picture.codes
    if picture.nothing is not None:
        rgba[picture.nothing] = 0
    if picture.holes is not None:
        rgba[picture.holes, 3] = 0
    # A copy: Qt keeps no reference to the array.
    return QImage(rgba.data, width, height, 4 * width, QImage.Format.Format_RGBA8888).copy()


def _runs(mask: Bools) -> Sequence[tuple[int, int, int]]:
    """Return (row, first column, column after the last) of all runs of set pixels."""
    padded = np.zeros((mask.shape[0], mask.shape[1] + 2), np.int8)
    padded[:, 1:-1] = mask
    steps = np.diff(padded, axis=1)
    starts, ends = np.argwhere(steps == 1), np.argwhere(steps == -1)
    return [(int(r), int(a), int(b)) for (r, a), (_, b) in zip(starts.tolist(), ends.tolist(), strict=True)]

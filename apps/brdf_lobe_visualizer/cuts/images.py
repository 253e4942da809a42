"""Images side by side, in rows and columns, with a scale bar, and the value under the mouse: what the slices share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFontMetricsF,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.image_layout import BAR, GAP, Layout, Room, best_layout
from brdf_lobe_visualizer.cuts.pens import hatching_brush
from brdf_suite.arrays import Bools, Bytes, Floats
from brdf_suite.foreign_text import make_visible

_POINT, _DOT = 3.0, 1.2
_MANY = 60
"""More samples than these are dots: rings would cover the picture."""
_CENTRE = Qt.AlignmentFlag.AlignCenter


@dataclass(frozen=True, eq=False)
class Picture:
    """One image: ``codes`` (rows, columns, 3) sRGB, ``value`` (rows, columns) what the readout shows.

    ``nothing`` (rows, columns): where there is nothing to be seen, below the horizon; ``holes``: where nothing was
    measured. ``points`` (k, 2) are shares of width and height at which samples lie. ``notes`` are one note in forms
    from the longest to the shortest; the first that fits lies over its foot.
    """

    codes: Bytes
    value: Floats
    nothing: Bools | None = None
    holes: Bools | None = None
    points: npt.NDArray[np.float64] | None = None
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class ScaleBar:
    """The bar: ``codes`` (n, 3) from its low end, and what stands at places 0…1 beside it."""

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
        self._layout: Layout | None = None

    def show_grid(self, grid: Grid) -> None:
        self.grid = grid
        self._images = {at: _image(picture) for at, picture in grid.pictures.items()}
        self._layout = None
        self.update()

    @property
    def placed(self) -> Layout:
        if self._layout is None:
            grid, metrics = self.grid, QFontMetricsF(self.font())
            axes, bar = grid.axes, grid.bar
            ticks = None
            if bar is not None:
                ticks = max((metrics.horizontalAdvance(text) for _, text in bar.ticks), default=0.0)
            room = Room(
                line=metrics.height(),
                titled_rows=any(grid.rows),
                titled_columns=any(grid.columns),
                y_ticks=self._y_ticks(metrics),
                y_name=bool(axes.y),
                x_ticks=bool(axes.x_ticks),
                x_name=bool(axes.x),
                bar_ticks=ticks,
            )
            self._layout = best_layout(self.width(), self.height(), len(grid.rows), len(grid.columns), room)
        return self._layout

    def place_of(self, row: int, column: int) -> QRectF:
        return self.placed.place_of(row, column)

    def at(self, position: QPointF) -> tuple[int, int, float, float] | None:
        """Return the picture and the place in it, shares from the left and the top, at a position."""
        for row, column in self.grid.pictures:
            place = self.place_of(row, column)
            if place.contains(position):
                away = position - place.topLeft()
                return row, column, away.x() / place.width(), away.y() / place.height()
        return None

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._layout = None

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._layout = None

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
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Base))
        if not self._images:
            return
        metrics = QFontMetricsF(self.font())
        for (row, column), image in self._images.items():
            place, picture = self.place_of(row, column), self.grid.pictures[row, column]
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, place.width() < image.width())
            painter.drawImage(place, image)
            self._draw_holes(painter, picture, place)
            _draw_points(painter, picture, place)
            _draw_note(painter, metrics, picture.notes, place)
            self._draw_cross(painter, place)
        painter.setPen(self.palette().color(QPalette.ColorRole.Text))
        self._draw_titles(painter, metrics)
        self._draw_axes(painter, metrics)
        if self.grid.bar is not None:
            self._draw_bar(painter, metrics, self.grid.bar)

    def _draw_holes(self, painter: QPainter, picture: Picture, place: QRectF) -> None:
        if picture.holes is None or not picture.holes.any():
            return
        brush, (rows, columns) = hatching_brush(self.palette()), picture.holes.shape
        wide, high = place.width() / columns, place.height() / rows
        for row, first, last in _runs(picture.holes):
            left, top = place.left() + first * wide, place.top() + row * high
            painter.fillRect(QRectF(left, top, (last - first) * wide, high), brush)

    def _draw_cross(self, painter: QPainter, place: QRectF) -> None:
        if self._cross is None:
            return
        across = place.left() + self._cross[0] * place.width()
        down = place.top() + self._cross[1] * place.height()
        for colour, width in ((QColor(0, 0, 0, 130), 3.0), (QColor(255, 255, 255, 200), 1.0)):
            painter.setPen(QPen(colour, width))
            painter.drawLine(QPointF(across, place.top()), QPointF(across, place.bottom()))
            painter.drawLine(QPointF(place.left(), down), QPointF(place.right(), down))

    def _draw_titles(self, painter: QPainter, metrics: QFontMetricsF) -> None:
        turned, line = self.placed.turned, metrics.height()
        above, beside = (self.grid.rows, self.grid.columns) if turned else (self.grid.columns, self.grid.rows)
        for number, title in enumerate(above):
            place = self.place_of(number, 0) if turned else self.place_of(0, number)
            shown = metrics.elidedText(make_visible(title), Qt.TextElideMode.ElideRight, place.width() + GAP)
            area = QRectF(place.left() - GAP, place.top() - line - 2.0, place.width() + 2.0 * GAP, line)
            painter.drawText(area, _CENTRE, shown)
        reach = self._y_ticks(metrics) + (line if self.grid.axes.y else 0.0)
        for number, title in enumerate(beside):
            place = self.place_of(0, number) if turned else self.place_of(number, 0)
            _upwards(painter, metrics, place.left() - reach - 0.5 * line - 2.0, place, title)

    def _draw_axes(self, painter: QPainter, metrics: QFontMetricsF) -> None:
        axes, line, layout = self.grid.axes, metrics.height(), self.placed
        whole = layout.whole
        for number in range(layout.columns if axes.x_ticks else 0):
            left, foot = whole.left() + number * layout.step_x, whole.bottom()
            # The last number of one picture and the first of the next would lie on each other.
            _draw_x_ticks(
                painter, metrics, axes.x_ticks, left, foot, layout.side, last=number + 1 == layout.columns
            )
            name = metrics.elidedText(axes.x, Qt.TextElideMode.ElideRight, layout.side)
            painter.drawText(QRectF(left, foot + line + 2.0, layout.side, line), _CENTRE, name)
        for number in range(layout.rows if axes.y_ticks else 0):
            foot = whole.top() + number * layout.step_y + layout.side
            _draw_y_ticks(painter, metrics, axes.y_ticks, whole.left(), foot, layout.side, way=-1.0)
            place = QRectF(whole.left(), foot - layout.side, layout.side, layout.side)
            _upwards(painter, metrics, whole.left() - self._y_ticks(metrics) - 0.5 * line, place, axes.y)

    def _draw_bar(self, painter: QPainter, metrics: QFontMetricsF, bar: ScaleBar) -> None:
        whole, line, below = self.placed.whole, metrics.height(), self.placed.bar_below
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, False)
        if below:
            axes = self.grid.axes
            foot = whole.bottom() + (line + 4.0 if axes.x_ticks else 0.0) + (line if axes.x else 0.0) + GAP
            place = QRectF(whole.left(), foot, whole.width(), BAR)
            codes = np.ascontiguousarray(bar.codes[None])
        else:
            place = QRectF(whole.right() + GAP, whole.top(), BAR, whole.height())
            codes = np.ascontiguousarray(bar.codes[::-1, None])
        high, wide = codes.shape[:2]
        painter.drawImage(place, QImage(codes.data, wide, high, 3 * wide, QImage.Format.Format_RGB888))
        painter.drawRect(place)
        ticks = sorted(bar.ticks)
        if below:
            _draw_x_ticks(painter, metrics, ticks, place.left(), place.bottom(), place.width())
            title = metrics.elidedText(bar.title, Qt.TextElideMode.ElideRight, place.width())
            room = QRectF(place.left(), place.bottom() + 4.0 + line, place.width(), line)
            painter.drawText(room, _CENTRE, title)
        else:
            _draw_y_ticks(painter, metrics, ticks, place.right(), place.bottom(), place.height(), way=1.0)
            widest = max((metrics.horizontalAdvance(label) for _, label in ticks), default=0.0)
            _upwards(painter, metrics, place.right() + 8.0 + widest + 0.5 * line, place, bar.title)

    def _y_ticks(self, metrics: QFontMetricsF) -> float:
        ticks = self.grid.axes.y_ticks
        return max(metrics.horizontalAdvance(text) for _, text in ticks) + 8.0 if ticks else 0.0


def _draw_x_ticks(
    painter: QPainter,
    metrics: QFontMetricsF,
    ticks: Sequence[tuple[float, str]],
    left: float,
    foot: float,
    width: float,
    *,
    last: bool = True,
) -> None:
    """Draw ticks below ``foot`` with the numbers that have room; without ``last``, none at the right end."""
    right = -1e9
    for share, label in ticks:
        x, wide = left + share * width, metrics.horizontalAdvance(label)
        painter.drawLine(QPointF(x, foot), QPointF(x, foot + 3.0))
        if x - 0.5 * wide > right + 3.0 and (last or share <= 0.999):
            painter.drawText(QPointF(x - 0.5 * wide, foot + 4.0 + metrics.ascent()), label)
            right = x + 0.5 * wide


def _draw_y_ticks(
    painter: QPainter,
    metrics: QFontMetricsF,
    ticks: Sequence[tuple[float, str]],
    edge: float,
    foot: float,
    height: float,
    *,
    way: float,
) -> None:
    """Draw ticks at the right of ``edge`` (``way`` 1) or at its left (-1), with the numbers that have room."""
    above, line = 1e9, metrics.height()
    for share, label in ticks:
        y = foot - share * height
        painter.drawLine(QPointF(edge, y), QPointF(edge + 3.0 * way, y))
        if y + 0.4 * line < above - 0.4 * line:
            x = edge + 5.0 if way > 0.0 else edge - 5.0 - metrics.horizontalAdvance(label)
            painter.drawText(QPointF(x, y + 0.35 * metrics.ascent()), label)
            above = y


def _upwards(painter: QPainter, metrics: QFontMetricsF, x: float, beside: QRectF, text: str) -> None:
    """Write ``text`` from the bottom to the top, its middle at ``x``, along the height of ``beside``."""
    if not text:
        return
    long, line = beside.height(), metrics.height()
    painter.save()
    painter.translate(x, beside.center().y())
    painter.rotate(-90.0)
    shown = metrics.elidedText(make_visible(text), Qt.TextElideMode.ElideRight, long)
    painter.drawText(QRectF(-0.5 * long, -0.5 * line, long, line), _CENTRE, shown)
    painter.restore()


def _draw_points(painter: QPainter, picture: Picture, place: QRectF) -> None:
    if picture.points is None:
        return
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    centres = [
        QPointF(place.left() + x * place.width(), place.top() + y * place.height())
        for x, y in picture.points.tolist()
    ]
    # White in black: seen on any colour.
    if len(centres) > _MANY:
        for colour, size in ((QColor(0, 0, 0), 2.0 * _DOT + 1.0), (QColor(255, 255, 255), 2.0 * _DOT - 0.6)):
            painter.setPen(QPen(colour, size, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            painter.drawPoints(centres)
    else:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for colour, width in ((QColor(0, 0, 0), 2.2), (QColor(255, 255, 255), 1.0)):
            painter.setPen(QPen(colour, width))
            for centre in centres:
                painter.drawEllipse(centre, _POINT, _POINT)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _draw_note(painter: QPainter, metrics: QFontMetricsF, notes: Sequence[str], place: QRectF) -> None:
    """Write the first of ``notes`` that fits over the foot of a picture."""
    fitting = (note for note in notes if metrics.horizontalAdvance(note) + 6.0 <= place.width())
    text = next(fitting, "")
    if not text:
        return
    wide, line = metrics.horizontalAdvance(text) + 6.0, metrics.height()
    area = QRectF(place.left(), place.bottom() - line, wide, line)
    painter.fillRect(area, QColor(0, 0, 0, 150))
    painter.setPen(QColor(255, 255, 255))
    painter.drawText(area, _CENTRE, text)


def _image(picture: Picture) -> QImage:
    """Return a picture's codes, transparent where there is nothing and in holes."""
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
    starts, ends = np.argwhere(steps == 1).tolist(), np.argwhere(steps == -1).tolist()
    return [(row, first, last) for (row, first), (_, last) in zip(starts, ends, strict=True)]

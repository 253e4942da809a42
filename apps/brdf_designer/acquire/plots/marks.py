"""What is drawn over a picture: outlines, points, differences and hatched areas, without colour.

Every line is white in black, so that it is seen on any picture; kinds differ in shape and dash.
Places are in pixels of the picture, (x, y) from its upper left corner, a pixel's centre at half numbers.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QFontMetricsF, QImage, QPainter, QPen, QPolygonF, QTransform

from brdf_suite.foreign_text import make_visible

Shape = Literal["cross", "ring", "dot"]
INK, CASING, PAPER = QColor(255, 255, 255), QColor(0, 0, 0, 190), QColor(0, 0, 0, 168)
_SHAPE, _DOT = 5.0, 1.2
_SAMPLE = 22.0


@dataclass(frozen=True, eq=False)
class Outline:
    """A line through ``points`` (n, 2)."""

    points: NDArray[np.floating]
    name: str
    dashed: bool = False


@dataclass(frozen=True, eq=False)
class Points:
    """A mark of one shape at each of ``points`` (n, 2)."""

    points: NDArray[np.floating]
    name: str
    shape: Shape = "cross"


@dataclass(frozen=True, eq=False)
class Differences:
    """A line from each of ``starts`` to ``ends`` (n, 2), drawn ``gain`` times as long."""

    starts: NDArray[np.floating]
    ends: NDArray[np.floating]
    name: str
    gain: float = 1.0


@dataclass(frozen=True, eq=False)
class Area:
    """An area of the picture (:func:`brdf_designer.acquire.plots.tone.area_of`), hatched."""

    image: QImage = field(default_factory=QImage)
    name: str = ""
    pattern: Qt.BrushStyle = Qt.BrushStyle.BDiagPattern


Mark = Outline | Points | Differences | Area


def draw_mark(painter: QPainter, mark: Mark, to_screen: QTransform) -> None:
    """Draw ``mark`` where ``to_screen`` takes the picture's pixels."""
    if isinstance(mark, Area):
        _draw_area(painter, mark, to_screen)
    elif isinstance(mark, Outline):
        _stroke(
            painter, QPolygonF([to_screen.map(QPointF(x, y)) for x, y in mark.points.tolist()]), mark.dashed
        )
    elif isinstance(mark, Differences):
        for start, end in zip(mark.starts.tolist(), mark.ends.tolist(), strict=True):
            far = [a + mark.gain * (b - a) for a, b in zip(start, end, strict=True)]
            _stroke(painter, QPolygonF([to_screen.map(QPointF(*start)), to_screen.map(QPointF(*far))]), False)
    else:
        for x, y in mark.points.tolist():
            _draw_shape(painter, mark.shape, to_screen.map(QPointF(x, y)))


def draw_legend(painter: QPainter, marks: list[Mark], area: QRectF) -> None:
    """Name the marks at the foot of ``area``, each beside a sample; what has no name is left out."""
    named = [mark for mark in marks if mark.name]
    if not named:
        return
    metrics = QFontMetricsF(painter.font())
    line = metrics.height() + 4.0
    wide = min(max(metrics.horizontalAdvance(mark.name) for mark in named) + _SAMPLE + 24.0, area.width())
    box = QRectF(
        area.left() + 8.0, area.bottom() - 8.0 - line * len(named) - 8.0, wide, line * len(named) + 8.0
    )
    painter.fillRect(box, PAPER)
    for number, mark in enumerate(named):
        middle = box.top() + 4.0 + (number + 0.5) * line
        left = box.left() + 8.0
        _draw_sample(painter, mark, QRectF(left, middle - 6.0, _SAMPLE, 12.0))
        painter.setPen(INK)
        room = QRectF(left + _SAMPLE + 6.0, middle - 0.5 * line, box.right() - left - _SAMPLE - 10.0, line)
        text = metrics.elidedText(make_visible(mark.name), Qt.TextElideMode.ElideRight, room.width())
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, text)


def _draw_sample(painter: QPainter, mark: Mark, place: QRectF) -> None:
    middle = place.center()
    if isinstance(mark, Area):
        _hatch(painter, place, mark.pattern)
    elif isinstance(mark, Points):
        _draw_shape(painter, mark.shape, middle)
    else:
        ends = [QPointF(place.left(), middle.y()), QPointF(place.right(), middle.y())]
        _stroke(painter, QPolygonF(ends), isinstance(mark, Outline) and mark.dashed)


def _hatch(painter: QPainter, place: QRectF, pattern: Qt.BrushStyle) -> None:
    painter.fillRect(place, QColor(0, 0, 0, 120))
    painter.fillRect(place, QBrush(QColor(255, 255, 255, 150), pattern))


def _draw_area(painter: QPainter, mark: Area, to_screen: QTransform) -> None:
    """Hatch in points of the screen, through the area as a stencil."""
    if mark.image.isNull():
        return
    shown = to_screen.mapRect(QRectF(0.0, 0.0, mark.image.width(), mark.image.height()))
    place = shown.intersected(QRectF(painter.viewport())).toAlignedRect()
    if place.isEmpty():
        return
    ground, hatching = QColor(0, 0, 0, 120), QBrush(QColor(255, 255, 255, 150), mark.pattern)
    hatch_area(painter, mark.image, shown, place, ground, hatching)


def hatch_area(
    painter: QPainter, area: QImage, shown: QRectF, place: QRect, ground: QColor, hatching: QBrush
) -> None:
    """Hatch the opaque part of ``area``, which is drawn at ``shown``, within ``place``, in points of the screen."""
    ratio = painter.device().devicePixelRatioF()
    layer = QImage(place.size() * ratio, QImage.Format.Format_ARGB32_Premultiplied)
    layer.setDevicePixelRatio(ratio)
    layer.fill(QColor(0, 0, 0, 0))
    stencil = QPainter(layer)
    stencil.translate(-place.topLeft())
    stencil.drawImage(shown, area)
    stencil.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceIn)
    stencil.fillRect(place, ground)
    stencil.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceAtop)
    stencil.fillRect(place, hatching)
    stencil.end()
    painter.drawImage(place.topLeft(), layer)


def _draw_shape(painter: QPainter, shape: Shape, at: QPointF) -> None:
    for colour, width in ((CASING, 3.0), (INK, 1.2)):
        painter.setPen(QPen(colour, width))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if shape == "ring":
            painter.drawEllipse(at, _SHAPE, _SHAPE)
        elif shape == "dot":
            painter.drawEllipse(at, _DOT, _DOT)
        else:
            painter.drawLine(at - QPointF(_SHAPE, 0.0), at + QPointF(_SHAPE, 0.0))
            painter.drawLine(at - QPointF(0.0, _SHAPE), at + QPointF(0.0, _SHAPE))


def _stroke(painter: QPainter, line: QPolygonF, dashed: bool) -> None:
    for colour, width in ((CASING, 3.0), (INK, 1.2)):
        pen = QPen(colour, width)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        if dashed:
            pen.setDashPattern([6.0 / width, 4.0 / width])
        painter.setPen(pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPolyline(line)

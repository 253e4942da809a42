"""A subject's line as a small picture."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap

from brdf_lobe_visualizer.cuts.pens import dashed_pen
from brdf_lobe_visualizer.subjects.subjects import Dash, Srgb

LINE_SIZE = QSize(28, 14)


def colour_of(srgb: Srgb) -> QColor:
    """Return an sRGB triple, 0 to 1, as Qt has it."""
    return QColor.fromRgbF(*(min(max(value, 0.0), 1.0) for value in srgb))


def line_icon(srgb: Srgb, dash: Dash, ratio: float = 1.0) -> QIcon:
    """Return the line as an icon of :data:`LINE_SIZE`, for a screen of ``ratio`` pixels per point."""
    picture = QPixmap(LINE_SIZE * ratio)
    picture.setDevicePixelRatio(ratio)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    middle = LINE_SIZE.height() / 2
    painter.setPen(dashed_pen(colour_of(srgb), 3.0, dash))
    painter.drawLine(QPointF(1.0, middle), QPointF(LINE_SIZE.width() - 1.0, middle))
    painter.end()
    return QIcon(picture)

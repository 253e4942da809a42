"""A subject's line as a small picture, and its dashes as Qt has them."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPen, QPixmap

from brdf_lobe_visualizer.subjects.subjects import Dash, Srgb

LINE_SIZE = QSize(28, 14)
LINE_WIDTH = 2.0

DASH_PATTERNS: dict[Dash, tuple[float, ...]] = {
    "solid": (),
    "dash": (4.0, 2.0),
    "dot": (1.0, 1.6),
    "dash dot": (4.0, 1.6, 1.0, 1.6),
    "long dash": (8.0, 2.5),
}
"""Lengths of strokes and gaps, in widths of the line."""


def colour_of(srgb: Srgb) -> QColor:
    """Return an sRGB triple, 0 to 1, as Qt has it."""
    return QColor.fromRgbF(*(min(max(value, 0.0), 1.0) for value in srgb))


def line_pen(srgb: Srgb, dash: Dash, width: float = LINE_WIDTH) -> QPen:
    """Return the pen of a subject's line."""
    pen = QPen(colour_of(srgb), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    if DASH_PATTERNS[dash]:
        pen.setDashPattern(list(DASH_PATTERNS[dash]))
    return pen


def line_icon(srgb: Srgb, dash: Dash, ratio: float = 1.0) -> QIcon:
    """Return the line as an icon of :data:`LINE_SIZE`, for a screen of ``ratio`` pixels per point."""
    picture = QPixmap(LINE_SIZE * ratio)
    picture.setDevicePixelRatio(ratio)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    middle = LINE_SIZE.height() / 2
    painter.setPen(line_pen(srgb, dash, 3.0))
    painter.drawLine(QPointF(1.0, middle), QPointF(LINE_SIZE.width() - 1.0, middle))
    painter.end()
    return QIcon(picture)

"""Pens, brushes and greys of the plots: a line has its subject's colour and dash in every plot and in the legend."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QIcon, QPainter, QPalette, QPen, QPixmap

from brdf_lobe_visualizer.cuts.lines import Line
from brdf_lobe_visualizer.subjects.subjects import Dash, Srgb
from brdf_suite.appearance.colour.colorimetry import srgb_decode

_STYLES: dict[Dash, tuple[float, ...]] = {
    "solid": (),
    "dash": (6.0, 3.0),
    "dot": (1.5, 2.5),
    "dash dot": (6.0, 2.5, 1.5, 2.5),
    "long dash": (12.0, 4.0),
}
FRONT_WIDTH, OTHER_WIDTH, FIT_WIDTH = 2.4, 1.6, 1.0


def colour_of(srgb: Srgb, base: QColor) -> QColor:
    """Return a line's colour, brought so far from ``base`` that it is seen on it; the hue stays."""
    colour = QColor.fromRgbF(*srgb)
    dark = base.lightnessF() < 0.5
    for _ in range(12):
        if contrast(colour, base) >= 2.2:
            break
        colour = colour.lighter(112) if dark else colour.darker(112)
    return colour


def contrast(one: QColor, other: QColor) -> float:
    """Return the contrast of two colours, 1 to 21 (WCAG 2)."""
    levels = [
        float(srgb_decode((c.redF(), c.greenF(), c.blueF())) @ (0.2126, 0.7152, 0.0722)) + 0.05
        for c in (one, other)
    ]
    return max(levels) / min(levels)


def pen_of(line: Line, base: QColor) -> QPen:
    """Return the pen of a line on ``base``; its width is in pixels, whatever the plot's scale."""
    width = FIT_WIDTH if line.kind == "fit" else FRONT_WIDTH if line.is_front else OTHER_WIDTH
    return dashed_pen(colour_of(line.colour, base), width, line.dash)


def dashed_pen(colour: QColor, width: float, dash: Dash) -> QPen:
    """Return a cosmetic pen with a dash whose lengths are in pixels, whatever its width."""
    pen = QPen(colour, width)
    pen.setCosmetic(True)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    pen.setJoinStyle(Qt.PenJoinStyle.BevelJoin)
    pattern = _STYLES[dash]
    if pattern:
        pen.setDashPattern([length * 1.6 / max(width, 1.0) for length in pattern])
    return pen


def grey_pen(palette: QPalette, alpha: float, width: float = 1.0) -> QPen:
    """Return a cosmetic pen of the theme's text, ``alpha`` of its strength."""
    colour = QColor(palette.color(QPalette.ColorRole.Text))
    colour.setAlphaF(alpha)
    pen = QPen(colour, width)
    pen.setCosmetic(True)
    return pen


def hatching_brush(palette: QPalette) -> QBrush:
    """Return the hatching of what was not measured."""
    colour = QColor(palette.color(QPalette.ColorRole.Text))
    colour.setAlphaF(0.35)
    return QBrush(colour, Qt.BrushStyle.BDiagPattern)


LINE_SIZE = QSize(28, 14)


def line_icon(srgb: Srgb, dash: Dash, ratio: float = 1.0) -> QIcon:
    """Return the line as an icon of :data:`LINE_SIZE`, for a screen of ``ratio`` pixels per point."""
    picture = QPixmap(LINE_SIZE * ratio)
    picture.setDevicePixelRatio(ratio)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    middle = LINE_SIZE.height() / 2
    painter.setPen(dashed_pen(QColor.fromRgbF(*srgb), 3.0, dash))
    painter.drawLine(QPointF(1.0, middle), QPointF(LINE_SIZE.width() - 1.0, middle))
    painter.end()
    return QIcon(picture)

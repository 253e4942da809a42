"""What stands over the picture: which paint is where, the divider, the scale of a difference, and the figures.

It is drawn by Qt, in the size of the screen's text, and is in no exported picture. It takes no mouse event.
"""

from __future__ import annotations

from dataclasses import dataclass

from brdf_qt.gl.layer import PADDING, PictureLayer, draw_chip, draw_paper
from brdf_qt.program.translation import decimal
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from brdf_suite.appearance.difference.colour_scale import STEPS, scale_table
from brdf_suite.foreign_text import make_visible

_MARGIN = 12.0
_HANDLE = 9.0
_SCALE_WIDTH, _SCALE_HEIGHT = 240.0, 12.0


@dataclass(frozen=True)
class OverlayLabel:
    """A caption over the picture: at which share of its width it begins, and how wide its part is."""

    text: str
    begins: float = 0.0
    share: float = 1.0


@dataclass(frozen=True)
class Scale:
    """The scale of a difference: its end in ΔE00, and what the difference is taken of."""

    end: float
    of: str


class PictureOverlay(PictureLayer):
    """The layer of words, divider and scale."""

    def __init__(self, picture: QWidget) -> None:
        super().__init__(picture)
        self.setObjectName("overlay")
        self.labels: tuple[OverlayLabel, ...] = ()
        self.divider: float | None = None
        self.scale: Scale | None = None
        self.figures: tuple[str, ...] = ()
        self.mark = ""

    def show_labels(
        self, labels: tuple[OverlayLabel, ...], divider: float | None, scale: Scale | None
    ) -> None:
        """Show which paint is where, the divider (share of the width), and the scale."""
        if (labels, divider, scale) != (self.labels, self.divider, self.scale):
            self.labels, self.divider, self.scale = labels, divider, scale
            self._changed()

    def show_figures(self, lines: tuple[str, ...]) -> None:
        """Show lines at the lower left; none hides them."""
        if lines != self.figures:
            self.figures = lines
            self._changed()

    def show_mark(self, words: str) -> None:
        """Say at the lower right which renderer made the picture; empty: nothing."""
        if words != self.mark:
            self.mark = words
            self._changed()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        _paint(painter, QRectF(self.rect()), self)

    def _changed(self) -> None:
        words = [*(label.text for label in self.labels), *self.figures, *([self.mark] if self.mark else [])]
        self.setAccessibleName("; ".join(words))
        self.setVisible(bool(words) or self.divider is not None or self.scale is not None)
        self.update()


def _paint(painter: QPainter, area: QRectF, overlay: PictureOverlay) -> None:
    metrics = QFontMetricsF(painter.font())
    for label in overlay.labels:
        room = area.width() * label.share - 2 * _MARGIN
        if room > 3 * metrics.height():
            left = area.left() + area.width() * label.begins + _MARGIN
            draw_chip(painter, QPointF(left, area.top() + _MARGIN), (label.text,), room)
    if overlay.divider is not None:
        _divider(painter, area, overlay.divider)
    bottom = area.bottom() - _MARGIN
    if overlay.mark:
        # A line of its own below all else: figures and scale stand on it, at any width.
        tall = metrics.height() + 2 * PADDING
        wide = min(metrics.horizontalAdvance(overlay.mark) + 2 * PADDING, area.width() - 2 * _MARGIN)
        corner = QPointF(area.right() - _MARGIN - wide, bottom - tall)
        draw_chip(painter, corner, (overlay.mark,), area.width() - 2 * _MARGIN)
        if overlay.scale is not None or overlay.figures:
            area = area.adjusted(0.0, 0.0, 0.0, -tall - PADDING)
            bottom = area.bottom() - _MARGIN
    if overlay.scale is not None:
        bottom = _scale(painter, metrics, area, overlay.scale) - PADDING
    if overlay.figures:
        tall = len(overlay.figures) * metrics.height() + 2 * PADDING
        corner = QPointF(area.left() + _MARGIN, max(area.top() + _MARGIN, bottom - tall))
        draw_chip(painter, corner, overlay.figures, area.width() - 2 * _MARGIN)


def _divider(painter: QPainter, area: QRectF, share: float) -> None:
    x = area.left() + share * area.width()
    for colour, width in ((QColor(0, 0, 0, 190), 3.0), (QColor(255, 255, 255, 230), 1.0)):
        painter.setPen(QPen(colour, width))
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))
    middle = QPointF(x, area.center().y())
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.0))
    painter.setBrush(QColor(255, 255, 255, 235))
    painter.drawEllipse(middle, _HANDLE, _HANDLE)
    painter.setBrush(QColor(0, 0, 0, 200))
    painter.setPen(Qt.PenStyle.NoPen)
    for side in (-1.0, 1.0):
        tip = middle + QPointF(side * 0.72 * _HANDLE, 0.0)
        base = middle + QPointF(side * 0.25 * _HANDLE, 0.0)
        painter.drawPolygon([tip, base + QPointF(0.0, -0.35 * _HANDLE), base + QPointF(0.0, 0.35 * _HANDLE)])


def _scale(painter: QPainter, metrics: QFontMetricsF, area: QRectF, scale: Scale) -> float:
    """Draw the bar with its numbers; return its upper edge."""
    width = min(_SCALE_WIDTH, area.width() - 2 * _MARGIN - 2 * PADDING)
    tall = 2 * metrics.height() + _SCALE_HEIGHT + 3 * PADDING
    box = QRectF(area.left() + _MARGIN, area.bottom() - _MARGIN - tall, width + 2 * PADDING, tall)
    draw_paper(painter, box)
    inner = box.adjusted(PADDING, PADDING, -PADDING, -PADDING)
    title = metrics.elidedText(make_visible(f"ΔE00 {scale.of}"), Qt.TextElideMode.ElideRight, inner.width())
    painter.drawText(QPointF(inner.left(), inner.top() + metrics.ascent()), title)
    bar = QRectF(inner.left(), inner.top() + metrics.height() + 0.5 * PADDING, inner.width(), _SCALE_HEIGHT)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.drawImage(bar, _scale_image())
    under = QRectF(bar.left(), bar.bottom(), bar.width(), metrics.height() + 0.5 * PADDING)
    flags = Qt.AlignmentFlag
    painter.drawText(under, flags.AlignLeft | flags.AlignBottom, "0")
    painter.drawText(under, flags.AlignHCenter | flags.AlignBottom, decimal(f"{0.5 * scale.end:g}"))
    painter.drawText(under, flags.AlignRight | flags.AlignBottom, decimal(f"≥ {scale.end:g}"))
    return box.top()


def _scale_image() -> QImage:
    image = QImage(STEPS + 1, 1, QImage.Format.Format_RGB32)
    for i, (red, green, blue) in enumerate(scale_table().tolist()):
        image.setPixelColor(i, 0, QColor.fromRgbF(red, green, blue))
    return image

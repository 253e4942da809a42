"""What stands over the picture: which paint is where, the divider, the scale of a difference, and the figures.

It is drawn by Qt, in the size of the screen's text, and is in no exported picture. It takes no mouse event.
"""

from __future__ import annotations

from dataclasses import dataclass

from brdf_qt.program.translation import decimal
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from brdf_suite.appearance.difference.colour_scale import STEPS, scale_table

_MARGIN = 12.0
_PADDING = 6.0
_HANDLE = 9.0
_SCALE_WIDTH, _SCALE_HEIGHT = 240.0, 12.0
_PAPER, _INK = QColor(0, 0, 0, 168), QColor(255, 255, 255)
"""Neutral, like all of the interface, and readable on any picture."""


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


class PictureOverlay(QWidget):
    """Covers ``picture`` and follows its size."""

    def __init__(self, picture: QWidget) -> None:
        super().__init__(picture)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self.setObjectName("overlay")
        self.labels: tuple[OverlayLabel, ...] = ()
        self.divider: float | None = None
        self.scale: Scale | None = None
        self.figures: tuple[str, ...] = ()
        self.mark = ""
        self._picture = picture
        picture.installEventFilter(self)
        self._follow()
        self.hide()

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

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Show, QEvent.Type.ChildAdded):
            self._follow()
        return super().eventFilter(watched, event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        _paint(painter, QRectF(self.rect()), self)

    def _changed(self) -> None:
        words = [*(label.text for label in self.labels), *self.figures, *([self.mark] if self.mark else [])]
        self.setAccessibleName("; ".join(words))
        self.setVisible(bool(words) or self.divider is not None or self.scale is not None)
        self.update()

    def _follow(self) -> None:
        self.setGeometry(self._picture.rect())
        self.raise_()


def _paint(painter: QPainter, area: QRectF, overlay: PictureOverlay) -> None:
    metrics = QFontMetricsF(painter.font())
    for label in overlay.labels:
        room = area.width() * label.share - 2 * _MARGIN
        if room > 3 * metrics.height():
            left = area.left() + area.width() * label.begins + _MARGIN
            _chip(painter, metrics, QPointF(left, area.top() + _MARGIN), (label.text,), room)
    if overlay.divider is not None:
        _divider(painter, area, overlay.divider)
    bottom = area.bottom() - _MARGIN
    if overlay.mark:
        # A line of its own below all else: figures and scale stand on it, at any width.
        tall = metrics.height() + 2 * _PADDING
        wide = min(metrics.horizontalAdvance(overlay.mark) + 2 * _PADDING, area.width() - 2 * _MARGIN)
        corner = QPointF(area.right() - _MARGIN - wide, bottom - tall)
        _chip(painter, metrics, corner, (overlay.mark,), area.width() - 2 * _MARGIN)
        if overlay.scale is not None or overlay.figures:
            area = area.adjusted(0.0, 0.0, 0.0, -tall - _PADDING)
            bottom = area.bottom() - _MARGIN
    if overlay.scale is not None:
        bottom = _scale(painter, metrics, area, overlay.scale) - _PADDING
    if overlay.figures:
        tall = len(overlay.figures) * metrics.height() + 2 * _PADDING
        corner = QPointF(area.left() + _MARGIN, max(area.top() + _MARGIN, bottom - tall))
        _chip(painter, metrics, corner, overlay.figures, area.width() - 2 * _MARGIN)


def _chip(
    painter: QPainter, metrics: QFontMetricsF, corner: QPointF, lines: tuple[str, ...], room: float
) -> None:
    inside = room - 2 * _PADDING
    shown = [metrics.elidedText(line, Qt.TextElideMode.ElideRight, inside) for line in lines]
    wide = max(metrics.horizontalAdvance(line) for line in shown) + 2 * _PADDING
    box = QRectF(corner.x(), corner.y(), wide, len(shown) * metrics.height() + 2 * _PADDING)
    _draw_paper(painter, box)
    for row, line in enumerate(shown):
        base = box.top() + _PADDING + row * metrics.height() + metrics.ascent()
        painter.drawText(QPointF(box.left() + _PADDING, base), line)


def _draw_paper(painter: QPainter, box: QRectF) -> None:
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(_PAPER)
    painter.drawRoundedRect(box, 4.0, 4.0)
    painter.setPen(_INK)


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
    width = min(_SCALE_WIDTH, area.width() - 2 * _MARGIN - 2 * _PADDING)
    tall = 2 * metrics.height() + _SCALE_HEIGHT + 3 * _PADDING
    box = QRectF(area.left() + _MARGIN, area.bottom() - _MARGIN - tall, width + 2 * _PADDING, tall)
    _draw_paper(painter, box)
    inner = box.adjusted(_PADDING, _PADDING, -_PADDING, -_PADDING)
    title = metrics.elidedText(f"ΔE00 {scale.of}", Qt.TextElideMode.ElideRight, inner.width())
    painter.drawText(QPointF(inner.left(), inner.top() + metrics.ascent()), title)
    bar = QRectF(inner.left(), inner.top() + metrics.height() + 0.5 * _PADDING, inner.width(), _SCALE_HEIGHT)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.drawImage(bar, _scale_image())
    under = QRectF(bar.left(), bar.bottom(), bar.width(), metrics.height() + 0.5 * _PADDING)
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

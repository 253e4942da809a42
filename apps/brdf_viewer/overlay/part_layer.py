"""Parts that are marked in the picture: an outline around what is seen of them, and a label."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from brdf_qt.gl.layer import PictureLayer, draw_chip
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QFontMetricsF, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

_LINE, _HALO = (255, 255, 255, 235), (0, 0, 0, 170)
_GAP = 8.0


@dataclass(frozen=True, eq=False)
class PartMark:
    """The outline of parts in one picture: ``box`` (of the layer's widget, shares 0…1) is where that picture lies."""

    outline: QImage
    box: QRectF
    above: QPointF
    """The middle of the upper edge of what is marked, shares of the picture."""


class PartLayer(PictureLayer):
    """Draws the marks with ``label`` at the first."""

    def __init__(self, picture: QWidget) -> None:
        super().__init__(picture)
        self.setObjectName("part_layer")
        self.label = ""
        self.marks: tuple[PartMark, ...] = ()

    def show_marks(self, marks: tuple[PartMark, ...], label: str) -> None:
        """Show these; none and no label: nothing."""
        if not marks and not self.marks and label == self.label:
            return
        self.marks, self.label = marks, label
        self.setAccessibleName(label)
        self.setVisible(bool(marks or label))
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
        whole = QRectF(self.rect())
        for mark in self.marks:
            painter.drawImage(_scaled(mark.box, whole), mark.outline)
        if not self.label:
            return
        metrics = QFontMetricsF(painter.font())
        wide = metrics.horizontalAdvance(self.label) + 12.0
        tall = metrics.height() + 12.0
        middle = QPointF(whole.center().x(), tall + 2 * _GAP)
        if self.marks:
            area, above = _scaled(self.marks[0].box, whole), self.marks[0].above
            middle = QPointF(
                area.left() + above.x() * area.width(), area.top() + above.y() * area.height() - _GAP
            )
        left = min(max(middle.x() - 0.5 * wide, _GAP), max(_GAP, whole.width() - wide - _GAP))
        top = max(middle.y() - tall, _GAP)
        draw_chip(painter, QPointF(left, top), (self.label,), whole.width() - 2 * _GAP)


def mark_of(seen: NDArray[np.bool_], box: QRectF, ratio: float) -> PartMark | None:
    """Return the mark around pixels ``seen`` (h, w) of a picture, ``ratio`` of them a logical pixel; None for none."""
    if not seen.any():
        return None
    width = max(1, round(2.0 * ratio))
    near = _grown(seen, width)
    pixels = np.zeros((*seen.shape, 4), np.uint8)
    pixels[_grown(near, max(1, width // 2)) & ~seen] = _HALO
    pixels[near & ~seen] = _LINE
    rows, columns = np.nonzero(seen)
    above = QPointF((columns.min() + columns.max() + 1) / 2 / seen.shape[1], rows.min() / seen.shape[0])
    height, across = seen.shape
    image = QImage(pixels.tobytes(), across, height, 4 * across, QImage.Format.Format_RGBA8888)
    return PartMark(image.copy(), box, above)


def _grown(seen: NDArray[np.bool_], by: int) -> NDArray[np.bool_]:
    """Return what is within ``by`` pixels of ``seen`` along rows, columns and half as far along both."""
    grown = seen.copy()
    for _ in range(by):
        wider = grown.copy()
        wider[1:] |= grown[:-1]
        wider[:-1] |= grown[1:]
        wider[:, 1:] |= grown[:, :-1]
        wider[:, :-1] |= grown[:, 1:]
        grown = wider
    return grown


def _scaled(box: QRectF, whole: QRectF) -> QRectF:
    return QRectF(
        box.x() * whole.width(),
        box.y() * whole.height(),
        box.width() * whole.width(),
        box.height() * whole.height(),
    )

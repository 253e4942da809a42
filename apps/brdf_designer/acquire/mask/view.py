"""The picture with a brush: what is hatched is left out of the measurement.

Left drag paints (Ctrl the other way round), the arrow keys move the brush, Space paints a dab at it, [ and ] make it
smaller and larger, X changes between leaving out and taking in.

Signals: ``mask_edited()`` after each stroke, undo and redo; ``radius_changed(pixels)``, ``mode_changed(takes_in)``.
"""

from __future__ import annotations

import numpy as np
from brdf_qt.program.translation import tr
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QWidget

from brdf_designer.acquire.mask.history import MaskHistory
from brdf_designer.acquire.plots.marks import CASING, INK, Area, Mark
from brdf_designer.acquire.plots.tone import area_of
from brdf_designer.acquire.plots.view import PictureView
from brdf_suite.arrays import Bools

LEAST_RADIUS, MOST_RADIUS = 0.5, 400.0
_STEP = 1.25
_KEY_PX = 12.0


class MaskView(PictureView):
    """A picture whose mask can be painted; without a mask it is a picture only."""

    mask_edited = Signal()
    radius_changed = Signal(float)
    mode_changed = Signal(bool)

    def __init__(self, name: str, empty_text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(name, empty_text, parent)
        self.setToolTip(
            tr(
                "Drag to paint (Ctrl: erase). Keys: arrows move the brush, Space paints, [ and "
                "] change its size, X switches its mode. Wheel zooms, Shift drag pans, F "
                "frames."
            )
        )
        self.history: MaskHistory | None = None
        self.radius = 12.0
        self.takes_in = False
        self._under: tuple[Mark, ...] = ()
        self._at = QPointF()
        self._last: QPointF | None = None
        self._stroke_takes_in = False

    def show_mask(self, used: Bools | None) -> None:
        """Start from this mask (rows, columns), true where pixels are used; its history is empty."""
        self.history = None if used is None else MaskHistory(used)
        self._at = QPointF(self.image.width() / 2.0, self.image.height() / 2.0)
        self._show()

    def show_under(self, *marks: Mark) -> None:
        """Draw these marks below the mask."""
        self._under = marks
        self._show()

    def set_radius(self, radius: float) -> None:
        """Set the brush's radius in pixels of the picture."""
        radius = min(MOST_RADIUS, max(LEAST_RADIUS, radius))
        if radius != self.radius:
            self.radius = radius
            self.radius_changed.emit(radius)
            self.update()

    def set_takes_in(self, takes_in: bool) -> None:
        """Let the brush take pixels in, or leave them out."""
        if takes_in != self.takes_in:
            self.takes_in = takes_in
            self.mode_changed.emit(takes_in)
            self.update()

    def undo(self) -> None:
        """Take the newest stroke back."""
        if self.history is not None and self.history.undo():
            self._edited()

    def redo(self) -> None:
        """Paint again what was taken back last."""
        if self.history is not None and self.history.redo():
            self._edited()

    def put(self, used: Bools) -> None:
        """Put another mask in its place, as one step."""
        if self.history is not None and self.history.put(used):
            self._edited()

    def include_all(self) -> None:
        """Put a mask that leaves nothing out in its place."""
        if self.history is not None:
            self.put(np.ones_like(self.history.used))

    def _edited(self) -> None:
        self._show()
        self.mask_edited.emit()

    def _show(self) -> None:
        marks = list(self._under)
        if self.history is not None:
            marks.append(Area(area_of(~self.history.used), tr("excluded")))
        self.show_marks(marks)

    def draw_over(self, painter: QPainter) -> None:
        """Draw the brush."""
        if self.history is None or not (self.underMouse() or self.hasFocus()):
            return
        size = self.radius * self.scale
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for colour, width in ((CASING, 3.0), (INK, 1.2)):
            pen = QPen(colour, width)
            if self.takes_in:
                pen.setDashPattern([4.0 / width, 3.0 / width])
            painter.setPen(pen)
            painter.drawEllipse(self.to_screen.map(self._at), size, size)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        keys = event.modifiers()
        plain = event.button() == Qt.MouseButton.LeftButton and not keys & Qt.KeyboardModifier.ShiftModifier
        if self.history is None or not plain:
            super().mousePressEvent(event)
            return
        self._stroke_takes_in = self.takes_in != bool(keys & Qt.KeyboardModifier.ControlModifier)
        self._at = self._last = self.to_picture(event.position())
        self.history.begin()
        self._dab(self._at, self._at)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        self._at = self.to_picture(event.position())
        if self._last is not None:
            self._dab(self._last, self._at)
            self._last = self._at
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._last is None or self.history is None:
            super().mouseReleaseEvent(event)
            return
        self._last = None
        if self.history.end():
            self._edited()

    def _dab(self, start: QPointF, end: QPointF) -> None:
        assert self.history is not None
        places = (start.x(), start.y()), (end.x(), end.y())
        if self.history.dab(*places, self.radius, use=self._stroke_takes_in):
            self._show()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self.history is None:
            super().keyPressEvent(event)
            return
        key, keys = Qt.Key(event.key()), event.modifiers()
        step = (1.0 if keys & Qt.KeyboardModifier.ShiftModifier else _KEY_PX) / self.scale
        moves = {
            Qt.Key.Key_Left: QPointF(-step, 0.0),
            Qt.Key.Key_Right: QPointF(step, 0.0),
            Qt.Key.Key_Up: QPointF(0.0, -step),
            Qt.Key.Key_Down: QPointF(0.0, step),
        }
        if key in moves:
            at, width, height = self._at + moves[key], self.image.width(), self.image.height()
            self._at = QPointF(min(max(at.x(), 0.0), width), min(max(at.y(), 0.0), height))
            self.hovered.emit(self._at.x(), self._at.y())
        elif key == Qt.Key.Key_Space:
            self._stroke_takes_in = self.takes_in != bool(keys & Qt.KeyboardModifier.ControlModifier)
            place = (self._at.x(), self._at.y())
            if self.history.dab(place, place, self.radius, use=self._stroke_takes_in):
                self._edited()
        elif key == Qt.Key.Key_BracketLeft:
            self.set_radius(self.radius / _STEP)
        elif key == Qt.Key.Key_BracketRight:
            self.set_radius(self.radius * _STEP)
        elif key == Qt.Key.Key_X and not keys:
            self.set_takes_in(not self.takes_in)
        else:
            super().keyPressEvent(event)
            return
        self.update()

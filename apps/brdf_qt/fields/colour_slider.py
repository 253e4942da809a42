"""A slider whose track shows the colour that each position would give; the part outside sRGB is hatched.

Signals as in :mod:`brdf_qt.fields.number`: ``edited(float)`` by the user only, and the gesture pair around a
drag and around a burst of keys or wheel turns. A wrapping slider (a hue) goes on at its other end.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import (
    QBrush,
    QColor,
    QFocusEvent,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractSlider, QSizePolicy, QWidget

from brdf_qt.fields.burst import Burst

TRACK_SAMPLES = 48
_MARGIN = 5.0
_FINE = 0.1
# Made once: a drag draws three tracks a hundred times a second.
_DARK_HATCH = QBrush(QColor(0, 0, 0, 130), Qt.BrushStyle.BDiagPattern)
_LIGHT_HATCH = QBrush(QColor(255, 255, 255, 60), Qt.BrushStyle.BDiagPattern)


@lru_cache(maxsize=32)
def _positions(low: float, high: float) -> NDArray[np.float64]:
    """Return the places of a track, not to be written: every edit asks for the same."""
    places = np.linspace(low, high, TRACK_SAMPLES)
    places.flags.writeable = False
    return places


class ColourSlider(QAbstractSlider):
    """A horizontal slider over ``minimum``…``maximum`` in units of ``unit``, moved in steps of ``step``."""

    edited = Signal(float)
    gesture_started = Signal()
    gesture_finished = Signal()

    def __init__(
        self,
        name: str,
        unit: str = "",
        minimum: float = 0.0,
        maximum: float = 1.0,
        step: float = 0.01,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._low, self._high, self._step = minimum, maximum, step
        self._wrapping = False
        self._amount = minimum
        self._grabbed: tuple[float, float] | None = None
        self._track = QImage()
        self._outside: list[tuple[float, float]] = []
        self.setOrientation(Qt.Orientation.Horizontal)
        self.set_reach(minimum, maximum, step)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        # Filled edge to edge, it is drawn without all that lies behind it.
        self.setAutoFillBackground(True)
        self.setAccessibleName(f"{name}, {unit}" if unit else name)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._burst = Burst(self)
        self._burst.started.connect(self.gesture_started)
        self._burst.finished.connect(self.gesture_finished)
        self.valueChanged.connect(self._on_changed)

    def set_reach(self, minimum: float, maximum: float, step: float, *, wrapping: bool = False) -> None:
        """Reach from ``minimum`` to ``maximum`` in ``step``; ``wrapping``: the ends are one. The amount stays."""
        self._low, self._high, self._step, self._wrapping = minimum, maximum, step, wrapping
        with QSignalBlocker(self):
            self.setRange(0, round((maximum - minimum) / step))
            self.setSingleStep(round(max(1.0, 0.5 / step)) if step < 0.5 else 1)
            self.setPageStep(10 * self.singleStep())
            self.setValue(round((self._amount - minimum) / step))
        self.update()

    def amount(self) -> float:
        return self._amount

    def set_amount(self, amount: float) -> None:
        """Show ``amount`` without a signal; beyond the range the handle stays at the end."""
        if amount != self._amount:
            before, self._amount = self._amount, amount
            with QSignalBlocker(self):
                self.setValue(round((amount - self._low) / self._step))
            for place in (before, amount):
                self.update(self._handle(place).toAlignedRect().adjusted(-2, -2, 2, 2))

    def positions(self) -> NDArray[np.float64]:
        """Return the ``TRACK_SAMPLES`` values, left to right, whose colours :meth:`set_track` wants."""
        return _positions(self._low, self._high)

    def set_track(self, rgb: NDArray[np.uint8], in_gamut: NDArray[np.bool_]) -> None:
        """Colour the track: ``rgb`` (n, 3) sRGB at n equal steps; ``in_gamut`` (n,) false where clipped."""
        row = np.ascontiguousarray(rgb, dtype=np.uint8)
        count = len(row)
        self._track = QImage(row.data, count, 1, 3 * count, QImage.Format.Format_RGB888).copy()
        self._outside = []
        if not in_gamut.all():
            edges = np.flatnonzero(np.diff(np.concatenate(([True], in_gamut, [True])).astype(np.int8)))
            self._outside = [(a / count, b / count) for a, b in zip(edges[::2], edges[1::2], strict=True)]
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(140, 22)

    def minimumSizeHint(self) -> QSize:
        return QSize(64, 22)

    def _groove(self) -> QRectF:
        return QRectF(self.rect()).adjusted(_MARGIN, 4, -_MARGIN, -4)

    def _x(self, amount: float) -> float:
        groove = self._groove()
        part = (amount - self._low) / (self._high - self._low)
        return groove.left() + min(1.0, max(0.0, part)) * groove.width()

    def _handle(self, amount: float) -> QRectF:
        return QRectF(self._x(amount) - 3.5, 1.5, 7, self.height() - 3)

    def _at(self, x: float) -> float:
        groove = self._groove()
        return self._snapped(self._low + (x - groove.left()) * self._per_pixel())

    def _per_pixel(self) -> float:
        return (self._high - self._low) / max(1.0, self._groove().width())

    def _snapped(self, amount: float) -> float:
        if self._wrapping:
            amount = self._low + (amount - self._low) % (self._high - self._low)
        steps = round((min(self._high, max(self._low, amount)) - self._low) / self._step)
        return round(self._low + steps * self._step, 9)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        groove = self._groove()
        if self._track.isNull():
            painter.fillRect(groove, self.palette().base())
        else:
            painter.drawImage(groove, self._track, QRectF(0.5, 0, self._track.width() - 1.0, 1))
        for start, end in self._outside:
            part = QRectF(groove.left() + start * groove.width(), groove.top(), 0, groove.height())
            part.setRight(groove.left() + end * groove.width())
            painter.fillRect(part, _DARK_HATCH)
            painter.fillRect(part.translated(1, 0), _LIGHT_HATCH)
        painter.setPen(QPen(self.palette().dark().color(), 1))
        painter.drawRect(groove)
        self._paint_handle(painter)

    def _paint_handle(self, painter: QPainter) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        x, handle = self._x(self._amount), self._handle(self._amount)
        focus = self.hasFocus()
        outer = self.palette().highlight().color() if focus else QColor(0, 0, 0)
        painter.setPen(QPen(outer, 2.0 if focus else 1.0))
        painter.setBrush(QColor(240, 240, 240) if self.isEnabled() else QColor(128, 128, 128))
        painter.drawRoundedRect(handle, 2, 2)
        painter.setPen(QPen(QColor(90, 90, 90), 1))
        painter.drawLine(QPointF(x, handle.top() + 4), QPointF(x, handle.bottom() - 4))

    def sliderChange(self, change: QAbstractSlider.SliderChange) -> None:
        """Draw nothing anew for a value: who changes it knows which part to draw."""
        if change != QAbstractSlider.SliderChange.SliderValueChange:
            super().sliderChange(change)

    def _on_changed(self, value: int) -> None:
        self._burst.touch()
        self._amount = round(self._low + value * self._step, 9)
        self.update()
        self.edited.emit(self._amount)

    def _move_to(self, amount: float) -> None:
        if amount != self._amount:
            self.set_amount(amount)
            self.edited.emit(amount)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            event.ignore()
            return
        self._burst.end()
        x = event.position().x()
        self.gesture_started.emit()
        if abs(x - self._x(self._amount)) > 5:
            self._move_to(self._at(x))
        self._grabbed = (x, self._amount)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._grabbed is None:
            return
        start, amount = self._grabbed
        scale = _FINE if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        self._move_to(self._snapped(amount + (event.position().x() - start) * self._per_pixel() * scale))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and self._grabbed is not None:
            self._grabbed = None
            self.gesture_finished.emit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Turn only with the focus, so that scrolling the inspector changes nothing."""
        if self.hasFocus() and event.angleDelta().y():
            self._step_by((1 if event.angleDelta().y() > 0 else -1) * self.singleStep())
            event.accept()
        else:
            event.ignore()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        keys, key, step = Qt.Key, Qt.Key(event.key()), self.singleStep()
        fine = {keys.Key_Right: 1, keys.Key_Left: -1}
        by = {keys.Key_Right: step, keys.Key_Up: step, keys.Key_Left: -step, keys.Key_Down: -step}
        by |= {keys.Key_PageUp: self.pageStep(), keys.Key_PageDown: -self.pageStep()}
        if key in fine and event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self._step_by(fine[key])
        elif key in by and self._wrapping:
            self._step_by(by[key])
        else:
            super().keyPressEvent(event)

    def _step_by(self, steps: int) -> None:
        value = self.value() + steps
        count = self.maximum() - self.minimum()
        self.setValue(self.minimum() + (value - self.minimum()) % count if self._wrapping else value)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.end()
        super().focusOutEvent(event)
        self.update()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.update()

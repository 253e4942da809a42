"""The divider of a swipe, dragged with the mouse, before the gestures of the camera see it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QWidget

REACH_PX = 8
"""So near to the line the mouse takes it."""


class DividerGesture(QObject):
    """Listens to ``widget``, to which no other filter may be added later.

    Signals: ``moved(share)`` of the width, 0…1; ``started()`` and ``finished()`` around a drag.
    """

    moved = Signal(float)
    started = Signal()
    finished = Signal()

    def __init__(self, widget: QWidget, parent: QObject | None = None) -> None:
        super().__init__(parent or widget)
        self._widget = widget
        self._share: float | None = None
        self._grip: float | None = None
        self._over = False
        widget.installEventFilter(self)

    def set_divider(self, share: float | None) -> None:
        """Say where the divider is; None where there is none."""
        self._share = share
        if share is None:
            self._end()
            self._hover(False)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if self._share is None:
            return False
        kind = event.type()
        if kind == QEvent.Type.MouseButtonPress and isinstance(event, QMouseEvent):
            return self._press(event)
        if kind == QEvent.Type.MouseMove and isinstance(event, QMouseEvent):
            return self._move(event)
        if kind == QEvent.Type.MouseButtonRelease and self._grip is not None:
            self._end()
            return True
        if kind in (QEvent.Type.Hide, QEvent.Type.WindowDeactivate):
            self._end()
        elif kind == QEvent.Type.Leave:
            self._hover(False)
        return False

    def _press(self, event: QMouseEvent) -> bool:
        plain = event.modifiers() == Qt.KeyboardModifier.NoModifier
        if event.button() != Qt.MouseButton.LeftButton or not plain or not self._is_near(event):
            return False
        self._grip = event.position().x() - self._line()
        self.started.emit()
        return True

    def _move(self, event: QMouseEvent) -> bool:
        if self._grip is None:
            if event.buttons() == Qt.MouseButton.NoButton:
                self._hover(self._is_near(event))
            return False
        if not event.buttons() & Qt.MouseButton.LeftButton:  # released outside the widget, without an event
            self._end()
            return False
        share = (event.position().x() - self._grip) / max(1, self._widget.width())
        self.moved.emit(min(1.0, max(0.0, share)))
        return True

    def _line(self) -> float:
        return (self._share or 0.0) * self._widget.width()

    def _is_near(self, event: QMouseEvent) -> bool:
        return abs(event.position().x() - self._line()) <= REACH_PX

    def _hover(self, over: bool) -> None:
        if over != self._over:
            self._over = over
            if over:
                self._widget.setCursor(Qt.CursorShape.SplitHCursor)
            else:
                self._widget.unsetCursor()

    def _end(self) -> None:
        if self._grip is not None:
            self._grip = None
            self.finished.emit()

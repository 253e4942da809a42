"""The mouse gestures of every picture in the suite, as intents: no camera and no rendering is known here.

Left drag orbits; middle drag or Shift + left drag pans; the wheel zooms to what is under the cursor; Alt + left
drag, or right drag (window managers like to keep Alt for themselves), turns the light; F frames the object. What
a drag does is settled when its button goes down. While Ctrl is held, all of them are ten times as fine. Nothing
goes on after the hand has stopped.
"""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

ORBIT_DEG_PER_PIXEL = 0.35
LIGHT_DEG_PER_PIXEL = 0.5
ZOOM_PER_NOTCH = 0.88
FINE = 0.1
"""What a gesture is multiplied by while Ctrl is held."""
_NOTCH = 120.0
CLICK_PIXELS = 4.0
"""A button that comes up within so many pixels of where it went down was no drag."""


class CameraGestures(QObject):
    """Turns the mouse and key events of ``widget`` into intents.

    Signals
    -------
    orbited(azimuth_deg, elevation_deg)
        Changes of the camera's angles; the object follows the mouse.
    panned(right, up)
        How far the picture moved, as fractions of the widget's height.
    zoomed(factor, right, up)
        What the distance is to be multiplied by; below 1 comes nearer. Where the cursor is, from the middle of the
        widget, as fractions of its height.
    light_turned(degrees)
        Change of the environment's rotation, positive counter-clockwise seen from above.
    framed()
        The object is to fill the picture.
    started(), finished()
        Around each drag.
    """

    orbited = Signal(float, float)
    panned = Signal(float, float)
    zoomed = Signal(float, float, float)
    light_turned = Signal(float)
    framed = Signal()
    started = Signal()
    finished = Signal()

    def __init__(self, widget: QWidget, parent: QObject | None = None) -> None:
        super().__init__(parent or widget)
        self._widget = widget
        self._drag: str | None = None
        self._button = Qt.MouseButton.NoButton
        self._last = QPointF()
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if isinstance(event, QMouseEvent):
            handle = {
                QEvent.Type.MouseButtonPress: self._press,
                QEvent.Type.MouseMove: self._move,
                QEvent.Type.MouseButtonRelease: self._release,
            }.get(kind)
            return handle is not None and handle(event)
        if isinstance(event, QWheelEvent):
            return self._wheel(event)
        if kind == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            return self._key(event)
        if kind in (QEvent.Type.Hide, QEvent.Type.WindowDeactivate):
            self._end()
        return super().eventFilter(watched, event)

    def _press(self, event: QMouseEvent) -> bool:
        drag = _drag_of(event)
        if drag is None or self._drag is not None:
            return False
        self._drag, self._button, self._last = drag, event.button(), event.position()
        self._widget.setCursor(Qt.CursorShape.ClosedHandCursor)
        self.started.emit()
        return True

    def _move(self, event: QMouseEvent) -> bool:
        if self._drag is None:
            return False
        if not event.buttons() & self._button:  # released outside the widget, without an event
            self._end()
            return False
        step = (event.position() - self._last) * _fineness(event)
        self._last = event.position()
        if self._drag == "orbit":
            self.orbited.emit(-ORBIT_DEG_PER_PIXEL * step.x(), ORBIT_DEG_PER_PIXEL * step.y())
        elif self._drag == "pan":
            height = max(1, self._widget.height())
            self.panned.emit(step.x() / height, -step.y() / height)
        else:
            self.light_turned.emit(LIGHT_DEG_PER_PIXEL * step.x())
        return True

    def _release(self, event: QMouseEvent) -> bool:
        if self._drag is None or event.button() != self._button:
            return False
        self._end()
        return True

    def _wheel(self, event: QWheelEvent) -> bool:
        delta = event.angleDelta().y() or event.angleDelta().x()  # Alt turns a wheel sideways
        if delta == 0:
            return False
        place = event.position() - QPointF(self._widget.width() / 2, self._widget.height() / 2)
        height = max(1, self._widget.height())
        notches = delta / _NOTCH * _fineness(event)
        self.zoomed.emit(ZOOM_PER_NOTCH**notches, place.x() / height, -place.y() / height)
        event.accept()
        return True

    def _key(self, event: QKeyEvent) -> bool:
        if event.key() != Qt.Key.Key_F or event.modifiers() != Qt.KeyboardModifier.NoModifier:
            return False
        self.framed.emit()
        return True

    def _end(self) -> None:
        if self._drag is not None:
            self._drag = None
            self._widget.unsetCursor()
            self.finished.emit()


def is_click(pressed: QPointF, event: QMouseEvent) -> bool:
    """Whether a button that went down at ``pressed`` and comes up with ``event`` was no drag."""
    moved = event.position() - pressed
    return abs(moved.x()) + abs(moved.y()) < CLICK_PIXELS


def _fineness(event: QMouseEvent | QWheelEvent) -> float:
    return FINE if event.modifiers() & Qt.KeyboardModifier.ControlModifier else 1.0


def _drag_of(event: QMouseEvent) -> str | None:
    """Which drag a button press begins; None where it is none of ours."""
    if event.button() == Qt.MouseButton.MiddleButton:
        return "pan"
    if event.button() == Qt.MouseButton.RightButton:
        return "light"
    if event.button() != Qt.MouseButton.LeftButton:
        return None
    modifiers = event.modifiers()
    if modifiers & Qt.KeyboardModifier.AltModifier:
        return "light"
    if modifiers & Qt.KeyboardModifier.ShiftModifier:
        return "pan"
    return "orbit"

"""The light taken by the hand: its handle dragged over the sphere, or turned by Alt + drag anywhere in the picture."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent

from brdf_lobe_visualizer.space_frame import LIGHT_REACH
from brdf_lobe_visualizer.space_view import SpaceView

DEG_PER_PIXEL = 0.35
FINE = 0.1


class IncidenceDrag(QObject):
    """Turns mouse events of the view into incidences; installed after the camera's gestures, so that it comes first.

    Signals: ``dragged(theta_deg, phi_deg)`` for the handle on the sphere, ``turned(theta_deg, phi_deg)`` changes by
    Alt + drag, ``reset()`` by a double click on the handle.
    """

    dragged = Signal(float, float)
    turned = Signal(float, float)
    reset = Signal()

    def __init__(self, view: SpaceView) -> None:
        super().__init__(view)
        self._view = view
        self._mode = ""
        self._last = QPointF()
        view.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if kind == QEvent.Type.MouseButtonPress:
            return self._press(event)
        if kind == QEvent.Type.MouseMove:
            return self._move(event)
        if kind == QEvent.Type.MouseButtonRelease and self._mode:
            self._end()
            return True
        if kind == QEvent.Type.MouseButtonDblClick and self._view.handle_at(event.position()):
            self._end()
            self.reset.emit()
            return True
        if kind in (QEvent.Type.Hide, QEvent.Type.WindowDeactivate, QEvent.Type.Leave) and not self._mode:
            self._view.set_hot(False)
        return super().eventFilter(watched, event)

    def _press(self, event: QMouseEvent) -> bool:
        left = event.button() == Qt.MouseButton.LeftButton
        alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        if left and not alt and self._view.handle_at(event.position()):
            self._mode = "handle"
            self._view.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif (left and alt) or event.button() == Qt.MouseButton.RightButton:
            self._mode = "turn"
            self._view.setCursor(Qt.CursorShape.SizeAllCursor)
        else:
            return False
        self._last = event.position()
        self._view.setFocus(Qt.FocusReason.MouseFocusReason)
        return True

    def _move(self, event: QMouseEvent) -> bool:
        at = event.position()
        if not self._mode:
            if event.buttons() == Qt.MouseButton.NoButton:
                hot = self._view.handle_at(at)
                self._view.set_hot(hot)
                if hot:
                    self._view.setCursor(Qt.CursorShape.OpenHandCursor)
                else:
                    self._view.unsetCursor()
            return False
        if event.buttons() == Qt.MouseButton.NoButton:  # released where nobody told us
            self._end()
            return False
        if self._mode == "handle":
            place = on_sphere(*self._view.ray(at)[:2], LIGHT_REACH)
            theta = math.degrees(math.atan2(math.hypot(place[0], place[1]), place[2]))
            # The light's azimuth in the frame is that of the incidence and half a turn.
            phi = math.degrees(math.atan2(-place[1], -place[0])) if theta > 0.05 else 0.0
            self.dragged.emit(theta, phi)
        else:
            step = at - self._last
            scale = DEG_PER_PIXEL * (FINE if event.modifiers() & Qt.KeyboardModifier.ControlModifier else 1.0)
            self.turned.emit(scale * step.y(), scale * step.x())
        self._last = at
        return True

    def _end(self) -> None:
        if self._mode:
            self._mode = ""
            self._view.unsetCursor()


def on_sphere(
    start: npt.NDArray[np.float64], along: npt.NDArray[np.float64], radius: float
) -> npt.NDArray[np.float64]:
    """Return where (3,) a ray meets the upper half of a sphere about 0 first, or comes nearest to it.

    A ray that meets the sphere below the horizon is taken to its far side where that is above, else to the horizon.
    """
    middle = -float(start @ along)
    nearest = start + middle * along
    apart = float(nearest @ nearest)
    if apart >= radius * radius:
        place = nearest
    else:
        reach = math.sqrt(radius * radius - apart)
        first, second = (start + (middle + sign * reach) * along for sign in (-1.0, 1.0))
        place = first if first[2] >= 0.0 or second[2] < 0.0 else second
    place = np.array([place[0], place[1], max(place[2], 0.0)])
    length = float(np.linalg.norm(place))
    return place * (radius / length) if length > 1e-9 else np.array([0.0, 0.0, radius])

"""The light taken by the hand: its handle dragged over the sphere, or turned by Alt + drag anywhere in the picture."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent

from brdf_lobe_visualizer.view3d.frame import LIGHT_REACH
from brdf_suite.arrays import Floats

if TYPE_CHECKING:
    from brdf_lobe_visualizer.view3d.view import LobeView

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

    def __init__(self, view: LobeView) -> None:
        super().__init__(view)
        self._view = view
        self._mode = ""
        self._last = QPointF()
        view.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if isinstance(event, QMouseEvent):
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
        if event.buttons() == Qt.MouseButton.NoButton:  # released outside of the view
            self._end()
            return False
        if self._mode == "handle":
            start, along, _ = self._view.ray(at)
            light = self._view.scene.light
            last = np.array([0.0, 0.0, 1.0]) if light is None else light
            place = on_sphere(start, along, LIGHT_REACH, LIGHT_REACH * last)
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


def on_sphere(start: Floats, along: Floats, radius: float, last: Floats) -> Floats:
    """Return where (3,) a ray meets the upper half of a sphere about 0, or comes nearest to it.

    Of two places above the horizon the one nearer to ``last``, so that what is dragged behind the sphere stays behind;
    where none is above, the horizon below the nearer one.
    """
    middle = -float(start @ along)
    nearest = start + middle * along
    apart = float(nearest @ nearest)
    places = [nearest]
    if apart < radius * radius:
        reach = math.sqrt(radius * radius - apart)
        both = [start + (middle + sign * reach) * along for sign in (-1.0, 1.0)]
        places = [place for place in both if place[2] >= 0.0] or both
    place = min(places, key=lambda row: float(np.linalg.norm(row - last)))
    place = np.array([place[0], place[1], max(place[2], 0.0)])
    length = float(np.linalg.norm(place))
    return place * (radius / length) if length > 1e-9 else np.array([0.0, 0.0, radius])

"""The turntable: the object turns before a camera and a light that stand still.

The object itself has no angle in a view, so camera and light are turned together about it, the other way.
"""

from __future__ import annotations

import dataclasses
import math

from PySide6.QtCore import QElapsedTimer, QObject, QTimer, Signal

from brdf_suite.documents.view import View
from brdf_viewer.camera_presets import signed_deg

_LONGEST_STEP_S = 0.1


class Turntable(QObject):
    """Emits ``turned(degrees)`` as time passes while it runs, and ``running_changed(bool)``.

    ``deg_per_second`` is its speed, counter-clockwise seen from above; negative turns the other way.
    """

    turned = Signal(float)
    running_changed = Signal(bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.deg_per_second = 24.0
        self._clock = QElapsedTimer()
        self._timer = QTimer(self, interval=16, timeout=self._step)

    @property
    def is_running(self) -> bool:
        """Whether the object turns."""
        return self._timer.isActive()

    def set_running(self, running: bool) -> None:
        """Start or stop."""
        if running == self.is_running:
            return
        if running:
            self._clock.start()
            self._timer.start()
        else:
            self._timer.stop()
        self.running_changed.emit(running)

    def _step(self) -> None:
        """One step for the time that has passed; a slow frame makes it slower, not jerky."""
        seconds = min(self._clock.restart() / 1000.0, _LONGEST_STEP_S)
        self.turned.emit(self.deg_per_second * seconds)


def turn(view: View, degrees: float, centre: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> View:
    """Return the view of the object turned by ``degrees`` counter-clockwise seen from above.

    ``centre`` (m) is a point of the axis: the object turns about itself, also where the camera looks past it.
    """
    camera, target = view.camera, view.camera.target
    if target is not None:
        angle = math.radians(-degrees)
        x, z = target[0] - centre[0], target[2] - centre[2]
        turned = (x * math.cos(angle) + z * math.sin(angle), z * math.cos(angle) - x * math.sin(angle))
        target = (centre[0] + turned[0], target[1], centre[2] + turned[1])
    camera = dataclasses.replace(camera, azimuth_deg=(camera.azimuth_deg - degrees) % 360.0, target=target)
    return dataclasses.replace(view, camera=camera, rotation_deg=signed_deg(view.rotation_deg - degrees))

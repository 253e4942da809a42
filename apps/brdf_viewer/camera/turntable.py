"""The clock of the turntable; :func:`brdf_suite.output.turning.turned` turns the view."""

from __future__ import annotations

from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QElapsedTimer, QObject, Signal

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
        self._timer = make_timer(self, self._step, 16, single_shot=False)

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

"""The clock of the turntable; :func:`brdf_suite.output.turning.turned` turns the view."""

from __future__ import annotations

from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QElapsedTimer, QObject, Signal

from brdf_viewer.documents.view_history import ViewHistory


class Turntable(QObject):
    """Emits ``turned(degrees)`` as time passes while it runs, and ``running_changed(bool)``.

    ``deg_per_second`` is its speed, counter-clockwise seen from above; negative turns the other way. A whole run is one
    step of the history, called ``name``.
    """

    turned = Signal(float)
    running_changed = Signal(bool)

    def __init__(self, history: ViewHistory, name: str, deg_per_second: float, parent: QObject) -> None:
        super().__init__(parent)
        self._history, self._name = history, name
        self.deg_per_second = deg_per_second
        self._clock = QElapsedTimer()
        self._timer = make_timer(self, self._step, 16, single_shot=False)

    def set_running(self, running: bool) -> None:
        if running == self._timer.isActive():
            return
        if running:
            self._clock.start()
            self._timer.start()
            self._history.begin_running(self._name)
        else:
            self._timer.stop()
            self._history.end_running()
        self.running_changed.emit(running)

    def _step(self) -> None:
        # For all the time that has passed: it turns as fast as it says, also where frames are slow.
        self.turned.emit(self.deg_per_second * self._clock.restart() / 1000.0)

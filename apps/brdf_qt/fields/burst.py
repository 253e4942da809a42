"""Wheel turns and key repeats that follow closely belong to one gesture, so that they make one undo step."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from brdf_qt.work.timer import make_timer

PAUSE_MS = 500


class Burst(QObject):
    """``touch()`` starts a gesture or keeps it going; it ends after a pause, or at once by ``end()``."""

    started = Signal()
    finished = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._timer = make_timer(self, self.finished.emit, PAUSE_MS)

    @property
    def is_running(self) -> bool:
        """Whether a gesture goes on."""
        return self._timer.isActive()

    def touch(self) -> None:
        running = self._timer.isActive()
        self._timer.start()
        if not running:
            self.started.emit()

    def end(self) -> None:
        """End the gesture now, where one runs."""
        if self._timer.isActive():
            self._timer.stop()
            self.finished.emit()

"""Progress that is shown once work has lasted a while: most is done at once, and a line that comes and goes is unrest.

A line also takes room from the views, which would then be drawn twice.
"""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from brdf_qt.window.progress_strip import ProgressStrip
from brdf_qt.work.timer import make_timer

SHOW_AFTER_MS = 400


class LateProgress(QObject):
    """The lines of several jobs, by key."""

    def __init__(self, strip: ProgressStrip, parent: QObject) -> None:
        super().__init__(parent)
        self._strip = strip
        self._timers: dict[str, QTimer] = {}
        self._at: dict[str, float] = {}

    def begin(self, key: str, text: str, cancel: Callable[[], None]) -> Callable[[float, str], None]:
        """Begin a job, in the place of one with its key; return what takes how far it is."""
        self.end(key)
        self._at[key] = 0.0
        timer = self._timers[key] = make_timer(
            self, lambda: self._strip.set_job(key, self._at[key], text, cancel), SHOW_AFTER_MS
        )
        timer.start()

        def moved(fraction: float, _what: str) -> None:
            if self._timers.get(key) is timer:
                self._at[key] = fraction
                if key in self._strip.jobs:
                    self._strip.set_job(key, fraction, text, cancel)

        return moved

    def end(self, key: str) -> None:
        """The job has ended; nothing where there is none."""
        timer = self._timers.pop(key, None)
        if timer is not None:
            timer.stop()
            timer.deleteLater()
            del self._at[key]
            self._strip.end_job(key)

"""Slow work after an edit, at idle: never between a slider and its numbers, and never twice for one edit."""

from __future__ import annotations

from collections.abc import Callable
from time import monotonic

from PySide6.QtCore import QObject, QTimer

QUIET_MS = 40
LONGEST_WAIT_MS = 250
"""A drag that never pauses is followed this often; what cannot keep up with it should run as a task."""


class IdleWork(QObject):
    """Runs what was asked for once the edits pause, or every quarter of a second during a drag.

    Work is asked for by key; asking again replaces it. One piece runs per turn of the event loop, so that input
    and painting come between two of them.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._work: dict[str, Callable[[], None]] = {}
        self._since = 0.0
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._run_one)

    @property
    def waiting(self) -> tuple[str, ...]:
        """The keys of what is still to be done."""
        return tuple(self._work)

    def ask(self, key: str, work: Callable[[], None]) -> None:
        """Do ``work`` when there is time; it takes the place of what was asked under the same key."""
        if not self._work:
            self._since = monotonic()
        self._work[key] = work
        waited = 1000.0 * (monotonic() - self._since)
        self._timer.start(max(0, min(QUIET_MS, round(LONGEST_WAIT_MS - waited))))

    def drop(self, key: str) -> None:
        """Ask no longer for the work of ``key``."""
        self._work.pop(key, None)

    def _run_one(self) -> None:
        if not self._work:
            return
        key = next(iter(self._work))
        work = self._work.pop(key)
        if self._work:
            self._timer.start(0)
        work()

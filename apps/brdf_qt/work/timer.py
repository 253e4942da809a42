"""Timers with their action, for the widgets and controllers of the programs."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer


def make_timer(
    parent: QObject, action: Callable[[], object], interval_ms: int = 0, *, single_shot: bool = True
) -> QTimer:
    """Return a timer of ``parent``, not started, that calls ``action`` after ``interval_ms``."""
    timer = QTimer(parent)
    timer.setSingleShot(single_shot)
    timer.setInterval(interval_ms)
    timer.timeout.connect(action)
    return timer

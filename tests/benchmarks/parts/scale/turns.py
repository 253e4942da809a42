"""The event loop of a window, turn by turn; for the processes of ``bench scale``."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from time import perf_counter, sleep, thread_time

PATIENCE_S = 300.0
REST_S = 0.0005


class Turns:
    """Runs the event loop, and keeps the longest turn by what was going on.

    ``longest_s`` is wall time, which other programs of the machine lengthen; ``processor_s`` the window's thread alone.
    """

    def __init__(self) -> None:
        self.longest_s: dict[str, float] = {}
        self.processor_s: dict[str, float] = {}

    def until(self, name: str, done: Callable[[], object], patience_s: float = PATIENCE_S) -> float:
        """Run turns until ``done`` holds; return the seconds that it took. :class:`TimeoutError` after the patience."""
        began = perf_counter()
        while not done():
            if perf_counter() - began > patience_s:
                raise TimeoutError(f"{name} takes longer than {patience_s:g} s")
            self.turn(name)
            # As an event loop does, it sleeps where there is nothing to do: threads go on meanwhile.
            sleep(REST_S)
        return perf_counter() - began

    def call(self, name: str, act: Callable[[], object]) -> float:
        """Do something as one turn, as the handler of an input event would; return its seconds."""
        wall, processor = perf_counter(), thread_time()
        act()
        wall, processor = perf_counter() - wall, thread_time() - processor
        self.longest_s[name] = max(self.longest_s.get(name, 0.0), wall)
        self.processor_s[name] = max(self.processor_s.get(name, 0.0), processor)
        return wall

    def turn(self, name: str) -> float:
        """Run one turn of the event loop; return its seconds."""
        return self.call(name, _run_events)


def _run_events() -> None:
    from PySide6.QtCore import QCoreApplication, QEvent

    QCoreApplication.processEvents()
    # An event loop does this by itself; events that are processed by hand leave it out.
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def resident_mb(name: str = "VmRSS", process: int | None = None) -> float:
    """Return the memory of a process as reported by Linux, MB; ``VmHWM``: its peak."""
    text = Path(f"/proc/{process or os.getpid()}/status").read_text()
    return float(next(line.split()[1] for line in text.splitlines() if line.startswith(f"{name}:"))) / 1024.0

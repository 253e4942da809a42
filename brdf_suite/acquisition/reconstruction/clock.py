"""How long the steps of a reconstruction took, from whichever thread they ran in."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter


class StepClock:
    """Seconds by the name of a step; a step within another counts for itself alone."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._lock = threading.Lock()
        self._within = threading.local()

    @contextmanager
    def step(self, name: str) -> Iterator[None]:
        """Count the time of the block."""
        outer: float = getattr(self._within, "seconds", 0.0)
        self._within.seconds = 0.0
        start = perf_counter()
        try:
            yield
        finally:
            whole = perf_counter() - start
            with self._lock:
                self.seconds[name] = self.seconds.get(name, 0.0) + whole - self._within.seconds
            self._within.seconds = outer + whole

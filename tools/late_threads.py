"""A plug-in of pytest under which work in the background begins and ends late, as on a busy machine.

``python packaging/test.py -p tools.late_threads -n 6 tests/designer`` finds tests that take what a thread has not done
yet for a fault, and windows that do not wait for it: work waits for up to a second before it begins, and before its
answer is handed on, two times of three. More workers than processors delay the main threads too. Folders of tests that
need a screen (``SCREEN`` in ``packaging/test.py``) are a run of their own.
"""

from __future__ import annotations

import random
import threading
import time
from collections.abc import Callable
from functools import wraps
from typing import Any

from brdf_qt.link import parsing
from brdf_qt.work.tasks import TaskRunner

from brdf_suite.fitting.lobes.background import BackgroundSolver
from brdf_suite.pipeline.seen_queue import SeenWeights

_SHARE = 2 / 3
_LONGEST_S = 1.0
_OFTEN_S = 0.5
"""A thread that works off thousands of small pieces waits once in this time."""
_OURS = ("brdf_suite.", "brdf_qt.", "brdf_viewer.")
_waited = threading.local()


def wait(between_s: float = 0.0) -> None:
    """Wait at times, in a thread once in ``between_s``; the main thread never does."""
    if threading.current_thread() is threading.main_thread():
        return
    since = time.monotonic() - getattr(_waited, "last", float("-inf"))
    if since >= between_s and random.random() < _SHARE:
        time.sleep(random.uniform(0.0, _LONGEST_S))
        _waited.last = time.monotonic()


def late(function: Callable[..., Any], between_s: float = 0.0) -> Callable[..., Any]:
    """Return a function that begins and ends late; ``between_s`` as of :func:`wait`."""

    @wraps(function)
    def call(*arguments: Any, **words: Any) -> Any:
        wait(between_s)
        found = function(*arguments, **words)
        wait(between_s)
        return found

    return call


def pytest_configure() -> None:
    """Put waits around the work of task runners, the link, fits and the threads of the suite."""
    submit, run = TaskRunner.submit, threading.Thread.run

    def submit_late(self: TaskRunner, key: str, work: Any, *others: Any, **words: Any) -> int:
        return submit(self, key, late(work), *others, **words)

    def run_late(self: threading.Thread) -> None:
        target = getattr(self, "_target", None)
        if (getattr(target, "__module__", None) or "").startswith(_OURS):
            wait()
        run(self)

    TaskRunner.submit = submit_late  # type: ignore[method-assign]
    threading.Thread.run = run_late  # type: ignore[method-assign]
    parsing.decode = late(parsing.decode, _OFTEN_S)
    BackgroundSolver.advance = late(BackgroundSolver.advance, _OFTEN_S)  # type: ignore[method-assign]
    SeenWeights.find = late(SeenWeights.find)  # type: ignore[method-assign]

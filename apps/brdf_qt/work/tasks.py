"""Work in the background: a frozen request in, a frozen answer out, delivered on the main thread.

Per key only the newest request counts. A newer one cancels the older one (its next ``progress`` call raises
:class:`Cancelled`), and an answer whose generation is no longer the newest is dropped, whenever it arrives.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from threading import Event
from typing import Any
from weakref import WeakSet

from PySide6.QtCore import QDeadlineTimer, QObject, QRunnable, Qt, QThreadPool, Signal
from shiboken6 import isValid

from brdf_suite.errors import Cancelled
from brdf_suite.progress import Progress

Work = Callable[[Any, Progress], Any]


@dataclass
class _Task:
    generation: int
    stop: Event
    done: Callable[[Any], None]
    failed: Callable[[Exception], None]
    progress: Callable[[float, str], None] | None


class _Job(QRunnable):
    def __init__(self, runner: TaskRunner, key: str, task: _Task, work: Work, request: Any) -> None:
        super().__init__()
        self._runner, self._key, self._task = runner, key, task
        self._work, self._request = work, request

    def run(self) -> None:
        key, generation, stop = self._key, self._task.generation, self._task.stop

        def progress(fraction: float, what: str) -> None:
            if stop.is_set():
                raise Cancelled
            self._runner._moved.emit(key, generation, fraction, what)

        try:
            if stop.is_set():
                raise Cancelled
            answer, error = self._work(self._request, progress), None
        except Exception as caught:  # noqa: BLE001 - carried to the main thread, where failed() informs the user
            answer, error = None, caught
        # The answer of what was stopped is dropped anyway, and its runner may be gone by now.
        if not stop.is_set():
            self._runner._ended.emit(key, generation, answer, error)


def _stop_all(tasks: dict[str, _Task]) -> None:
    for task in tasks.values():
        task.stop.set()


_runners: WeakSet[TaskRunner] = WeakSet()


class TaskRunner(QObject):
    """Runs work on threads; ``busy_changed`` reports when the first starts and the last ends."""

    busy_changed = Signal(bool)
    _moved = Signal(str, int, float, str)
    _ended = Signal(str, int, object, object)

    def __init__(self, parent: QObject | None = None, threads: int = 2) -> None:
        super().__init__(parent)
        self._pool = QThreadPool(self)
        _runners.add(self)
        self._pool.setMaxThreadCount(threads)
        self._generation = 0
        self._tasks: dict[str, _Task] = {}
        queued = Qt.ConnectionType.QueuedConnection
        tasks = self._tasks
        # One that goes without being stopped waits for its threads, whose answers it can no longer take.
        self.destroyed.connect(lambda: _stop_all(tasks))
        self._moved.connect(self._on_moved, queued)
        self._ended.connect(self._on_ended, queued)

    @property
    def busy(self) -> bool:
        """Whether any task whose answer is still wanted runs or waits."""
        return bool(self._tasks)

    def submit(
        self,
        key: str,
        work: Work,
        request: Any,
        done: Callable[[Any], None],
        failed: Callable[[Exception], None],
        progress: Callable[[float, str], None] | None = None,
    ) -> int:
        """Run ``work(request, progress)`` on a thread and return its generation number.

        ``done(answer)``, ``failed(error)`` and ``progress(fraction, what)`` are called on the thread of the
        runner; none of them once a newer task of the same key was submitted or the task was cancelled.
        """
        was_busy = self.busy
        if key in self._tasks:
            self._tasks[key].stop.set()
        self._generation += 1
        task = _Task(self._generation, Event(), done, failed, progress)
        self._tasks[key] = task
        self._pool.start(_Job(self, key, task, work, request))
        if not was_busy:
            self.busy_changed.emit(True)
        return task.generation

    def cancel(self, key: str) -> None:
        """Ask the task to stop; its answer, should it come, is dropped."""
        task = self._tasks.pop(key, None)
        if task is not None:
            task.stop.set()
            if not self._tasks:
                self.busy_changed.emit(False)

    def stop(self, timeout_ms: int = 5000) -> bool:
        """Cancel everything and wait for the threads; True where all have ended in time."""
        for key in list(self._tasks):
            self.cancel(key)
        return self._pool.waitForDone(timeout_ms)

    def _current(self, key: str, generation: int) -> _Task | None:
        task = self._tasks.get(key)
        return task if task is not None and task.generation == generation else None

    def _on_moved(self, key: str, generation: int, fraction: float, what: str) -> None:
        task = self._current(key, generation)
        if task is not None and task.progress is not None:
            task.progress(fraction, what)

    def _on_ended(self, key: str, generation: int, answer: Any, error: Exception | None) -> None:
        task = self._current(key, generation)
        if task is None:
            return
        del self._tasks[key]
        if not self._tasks:
            self.busy_changed.emit(False)
        if error is None:
            task.done(answer)
        elif not isinstance(error, Cancelled):
            task.failed(error)


def end_all_tasks(timeout_ms: int) -> bool:
    """Cancel the work of all runners and wait for the threads; True where all have ended in time.

    For the end of a process: a thread that sends a signal of Qt while objects are destroyed waits for the main thread,
    which waits for it.
    """
    ends = QDeadlineTimer(timeout_ms)
    runners = [runner for runner in _runners if isValid(runner)]
    for runner in runners:
        _stop_all(runner._tasks)
    pools = (*(runner._pool for runner in runners), QThreadPool.globalInstance())
    return all(pool.waitForDone(ends) for pool in pools)

"""Reading files for a window: on threads, one after another in the order of the requests, each with a Cancel."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject

from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import tr
from brdf_qt.window.late_progress import LateProgress
from brdf_qt.window.progress_strip import ProgressStrip
from brdf_qt.work.tasks import TaskRunner
from brdf_suite.progress import Progress

_THREADS = 4
"""One reads; the others are for those that were cancelled and still wait for a disk or a library."""


@dataclass(frozen=True, eq=False)
class _Job:
    """A file that is to be read; ``moved`` takes how far it is."""

    key: str
    path: Path
    work: Callable[[Path, Progress], Any]
    done: Callable[[Any], None]
    failed: Callable[[Exception], None]
    moved: Callable[[float, str], None]


class FileReading(Feature, QObject):
    """Reads files, and shows in ``strip`` what takes longer than a moment."""

    def __init__(self, strip: ProgressStrip, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = TaskRunner(self, threads=_THREADS)
        self._progress = LateProgress(strip, self)
        self._numbers = count(1)
        self._jobs: dict[str, _Job] = {}

    @property
    def is_idle(self) -> bool:
        return not self._jobs

    def begin(
        self,
        path: Path,
        work: Callable[[Path, Progress], Any],
        done: Callable[[Any], None],
        failed: Callable[[Exception], None],
    ) -> None:
        """Run ``work(path, progress)`` on a thread once the files that were asked for before are read.

        ``done(answer)`` or ``failed(error)`` is called on the thread of the window, neither where the user cancels.
        """
        key = f"reading {next(self._numbers)}"
        text = tr("Reading {name}").format(name=path.name)
        moved = self._progress.begin(key, text, lambda: self._cancel(key))
        self._jobs[key] = _Job(key, path, work, done, failed, moved)
        if len(self._jobs) == 1:
            self._start_next()

    def close(self) -> None:
        """Drop what is waiting, and wait for the threads."""
        for key in list(self._jobs):
            self._progress.end(key)
        self._jobs.clear()
        self._tasks.stop()

    def _start_next(self) -> None:
        job = next(iter(self._jobs.values()), None)
        if job is not None:
            self._tasks.submit(
                job.key,
                job.work,
                job.path,
                lambda answer: self._end(job.key, job.done, answer),
                lambda error: self._end(job.key, job.failed, error),
                job.moved,
            )

    def _end(self, key: str, take: Callable[[Any], None], result: Any) -> None:
        self._progress.end(key)
        del self._jobs[key]
        try:
            take(result)
        finally:
            self._start_next()

    def _cancel(self, key: str) -> None:
        running = next(iter(self._jobs)) == key
        self._progress.end(key)
        del self._jobs[key]
        self._tasks.cancel(key)
        if running:
            self._start_next()

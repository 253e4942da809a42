"""What a worker does: some items, one after the other, in one thread of its process.

OpenGL contexts and Mitsuba belong to the thread that made them, and a worker of a cluster may have several: the items
of a process are done in a thread of their own, in which the step stays open for the next items.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from socket import gethostname
from threading import Timer
from time import monotonic

from brdf_suite.batches.items import JOURNAL, BatchItem
from brdf_suite.batches.journal import Finished
from brdf_suite.batches.steps import BatchStep, Work
from brdf_suite.errors import SuiteError
from brdf_suite.regular_files import is_file
from brdf_suite.release import __version__

IDLE_S = 60.0
"""After so long without an item a step is closed."""


@dataclass
class _Open:
    """The step that this process has open."""

    step: str
    work: Work
    stack: ExitStack
    used: float = 0.0


_thread = ThreadPoolExecutor(1, "batch")
_open: list[_Open] = []
_timers: list[Timer] = []
"""One of each at most; only ``_thread`` changes them."""


def do_items(
    step: BatchStep, key: str, items: Sequence[BatchItem], folder: str, release: str
) -> list[Finished]:
    """Do items and return what came of each; a problem with one stands in its place. ``key`` is the step's fingerprint.

    Raises
    ------
    SuiteError
        The worker has another release, does not see the folder of the results, or cannot do the step at all.
    """
    return _thread.submit(_do_items, step, key, items, folder, release).result()


def _do_items(
    step: BatchStep, key: str, items: Sequence[BatchItem], folder: str, release: str
) -> list[Finished]:
    if release != __version__:
        raise SuiteError(
            f"The worker on {gethostname()} has BRDF Suite {__version__}, the batch is of {release}; install the same."
        )
    if not is_file(Path(folder) / JOURNAL):
        raise SuiteError(
            f"The worker on {gethostname()} does not see {folder}; results go to a folder that all workers share."
        )
    work = _opened(step, key)
    try:
        return [_finished(work, item, Path(folder)) for item in items]
    finally:
        _close_when_idle()


def _opened(step: BatchStep, key: str) -> Work:
    if _open and _open[0].step != key:
        _close()
    if not _open:
        stack = ExitStack()
        _open.append(_Open(key, stack.enter_context(step.open()), stack))
    _open[0].used = monotonic()
    return _open[0].work


def _close() -> None:
    if _open:
        _open.pop().stack.close()


def _close_when_idle() -> None:
    """Close the step once a minute has passed without an item: the scene of a batch that has ended takes memory."""
    _open[0].used = monotonic()
    if not _timers:  # one for all items: each is a thread, and items may take a millisecond
        _look_after(IDLE_S)


def _look_after(seconds: float) -> None:
    timer = Timer(seconds, _thread.submit, [_close_if_idle])
    timer.daemon = True
    timer.start()
    _timers.append(timer)


def _close_if_idle() -> None:
    _timers.clear()
    if _open:
        left = _open[0].used + IDLE_S - monotonic()
        if left > 0.0:
            _look_after(left)
        else:
            _close()


def _finished(work: Work, item: BatchItem, folder: Path) -> Finished:
    try:
        done = work(item, folder)
    except SuiteError as error:
        return Finished.failed(item, str(error))
    except Exception as error:  # noqa: BLE001 - one bad item must not end a batch of a million
        return Finished.failed(item, f"{type(error).__name__}: {error}")
    notices = (*item.notices, *done.notices)
    return Finished(item.key, item.label, item.source, done.row, done.files, notices)

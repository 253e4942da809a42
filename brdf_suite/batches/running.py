"""Running a batch: items go to the workers in groups, and what comes back goes to the journal.

At the end the results are made. A batch that was stopped in any way goes on where it was: what the journal has is not
done again.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path
from time import monotonic

from brdf_suite.batches.items import BatchItem
from brdf_suite.batches.journal import Finished, Journal, journal_of
from brdf_suite.batches.results import write_results
from brdf_suite.batches.steps import BatchStep, fingerprint
from brdf_suite.batches.worker import do_items
from brdf_suite.batches.workers import BatchWorkers
from brdf_suite.errors import SuiteError, ValueRangeError
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.release import __version__

_AHEAD = 3
"""Groups for each worker that are handed out: enough that none waits, few enough for any scheduler."""
_GROUP_S = 2.0
MOST_IN_A_GROUP = 1024
_LOOK_S = 1.0
_LOST_S = 30.0
"""Time without an answer from the workers after which a batch ends."""


@dataclass(frozen=True)
class BatchResult:
    """What a batch has done: of ``items``, how many now and how many before; problems with the item's source.

    ``notices`` are of all items, each once; ``others`` counts items of other batches in this folder, whose table and
    page are replaced.
    """

    folder: Path
    step: str
    items: int
    done: int
    done_before: int
    problems: tuple[tuple[str, str], ...]
    seconds: float
    notices: tuple[str, ...] = ()
    others: int = 0


def run_batch(
    step: BatchStep,
    items: Sequence[BatchItem],
    folder: Path,
    hire: Callable[[], AbstractContextManager[BatchWorkers]],
    *,
    group: int | None = None,
    progress: Progress | None = None,
) -> BatchResult:
    """Do a step with every item that is not done yet, and write the results.

    Parameters
    ----------
    folder
        Where the results go; all workers must see it.
    hire
        What brings workers; called where there is something left to do.
    group
        Items that a worker takes at once; left out, as many as take about 2 s.
    progress
        Called with a share, 0 to 1, and a sentence with rate and time left; it may raise
        :class:`brdf_suite.errors.Cancelled`, after which the batch can go on.

    Raises
    ------
    FileError
        The folder cannot be written, or another batch runs in it.
    SuiteError
        The step cannot be done at all, or the workers are lost.
    """
    if group is not None and not 1 <= group <= MOST_IN_A_GROUP:
        raise ValueRangeError("group", f"expected 1 to {MOST_IN_A_GROUP:,}, not {group}")
    start = monotonic()
    folder = folder.absolute()
    key = fingerprint(step)
    with journal_of(folder, key) as journal:
        before = sum(item.key in journal.finished for item in items)
        left = [item for item in items if item.key not in journal.finished]
        # The workers look for the journal; of what cannot be loaded it says so at once.
        journal.append([Finished.failed(item, item.fault) for item in left if item.fault])
        left = [item for item in left if not item.fault]
        if left:
            step.prepare(subrange(progress, 0.0, 0.05))
            report(progress, 0.05, "starting the workers")
            with hire() as workers:
                _Run(step, key, folder, workers, journal, group, subrange(progress, 0.05, 0.98)).do(left)
        report(progress, 0.98, "writing the results")
        seconds = monotonic() - start
        write_results(folder, step.name, items, journal.finished, seconds)
        report(progress, 1.0, "written")
        done = [(item, journal.finished[item.key]) for item in items]
        problems = tuple((item.source, one.problem) for item, one in done if one.problem)
        # How often an item is there is a matter of this run's sources, and not of the journal.
        repeated = [
            f"{one.label} is there {one.times:,} times; it is done once" for one in items if one.times > 1
        ]
        notices = tuple(dict.fromkeys([*repeated, *(text for _, one in done for text in one.notices)]))
        others = len(journal.others)
    return BatchResult(
        folder, step.name, len(items), len(items) - before, before, problems, seconds, notices, others
    )


class _Run:
    """The groups that are waiting, and those that workers have."""

    def __init__(
        self,
        step: BatchStep,
        key: str,
        folder: Path,
        workers: BatchWorkers,
        journal: Journal,
        group: int | None,
        progress: Progress | None,
    ) -> None:
        self._step = step
        self._key = key
        self._folder = folder
        self._workers = workers
        self._journal = journal
        self._group = group
        self._progress = progress
        self._waiting: deque[BatchItem] = deque()
        self._suspects: deque[list[BatchItem]] = deque()
        """Groups whose workers died."""
        self._out: dict[Future[list[Finished]], list[BatchItem]] = {}
        self._start = monotonic()
        self._unreached_since = self._idle_since = math.inf
        """When the workers last began not to answer, and none to be there; infinity while they are."""
        self._looked = -math.inf
        self._width = 1

    def do(self, items: Sequence[BatchItem]) -> None:
        """Do all items; see :func:`run_batch`."""
        self._waiting.extend(items)
        count = done = problems = 0
        self._start, count = monotonic(), len(items)
        try:
            while self._waiting or self._suspects or self._out:
                self._check_workers()
                self._hand_out(done)
                ended, _ = wait(self._out, timeout=_LOOK_S, return_when=FIRST_COMPLETED)
                alone = len(self._out) == 1
                back = [one for future in ended for one in self._collected(future, alone)]
                if back:
                    self._journal.append(back)
                    done += len(back)
                    problems += sum(bool(one.problem) for one in back)
                report(self._progress, done / count, self._words(done, count, problems))
        finally:
            for future in self._out:
                future.cancel()

    def _check_workers(self) -> None:
        """Have lost workers replaced; raise :class:`SuiteError` where none answers or is there for long."""
        now = monotonic()
        if now - self._looked < _LOOK_S:
            return
        self._looked = now
        if self._workers.reached():
            self._unreached_since = math.inf
            self._workers.replace_lost()
            self._width = self._workers.width()
            self._idle_since = math.inf if self._width else min(self._idle_since, now)
        else:
            self._unreached_since = min(self._unreached_since, now)
        if now - self._unreached_since > _LOST_S:
            raise self._lost()
        if now - self._idle_since > self._workers.patience_s:
            raise self._lost(f"No worker was there for {self._workers.patience_s:g} s")

    def _hand_out(self, done: int) -> None:
        if self._suspects:
            # Alone, so that no other group is blamed for the end of its worker.
            if not self._out:
                self._submit(self._suspects.popleft())
            return
        width = max(1, self._width)
        size = self._group or self._size(done, width)
        while len(self._out) < _AHEAD * width and self._waiting:
            self._submit([self._waiting.popleft() for _ in range(min(size, len(self._waiting)))])

    def _submit(self, group: list[BatchItem]) -> None:
        try:
            future = self._workers.executor.submit(
                do_items, self._step, self._key, group, str(self._folder), __version__
            )
        except RuntimeError as error:  # the executor is shut down or broken
            raise self._lost() from error
        self._out[future] = group

    def _size(self, done: int, width: int) -> int:
        """Return how many items take a worker about two seconds, by those that are done; at first a few."""
        if done == 0:
            return 1
        each = (monotonic() - self._start) * width / done
        return max(1, min(MOST_IN_A_GROUP, round(_GROUP_S / max(each, 1e-6))))

    def _collected(self, future: Future[list[Finished]], alone: bool) -> list[Finished]:
        """Return what a group came to. One whose workers died is divided, until the item that did it is alone."""
        group = self._out.pop(future)
        try:
            return future.result()
        except CancelledError as error:
            raise self._lost() from error
        except SuiteError:
            raise
        except Exception as error:  # noqa: BLE001 - of the executor: its worker died, again and again
            if len(group) > 1 or not alone:
                middle = (len(group) + 1) // 2
                self._suspects.extend(half for half in (group[:middle], group[middle:]) if half)
                return []
            name = type(error).__name__
            reason = f"the process that worked on it ended, or took more memory than it may ({name})"
            return [Finished.failed(group[0], reason)]

    def _lost(self, why: str = "The workers are lost") -> SuiteError:
        return SuiteError(f"{why}; what they finished is kept, and the same batch goes on where it was.")

    def _words(self, done: int, count: int, problems: int) -> str:
        rate = done / max(monotonic() - self._start, 1e-6)
        words = f"{self._step.name}: {done:,} of {count:,}"
        if self._idle_since < math.inf:
            words += ", waiting for a worker"
        elif done:
            words += f", {rate:.3g} a second, {_duration((count - done) / rate)} left"
        return words + (f", {problems:,} with a problem" if problems else "")


def _duration(seconds: float) -> str:
    """Return a time in the largest unit that fits.

    >>> _duration(12.3), _duration(600.0), _duration(9000.0)
    ('12 s', '10 min', '2.5 h')
    """
    if seconds < 100.0:
        return f"{seconds:.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 6000.0 else f"{seconds / 3600.0:.1f} h"

"""Parallel optimizations from several starts, in processes; the results depend on the starts alone."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from functools import partial
from multiprocessing.synchronize import Event

from brdf_suite.errors import Cancelled, FittingError
from brdf_suite.fitting.basis_search.database import Database
from brdf_suite.fitting.basis_search.error import BasisError
from brdf_suite.fitting.basis_search.optimize import Optimum, optimize
from brdf_suite.processes import safe_path_inherited

Exponents = tuple[float, ...]
#: How often the caller hears of the work, seconds: it may want to cancel.
POLL_S = 0.2

# State of a worker process from its start: the errors, and the event that stops it.
_errors: BasisError | None = None
_stop: Event | None = None


def usable_cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class Workers:
    """``count`` processes that each hold the database; the caller's own process where it is 1."""

    def __init__(self, database: Database, count: int) -> None:
        self.count = count
        self._own = BasisError(database) if count == 1 else None
        self._pool: ProcessPoolExecutor | None = None
        if count > 1:
            # A fresh interpreter: a fork would copy threads' locks in any state.
            context = multiprocessing.get_context("spawn")
            with safe_path_inherited():  # the event starts a process that keeps track of it
                self._event = context.Event()
            self._pool = ProcessPoolExecutor(
                count, mp_context=context, initializer=_start, initargs=(database, self._event)
            )

    def run(self, starts: Sequence[Exponents], report: Callable[[int], None]) -> list[Optimum]:
        """Return the optimum of each start, in their order.

        ``report`` is called with the number of starts that are done, at least every fifth of a second where there
        are processes, else after each evaluation; it cancels by raising, and nothing then runs on.

        Raises
        ------
        FittingError
            A worker process ended before its work was done.
        """
        if self._pool is None:
            assert self._own is not None
            optima = []
            for done, start in enumerate(starts):
                optima.append(optimize(self._own, start, partial(report, done)))
            return optima
        futures: list[Future[Optimum]] = []
        try:
            # The first tasks start the processes, which inherit both.
            with _interrupt_held(), safe_path_inherited():
                futures = [self._pool.submit(_work, start) for start in starts]
            left = set(futures)
            while left:
                report(len(futures) - len(left))
                left -= wait(left, POLL_S, FIRST_COMPLETED).done
            return [future.result() for future in futures]
        except BrokenProcessPool as error:
            raise FittingError(
                "A worker process of the search ended before its work was done (short of memory?). What is found is "
                "kept: run the command again."
            ) from error

    def close(self) -> None:
        """Stop what runs, within an evaluation, and end the processes."""
        if self._pool is not None:
            self._event.set()
            self._pool.shutdown(wait=True, cancel_futures=True)
            self._pool = None


def _start(database: Database, stop: Event) -> None:
    global _errors, _stop
    _errors, _stop = BasisError(database), stop
    threading.Thread(target=_leave_with_parent, daemon=True).start()


def _leave_with_parent() -> None:
    """End this process when its parent is gone: a killed parent sends no notice."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _work(start: Exponents) -> Optimum:
    assert _errors is not None
    return optimize(_errors, start, _check)


def _check() -> None:
    if _stop is not None and _stop.is_set():
        raise Cancelled


@contextmanager
def _interrupt_held() -> Iterator[None]:
    """Hold Ctrl-C back from the processes that are started meanwhile: it is the parent's to answer."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    held = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, held)

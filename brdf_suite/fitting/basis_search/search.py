"""Basis search: lobes added one at a time, each count from several starts (Westlund and Meyer, section 3.2)."""

from __future__ import annotations

import itertools
import multiprocessing
import os
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from functools import partial
from multiprocessing.synchronize import Event

import numpy as np

from brdf_suite.errors import Cancelled, FittingError
from brdf_suite.fitting.basis_search.database import Database
from brdf_suite.fitting.basis_search.error import BasisError, equation_4
from brdf_suite.fitting.basis_search.optimize import LARGEST_EXPONENT, LOG_ENDS, Optimum, optimize
from brdf_suite.fitting.lobes.basis import MOST_LOBES
from brdf_suite.processes import interrupts_held_back, safe_path_inherited
from brdf_suite.progress import Progress, report

Exponents = tuple[float, ...]
#: How often the caller hears of the work, seconds: it may want to cancel.
POLL_S = 0.2

# State of a worker process from its start: the errors, and the event that stops it.
_errors: BasisError | None = None
_stop: Event | None = None
#: Answers of the last count from which a lobe is added, and the places in a gap where it is tried.
PARENTS = 2
PLACES = (0.25, 0.5, 0.75)
#: First exponents of the log-spaced starts; they end at the largest.
LOG_SPACED_FROM = (1.0, 3.0)
#: Starts of one lobe, before the best are chosen.
SINGLE_STARTS = 24


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
            with safe_path_inherited(), interrupts_held_back():
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


@dataclass(frozen=True)
class CountResult:
    """The best basis of one count: errors per paint ``(paints,)``, of base and of coat, and what it took.

    ``others`` are the optima of the other starts, best first: the next count may grow from them too.
    """

    exponents: Exponents
    errors: tuple[float, ...]
    base_errors: tuple[float, ...]
    coat_errors: tuple[float, ...]
    evaluations: int
    seconds: float
    others: tuple[tuple[Exponents, float], ...]

    @property
    def count(self) -> int:
        """Number of lobes."""
        return len(self.exponents)

    @property
    def value(self) -> float:
        """Equation 4: maximum plus mean error."""
        return equation_4(np.array(self.errors))


def search(
    database: Database,
    largest: int,
    *,
    starts: int,
    workers: int,
    done: Sequence[CountResult] = (),
    progress: Progress | None = None,
    found: Callable[[CountResult], None] | None = None,
) -> list[CountResult]:
    """Return the best basis of each count from 1 to ``largest``; the same whatever ``workers`` is.

    Parameters
    ----------
    database
        The paints; at least as many as lobes.
    starts
        Starts for each count, at least 2.
    workers
        Processes to work in.
    done
        Results of an earlier run for the first counts, from which it goes on.
    found
        Called with each new result, so that it can be kept.

    Raises
    ------
    FittingError
        Counts or starts out of range, too few paints, or a worker that ended early.
    Cancelled
        The progress callback asked for it.
    """
    if not 1 <= largest <= MOST_LOBES:
        raise FittingError(f"The search takes from 1 to {MOST_LOBES} lobes, not {largest}.")
    if starts < 2 or workers < 1:
        raise FittingError(f"The search needs at least 2 starts and 1 worker, not {starts} and {workers}.")
    if len(database.paints) < largest:
        held = f"The database holds {len(database.paints)} paints"
        raise FittingError(f"{held}; for {largest} lobes it needs as many or more.")
    results = list(done[:largest])
    if len(results) == largest:
        return results
    errors = BasisError(database)
    whole = sum(count**2 for count in range(1, largest + 1))
    team = Workers(database, workers)
    try:
        for count in range(len(results) + 1, largest + 1):
            begun = time.perf_counter()
            before = sum(k**2 for k in range(1, count))
            what = f"{count} lobe{'s' if count > 1 else ''}"
            report(progress, before / whole, what)
            chosen = _starts(errors, results[-1] if results else None, count, starts)

            def report_finished(
                finished: int, before: int = before, count: int = count, what: str = what
            ) -> None:
                report(progress, (before + count**2 * finished / starts) / whole, what)

            optima = team.run(chosen, report_finished)
            result = _result(errors, optima, time.perf_counter() - begun)
            results.append(result)
            if found is not None:
                found(result)
    finally:
        team.close()
    report(progress, 1.0, "done")
    return results


def _starts(errors: BasisError, last: CountResult | None, count: int, starts: int) -> list[Exponents]:
    """Return the starts of a count: a lobe more in the last answers where it helps most, and log-spaced sets."""
    if last is None:
        candidates: list[Exponents] = [(float(e),) for e in np.exp(np.linspace(*LOG_ENDS, SINGLE_STARTS))]
        spaced: list[Exponents] = []
    else:
        parents = [last.exponents, *(exponents for exponents, _ in last.others[: PARENTS - 1])]
        candidates = [grown for parent in parents for grown in _grown(parent)]
        spaced = [tuple(np.geomspace(low, LARGEST_EXPONENT, count).tolist()) for low in LOG_SPACED_FROM]
        spaced = spaced[: starts - 1]
    values = [equation_4(errors(candidate)) for candidate in candidates]
    best = sorted(range(len(candidates)), key=lambda k: (values[k], k))[: starts - len(spaced)]
    return [candidates[k] for k in best] + spaced


def _grown(parent: Exponents) -> list[Exponents]:
    """Return ``parent`` with one lobe more, in each gap between its lobes and their ends."""
    logs = [LOG_ENDS[0], *np.log(parent).tolist(), LOG_ENDS[1]]
    gaps = [(low, high - low) for low, high in itertools.pairwise(logs) if high - low > 0.05]
    added = [float(np.exp(low + place * wide)) for low, wide in gaps for place in PLACES]
    return [tuple(sorted((*parent, value))) for value in added]


def _result(errors: BasisError, optima: Sequence[Optimum], seconds: float) -> CountResult:
    order = sorted(range(len(optima)), key=lambda k: (optima[k].value, k))
    best = optima[order[0]]
    base, coat = errors.layers(best.exponents)
    return CountResult(
        best.exponents,
        tuple(errors(best.exponents).tolist()),
        tuple(base.tolist()),
        tuple(coat.tolist()),
        sum(optimum.evaluations for optimum in optima),
        seconds,
        tuple((optima[k].exponents, optima[k].value) for k in order[1:]),
    )

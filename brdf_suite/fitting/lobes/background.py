"""Background thread that completes a fit after the time limit, in slices, at lower priority.

The model belongs to the holder of the lock: the caller inside its limit, or this thread for one slice. Between
slices a request that was cancelled is dropped, so that the newest edit gets the model soon. The slices are
tasks of an executor of one thread, each of which asks for the next: an executor that is shut down, or an
interpreter that ends, refuses the next one, and the thread ends after at most one slice, or one channel that is solved
afresh.

A caller may wait for the rest of its limit. It gets the optimum before anything is made of it; what is made of an
optimum is for those who come later, and not made where the caller was in time.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.answers import LimitedSolution, NormalizedTargets, optimal_answer
from brdf_suite.fitting.lobes.highs_model import BlockSolution, BlockSolver, SolverOutcome
from brdf_suite.fitting.lobes.program import PartProgram

if TYPE_CHECKING:
    from concurrent.futures import Future

Solutions = tuple[Floats, ...]
Then = Callable[[LimitedSolution], Any]

#: Shortest slice, and its length per matrix entry: five times what the solver needs to start (15 ns an entry).
SHORTEST_SLICE_S = 0.001
SLICE_S_PER_ENTRY = 75e-9
#: How much lower than its program the thread's priority is (Unix niceness).
NICENESS = 5
#: A slice is so much longer than the one before, up to the longest. What a slice takes to start does not grow; on a
#: machine that other programs occupy too, a short slice ends before it has done anything else.
SLICE_GROWTH, LONGEST_SLICE_S = 1.5, 0.5
#: Times that the solver may give up and start from nothing. After them each channel of each part is solved for itself,
#: by a careful solver of its own, which is given so long.
MOST_TRIES = 2
AFRESH_S = 60.0


@dataclass(eq=False)
class Work:
    """A request in progress. ``waited``: its caller waits, and takes the optimum as it is; ``answer`` is then here."""

    request: NormalizedTargets
    then: Then
    future: Future[Any]
    waited: bool
    answer: tuple[LimitedSolution, Solutions] | None = None
    changed: threading.Condition = field(default_factory=threading.Condition)


class BackgroundSolver:
    """Background solver of one request at a time; ``last`` are the newest normalized solutions, for the next start."""

    def __init__(self, parts: Sequence[PartProgram], channels: int) -> None:
        # 3 ms, with logging, on the start-up path of programs that may not fit.
        from concurrent.futures import Future, ThreadPoolExecutor

        self.solver = BlockSolver(parts, channels)
        self.last: Solutions = tuple(np.zeros((p.shape[1], channels)) for p in parts)
        self.lock = threading.Lock()
        self._parts = tuple(parts)
        self._slice_s = max(SHORTEST_SLICE_S, SLICE_S_PER_ENTRY * self.solver.entry_count)
        self._new_future: Callable[[], Future[Any]] = Future
        self._loaded: NormalizedTargets | None = None
        self._iterations = 0
        self._tries = 0
        self._next_slice_s = self._slice_s
        self._newest: Future[Any] | None = None
        self._thread_id: int | None = None
        self._executor = ThreadPoolExecutor(1, "brdf-fit", initializer=self._begin)

    def warm(self) -> None:
        """Start the thread now rather than at the first request."""
        self._executor.submit(int).result()

    def supersede(self) -> None:
        """Drop the request in work; its future is cancelled."""
        if self._newest is not None:
            self._newest.cancel()
            self._newest = None

    def start(self, request: NormalizedTargets, then: Then, *, waited: bool = False) -> Work:
        """Begin ``request``; its future gets ``then(answer)``, computed on this thread.

        With ``waited``, :meth:`wait` is to follow, and the future gets nothing where that was in time.
        """
        self.supersede()
        work = Work(request, then, self._new_future(), waited)
        self._newest = work.future
        self._next(work)
        return work

    def wait(self, work: Work, seconds: float) -> tuple[LimitedSolution, Solutions] | None:
        """Return the optimum and its solutions of size 1; None where it is late, lost or no longer wanted."""
        with work.changed:
            work.changed.wait_for(lambda: not work.waited, timeout=seconds)
            work.waited = False
            return work.answer

    def close(self, *, wait: bool = True) -> None:
        """Drop what is in work and end the thread, at the latest after its slice."""
        self.supersede()
        self._executor.shutdown(wait=wait and threading.get_ident() != self._thread_id)

    def _begin(self) -> None:
        self._thread_id = threading.get_ident()
        if sys.platform == "linux":
            # Linux alone gives each thread a priority of its own under this call; elsewhere it is the process's.
            # A sandbox may forbid it; the thread then runs as the program does.
            with suppress(OSError):
                os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), min(os.nice(0) + NICENESS, 19))

    def _next(self, work: Work) -> None:
        try:
            self._executor.submit(self._slice, work)
        except RuntimeError:  # shut down, or the interpreter ends: no caller waits for the rest
            self._drop(work)

    def _drop(self, work: Work) -> None:
        """End ``work`` without a result and notify waiting callers: a cancelled future does not by itself."""
        work.future.cancel()
        work.future.set_running_or_notify_cancel()
        self._let_go(work, None)

    @staticmethod
    def _let_go(work: Work, answer: tuple[LimitedSolution, Solutions] | None) -> bool:
        """Return whether a caller waited, who now goes on with ``answer``."""
        with work.changed:
            waited, work.waited = work.waited, False
            if waited:
                work.answer = answer
                work.changed.notify_all()
            return waited

    def _slice(self, work: Work) -> None:
        future = work.future
        try:
            answer = self.advance(work)
            if answer is None:
                if future.cancelled():
                    self._drop(work)
                else:
                    self._next(work)
                return
            if self._let_go(work, answer):
                self._drop(work)
                return
            value = work.then(answer[0])
        except Exception as error:  # noqa: BLE001 - carried to the waiting caller; a future left alone hangs
            if future.set_running_or_notify_cancel():
                future.set_exception(error)
            self._let_go(work, None)
            return
        if future.set_running_or_notify_cancel():
            self.last = answer[1]
            future.set_result(value)

    def advance(self, work: Work) -> tuple[LimitedSolution, Solutions] | None:
        """Solve for one slice, or afresh where the model is lost; None: still to come, or no longer requested."""
        request = work.request
        with self.lock:
            if work.future.cancelled():
                return None
            if request is not self._loaded:
                self.solver.load(request.targets, request.factors)
                self._loaded, self._iterations, self._tries = request, 0, 0
                self._next_slice_s = self._slice_s
            outcome = self.solver.run(self._next_slice_s)
            self._iterations += self.solver.iterations
            self._next_slice_s = max(self._slice_s, min(SLICE_GROWTH * self._next_slice_s, LONGEST_SLICE_S))
            if outcome is SolverOutcome.OPTIMAL:
                self._loaded = None
                held = self.solver.solution()
                return optimal_answer(self._parts, held, request, self._iterations)
            if outcome is SolverOutcome.LOST:
                self.solver.forget()
                self._tries += 1
            if self._tries < MOST_TRIES:
                return None
            self._loaded = None
        afresh = self._solve_afresh(work)
        return None if afresh is None else optimal_answer(self._parts, afresh, request, self._iterations)

    def _solve_afresh(self, work: Work) -> BlockSolution | None:
        """Solve what the kept model cannot, by others that know nothing of it; None where it is no longer wanted."""
        request, solutions, duals = work.request, [], []
        for k, part in enumerate(self._parts):
            factors, found = request.factors_of(k), []
            for channel in range(request.targets[k].shape[1]):
                if work.future.cancelled():
                    return None
                one = slice(channel, channel + 1)
                solver = BlockSolver([part], 1, careful=True)
                solver.load([request.targets[k][:, one]], None if factors is None else [factors[:, one]])
                if solver.run(AFRESH_S) is not SolverOutcome.OPTIMAL:
                    raise FittingError("The linear-programming solver found no optimum for these samples.")
                self._iterations += solver.iterations
                found.append(solver.solution())
            solutions.append(np.concatenate([held.solutions[0] for held in found], axis=1))
            duals.append(np.concatenate([held.duals[0] for held in found], axis=1))
        return BlockSolution(tuple(solutions), tuple(duals))


First = TypeVar("First")
Second = TypeVar("Second")


def chain_futures(
    first: Future[First], begin: Callable[[First, Future[Second]], Future[Second] | None]
) -> Future[Second]:
    """Return a future of what ``begin`` begins with the result of ``first``.

    ``begin`` is called on the thread that ends ``first``, and is given the whole's future too: it returns None where
    that was cancelled meanwhile. Cancelling the whole cancels what is in work of it; where one of the two is
    cancelled or fails, so does the whole.
    """
    from concurrent.futures import Future, InvalidStateError

    whole: Future[Second] = Future()

    def settle(value: Second | None = None, error: BaseException | None = None) -> None:
        """Give the whole a value or an error, unless it was cancelled meanwhile."""
        with suppress(InvalidStateError):
            if error is not None:
                whole.set_exception(error)
            else:
                whole.set_result(value)  # type: ignore[arg-type]  # None may be what Second is

    def stop(_: Future[Second]) -> None:
        if whole.cancelled():
            whole.set_running_or_notify_cancel()  # or concurrent.futures.wait would go on waiting
            first.cancel()

    def go_on(done: Future[First]) -> None:
        if done.cancelled():
            whole.cancel()
            return
        try:
            second = begin(done.result(), whole)
        except Exception as error:  # noqa: BLE001 - carried to the waiting caller; a future left alone hangs
            settle(error=error)
            return
        if second is None:
            return
        whole.add_done_callback(lambda _: second.cancel() if whole.cancelled() else None)
        second.add_done_callback(finish)

    def finish(done: Future[Second]) -> None:
        if done.cancelled():
            whole.cancel()
        elif (error := done.exception()) is not None:
            settle(error=error)
        else:
            settle(done.result())

    whole.add_done_callback(stop)
    first.add_done_callback(go_on)
    return whole

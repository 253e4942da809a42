"""Linear programs under a hard time limit, with the optimum delivered later.

HiGHS alone overruns a limit of its own by milliseconds, because it looks at the clock between pieces of work
that grow with the program. Two ways keep it, by the size of the program (docs/method/fit.md has the measurements):

- A small program is solved by the caller, in runs of so many iterations as half of what is left allows at the
  pace seen last. Handing it to a thread and back costs more than the fit. Where two targets had their optimum at
  one vertex, that vertex is kept and tried before the solver (:mod:`.exact_vertex`).
- A large one is given to a thread of lower priority, after the caller has computed feasible answers: at once,
  the two would wait for the interpreter's lock in turns. The caller waits for the rest of the limit, and leaves
  with the best that it has.

Where the limit comes first, the least L1 error per channel wins among what the simplex held, the last weights
rescaled, non-negative least squares, and zero; the thread goes on to the optimum and delivers it.
"""

from __future__ import annotations

import time
import weakref
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.answers import (
    LimitedSolution,
    NormalizedTargets,
    normalize_targets,
    optimal_answer,
    optimum,
    rescale_solutions,
)
from brdf_suite.fitting.lobes.background import MOST_TRIES, BackgroundSolver
from brdf_suite.fitting.lobes.exact_vertex import KeptVertex, kept_vertex
from brdf_suite.fitting.lobes.fallback import FallbackSolver
from brdf_suite.fitting.lobes.highs_model import SolverOutcome
from brdf_suite.fitting.lobes.program import PartProgram

if TYPE_CHECKING:
    from concurrent.futures import Future  # see answers.py

__all__ = ["LimitedSolution", "LimitedSolver"]


#: Programs of at most so many matrix entries are solved by the caller: their solver starts in under .7 ms.
LARGEST_INLINE_ENTRIES = 50_000
#: Share of a limit that is kept from the solver for the feasible answers, and the least and the most of it.
RESERVE_SHARE = 0.15
LEAST_RESERVE_S = 0.0006
#: What giving a request to the thread takes.
HAND_OVER_S = 0.0001
#: A wait shorter than this brings no answer, but may end late: the thread has the interpreter's lock meanwhile.
SHORTEST_WAIT_S = 0.0003
#: No run is begun with less time than this.
SHORTEST_RUN_S = 0.0001
#: No run is longer where the caller watches.
WATCHED_RUN_S = 0.1
#: Iterations of a run, at least; and what one is first thought to take, per matrix entry.
FEWEST_ITERATIONS = 10
FIRST_PACE_S_PER_ENTRY = 4e-9


def _same(answer: LimitedSolution) -> LimitedSolution:
    return answer


class LimitedSolver:
    """A persistent model over ``parts`` × ``channels`` that answers within a limit and finishes in the background.

    Any sequence of :class:`PartProgram` will do; each is solved for every channel, all in one block-diagonal
    model. ``inline`` forces the caller's way (True) or the thread's (False); by size where left out. ``fallbacks``,
    one per part, are those of another solver of the same parts, which saves making them again.

    ``background`` finishes what the limit cut short, on its thread; ``model`` is the solver of HiGHS that both use,
    under the background's lock; ``vertex`` is that of the last optimum, and ``pace_s`` what an iteration was last seen
    to take, seconds.

    One solver serves one thread. :meth:`close` ends its background thread, as does losing the last reference.
    """

    def __init__(
        self,
        parts: Sequence[PartProgram],
        channels: int = 3,
        *,
        inline: bool | None = None,
        fallbacks: Sequence[FallbackSolver] | None = None,
    ) -> None:
        self.parts = tuple(parts)
        self.channels = channels
        self.background = BackgroundSolver(self.parts, channels)
        self.model = self.background.solver
        if fallbacks is None:
            # Parts that are the same one, as for several groups of channels, share theirs.
            different = {part: FallbackSolver(part) for part in dict.fromkeys(self.parts)}
            fallbacks = [different[part] for part in self.parts]
        self.fallbacks = tuple(fallbacks)
        self.inline = self.model.entry_count <= LARGEST_INLINE_ENTRIES if inline is None else inline
        self.vertex: KeptVertex | None = None
        self.pace_s = FIRST_PACE_S_PER_ENTRY * self.model.entry_count
        weakref.finalize(self, BackgroundSolver.close, self.background, wait=False)
        if not self.inline:
            self.background.warm()

    def solve(
        self,
        targets: Sequence[Floats],
        deadline: float,
        *,
        factors: Sequence[Floats] | None = None,
        finish: bool = True,
        then: Callable[[LimitedSolution], Any] = _same,
        watch: Callable[[], None] | None = None,
    ) -> LimitedSolution:
        """Return the best weights for ``targets`` that are available at ``deadline``.

        Parameters
        ----------
        targets
            Per part ``(n, channels)``: the target times the rows' weights. Any size and sign.
        deadline
            A time of ``time.perf_counter()``.
        factors
            Per part ``(n, channels)`` > 0: multiply the weights of single samples for this target alone.
        finish
            Whether the optimum is wanted after the limit. It is then the result of ``exact``, unless the next
            call of this method comes first and cancels it.
        then
            What becomes of the optimum before it is delivered; called on the background thread.
        watch
            Called between the runs of the caller's way, each then of a tenth of a second at most; to cancel, it raises
            what is to leave this method.

        Raises
        ------
        FittingError
            See :func:`~brdf_suite.fitting.lobes.answers.normalize_targets`.
        """
        self.background.supersede()
        request = normalize_targets(self.parts, self.channels, targets, factors)
        if self.inline:
            return self._solve_here(request, deadline, finish, then, watch)
        answer = self._feasible(request, deadline - HAND_OVER_S, None, 0)
        waited = deadline - time.perf_counter() > SHORTEST_WAIT_S
        work = self.background.start(request, then, waited=waited)
        finished = self.background.wait(work, deadline - time.perf_counter()) if waited else None
        if finished is not None:
            answer, self.background.last = finished
            return answer
        if not finish:
            work.future.cancel()
            return answer
        return replace(answer, exact=work.future)

    def begin(
        self,
        targets: Sequence[Floats],
        *,
        factors: Sequence[Floats] | None = None,
        then: Callable[[LimitedSolution], Any] = _same,
    ) -> Future[Any]:
        """Begin to look for the optimum, in slices on the solver's thread; the future gets ``then`` of it.

        For work that no caller waits for. The next call of this method or of :meth:`solve`, and :meth:`close`, cancel
        the future. Arguments and errors as :meth:`solve`.
        """
        request = normalize_targets(self.parts, self.channels, targets, factors)
        return self.background.start(request, then).future

    def close(self) -> None:
        """Drop what is in work and wait for the thread to end: at most one slice of the solver."""
        self.background.close()

    def _solve_here(
        self,
        request: NormalizedTargets,
        deadline: float,
        finish: bool,
        then: Callable[[LimitedSolution], Any],
        watch: Callable[[], None] | None,
    ) -> LimitedSolution:
        if self.vertex is not None and request.factors is None:
            found = self.vertex.answer(request.targets)
            if found is not None:
                answer, self.background.last = optimum(request, *found, 0)
                return answer
            self.vertex = None
        start = time.perf_counter()
        budget = deadline - start
        until = deadline - min(max(RESERVE_SHARE * budget, LEAST_RESERVE_S), 0.5 * budget)
        partial, iterations = None, 0
        # The thread may be in a slice of the request before; it lets go after it.
        if until - start > SHORTEST_RUN_S and self.background.lock.acquire(timeout=until - start):
            try:
                self.model.load(request.targets, request.factors)
                outcome, iterations = self._run_until(until, watch)
                if outcome in (SolverOutcome.OPTIMAL, SolverOutcome.STOPPED):
                    held = self.model.solution()
                    if outcome is SolverOutcome.OPTIMAL:
                        answer, self.background.last = optimal_answer(self.parts, held, request, iterations)
                        if iterations == 0 and request.factors is None:
                            self.vertex = kept_vertex(self.parts, held)
                        return answer
                    partial = held.solutions
            finally:
                self.background.lock.release()
        answer = self._feasible(request, deadline, partial, iterations)
        return replace(answer, exact=self.background.start(request, then).future) if finish else answer

    def _run_until(
        self, until: float, watch: Callable[[], None] | None = None
    ) -> tuple[SolverOutcome | None, int]:
        """Run in pieces until the optimum, the time, or a solver that is lost again and again.

        None where there was no time for any.
        """
        outcome, iterations, tries = None, 0, 0
        while (left := until - time.perf_counter()) > SHORTEST_RUN_S:
            if watch is not None:
                watch()
                left = min(left, WATCHED_RUN_S)
            begun = time.perf_counter()
            outcome = self.model.run(left, max(FEWEST_ITERATIONS, int(0.5 * left / self.pace_s)))
            done = self.model.iterations
            iterations += done
            if done >= FEWEST_ITERATIONS:
                pace = (time.perf_counter() - begun) / done
                # Slower is believed at once, faster little by little.
                self.pace_s = max(pace, 0.9 * self.pace_s + 0.1 * pace)
            if outcome is SolverOutcome.OPTIMAL:
                break
            if outcome is SolverOutcome.LOST:
                self.model.forget()
                tries += 1
                if tries >= MOST_TRIES:
                    break
        return outcome, iterations

    def _feasible(
        self,
        request: NormalizedTargets,
        deadline: float,
        partial: Sequence[Floats] | None,
        iterations: int,
    ) -> LimitedSolution:
        """Return the best of the answers that need no optimum, in what is left until ``deadline``."""
        solutions, errors, methods = [], [], []
        for k, part in enumerate(self.parts):
            begun = time.perf_counter()
            target, factors = request.targets[k], request.factors_of(k)
            last, last_error = self.fallbacks[k].rescaled(self.background.last[k], target, factors)
            now = time.perf_counter()
            # What rescaling took, cold, is kept for comparing; the parts to come get their share.
            stop = now + (deadline - now) / (len(self.parts) - k) - 0.8 * (now - begun)
            squares = self.fallbacks[k].least_squares(target, deadline=stop)
            whole = np.abs(target) if factors is None else factors * np.abs(target)
            candidates = {
                "rescaled": (last, last_error),
                # Its factor is best for squares; clamped after few steps, it may be far from best.
                "least squares": self.fallbacks[k].rescaled(squares, target, factors),
                "zero": (np.zeros_like(last), whole.sum(axis=0)),
            }
            if partial is not None:
                candidates["simplex"] = (partial[k], part.residual_l1(partial[k], target, factors))
            names = list(candidates)
            table = np.stack([candidates[name][1] for name in names])
            winner = np.argmin(table, axis=0)
            channels = np.arange(target.shape[1])
            stack = np.stack([candidates[name][0] for name in names])
            solutions.append(stack[winner, :, channels].T)
            errors.append(table[winner, channels])
            methods.append(tuple(names[w] for w in winner))
        self.background.last = tuple(solutions)
        return rescale_solutions(request, solutions, errors, tuple(methods), False, iterations)

"""The limit by a clock of the test's own: what the solver, the lock and the wait are given, and when they begin."""

from __future__ import annotations

import types
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

from brdf_suite.fitting.lobes import fallback, time_limit
from brdf_suite.fitting.lobes.highs_model import BlockSolution, BlockSolver, SolverOutcome
from brdf_suite.fitting.lobes.program import PartProgram, build_program
from brdf_suite.fitting.lobes.time_limit import LimitedSolver

PATIENCE_S = 250.0
START_S = 100.0


def program(rows: int = 20, columns: int = 6, seed: int = 1) -> PartProgram:
    rng = np.random.default_rng(seed)
    return build_program(rng.uniform(0, 1, (rows, columns)) ** 4, np.ones(rows))


def target(seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).uniform(0, 1, (20, 3))


class Clock:
    """Time that passes only where the test says so."""

    def __init__(self) -> None:
        self.now = START_S

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    made = Clock()
    for module in (time_limit, fallback):
        monkeypatch.setattr(module, "time", types.SimpleNamespace(perf_counter=made))
    return made


class SteadySolver:
    """Takes ``step_s`` for each iteration, stops where it was reported, and never ends by itself."""

    def __init__(self, clock: Clock, real: BlockSolver, step_s: float) -> None:
        self.runs: list[tuple[float, float, int]] = []  # when, for how long, how many iterations at most
        self.iterations = 0
        self.outcome = SolverOutcome.STOPPED
        self.forgotten = 0
        self._clock, self._real, self._step_s = clock, real, step_s

    def load(self, *_: Any) -> None:
        pass

    def run(self, budget_s: float, iterations: int) -> SolverOutcome:
        assert len(self.runs) < 1000, "it runs on and on"
        self.runs.append((self._clock.now, budget_s, iterations))
        self.iterations = min(iterations, int(np.ceil(budget_s / self._step_s)))
        if self.outcome is SolverOutcome.LOST:  # which it is soon
            self.iterations = 1
        self._clock.now += self.iterations * self._step_s
        return self.outcome

    def forget(self) -> None:
        self.forgotten += 1

    def solution(self) -> BlockSolution:
        return self._real.solution()


MakeSteady = Callable[..., tuple[LimitedSolver, SteadySolver]]


@pytest.fixture
def make_steady(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> Iterator[MakeSteady]:
    made = []

    def make(step_s: float = 1e-5) -> tuple[LimitedSolver, SteadySolver]:
        solver = LimitedSolver([program()], inline=True)
        made.append(solver)
        steady = SteadySolver(clock, solver.model, step_s)
        monkeypatch.setattr(solver, "model", steady)
        return solver, steady

    yield make
    for solver in made:
        solver.close()


def test_no_run_is_begun_after_its_share_nor_allowed_to_last_longer(
    make_steady: MakeSteady, clock: Clock
) -> None:
    solver, steady = make_steady()
    solver.pace_s = 1e-5
    answer = solver.solve([target()], START_S + 0.004, finish=False)
    assert not answer.optimal
    assert len(steady.runs) > 1
    until = START_S + 0.004 - 0.0006  # the least that is kept for feasible answers
    for begun, budget, _ in steady.runs:
        assert begun < until
        assert begun + budget <= until + 1e-9
    longer, runs = make_steady()
    longer.solve([target()], clock.now + 1.0, finish=False)
    assert runs.runs[0][1] <= 0.85 + 1e-9
    assert runs.runs[0][1] > 0.8


@pytest.mark.parametrize("left", [-1.0, 0.0, 1e-6])
def test_where_no_time_is_left_no_run_is_begun(make_steady: MakeSteady, left: float) -> None:
    solver, steady = make_steady()
    solver.solve([target()], START_S + left, finish=False)
    assert steady.runs == []


def test_a_run_is_as_many_iterations_as_half_of_the_time_allows_at_the_pace_seen(
    make_steady: MakeSteady, clock: Clock
) -> None:
    solver, steady = make_steady(step_s=2e-5)
    solver.solve([target()], START_S + 0.02, finish=False)
    steady.runs.clear()
    solver.solve([target()], clock.now + 0.02, finish=False)
    (_, budget, iterations), (_, next_budget, next_iterations) = steady.runs[:2]
    assert iterations == pytest.approx(0.5 * budget / 2e-5, abs=1.0)
    assert next_iterations == pytest.approx(0.5 * next_budget / 2e-5, abs=1.0)


def test_a_solver_that_is_lost_twice_is_left(make_steady: MakeSteady) -> None:
    solver, steady = make_steady()
    steady.outcome = SolverOutcome.LOST
    steady.solution = lambda: pytest.fail("it holds nothing")  # type: ignore[method-assign]  # of this test
    answer = solver.solve([target()], START_S + 10.0, finish=False)
    assert len(steady.runs) == 2
    assert steady.forgotten == 2
    assert not answer.optimal
    assert "simplex" not in answer.methods[0]
    assert (answer.relative[0] < 1.0).all()


def test_the_lock_is_waited_for_no_longer_than_the_limit(
    make_steady: MakeSteady, monkeypatch: pytest.MonkeyPatch
) -> None:
    solver, steady = make_steady()
    asked: list[float] = []

    class HeldLock:
        def acquire(self, timeout: float = -1.0) -> bool:
            asked.append(timeout)
            return False

    monkeypatch.setattr(solver.background, "lock", HeldLock())
    answer = solver.solve([target()], START_S + 0.004, finish=False)
    assert len(asked) == 1
    assert 0.0 < asked[0] <= 0.004 - 0.0006 + 1e-9
    assert steady.runs == []
    assert not answer.optimal


def test_the_caller_waits_for_the_thread_no_longer_than_the_limit(
    clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    solver = LimitedSolver([program()], inline=False)
    waits: list[float] = []

    def late(_work: object, seconds: float) -> None:
        waits.append(seconds)

    monkeypatch.setattr(solver.background, "wait", late)
    for limit in (0.004, 1.0):
        solver.solve([target()], START_S + limit, finish=False)
        assert 0.9 * limit < waits[-1] <= limit + 1e-9
    solver.solve([target()], START_S + 0.0001, finish=False)
    assert len(waits) == 2  # too short to be worth it
    solver.close()


def test_what_the_simplex_held_wins_where_it_is_best(make_steady: MakeSteady, clock: Clock) -> None:
    solver, steady = make_steady()
    other = LimitedSolver([program()], inline=True)
    best = other.solve([target()], clock.now + PATIENCE_S)
    assert best.optimal
    sizes = target().sum(axis=0)
    held = BlockSolution((best.solutions[0] / sizes,), (np.zeros((20, 3)),))
    steady.solution = lambda: held  # type: ignore[method-assign]  # stopped just before it could know
    limited_answer = solver.solve([target()], clock.now + 0.004, finish=False)
    assert limited_answer.methods == (("simplex",) * 3,)
    np.testing.assert_allclose(limited_answer.objectives[0], best.objectives[0], rtol=1e-9)
    other.close()


def test_the_vertex_of_two_targets_answers_the_third_without_the_solver(
    clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> None:
    solver = LimitedSolver([program()], inline=True)
    first = solver.solve([target()], clock.now + PATIENCE_S)
    assert first.iterations > 0
    again = solver.solve([target()], clock.now + PATIENCE_S)
    assert again.iterations == 0
    monkeypatch.setattr(solver, "model", None)  # any use of it fails
    third = solver.solve([target() * (1.0 + 1e-9)], clock.now - 1.0)
    assert third.optimal
    np.testing.assert_allclose(third.objectives[0], first.objectives[0], rtol=1e-6)
    solver.close()


def test_the_next_target_cancels_the_one_in_work_even_where_nothing_is_begun_for_it(clock: Clock) -> None:
    solver = LimitedSolver([program()], inline=True)
    with solver.background.lock:  # the thread cannot come to its end meanwhile
        first = solver.solve([target()], clock.now - 1.0)
        assert first.exact is not None
        assert not first.exact.cancelled()
        solver.solve([target(1)], clock.now - 1.0, finish=False)
        assert first.exact.cancelled()
    solver.close()


def test_a_watcher_is_asked_between_short_runs_and_may_end_it(make_steady: MakeSteady, clock: Clock) -> None:
    solver, steady = make_steady()
    times: list[float] = []

    class EnoughError(Exception):
        pass

    def watch() -> None:
        times.append(clock.now)
        if len(times) == 4:
            raise EnoughError

    with pytest.raises(EnoughError):
        solver.solve([target()], START_S + 30.0, finish=False, watch=watch)
    assert len(steady.runs) == 3
    assert all(budget <= 0.1 for _, budget, _ in steady.runs)
    assert solver.background.lock.acquire(blocking=False)  # nothing is left locked
    solver.background.lock.release()

"""Waiting callers are notified of the optimum before anything is made of it, and of work that never ends."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from concurrent.futures import CancelledError, as_completed, wait

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.background import LONGEST_SLICE_S
from brdf_suite.fitting.lobes.highs_model import BlockSolver, SolverOutcome
from brdf_suite.fitting.lobes.program import PartProgram, build_program
from brdf_suite.fitting.lobes.time_limit import LimitedSolver

PATIENCE_S = 250.0


def program(seed: int = 1) -> PartProgram:
    rng = np.random.default_rng(seed)
    return build_program(rng.uniform(0, 1, (20, 6)) ** 4, np.ones(20))


def target(seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).uniform(0, 1, (20, 3))


@pytest.fixture(params=[True, False], ids=["inline", "thread"])
def solver(request: pytest.FixtureRequest) -> Iterator[LimitedSolver]:
    made = LimitedSolver([program()], inline=request.param)
    yield made
    made.close()


def past() -> float:
    return time.perf_counter() - 1.0


def test_waiting_for_a_request_that_was_dropped_ends(solver: LimitedSolver) -> None:
    with solver.background.lock:
        dropped = solver.solve([target()], past()).exact
        given_up = solver.solve([target(1)], past()).exact
        assert dropped is not None
        assert given_up is not None
        given_up.cancel()
    assert wait([dropped, given_up], timeout=PATIENCE_S).done == {dropped, given_up}
    assert set(as_completed([dropped, given_up], timeout=PATIENCE_S)) == {dropped, given_up}
    for future in (dropped, given_up):
        with pytest.raises(CancelledError):
            future.result(timeout=PATIENCE_S)


def test_waiting_for_a_request_of_a_closed_solver_ends(solver: LimitedSolver) -> None:
    with solver.background.lock:
        dropped = solver.solve([target()], past()).exact
        closing = threading.Thread(target=solver.close)
        closing.start()
    closing.join()
    refused = solver.solve([target()], past()).exact
    assert dropped is not None
    assert refused is not None
    assert wait([dropped, refused], timeout=PATIENCE_S).done == {dropped, refused}


def test_a_caller_in_time_has_its_optimum_before_anything_is_made_of_it() -> None:
    solver = LimitedSolver([program()], inline=False)
    made = []
    free = threading.Event()

    def then(answer: object) -> None:
        made.append(answer)
        free.wait(2.0 * PATIENCE_S)  # what is made of it takes longer than the caller's limit

    answer = solver.solve([target()], time.perf_counter() + PATIENCE_S, then=then)
    assert answer.optimal
    assert answer.exact is None
    free.set()
    solver.close()
    assert made == []  # the caller has it, so no other does


@pytest.mark.parametrize("relative", [False, True])
def test_what_the_kept_model_loses_is_solved_afresh(solver: LimitedSolver, relative: bool) -> None:
    factors = [1.0 + target(9)] if relative else None
    expected = solver.solve([target()], time.perf_counter() + PATIENCE_S, factors=factors)
    assert expected.optimal
    solver.vertex = None
    solver.model.run = lambda *_: SolverOutcome.LOST  # type: ignore[method-assign]  # of this one alone
    answer = solver.solve([target()], time.perf_counter() + PATIENCE_S, factors=factors)
    if not answer.optimal:  # a small program is left to the thread where the caller's own model is lost
        assert answer.exact is not None
        answer = answer.exact.result(timeout=PATIENCE_S)
    assert answer.optimal
    np.testing.assert_allclose(answer.objectives[0], expected.objectives[0], rtol=1e-8)
    np.testing.assert_allclose(answer.solutions[0], expected.solutions[0], rtol=1e-6, atol=1e-9)


def test_slices_become_longer_so_that_a_busy_machine_comes_to_an_end() -> None:
    solver = LimitedSolver([program()], inline=False)
    run, budgets = solver.model.run, []

    def stopped(budget_s: float, *_: int) -> SolverOutcome:
        budgets.append(budget_s)
        return SolverOutcome.STOPPED if len(budgets) < 20 else run(budget_s)

    solver.model.run = stopped  # type: ignore[method-assign]  # as where others have the processor
    assert solver.begin([target()]).result(timeout=PATIENCE_S).optimal
    solver.close()
    assert budgets == sorted(budgets)
    assert budgets[-1] == LONGEST_SLICE_S
    assert budgets[0] < 0.01 * LONGEST_SLICE_S


def test_a_caller_whose_solver_is_lost_is_reported_before_its_limit(
    solver: LimitedSolver, monkeypatch: pytest.MonkeyPatch
) -> None:
    tries = []

    def lost(*_: object) -> SolverOutcome:
        tries.append(threading.current_thread().name)
        if len(tries) > 100:
            raise AssertionError("it tries on and on")
        return SolverOutcome.LOST

    monkeypatch.setattr(BlockSolver, "run", lost)  # also those that start afresh
    answer = solver.solve([target()], time.perf_counter() + PATIENCE_S)
    assert not answer.optimal
    assert answer.exact is not None
    with pytest.raises(FittingError, match="no optimum"):
        answer.exact.result(timeout=PATIENCE_S)
    assert sum(name.startswith("brdf-fit") for name in tries) == 3
    assert len(tries) == (5 if solver.inline else 3)


def test_work_that_no_caller_waits_for_is_begun_and_dropped(solver: LimitedSolver) -> None:
    best = solver.solve([target()], time.perf_counter() + PATIENCE_S)
    late = solver.begin([target()], then=lambda answer: (answer, threading.current_thread().name))
    answer, name = late.result(timeout=PATIENCE_S)
    assert answer.optimal
    assert name.startswith("brdf-fit")
    np.testing.assert_allclose(answer.objectives[0], best.objectives[0], rtol=1e-9)
    with solver.background.lock:
        first = solver.begin([target(1)])
        second = solver.begin([target(2)])
    assert wait([first, second], timeout=PATIENCE_S).not_done == set()
    assert first.cancelled()
    assert second.result().optimal


def test_solvers_of_one_part_share_its_feasible_answers() -> None:
    part = program()
    solver = LimitedSolver([part], 3)
    other = LimitedSolver([part], 1, fallbacks=solver.fallbacks)
    assert other.fallbacks[0] is solver.fallbacks[0]
    answer = other.solve([target()[:, :1]], past(), finish=False)
    assert (answer.relative[0] < 1.0).all()
    for made in (solver, other):
        made.close()

"""The limited solver: the optimum in time, the best at hand out of time, and the optimum later."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import CancelledError

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.program import PartProgram, build_program
from brdf_suite.fitting.lobes.time_limit import LimitedSolver

PATIENCE_S = 250.0


def later() -> float:
    return time.perf_counter() + PATIENCE_S


def program(rows: int, columns: int, seed: int) -> PartProgram:
    rng = np.random.default_rng(seed)
    return build_program(rng.uniform(0, 1, (rows, columns)) ** 4, rng.uniform(0.5, 2, rows))


def optimum(matrix: np.ndarray, target: np.ndarray) -> float:
    rows, columns = matrix.shape
    answer = linprog(
        np.concatenate([np.zeros(columns), np.ones(2 * rows)]),
        A_eq=np.concatenate([matrix, -np.eye(rows), np.eye(rows)], axis=1),
        b_eq=target,
        bounds=(0, None),
    )
    assert answer.success
    return float(answer.fun)


def fit_threads() -> set[threading.Thread]:
    return {thread for thread in threading.enumerate() if thread.name.startswith("brdf-fit")}


@pytest.fixture(params=[True, False], ids=["inline", "thread"])
def solver(request: pytest.FixtureRequest) -> Iterator[LimitedSolver]:
    made = LimitedSolver([program(20, 6, 1), program(15, 9, 2)], inline=request.param)
    yield made
    made.close()


def targets(seed: int) -> list[np.ndarray]:
    rng = np.random.default_rng(seed)
    return [rng.uniform(0, 1, (20, 3)), 1e4 * rng.uniform(0, 1, (15, 3)) ** 3]


def test_in_time_it_is_the_optimum(solver: LimitedSolver) -> None:
    for seed in range(4):
        wanted = targets(seed)
        answer = solver.solve(wanted, later())
        assert answer.optimal
        assert answer.exact is None
        for part, solution, objective, target in zip(
            solver.parts, answer.solutions, answer.objectives, wanted, strict=True
        ):
            assert (solution >= 0.0).all()
            np.testing.assert_allclose(part.residual_l1(solution, target), objective, rtol=1e-9)
            for channel in range(3):
                exact = optimum(part.matrix, target[:, channel])
                assert objective[channel] == pytest.approx(exact, rel=1e-7)


def test_out_of_time_it_is_the_best_at_hand_and_the_optimum_follows(solver: LimitedSolver) -> None:
    solver.solve(targets(0), later())
    limited = solver.solve(targets(1), time.perf_counter() - 1.0)
    assert not limited.optimal
    assert limited.exact is not None
    methods = {name for part in limited.methods for name in part}
    assert methods <= {"rescaled", "least squares", "zero"}
    exact = limited.exact.result(timeout=PATIENCE_S)
    again = solver.solve(targets(1), later())
    assert exact.optimal
    for k in range(2):
        np.testing.assert_allclose(exact.objectives[k], again.objectives[k], rtol=1e-9)
        assert (limited.objectives[k] >= exact.objectives[k] * (1 - 1e-9)).all()
        assert (limited.relative[k] < 1.0).all()  # better than no weights
        np.testing.assert_allclose(
            solver.parts[k].residual_l1(limited.solutions[k], targets(1)[k]), limited.objectives[k]
        )


def test_after_an_optimum_near_by_the_rescaled_weights_win(solver: LimitedSolver) -> None:
    solver.solve(targets(0), later())
    limited = solver.solve([3.0 * target for target in targets(0)], time.perf_counter() - 1.0, finish=False)
    assert limited.methods == (("rescaled",) * 3,) * 2
    assert limited.exact is None
    best = solver.solve(targets(0), later())
    np.testing.assert_allclose(limited.objectives[0], 3.0 * best.objectives[0], rtol=1e-9)


def test_the_next_request_cancels_the_one_in_work() -> None:
    big = program(60, 12, 3)
    solver = LimitedSolver([big])
    rng = np.random.default_rng(0)
    with solver.background.lock:  # the first cannot come to its end before the second is asked for
        first = solver.solve([rng.uniform(0, 1, (60, 3))], time.perf_counter())
        second = solver.solve([rng.uniform(0, 1, (60, 3))], time.perf_counter())
    assert first.exact is not None
    assert second.exact is not None
    with pytest.raises(CancelledError):
        first.exact.result(timeout=PATIENCE_S)
    assert second.exact.result(timeout=PATIENCE_S).optimal
    solver.close()


def test_what_becomes_of_the_optimum_is_made_on_the_thread(solver: LimitedSolver) -> None:
    limited = solver.solve(
        targets(5), time.perf_counter(), then=lambda answer: (answer.optimal, threading.current_thread().name)
    )
    assert limited.exact is not None
    optimal, name = limited.exact.result(timeout=PATIENCE_S)
    assert optimal
    assert name.startswith("brdf-fit")


@pytest.mark.skipif(
    sys.platform != "linux", reason="other systems have no priority of a thread under this call"
)
def test_the_thread_gives_way_to_the_program(solver: LimitedSolver) -> None:
    def niceness(_: object) -> int:
        return os.getpriority(os.PRIO_PROCESS, threading.get_native_id())

    limited = solver.solve(targets(5), time.perf_counter(), then=niceness)
    assert limited.exact is not None
    own = os.getpriority(os.PRIO_PROCESS, threading.get_native_id())
    assert limited.exact.result(timeout=PATIENCE_S) == min(own + 5, 19)
    assert os.getpriority(os.PRIO_PROCESS, threading.get_native_id()) == own


def test_an_error_on_the_thread_reaches_who_waits(solver: LimitedSolver) -> None:
    def broken(_: object) -> None:
        raise ValueError("of a test")

    limited = solver.solve(targets(5), time.perf_counter(), then=broken)
    assert limited.exact is not None
    with pytest.raises(ValueError, match="of a test"):
        limited.exact.result(timeout=PATIENCE_S)
    assert solver.solve(targets(6), later()).optimal


def test_factors_are_weights_of_this_target_alone(solver: LimitedSolver) -> None:
    rng = np.random.default_rng(8)
    factors = [rng.uniform(0.2, 5.0, target.shape) for target in targets(0)]
    plain = solver.solve(targets(0), later())
    weighted = solver.solve(targets(0), later(), factors=factors)
    for k, part in enumerate(solver.parts):
        for channel in range(3):
            factor = factors[k][:, channel]
            exact = optimum(factor[:, None] * part.matrix, factor * targets(0)[k][:, channel])
            assert weighted.objectives[k][channel] == pytest.approx(exact, rel=1e-7)
    after = solver.solve(targets(0), later())
    np.testing.assert_allclose(after.objectives[0], plain.objectives[0], rtol=1e-9)
    limited = solver.solve(targets(1), time.perf_counter() - 1.0, factors=factors)
    assert limited.exact is not None
    exact_error = limited.exact.result(timeout=PATIENCE_S).objectives[0]
    assert (limited.objectives[0] >= exact_error * (1 - 1e-9)).all()


def test_one_part_may_stand_several_times() -> None:
    part, other = program(20, 6, 1), program(15, 9, 2)
    rng = np.random.default_rng(9)
    wanted = [rng.uniform(0, 1, (part.shape[0], 1)) for part in (part, part, other)]
    solver = LimitedSolver([part, part, other], channels=1)
    best = solver.solve(wanted, later())
    limited = solver.solve(wanted, time.perf_counter() - 1.0, finish=False)
    for k, made in enumerate((part, part, other)):
        assert best.objectives[k][0] == pytest.approx(optimum(made.matrix, wanted[k][:, 0]), rel=1e-7)
        np.testing.assert_allclose(limited.objectives[k], best.objectives[k], rtol=1e-9)
    solver.close()


def test_rows_of_any_sign_tie_unknowns_together() -> None:
    rng = np.random.default_rng(4)
    samples = rng.uniform(0, 1, (8, 4))
    ties = np.array([[1.0, -1.0, 0.0, 0.0], [0.0, 1.0, -1.0, 0.0], [0.0, 0.0, 1.0, -1.0]])
    matrix = np.vstack([samples, 0.3 * ties])
    solver = LimitedSolver([PartProgram(matrix, np.ones(11), np.ones(4))])
    target = np.vstack([rng.uniform(0, 1, (8, 3)), np.zeros((3, 3))])
    answer = solver.solve([target], later())
    for channel in range(3):
        assert answer.objectives[0][channel] == pytest.approx(optimum(matrix, target[:, channel]), rel=1e-7)
    limited = solver.solve([2.0 * target], time.perf_counter() - 1.0, finish=False)
    np.testing.assert_allclose(limited.objectives[0], 2.0 * answer.objectives[0], rtol=1e-9)
    solver.close()


@settings(max_examples=settings.default.max_examples // 4)
@given(seed=st.integers(0, 2**32 - 1), magnitude=st.floats(-12, 12), zero=st.integers(0, 2))
def test_any_target_has_a_sound_answer(seed: int, magnitude: float, zero: int) -> None:
    rng = np.random.default_rng(seed)
    part = program(int(rng.integers(1, 12)), int(rng.integers(1, 20)), seed)
    solver = LimitedSolver([part])
    target = 10.0**magnitude * rng.normal(0, 1, (part.shape[0], 3))
    target[:, zero] = 0.0
    for deadline in (later(), time.perf_counter() - 1.0):
        answer = solver.solve([target], deadline, finish=False)
        assert np.isfinite(answer.solutions[0]).all()
        assert (answer.solutions[0] >= 0.0).all()
        assert not answer.solutions[0][:, zero].any()
        assert (answer.objectives[0] <= np.abs(target).sum(axis=0) * (1 + 1e-12)).all()
    solver.close()


@pytest.mark.parametrize("bad", [np.nan, np.inf, 1e308])
def test_bad_targets_and_factors_are_named(solver: LimitedSolver, bad: float) -> None:
    wanted = targets(0)
    wanted[1][3:5, 1] = bad
    with np.errstate(over="ignore"), pytest.raises(FittingError, match="not finite"):
        solver.solve(wanted, later())
    with pytest.raises(FittingError, match="shapes"):
        solver.solve(targets(0)[:1], later())
    with pytest.raises(FittingError, match="factor"):
        solver.solve(targets(0), later(), factors=[0.0 * target for target in targets(0)])
    assert solver.solve(targets(0), later()).optimal


def test_no_thread_outlives_its_solver() -> None:
    before = fit_threads()  # those of other tests, which may end meanwhile
    big = program(1500, 60, 3)
    closed, lost = LimitedSolver([big]), LimitedSolver([big])
    target = np.random.default_rng(1).uniform(0, 1, (1500, 3))
    pending = [made.solve([target], time.perf_counter()).exact for made in (closed, lost)]
    assert len(fit_threads() - before) == 2
    closed.close()
    assert len(fit_threads() - before) == 1
    del lost
    gc.collect()
    for _ in range(2400):
        if fit_threads() <= before:
            break
        time.sleep(0.05)
    assert fit_threads() <= before
    assert all(future is not None and future.done() for future in pending)


def test_a_closed_solver_answers_and_finishes_nothing(solver: LimitedSolver) -> None:
    solver.close()
    solver.close()
    if solver.inline:
        assert solver.solve(targets(0), later()).optimal
    limited = solver.solve(targets(1), time.perf_counter() - 1.0)
    assert limited.exact is not None
    assert limited.exact.cancelled()


def test_an_optimum_whose_callback_closes_the_solver() -> None:
    solver = LimitedSolver([program(20, 6, 1)])
    limited = solver.solve([targets(0)[0]], time.perf_counter() - 1.0)
    assert limited.exact is not None
    done = threading.Event()

    def close(_: object) -> None:
        solver.close()
        done.set()

    limited.exact.add_done_callback(close)
    assert done.wait(PATIENCE_S)


@pytest.mark.parametrize("ending", ["", "sys.exit(0)", "raise SystemExit"])
def test_the_interpreter_ends_while_a_fit_is_in_work(ending: str) -> None:
    code = f"""
import sys, time
import numpy as np
from brdf_suite.fitting.lobes.time_limit import LimitedSolver
from brdf_suite.fitting.lobes.program import build_program
rng = np.random.default_rng(0)
solver = LimitedSolver([build_program(rng.uniform(0, 1, (3000, 150)), np.ones(3000))])
for _ in range(50):  # until this process is not held up for as long as the whole work takes
    answer = solver.solve([rng.uniform(0, 1, (3000, 3))], time.perf_counter())
    if not answer.exact.done():
        break
assert not answer.exact.done()
print("in work", flush=True)
{ending}
"""
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=PATIENCE_S)
    assert (ended.returncode, ended.stdout.strip(), ended.stderr) == (0, "in work", "")

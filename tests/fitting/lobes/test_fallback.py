from __future__ import annotations

import itertools
import types

import numpy as np
import pytest
from scipy.optimize import nnls

from brdf_suite.fitting.lobes import fallback
from brdf_suite.fitting.lobes.fallback import FallbackSolver
from brdf_suite.fitting.lobes.program import build_program


def test_alternating_directions_reach_the_non_negative_least_squares_answer() -> None:
    rng = np.random.default_rng(5)
    program = build_program(rng.uniform(0, 1, (20, 5)), np.ones(20))
    target = rng.uniform(0, 1, (20, 3))
    found = FallbackSolver(program).least_squares(target, steps=5000)
    for channel in range(3):
        np.testing.assert_allclose(found[:, channel], nnls(program.matrix, target[:, channel])[0], atol=1e-8)


def test_rescaling_is_the_best_factor() -> None:
    rng = np.random.default_rng(6)
    program = build_program(rng.uniform(0, 1, (11, 4)), rng.uniform(0.5, 2, 11))
    last, target = rng.uniform(0, 1, (4, 1)), rng.uniform(0, 1, (11, 1))
    chosen = program.residual_l1(FallbackSolver(program).rescaled(last, target)[0], target)[0]
    factors = np.linspace(0.0, 20.0, 20_001)
    brute = min(program.residual_l1(last * f, target)[0] for f in factors)
    assert chosen <= brute + 1e-9


def test_alternating_directions_stop_at_their_deadline(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(7)
    program = build_program(rng.uniform(0, 1, (30, 20)), np.ones(30))
    target = rng.uniform(0, 1, (30, 3))
    solver = FallbackSolver(program)
    looks = itertools.count(1)  # a clock that goes on by 1 at each look
    monkeypatch.setattr(fallback, "time", types.SimpleNamespace(perf_counter=lambda: float(next(looks))))
    found = solver.least_squares(target, deadline=5.0, steps=100)
    assert next(looks) == 6  # one look for each step after the first eight
    assert (found >= 0.0).all()
    # Clamped at once, it misses by a factor; the best one makes it better than nothing.
    assert (solver.rescaled(found, target)[1] < target.sum(axis=0)).all()


def test_nothing_to_rescale_gives_zeros() -> None:
    program = build_program(np.ones((3, 2)), np.ones(3))
    assert not FallbackSolver(program).rescaled(np.zeros((2, 3)), np.ones((3, 3)))[0].any()


def test_weights_that_came_to_all_but_nothing_are_not_divided_by() -> None:
    """Each target of a drag may scale the last weights down, until ratios to what they predict overflow."""
    solver = FallbackSolver(build_program(np.ones((3, 2)), np.ones(3)))
    solution, error = solver.rescaled(np.full((2, 3), 1e-310), np.full((3, 3), 1.0 / 3.0))
    assert not solution.any()
    np.testing.assert_allclose(error, 1.0)

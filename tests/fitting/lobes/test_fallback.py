from __future__ import annotations

import time

import numpy as np
from scipy.optimize import nnls

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


def test_alternating_directions_stop_at_their_deadline() -> None:
    rng = np.random.default_rng(7)
    program = build_program(rng.uniform(0, 1, (300, 200)), np.ones(300))
    target = rng.uniform(0, 1, (300, 3))
    start = time.perf_counter()
    fallback = FallbackSolver(program)
    found = fallback.least_squares(target, deadline=0.0, steps=10**7)
    assert time.perf_counter() - start < 2.0
    assert (found >= 0.0).all()
    # Clamped at once, it misses by a factor; the best one makes it better than nothing.
    assert (fallback.rescaled(found, target)[1] < target.sum(axis=0)).all()


def test_nothing_to_rescale_gives_zeros() -> None:
    program = build_program(np.ones((3, 2)), np.ones(3))
    assert not FallbackSolver(program).rescaled(np.zeros((2, 3)), np.ones((3, 3)))[0].any()

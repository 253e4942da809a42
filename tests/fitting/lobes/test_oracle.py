"""scipy's linear programming, called afresh for each program, reaches the same objective."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from brdf_suite.fitting import LobeFitter


def optimum(matrix: np.ndarray, target: np.ndarray) -> float:
    """``min Σ|M x - b|, x ≥ 0`` in its plain form, residuals split in two."""
    rows, columns = matrix.shape
    answer = linprog(
        np.concatenate([np.zeros(columns), np.ones(2 * rows)]),
        A_eq=np.concatenate([matrix, -np.eye(rows), np.eye(rows)], axis=1),
        b_eq=target,
        bounds=(0, None),
        method="highs",
        options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10},
    )
    assert answer.success
    return float(answer.fun)


def check(fitter: LobeFitter, base: np.ndarray, coat: np.ndarray) -> None:
    fit = fitter.fit_samples(base, coat, ior=1.5)
    assert not fit.time_limited
    energy = fitter.coat_samples.solid_angle @ coat
    for program, target, error in (
        (fitter.programs[0], base, fit.base_error),
        (fitter.programs[1], np.vstack([coat, energy]), fit.coat_error),
    ):
        weighted = program.row_weights[:, None] * target
        for channel in range(3):
            size = weighted[:, channel].sum()
            if size == 0.0:
                assert error.absolute[channel] == 0.0
                continue
            exact = optimum(program.matrix, weighted[:, channel] / size)
            ours = error.absolute[channel] / size
            # Below 1e-6 of the target's size both are rounding.
            assert ours == pytest.approx(exact, rel=1e-6, abs=1e-9)


def test_designed_paints(fitter: LobeFitter, make_paint: Callable[..., object]) -> None:
    for exponent, roughness in ((3.0, 0.002), (5.5, 0.005), (9.0, 0.03), (30.0, 0.1)):
        base, coat = fitter.sample(make_paint(exponent=exponent, roughness=roughness))
        check(fitter, base, coat)


@settings(max_examples=settings.default.max_examples // 4)
@given(st.integers(0, 2**32 - 1), st.floats(-3.0, 3.0))
def test_any_targets(fitter: LobeFitter, seed: int, magnitude: float) -> None:
    rng = np.random.default_rng(seed)
    base = 10.0**magnitude * rng.uniform(0, 1, (fitter.base_samples.gamma_rad.size, 3)) ** 3
    gamma = fitter.coat_samples.gamma_rad
    coat = 10.0**magnitude * np.exp(-np.outer(gamma**2, 10.0 ** rng.uniform(1, 5, 3)))
    check(fitter, base, coat * rng.uniform(0.8, 1.2, coat.shape))

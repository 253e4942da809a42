from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.program import build_program


def test_scaling_keeps_the_residual() -> None:
    rng = np.random.default_rng(3)
    matrix = rng.uniform(0, 1, (9, 4)) * 10.0 ** np.array([-3, 0, 2, 4])
    weights = rng.uniform(0.1, 5, 9)
    program = build_program(matrix, weights)
    solution, target = rng.uniform(0, 1, (4, 3)), rng.uniform(0, 1, (9, 3))
    plain = (weights[:, None] * np.abs(matrix @ (solution * program.column_scale[:, None]) - target)).sum(
        axis=0
    )
    np.testing.assert_allclose(program.residual_l1(solution, weights[:, None] * target), plain, rtol=1e-9)
    np.testing.assert_allclose(program.matrix.sum(axis=0), 1.0)


@pytest.mark.parametrize(
    ("matrix", "weights"),
    [
        (np.ones((3, 2)), np.ones(2)),
        (np.ones((3, 2)), np.array([1.0, 0.0, 1.0])),
        (np.array([[1.0], [np.nan]]), np.ones(2)),
        (np.array([[1.0], [-1.0]]), np.ones(2)),
        (np.ones((0, 2)), np.ones(0)),
    ],
)
def test_bad_systems_are_refused(matrix: np.ndarray, weights: np.ndarray) -> None:
    with pytest.raises(FittingError):
        build_program(matrix, weights)

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.fitting.lobes.exact_vertex import kept_vertex
from brdf_suite.fitting.lobes.highs_model import BlockSolution, BlockSolver, SolverOutcome
from brdf_suite.fitting.lobes.program import PartProgram, build_program


def solved(parts: list[PartProgram], targets: list[np.ndarray]) -> BlockSolution:
    solver = BlockSolver(parts)
    solver.load(targets)
    assert solver.run(60.0) is SolverOutcome.OPTIMAL
    return solver.solution()


@pytest.fixture(scope="module")
def case() -> tuple[list[PartProgram], list[np.ndarray]]:
    rng = np.random.default_rng(11)
    parts = [build_program(rng.uniform(0, 1, shape), np.ones(shape[0])) for shape in ((20, 5), (12, 7))]
    targets = [rng.uniform(0, 1, (part.shape[0], 3)) for part in parts]
    return parts, [target / target.sum(axis=0) for target in targets]


def test_a_small_step_is_answered_with_its_optimum(case: tuple[list[PartProgram], list[np.ndarray]]) -> None:
    parts, targets = case
    vertex = kept_vertex(parts, solved(parts, targets))
    assert vertex is not None
    rng = np.random.default_rng(1)
    near = [target * (1.0 + 1e-6 * rng.uniform(-1, 1, target.shape)) for target in targets]
    found = vertex.answer(near)
    assert found is not None
    exact = solved(parts, near)
    for k, part in enumerate(parts):
        np.testing.assert_allclose(found[1][k], part.residual_l1(exact.solutions[k], near[k]), rtol=1e-8)
        np.testing.assert_allclose(part.residual_l1(found[0][k], near[k]), found[1][k], rtol=1e-12)
        assert (found[0][k] >= 0.0).all()


def test_a_large_step_is_left_to_the_simplex(case: tuple[list[PartProgram], list[np.ndarray]]) -> None:
    parts, targets = case
    vertex = kept_vertex(parts, solved(parts, targets))
    assert vertex is not None
    rng = np.random.default_rng(2)
    for _ in range(20):
        far = [rng.uniform(0, 1, target.shape) for target in targets]
        far = [target / target.sum(axis=0) for target in far]
        found = vertex.answer(far)
        if found is not None:  # then it is the optimum
            exact = solved(parts, far)
            for k, part in enumerate(parts):
                optimum = part.residual_l1(exact.solutions[k], far[k])
                np.testing.assert_allclose(found[1][k], optimum, rtol=1e-7)
    assert vertex.answer([np.full_like(target, np.nan) for target in targets]) is None


def test_duals_that_are_not_feasible_are_not_kept(case: tuple[list[PartProgram], list[np.ndarray]]) -> None:
    parts, targets = case
    held = solved(parts, targets)
    loose = BlockSolution(held.solutions, tuple(dual + 1e-9 for dual in held.duals))
    assert kept_vertex(parts, loose) is None


def test_a_degenerate_optimum_is_not_kept() -> None:
    """Targets that the columns reach exactly are met by more samples than there are columns in use."""
    rng = np.random.default_rng(3)
    part = build_program(rng.uniform(0, 1, (12, 5)), np.ones(12))
    target = part.matrix @ np.diag([1.0, 1.0, 0.0, 0.0, 0.0])[:, :3]
    target[:, 2] = target[:, 0]
    held = solved([part], [target / target.sum(axis=0)])
    interior = BlockSolution(held.solutions, tuple(0.0 * dual for dual in held.duals))
    assert kept_vertex([part], interior) is None


def test_a_part_of_many_columns_is_left_to_the_simplex() -> None:
    rng = np.random.default_rng(5)
    part = build_program(rng.uniform(0, 1, (90, 70)), np.ones(90))
    target = rng.uniform(0, 1, (90, 3))
    assert kept_vertex([part], solved([part], [target / target.sum(axis=0)])) is None

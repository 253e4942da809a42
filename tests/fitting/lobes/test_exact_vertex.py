from __future__ import annotations

import numpy as np

from brdf_suite.fitting.lobes.exact_vertex import refine_vertex
from brdf_suite.fitting.lobes.highs_model import BlockSolver, SolverOutcome
from brdf_suite.fitting.lobes.program import build_program


def test_a_target_that_the_columns_reach_is_reached_to_rounding() -> None:
    rng = np.random.default_rng(2)
    program = build_program(rng.uniform(0, 1, (14, 6)) ** 3, np.ones(14))
    exact = rng.uniform(0, 1, (6, 3)) * (rng.uniform(0, 1, (6, 3)) < 0.6)
    target = program.matrix @ exact
    target /= target.sum(axis=0)
    solver = BlockSolver([program])
    solver.load([target])
    assert solver.run(60.0) is SolverOutcome.OPTIMAL
    held = solver.solution()
    blurred = held.solutions[0] * (1.0 + 1e-7)
    found, errors = refine_vertex(program, blurred, held.duals[0], target)
    assert (errors < 1e-14).all()
    assert (program.residual_l1(blurred, target) > 1e-9).all()
    np.testing.assert_allclose(program.residual_l1(found, target), errors, atol=1e-16)


def test_an_answer_that_its_duals_prove_is_left_alone() -> None:
    rng = np.random.default_rng(3)
    program = build_program(rng.uniform(0, 1, (14, 6)), np.ones(14))
    target = rng.uniform(0, 1, (14, 3))
    target /= target.sum(axis=0)
    solver = BlockSolver([program])
    solver.load([target])
    assert solver.run(60.0) is SolverOutcome.OPTIMAL
    held = solver.solution()
    found, errors = refine_vertex(program, held.solutions[0], held.duals[0], target)
    assert found is held.solutions[0]
    np.testing.assert_allclose(errors, (target * held.duals[0]).sum(axis=0), rtol=1e-8)


def test_a_refinement_that_does_not_help_is_not_taken() -> None:
    """Duals of another target say nothing of this one."""
    rng = np.random.default_rng(4)
    program = build_program(rng.uniform(0, 1, (9, 4)), np.ones(9))
    solution, target = rng.uniform(0, 0.3, (4, 3)), rng.uniform(0, 0.2, (9, 3))
    before = program.residual_l1(solution, target)
    found, errors = refine_vertex(program, solution, rng.uniform(-1, 1, (9, 3)), target)
    assert (errors <= before).all()
    assert (found >= 0.0).all()

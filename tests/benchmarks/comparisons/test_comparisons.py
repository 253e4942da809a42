"""The comparisons that docs/method/fit.md quotes still run, and what the page says of them holds on a few paints."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

HERE = Path(__file__).resolve().parent
SCRIPTS = (
    "compare_colour_spaces.py",
    "compare_lobe_bases.py",
    "compare_lobe_families.py",
    "compare_samples.py",
    "compare_solvers.py",
    "compare_weights.py",
)


@pytest.mark.parametrize("script", SCRIPTS)
def test_a_comparison_prints_its_tables(script: str) -> None:
    command = [sys.executable, "-W", "error", script, "--paints", "2"]
    done = subprocess.run(command, cwd=HERE, capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0, done.stderr
    rows = [line for line in done.stdout.splitlines() if line.startswith("| ")]
    assert len(rows) >= 4
    assert not any("nan" in line or "inf" in line for line in rows)


def test_the_plots_are_drawn(tmp_path: Path) -> None:
    script = HERE.parents[2] / "packaging" / "plots" / "fit.py"
    command = [sys.executable, str(script), str(tmp_path), "--paints", "2"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0, done.stderr
    for name in ("fit_solvers.png", "fit_samples.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")


@pytest.fixture
def experiment(monkeypatch: pytest.MonkeyPatch) -> object:
    monkeypatch.syspath_prepend(str(HERE))
    import lobe_experiment

    return lobe_experiment


def test_the_three_solvers_agree_where_lobes_give_the_target_exactly(experiment) -> None:
    lobes = experiment.Lobes((2.0, 8.0), (3.0,))
    matrix = lobes.matrix((0.0, 15.0, 30.0, 45.0, 60.0, 80.0, 110.0))
    columns = np.array([[[0.1], [0.0], [0.7], [0.2]], [[0.0], [0.3], [0.4], [0.0]]])
    weights = np.array([1.0, 50.0, 1.0, 4.0, 2.0, 1.0, 50.0])
    for solver in (
        experiment.l1_program,
        experiment.non_negative_least_squares,
        experiment.clamped_least_squares,
    ):
        np.testing.assert_allclose(solver(matrix, weights, matrix @ columns), columns, atol=1e-6)


def test_the_bare_program_finds_what_the_fitter_finds(experiment) -> None:
    from brdf_suite.fitting import LobeFitter

    fitter = LobeFitter(time_limit_s=1.0)
    chosen = experiment.paints(count=4)
    database = experiment.Database.of(list(chosen.values()))
    found = database.fit(experiment.Lobes(fitter.basis.exponents))
    for columns, layers in zip(found, chosen.values(), strict=True):
        fit = fitter.fit(layers)
        matrix = experiment.Lobes(fitter.basis.exponents).matrix(database.gammas_deg)
        rest = matrix @ columns - experiment.base_values([layers], database.gammas_deg)[0]
        objective = (database.weights[:, None] * np.abs(rest)).sum(axis=0)
        np.testing.assert_allclose(objective, fit.base_error.absolute, rtol=1e-4, atol=1e-6)


def test_clamping_grows_worse_with_more_lobes_and_the_program_does_not(experiment) -> None:
    from brdf_suite.fitting import log_spaced

    database = experiment.Database.of(list(experiment.paints(count=4).values()))
    few, many = (experiment.Lobes(log_spaced(n, 2.0, 64.0).exponents) for n in (4, 10))
    clamped = [database.errors(x, experiment.clamped_least_squares).equation_4 for x in (few, many)]
    program = [database.errors(x).equation_4 for x in (few, many)]
    assert clamped[1] > 10.0 * clamped[0]
    assert program[1] < program[0]


def test_a_half_lobe_reaches_beyond_ninety_degrees_and_holds_its_solid_angle(experiment) -> None:
    lobes = experiment.Lobes((4.0,), (4.0,))
    values = lobes.of_cosine(np.array([-0.5, 0.0, 1.0]))
    np.testing.assert_allclose(values, [[0.0, 0.25**4], [0.0, 0.5**4], [1.0, 1.0]])
    cosine, step = np.linspace(-1.0, 1.0, 200_001, retstep=True)
    energy = 2.0 * np.pi * step * lobes.of_cosine(cosine).sum(axis=0)
    np.testing.assert_allclose(energy, [2.0 * np.pi / 5.0, 4.0 * np.pi / 5.0], rtol=1e-4)

"""The model of the fit: equal to the reflectance of the suite, with a Jacobian that is its derivative."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.arrays import Floats
from brdf_suite.fitting.cook_torrance.model import LobeModel, Terms, fresnel
from brdf_suite.fitting.cook_torrance.samples import check_samples, half_and_difference, spread
from brdf_suite.fitting.cook_torrance.solve import Cost, FitProblem
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.ggx import Ggx
from brdf_suite.reflectance.models.table_1 import TABLE_1


@pytest.fixture(scope="module")
def pairs() -> tuple[Floats, Floats]:
    h, d, p = np.random.default_rng(1).random((3, 800))
    wi, wo = from_half_angle_coordinates(1.4 * h**2, 0.0, 1.4 * d, np.pi * p)
    seen = (wi[:, 2] > 0.1) & (wo[:, 2] > 0.1)
    return wi[seen], wo[seen]


def vector(model: LobeModel, name: str) -> Floats:
    paint = TABLE_1[name]
    lobes = paint.lobes
    return model.vector(paint.kd, [x.ks for x in lobes], [x.m for x in lobes], [x.r for x in lobes])


@pytest.mark.parametrize("name", sorted(TABLE_1))
def test_it_is_the_reflectance_of_the_suite(name: str, pairs: tuple[Floats, Floats]) -> None:
    model = LobeModel("cook-torrance", 3)
    found = model.parts(vector(model, name), Terms.of(*pairs)).sum(axis=0).T
    assert np.allclose(found, CookTorrance(TABLE_1[name]).eval(*pairs), rtol=1e-6)


def test_a_lobe_of_ggx_is_that_of_the_suite(pairs: tuple[Floats, Floats]) -> None:
    model = LobeModel("ggx", 1)
    # Where nothing but the facets differs: F = 1.
    x = model.vector(np.zeros(3), np.full((1, 3), 0.25), [0.3], [1.0])
    found = model.parts(x, Terms.of(*pairs))[1].T
    assert np.allclose(found, Ggx(kd=0.0, f0=1.0, alpha=0.3, scattering="single").eval(*pairs), rtol=1e-9)


@pytest.mark.parametrize("kind", ["cook-torrance", "ggx", "ggx-clearcoat"])
def test_the_jacobian_is_the_derivative(kind: str, pairs: tuple[Floats, Floats]) -> None:
    model, terms = LobeModel(kind, 3), Terms.of(*pairs)
    x = vector(model, "table1_ford_f8")
    slopes = model.logs(x, terms)[1]
    for place in range(model.size):
        step = np.zeros(model.size)
        step[place] = 1e-6
        change = (model.logs(x + step, terms, False)[0] - model.logs(x - step, terms, False)[0]) / 2e-6
        for channel in range(3):
            at = np.flatnonzero(model.columns(channel) == place)
            wanted = slopes[channel, at[0]] if at.size else 0.0
            assert np.allclose(change[channel], wanted, atol=1e-6)


@pytest.mark.parametrize("r", [0.0, 0.04, 0.5, 1.0])
def test_fresnel_is_that_of_the_suite_up_to_a_mirror(r: float) -> None:
    cosine = np.linspace(0.05, 1.0, 40)
    e = (1.0 - np.sqrt(r)) / (1.0 + np.sqrt(r))
    wanted = fresnel_dielectric(cosine, 1.0 / e) if e > 0.0 else np.ones(40)
    assert np.allclose(fresnel(cosine, e)[0], wanted, atol=1e-12)


def test_values_come_back_from_the_vector_and_lobes_are_sorted() -> None:
    model = LobeModel("cook-torrance", 3)
    x = vector(model, "table1_blue")
    swapped = np.concatenate((x[:3], x[13:18], x[3:8], x[8:13]))
    kd, ks, m, r = model.values(model.sorted(swapped))
    paint = TABLE_1["table1_blue"]
    assert kd == pytest.approx(paint.kd)
    assert np.allclose(ks, [lobe.ks for lobe in paint.lobes])
    assert m == pytest.approx([lobe.m for lobe in paint.lobes])
    assert r == pytest.approx([lobe.r for lobe in paint.lobes])


@pytest.mark.parametrize("kind", ["linear", "smooth", "cauchy"])
def test_the_reduced_problem_has_cost_and_gradient_of_the_whole(
    kind: str, pairs: tuple[Floats, Floats]
) -> None:
    model = LobeModel("cook-torrance", 3)
    truth = CookTorrance(TABLE_1["table1_ford_f8"]).eval(*pairs)
    problem = FitProblem.of(model, check_samples(*pairs, truth * 1.3))
    x, cost = vector(model, "table1_ford_f8"), Cost(kind, 0.1)

    def whole(at: Floats) -> float:
        return problem.objective(at, cost) * problem.counted

    residuals, jacobian = problem.reduced(x, cost)
    assert 0.5 * residuals @ residuals == pytest.approx(whole(x))
    gradient = jacobian.T @ residuals
    for place in range(model.size):
        step = np.zeros(model.size)
        step[place] = 1e-5
        assert gradient[place] == pytest.approx(
            (whole(x + step) - whole(x - step)) / 2e-5, rel=1e-3, abs=1e-3
        )


def test_few_samples_are_spread_over_both_angles() -> None:
    rng = np.random.default_rng(0)
    # Nearly all far from the peak, and nearly all at one difference.
    h = np.concatenate((rng.uniform(0.5, 1.2, 20_000), rng.uniform(0.0, 0.01, 200)))
    d = np.concatenate((rng.uniform(0.2, 0.3, 20_000), rng.uniform(0.0, 1.4, 200)))
    wi, wo = from_half_angle_coordinates(h, 0.0, d, 1.6)
    chosen = spread(*half_and_difference(wi, wo), 400, 0)
    assert len(chosen) == 400
    assert np.count_nonzero(h[chosen] < 0.01) > 100
    assert np.array_equal(chosen, spread(*half_and_difference(wi, wo), 400, 0))

"""Every registered model: shape, sign, reciprocity, energy, and its sampler against its density."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from brdf_suite.documents.parameter import Parameter
from brdf_suite.geometry.directions import illumination, spherical
from brdf_suite.reflectance.albedo import white_furnace
from brdf_suite.reflectance.checks import CheckReport, check_model
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.registry import MODELS

COUNT = 60_000
ANGLES = (0.0, 40.0, 75.0)
SAMPLED = {name: entry.default for name, entry in MODELS.items() if hasattr(entry.default, "sample")} | {
    name: CookTorrance(paint) for name, paint in TABLE_1.items()
}


@cache
def report(name: str) -> CheckReport:
    return check_model(MODELS[name])


def test_the_models_of_the_field_are_there() -> None:
    assert {
        "aspecular",
        "aspecular_monotone",
        "aspecular_polynomial",
        "aspecular_half_vector",
        "aspecular_two_lights",
        "cosine_lobes",
        "phong",
        "phong_original",
        "lafortune",
        "coated_phong",
        "cook_torrance",
        "ggx_clearcoat",
        "poulin_fournier",
        "coated_matt",
        "coat",
    } <= set(MODELS)


@pytest.mark.parametrize("name", MODELS)
def test_each_keeps_what_it_claims(name: str) -> None:
    for finding in report(name).findings:
        assert finding.passed, finding


@pytest.mark.parametrize("name", MODELS)
def test_known_violators_are_listed_with_their_size(name: str) -> None:
    found = {f.check: f.size for f in report(name).findings if f.outcome == "known violator"}
    listed = MODELS[name].violations
    assert found.keys() == listed.keys()
    for check, size in listed.items():
        assert found[check] == pytest.approx(size, rel=0.01)


@pytest.mark.parametrize("name", MODELS)
def test_each_claims_what_its_model_claims(name: str) -> None:
    entry = MODELS[name]
    assert entry.default.reciprocal == entry.reciprocal
    assert entry.default.energy_conserving == entry.energy_conserving


@pytest.mark.parametrize("name", MODELS)
def test_each_declares_its_parameters(name: str) -> None:
    parameters = MODELS[name].parameters
    assert parameters
    for parameter in parameters.values():
        assert isinstance(parameter, Parameter)
        assert parameter.label
        assert parameter.meaning
        assert parameter.low <= parameter.default <= parameter.high


@pytest.mark.parametrize("name", MODELS)
def test_each_broadcasts_and_is_black_below_the_horizon(name: str) -> None:
    model = MODELS[name].default
    wi = spherical(np.linspace(0.0, 3.1, 5)[:, None], 0.3)
    wo = spherical(np.linspace(0.1, 3.0, 4), 2.0)
    value = model.eval(wi, wo)
    assert value.shape == (5, 4, 3)
    assert value.dtype == np.float64
    dark = (wi[..., 2] <= 0.0) | (wo[..., 2] <= 0.0)
    assert np.all(value[np.broadcast_to(dark, (5, 4))] == 0.0)
    assert model.eval(wi[0, 0], wo[0]).shape == (3,)
    assert model.eval(np.empty((0, 3)), wo[0]).shape == (0, 3)
    np.testing.assert_allclose(model.eval(wi[1, 0], wo[1]), value[1, 1], rtol=1e-12)


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("name", SAMPLED)
def test_what_is_drawn_has_the_density(name: str, angle: float, chi_square) -> None:
    model = SAMPLED[name]
    wo = illumination(angle)
    u = np.random.default_rng([7, int(angle)]).random((COUNT, 3))
    wi = model.sample(wo, u)
    np.testing.assert_allclose(np.linalg.norm(wi, axis=-1), 1.0, atol=1e-9)
    p = chi_square(wi, lambda w: model.pdf(w, wo), np.radians(angle))
    # All of them together fail by chance once in a hundred; and the seeds are fixed.
    assert p > 0.01 / (len(SAMPLED) * len(ANGLES))


@pytest.mark.parametrize("name", SAMPLED)
def test_sampling_and_quadrature_agree_on_the_furnace(name: str) -> None:
    """Two independent ways to the same integral: a z-test, 0.01 for all together (|z| < 4.2)."""
    model = SAMPLED[name]
    random = np.random.default_rng(13)
    for angle in (20.0, 70.0):
        wo = illumination(angle)
        wi = model.sample(wo, random.random((COUNT, 3)))
        density = model.pdf(wi, wo)
        cosine = np.maximum(wi[:, 2], 0.0)
        weight = np.divide(cosine, density, out=np.zeros_like(density), where=density > 0.0)
        got = model.eval(wi, wo)[:, 1] * weight
        error = got.std() / np.sqrt(COUNT)
        # What the quadrature itself is sure of.
        assert abs(got.mean() - white_furnace(model, wo)[1]) < 4.2 * error + 2e-4 * got.mean()


@pytest.mark.parametrize("name", SAMPLED)
def test_light_is_drawn_wherever_the_model_shines(name: str) -> None:
    """A direction that the sampler never draws would be missing from every picture."""
    model = SAMPLED[name]
    random = np.random.default_rng(3)
    wi, wo = spherical(random.uniform(0.0, 1.5, (2, 2000)), random.uniform(-3.1, 3.1, (2, 2000)))
    assert np.all(model.pdf(wi, wo)[model.eval(wi, wo).max(axis=-1) > 0.0] > 0.0)

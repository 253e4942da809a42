"""The renderer's reflectances against those of the core: the same values, and directions drawn as the density says."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.reference.variant import Variant
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

_spec = importlib.util.spec_from_file_location("pairs", Path(__file__).with_name("pairs.py"))
assert _spec is not None
assert _spec.loader is not None
made = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(made)

pytestmark = pytest.mark.usefixtures("variant")

# Single precision has 6e-8. What a rounding of the directions themselves changes comes on top, and is large where a
# lobe is narrow: it is measured with the core, at the directions as they are rounded and at those of unit length.
TOLERANCE = 5e-5


@pytest.fixture(scope="module")
def twins(variant: Variant) -> Callable[[str], tuple[Any, Any]]:
    """Return a model of the core and its twin, by name."""
    from brdf_suite.reference.bsdfs.translate import translate

    kept: dict[str, tuple[Any, Any]] = {}

    def twin(name: str) -> tuple[Any, Any]:
        if name not in kept:
            model = made.MODELS[name]()
            kept[name] = model, translate(model).term
        return kept[name]

    return twin


def vectors(directions: np.ndarray) -> Any:
    import mitsuba as mi

    return mi.Vector3f(np.ascontiguousarray(directions.T, np.float32))


def rows(values: Any, count: int) -> np.ndarray:
    found = np.atleast_2d(np.array(values, np.float64)).T
    return np.broadcast_to(found, (count, found.shape[1]))


@pytest.mark.parametrize("name", made.MODELS)
def test_values_are_those_of_the_core_to_single_precision(twins, name: str) -> None:
    model, term = twins(name)
    wi, wo = made.pairs(20_000)
    rounded = model.eval(wi.astype(np.float32).astype(float), wo.astype(np.float32).astype(float))
    wanted = model.eval(wi, wo)
    found = rows(term.eval(vectors(wi), vectors(wo)), len(wi))
    error = np.abs(found - wanted) - 2.0 * np.abs(rounded - wanted)
    least = 1e-3 + 1e-7 * wanted.max()  # 1/sr: a reflectance factor of .003 is nearly black
    assert (error / (wanted + least)).max() < TOLERANCE


@pytest.mark.parametrize("theta_deg", [20.0, 65.0])
@pytest.mark.parametrize("name", made.MODELS)
def test_directions_are_drawn_as_the_density_says(twins, chi_square, name: str, theta_deg: float) -> None:
    import mitsuba as mi

    from brdf_suite.reference.bsdfs import terms

    _, term = twins(name)
    count = 100_000
    rng = np.random.default_rng(11)
    # From the -x side, so that the mirror direction is on the +x side, where the test's panels are narrow.
    view = spherical(np.full(count, math.radians(theta_deg)), math.pi)
    choice, u = mi.Float(rng.random(count).astype(np.float32)), rng.random((2, count)).astype(np.float32)
    drawn = rows(terms.sample(term.samplers, vectors(view), choice, mi.Point2f(u)), count)

    def density(light: np.ndarray) -> np.ndarray:
        views = np.broadcast_to(view[0], light.shape)
        return rows(terms.pdf(term.samplers, vectors(light), vectors(views)), len(light))[:, 0]

    assert chi_square(drawn, density, math.radians(theta_deg)) > 1e-4


@pytest.mark.parametrize(
    "name",
    [
        "lambertian",
        "satin_coat_lobe",
        "matte_coated_white",
        "designed",
        "designed_matte",
        "cook_torrance",
        "coated",
        "table",
    ],
)
def test_in_a_white_furnace_the_albedo_comes_back(twins, name: str) -> None:
    """What the samplers' weights add up to is what the core's quadrature gives: a z-test."""
    import mitsuba as mi

    from brdf_suite.reference.bsdfs import terms

    model, term = twins(name)
    count = 200_000
    rng = np.random.default_rng(5)
    for theta in (0.3, 1.1):
        view = vectors(np.broadcast_to(spherical(theta, 0.4), (count, 3)))
        choice = mi.Float(rng.random(count).astype(np.float32))
        light = terms.sample(
            term.samplers, view, choice, mi.Point2f(rng.random((2, count)).astype(np.float32))
        )
        pdf = rows(terms.pdf(term.samplers, light, view), count)
        above = np.array(light.z) > 0.0
        value = rows(term.eval(light, view), count) * np.array(light.z)[:, None]
        weights = np.where(above[:, None] & (pdf > 0.0), value / np.maximum(pdf, 1e-30), 0.0)
        wanted = directional_albedo(model, spherical(theta, 0.4))
        error = weights.std(axis=0) / math.sqrt(count)
        assert np.all(np.abs(weights.mean(axis=0) - wanted) < 4.5 * error + 2e-3 * wanted), (theta, wanted)


def test_what_has_no_formula_here_is_a_table_and_says_so(variant: Variant) -> None:
    from brdf_suite.reference.bsdfs.translate import TABULATED, translate

    model = made.without_a_formula()
    translated = translate(model)
    assert translated.notices == (TABULATED,)
    wi, wo = made.pairs(4000)
    found = rows(translated.term.eval(vectors(wi), vectors(wo)), len(wi))
    wanted = IsotropicTable.from_reflectance(model).eval(wi, wo)
    assert np.abs(found - wanted).max() < 1e-4 * wanted.max()
    assert np.abs(wanted - model.eval(wi, wo)).mean() < 0.1 * wanted.mean()


def test_the_lobes_of_a_fit_are_those_of_the_core(variant: Variant) -> None:
    from brdf_suite.reference.bsdfs.lobe_weights import LobeWeightsTerm
    from brdf_suite.reflectance.models.cosine_lobes import lobe_sums

    weights = fit_material(load_material("copper")).weights
    term = LobeWeightsTerm(
        weights.exponents,
        weights.kd,
        weights.kdd,
        weights.kg,
        "dielectric",
        weights.theta_fit_rad,
        weights.ior,
        False,
    )
    wi, wo = made.pairs(20_000)
    wanted = lobe_sums(wi, wo, weights.exponents, weights.kd, weights.kdd, weights.kg).brdf()
    found = rows(term.eval(vectors(wi), vectors(wo)), len(wi))
    assert np.max(np.abs(found - wanted) / (wanted + 1e-7 * wanted.max())) < 1e-3  # √E times the rounding


def test_a_material_of_a_file_is_that_of_the_core(variant: Variant, shared_data: Path) -> None:
    """Not reciprocal, as measured ones are: light and view must not be exchanged."""
    from brdf_suite.files.measured import read_measured
    from brdf_suite.reference.bsdfs.translate import translate

    model = read_measured(shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf")
    translated = translate(model)
    assert translated.notices == ()
    wi, wo = made.pairs(20_000)
    wanted = model.eval(wi, wo)
    found = rows(translated.term.eval(vectors(wi), vectors(wo)), len(wi))
    error = np.abs(found - wanted) / (wanted + 1e-3)
    assert np.quantile(error, 0.99) < TOLERANCE
    assert error.max() < 0.02  # beside the edge of a cell, where single precision takes the next one
    assert np.abs(model.eval(wo, wi) - wanted).max() > 0.1 * wanted.mean()

"""Narrow lobes of the ray tracer: cut off exactly, drawn as the density says, and mirrored with what they send."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.reference.variant import Variant
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe

_spec = importlib.util.spec_from_file_location("pairs", Path(__file__).with_name("pairs.py"))
assert _spec is not None
assert _spec.loader is not None
made = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(made)

pytestmark = pytest.mark.usefixtures("variant")

CUT = (
    "designed",
    "designed_base",
    "cook_torrance",
    "cook_torrance_white",
    "coated",
    "satin_coat_lobe",
    "lambertian",
)


def vectors(directions: np.ndarray) -> Any:
    import mitsuba as mi

    return mi.Vector3f(np.ascontiguousarray(directions.T, np.float32))


def rows(values: Any, count: int) -> np.ndarray:
    found = np.atleast_2d(np.array(values, np.float64)).T
    return np.broadcast_to(found, (count, found.shape[1]))


@pytest.fixture(scope="module")
def terms_of(variant: Variant) -> Any:
    """Return a term by its model's name; tables are of a paint with a peak."""
    from brdf_suite.reference.bsdfs.translate import translate

    kept: dict[str, Any] = {}

    def term(name: str) -> Any:
        if name not in kept:
            kept[name] = translate(made.MODELS[name]()).term
        return kept[name]

    return term


def lobe_weights() -> Any:
    from brdf_suite.reference.bsdfs.lobe_weights import LobeWeightsTerm

    w = fit_material(load_material("copper")).weights
    return LobeWeightsTerm(w.exponents, w.kd, w.kdd, w.kg, "dielectric", w.theta_fit_rad, w.ior)


@pytest.mark.parametrize("mirror", [False, True])
def test_the_two_parts_of_a_sum_of_lobes_are_the_whole(terms_of, mirror: bool) -> None:
    from brdf_suite.reference.raytraced.split import split

    wi, wo = made.pairs(4000)
    light, view = vectors(wi), vectors(wo)
    narrow = {}
    for name in (*CUT, "fitted lobes"):
        term = lobe_weights() if name == "fitted lobes" else terms_of(name)
        cut = split(term, mirror=mirror)
        narrow[name] = len(cut.narrow)
        whole = rows(term.eval(light, view), len(wi))
        found = rows(cut.broad.eval(light, view), len(wi)) + rows(cut.narrow_value(light, view), len(wi))
        np.testing.assert_allclose(found, whole, rtol=2e-5, atol=1e-6, err_msg=name)
    assert narrow["designed"] == 1
    assert narrow["designed_base"] == narrow["lambertian"] == 0
    assert narrow["satin_coat_lobe"] == (0 if mirror else 1)  # α = .1: sampled, but too wide to be mirrored
    assert narrow["coated"] == 3  # the two blue lobes of Table 1, and the coat over them
    assert narrow["fitted lobes"] > 0


@pytest.mark.parametrize("how", ["clamp", "subtract"])
@pytest.mark.parametrize("name", ["table", "table_both_ways"])
def test_the_two_parts_of_a_table_are_the_whole_and_the_broad_one_has_no_peak(
    terms_of, name: str, how: str
) -> None:
    from brdf_suite.reference.raytraced.split import split
    from brdf_suite.reference.raytraced.table_split import evaluate_term

    term = terms_of(name)
    cut = split(term, tables=how)
    wi, wo = made.pairs(4000)
    light, view = vectors(wi), vectors(wo)
    whole = rows(term.eval(light, view), len(wi))
    found = rows(cut.broad.eval(light, view), len(wi)) + rows(cut.narrow_value(light, view), len(wi))
    np.testing.assert_allclose(found, whole, rtol=2e-5, atol=1e-6)
    assert len(cut.narrow) == (2 if how == "clamp" else 1)
    assert [lobe.is_sunlit for lobe in cut.narrow] == ([False, True] if how == "clamp" else [False])
    mirror, eye = spherical(np.array([0.8]), np.array([math.pi])), spherical(0.8, 0.0)
    assert evaluate_term(cut.broad, mirror, eye).max() < 0.2 * evaluate_term(term, mirror, eye).max()
    # Away from the mirror direction all is broad.
    aside = spherical(np.array([0.3]), np.array([1.0]))
    np.testing.assert_allclose(
        evaluate_term(cut.broad, aside, eye), evaluate_term(term, aside, eye), rtol=1e-5
    )


def test_a_matt_table_is_not_cut(variant: Variant) -> None:
    from brdf_suite.reference.bsdfs.translate import translate
    from brdf_suite.reference.raytraced.split import split
    from brdf_suite.reflectance.models.lambertian import Lambertian
    from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
    from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

    table = IsotropicTable.from_reflectance(Lambertian(np.array([0.2, 0.5, 0.8])), HalfAngleGrid(20, 10, 18))
    for how in ("clamp", "subtract"):
        assert not split(translate(table).term, tables=how).narrow


def narrow_lobe(which: str) -> Any:
    from brdf_suite.reference.raytraced.lobes import FacetGlint, MirrorLobe
    from brdf_suite.reference.raytraced.table_split import FacetMixture

    lobes = {
        "facets": lambda: FacetGlint(1.0, 0.12),
        "narrow facets": lambda: FacetGlint(1.0, 0.02),
        "about the mirror": lambda: MirrorLobe(1.0, 60.0),
        "mixture": lambda: FacetMixture(None, ((0.5, 0.03), (0.3, 0.1), (0.2, 0.2))),
    }
    return lobes[which]()


@pytest.mark.parametrize("theta_deg", [20.0, 65.0])
@pytest.mark.parametrize("which", ["facets", "narrow facets", "about the mirror", "mixture"])
def test_directions_are_drawn_as_the_density_says(chi_square, which: str, theta_deg: float) -> None:
    import mitsuba as mi

    lobe, count = narrow_lobe(which), 100_000
    rng = np.random.default_rng(3)
    view = spherical(np.full(count, math.radians(theta_deg)), math.pi)
    drawn = rows(lobe.sample(vectors(view), mi.Point2f(rng.random((2, count)).astype(np.float32))), count)

    def density(light: np.ndarray) -> np.ndarray:
        views = np.broadcast_to(view[0], light.shape)
        return rows(lobe.pdf(vectors(light), vectors(views)), len(light))[:, 0]

    assert chi_square(drawn, density, math.radians(theta_deg)) > 1e-4


def test_the_cosine_lobe_is_that_of_the_paper() -> None:
    """n = 2π/4m² - 1, θ = arccos r^(1/(n+1)), and a weight that stays below 4/π of the middle's: the lobe is wider."""
    import mitsuba as mi

    from brdf_suite.reference.bsdfs.directions import Half
    from brdf_suite.reference.bsdfs.terms import FacetLobe
    from brdf_suite.reference.raytraced.lobes import (
        cosine_lobe_mirrored,
        cosine_lobe_pdf,
        equivalent_exponent,
    )

    m = 0.013
    n = equivalent_exponent(m)
    assert n == pytest.approx(2.0 * math.pi / (4.0 * m * m) - 1.0)
    r = np.linspace(0.001, 0.999, 400).astype(np.float32)
    up = mi.Vector3f(0.0, 0.0, 1.0)
    light = cosine_lobe_mirrored(up, mi.Point2f(mi.Float(1.0 - r), mi.Float(0.0)), mi.Float(n))
    tilt = 0.5 * np.arctan2(np.array(light.x), np.array(light.z))
    np.testing.assert_allclose(tilt, np.arccos(r.astype(float) ** (1.0 / (n + 1.0))), rtol=2e-3)
    lobe = FacetLobe((1.0, 1.0, 1.0), m, 0.25, None, 1.0)
    weight = np.array((lobe.eval(light, up) * light.z / cosine_lobe_pdf(Half.of(light, up), mi.Float(n))).x)
    middle = weight[np.argmax(r)]
    assert weight.max() <= 1.001 * middle
    assert weight.min() > 0.0


def test_a_mirrored_lobe_has_the_albedo_of_the_sampled_one(variant: Variant) -> None:
    import mitsuba as mi

    from brdf_suite.reference.bsdfs.translate import translate
    from brdf_suite.reference.raytraced.split import split

    model = CoatLobe(1.5, 0.01)
    mirrored = split(translate(model).term, mirror=True)
    for theta in (0.2, 0.9, 1.35):
        view = vectors(spherical(np.array([theta]), np.array([0.3])))
        light, weight, _ = mirrored.sample(view, mi.Float(0.3), mi.Point2f(0.1, 0.7))
        np.testing.assert_allclose(np.array(light).T, np.array(view).T * [-1.0, -1.0, 1.0], atol=1e-7)
        wanted = directional_albedo(model, spherical(theta, 0.3))
        np.testing.assert_allclose(np.array(weight).T[0], wanted, rtol=0.02)


def test_what_reflects_more_than_falls_on_it_is_found(terms_of) -> None:
    from brdf_suite.reference.bsdfs.terms import LambertianTerm
    from brdf_suite.reference.raytraced.energy import TOLERANCE, largest_albedo

    assert largest_albedo(LambertianTerm((0.3, 1.2, 0.5))) == pytest.approx(1.2, rel=0.01)
    assert largest_albedo(LambertianTerm((1.0, 1.0, 1.0))) <= 1.0 + TOLERANCE
    assert largest_albedo(terms_of("designed")) < 1.0

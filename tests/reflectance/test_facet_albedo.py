"""Multiple scattering of rough facets: white furnaces are white, and the single form is that of the papers."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Paint, solid_paint
from brdf_suite.geometry.directions import illumination, spherical
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reflectance.albedo import directional_albedo, hemispherical_albedo
from brdf_suite.reflectance.designed.aspecular_base import AspecularBase
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.facet_albedo import (
    COSINES,
    DISTRIBUTIONS,
    ROUGHNESSES,
    coat_albedo,
    entering,
    mean_reflected,
)
from brdf_suite.reflectance.facet_table import change
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.ggx import Ggx
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.resources import resource

LIGHT = math.radians(45.0)


def designed_white(ior: float, alpha: float) -> PaintReflectance:
    """A designed paint whose readings are those of a white matt body under a coat."""

    def rule(gamma: Floats) -> Floats:
        out = entering(np.cos(LIGHT - gamma), ior, alpha)
        rho = entering(math.cos(LIGHT), ior, alpha) * out / (1.0 - mean_reflected(ior, alpha))
        return np.repeat(rho[..., None], 3, axis=-1)

    base = AspecularBase(rule, 0.26, 1.9, 1.0, LIGHT, ior, roughness=alpha)
    return PaintReflectance(base, CoatLobe(ior, alpha))


@settings(max_examples=settings.default.max_examples // 4)
@given(st.floats(0.002, 0.6), st.floats(0.0, 85.0), st.floats(1.2, 2.0), st.floats(0.02, 1.0))
def test_a_white_furnace_is_white(alpha: float, angle: float, ior: float, f0: float) -> None:
    """All that reflects without loss: facets of F = 1, facets over a white body, and a coat over one."""
    for white in (
        Ggx(0.0, 1.0, alpha),
        Ggx(1.0, (f0, 0.5, 1.0), alpha),
        CoatLobe(1e9, alpha),
        Coated(Lambertian(1.0), ior, alpha),
        designed_white(ior, alpha),
    ):
        np.testing.assert_allclose(directional_albedo(white, illumination(angle), 32), 1.0, atol=0.005)


@pytest.mark.parametrize("alpha", [0.05, 0.3, 1.0])
@pytest.mark.parametrize("ior", [1.3, 1.7, 3.0])
def test_the_albedo_of_a_coat_is_what_its_lobe_reflects(alpha: float, ior: float) -> None:
    coat, albedo = CoatLobe(ior, alpha), coat_albedo(ior, alpha)
    theta = np.radians([0.0, 50.0, 75.0, 85.0])
    found = directional_albedo(coat, spherical(theta, math.pi), 32)[:, 0]
    np.testing.assert_allclose(albedo.at(np.cos(theta)), found, atol=1.5e-3)
    assert float(albedo.mean) == pytest.approx(float(hemispherical_albedo(coat)[0]), abs=3e-3)


def test_a_smooth_coat_is_fresnels() -> None:
    """As α goes to 0, exactly; and at 75° still at α = .01."""
    cosines = np.linspace(0.0, 1.0, 50)
    np.testing.assert_allclose(
        coat_albedo(1.5, 0.0).at(cosines), fresnel_dielectric(cosines, 1.5), atol=1e-12
    )
    assert float(coat_albedo(1.5, 0.01).at(math.cos(math.radians(75.0)))) == pytest.approx(0.2531, abs=2e-4)
    assert mean_reflected(1.5, 1e-3) == pytest.approx(mean_reflected(1.5), abs=2e-4)


def test_what_several_facets_lose() -> None:
    """F = .5 and a third of the light lost: F_ms = F² Ē/(1 - F (1 - Ē)) = .25 · .6/(1 - .5 · .4) = .1875 at Ē = .6."""
    alpha = 0.8
    lost = 1.0 - hemispherical_albedo(Ggx(0.0, 1.0, alpha, "single"), 64)[0]
    even = 0.5 + 0.5 / 21.0
    single, multiple = (hemispherical_albedo(Ggx(0.0, 0.5, alpha, s), 64)[0] for s in ("single", "multiple"))
    expected = even**2 * (1.0 - lost) / (1.0 - even * lost) * lost
    assert multiple - single == pytest.approx(expected, rel=0.02)
    assert expected > 0.05


def test_the_single_form_loses_what_papers_lose() -> None:
    """Albedo of a white body under α = .1 and .3 at 85°, as measured of the form with 1 - F: .82 and .63."""
    for alpha, seen in ((0.1, 0.82), (0.3, 0.63)):
        model = Coated(Lambertian(1.0), 1.5, alpha, scattering="single")
        assert float(directional_albedo(model, illumination(85.0))[0]) == pytest.approx(seen, abs=0.01)


def test_a_paint_chooses_the_form() -> None:
    white = solid_paint("white", (95.0, 0.0, 0.0))
    matte = Paint(white.name, white.measurements, type(white.gloss)(2.0))
    single = Paint(white.name, white.measurements, type(white.gloss)(2.0), scattering="single")
    made, published = build_paint(matte), build_paint(single)
    assert made.base.roughness == made.coat.roughness > 0.05
    assert (published.base.roughness, published.coat.scattering) == (0.0, "single")
    assert published.base.entering(0.1) == pytest.approx(1.0 - fresnel_dielectric(0.1, published.ior))
    low = illumination(85.0)
    assert directional_albedo(made, low)[1] > directional_albedo(published, low)[1] + 0.1
    # Both are the readings where they were taken.
    wi, wo = illumination(45.0), spherical(0.0, 0.0)
    np.testing.assert_allclose(made.eval(wi, wo), published.eval(wi, wo), rtol=2e-3)


@pytest.mark.parametrize("distribution", DISTRIBUTIONS)
def test_the_packaged_table_is_what_the_command_makes(distribution) -> None:
    table = np.load(resource("shading", "facet_albedo.npy"))[DISTRIBUTIONS.index(distribution)]
    for rough, low in ((1, 3), (9, 20), (20, 40), (32, 64)):
        made = change(distribution, float(ROUGHNESSES[rough]), float(COSINES[low]))
        np.testing.assert_allclose(table[rough, low], made, atol=1.1e-5)

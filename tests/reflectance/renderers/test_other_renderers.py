"""Other renderers' models: what any reflectance promises, and the energy that their formulas keep."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.geometry.directions import illumination, spherical
from brdf_suite.reflectance.albedo import white_furnace
from brdf_suite.reflectance.renderers.carpaint import CarPaint
from brdf_suite.reflectance.renderers.coated_facets import CoatedFacets
from brdf_suite.reflectance.renderers.facet_lobe import RendererLobe, index_of, normal_reflectance
from brdf_suite.reflectance.renderers.surface_shader import SurfaceShader

Model = CoatedFacets | CarPaint | SurfaceShader

BLACK, WHITE = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
RED, BLUE = (0.6, 0.05, 0.02), (0.02, 0.1, 0.5)
MODELS = {
    "gltf": CoatedFacets("gltf", RED, BLUE, 0.2),
    "gltf_solid": CoatedFacets("gltf", RED, BLACK, 1.0),
    "openpbr": CoatedFacets("openpbr", RED, BLUE, 0.2, 1.6, 0.1, grey=0.4),
    "usd": CoatedFacets("usd", RED, BLACK, 0.2, 1.6, 0.01),
    "usd_metal": CoatedFacets("usd", RED, BLACK, 0.2, 1.6, 0.01, metal=True),
    "coated plastic": SurfaceShader(
        base=RED, base_roughness=0.4, specular=1.0, specular_ior=1.5, alpha=0.1, coat=1.0, coat_alpha=0.02
    ),
    "openpbr base": SurfaceShader(base=RED, base_roughness=0.9, compensated=True, subsurface=BLUE),
    "edged metal": SurfaceShader(metalness=1.0, metal_f0=(0.9, 0.6, 0.2), metal_edge=RED, alpha=0.2),
    "conductor": SurfaceShader(
        base=RED, metalness=0.6, metal_f0=(0.9, 0.6, 0.2), metal_edge=RED, conductor=True, alpha=0.2
    ),
    "carpaint": CarPaint(RED, (BLUE, (0.1, 0.0, 0.0), WHITE), (1.0, 0.5, 0.04), (0.5, 0.2, 0.01)),
}


@pytest.fixture(params=MODELS)
def model(request: pytest.FixtureRequest) -> Model:
    return MODELS[request.param]


def test_values_are_finite_and_nothing_is_reflected_below_the_horizon(model: Model) -> None:
    theta, phi = np.meshgrid(np.linspace(0.0, np.pi, 37), np.linspace(0.0, 6.0, 7), indexing="ij")
    wi, wo = spherical(theta, phi).reshape(-1, 1, 3), spherical(theta[:, 0], 0.3)[None]
    value = model.eval(wi, wo)
    above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
    assert np.isfinite(value).all()
    assert value.min() >= 0.0
    assert not value[~above].any()
    inside = (wi[..., 2] > 0.1) & (wo[..., 2] > 0.1)
    assert value[inside].max(axis=-1).min() > 0.0


def test_directions_are_drawn_by_their_density(model: Model) -> None:
    """What is drawn brings as much light as even directions do: the mean of f cos / pdf against the albedo."""
    wo = illumination(40.0)
    u = np.random.default_rng(3).random((200_000, 3))
    wi = model.sample(wo, u)
    density = model.pdf(wi, wo)
    share = np.where(density > 0.0, wi[:, 2].clip(0.0) / np.maximum(density, 1e-9), 0.0)
    found = (model.eval(wi, wo) * share[:, None]).mean(axis=0)
    assert found == pytest.approx(white_furnace(model, wo[None])[0], rel=0.02)


@pytest.mark.parametrize("kind", ["gltf", "openpbr", "usd"])
@pytest.mark.parametrize("alpha", [0.1, 0.5])
def test_white_paint_returns_what_it_gets(kind: str, alpha: float) -> None:
    """A white matt layer under a coat, and a white lobe: nothing is lost towards any view but the outermost."""
    views = illumination(np.array([0.0, 30.0, 60.0]))
    matt = CoatedFacets(kind, WHITE, BLACK, alpha, coat_alpha=0.02)
    np.testing.assert_allclose(white_furnace(matt, views), 1.0, atol=0.015)
    lobe = replace(matt, diffuse=BLACK, specular=WHITE, grey=0.999)
    if kind == "usd":
        lobe = replace(matt, metal=True)
    np.testing.assert_allclose(white_furnace(lobe, views), 1.0, atol=0.03)


def test_an_energy_compensated_white_base_returns_what_it_gets() -> None:
    """Fujii's form, of any roughness: the rough lobe alone loses light."""
    views = illumination(np.array([0.0, 30.0, 60.0, 80.0]))
    for rough in (0.3, 1.0):
        white = SurfaceShader(base=WHITE, base_roughness=rough, compensated=True)
        np.testing.assert_allclose(white_furnace(white, views), 1.0, atol=5e-3)
        assert white_furnace(replace(white, compensated=False), views).min() < 0.98


def test_a_metal_has_its_colours_along_the_normal_and_at_the_edge() -> None:
    gold, edge = np.array([0.9, 0.6, 0.2]), np.array([0.5, 0.7, 0.9])
    cosines = np.array([1.0, 1.0 / 7.0, 0.0])
    schlick = SurfaceShader(metalness=1.0, metal_f0=tuple(gold), metal_edge=tuple(edge))
    plain = replace(schlick, metal_edge=WHITE)
    along, at_edge, grazing = schlick.metal_fresnel(cosines)
    assert along == pytest.approx(gold)
    assert at_edge == pytest.approx(edge * plain.metal_fresnel(cosines)[1])
    assert grazing == pytest.approx([1.0] * 3)
    along, _, grazing = replace(schlick, conductor=True).metal_fresnel(cosines)
    assert along == pytest.approx(gold)
    assert grazing == pytest.approx([1.0] * 3)


def test_a_narrow_lobe_at_the_normal_has_its_known_peak() -> None:
    """Light and view along the normal, α 0.05, f0 0.5: hardly any light meets a second facet."""
    lobe = RendererLobe(0.05)
    normal = np.array([[0.0, 0.0, 1.0]])
    value = lobe.sum_terms(lobe.terms(normal, normal), np.array([0.5]), np.ones(1))
    # 1 / (π α²) · 1/4 · f0
    assert value[0, 0] == pytest.approx(0.125 / (np.pi * 0.05**2), rel=5e-3)


def test_index_and_reflectance_are_inverse() -> None:
    assert index_of(normal_reflectance(1.7)) == pytest.approx(1.7)
    assert normal_reflectance(1.5) == pytest.approx(0.04)

"""Phong, Lafortune, the lobe sum, the coated Phong and GGX against numbers worked out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import ValueRangeError
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import illumination, mirror, spherical
from brdf_suite.geometry.fresnel import fresnel_at
from brdf_suite.reflectance.albedo import directional_albedo, white_furnace
from brdf_suite.reflectance.models.cosine_lobes import CosineLobes
from brdf_suite.reflectance.models.ggx import Ggx
from brdf_suite.reflectance.models.lafortune import Lafortune, LafortuneLobe
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.phong import CoatedPhong, Phong

NORMAL = np.array([0.0, 0.0, 1.0])
AT_45, AT_60 = illumination(45.0), illumination(60.0)


def test_matt_by_hand() -> None:
    np.testing.assert_allclose(
        Lambertian((0.3, 0.6, 0.9)).eval(AT_45, NORMAL), np.array([0.3, 0.6, 0.9]) / math.pi
    )


def test_phong_by_hand() -> None:
    """View along the normal, light at 60°: R·V = 1/2. Modified: .2/π + .3 · 4/(2π)/4 = .35/π.

    Original, n = 2: .2/π + .3 · 3/(2π)/4/cos 60° = .425/π.
    """
    np.testing.assert_allclose(Phong(0.2, 0.3, 2.0).eval(AT_60, NORMAL), 0.35 / math.pi)
    np.testing.assert_allclose(Phong(0.2, 0.3, 2.0, "original").eval(AT_60, NORMAL), 0.425 / math.pi)


def test_modified_phong_sends_back_kd_and_ks_along_the_normal() -> None:
    np.testing.assert_allclose(directional_albedo(Phong(0.2, 0.3, 7.0), NORMAL), 0.5, atol=3e-4)


def test_original_phong_lights_the_furnace_by_kd_and_ks_at_any_view_above_its_lobe() -> None:
    np.testing.assert_allclose(white_furnace(Phong(0.2, 0.3, 5000.0, "original"), AT_60), 0.5, atol=1e-3)


def test_lafortune_by_hand() -> None:
    """Light and view at 45°, mirrored: product = ½ Cx' + ½ Cz with Cx' = -Cx; (.5 · .8 + .5 · 1)³ = .729."""
    model = Lafortune(0.0, (LafortuneLobe((1.0, 2.0, 3.0), -0.8, -0.8, 1.0, 3.0),))
    np.testing.assert_allclose(
        model.eval(AT_45, mirror(AT_45)), np.array([1.0, 2.0, 3.0]) * 0.729, rtol=1e-12
    )
    # Back to the light the product is .5 - .4 = .1.
    np.testing.assert_allclose(model.eval(AT_45, AT_45), np.array([1.0, 2.0, 3.0]) * 1e-3, rtol=1e-9)


def test_lafortune_with_mirror_directions_is_phong() -> None:
    random = np.random.default_rng(1)
    wi, wo = spherical(random.uniform(0, 1.5, (2, 200)), random.uniform(-3, 3, (2, 200)))
    ours = Lafortune(0.2, (LafortuneLobe(0.3 * 22.0 / (2.0 * math.pi), exponent=20.0),))
    np.testing.assert_allclose(ours.eval(wi, wo), Phong(0.2, 0.3, 20.0).eval(wi, wo), atol=1e-12)


def test_lafortune_is_anisotropic_where_cx_and_cy_differ() -> None:
    model = Lafortune(0.0, (LafortuneLobe(1.0, -1.0, -0.2, 1.0, 10.0),))
    wi, turned = spherical(0.7, math.pi), spherical(0.7, math.pi / 2)
    # In the xz plane: product 1. In the yz plane: cos² .7 + .2 sin² .7.
    assert model.eval(wi, mirror(wi))[0] == pytest.approx(1.0)
    across = (math.cos(0.7) ** 2 + 0.2 * math.sin(0.7) ** 2) ** 10
    assert model.eval(turned, mirror(turned))[0] == pytest.approx(across)


def test_the_lobe_sum_by_hand() -> None:
    """R·V = 1/2, cosθi = 1/2: .1 + .2 · (1/2)² + .3 · (1/2)³ / (1/2) = .225; the gloss alone is halved by cosine."""
    model = CosineLobes(0.1, (2.0, 3.0), ((0.2,) * 3, (0.0,) * 3), ((0.0,) * 3, (0.3,) * 3))
    np.testing.assert_allclose(model.eval(AT_60, NORMAL), 0.1 + 0.05 + 0.075, rtol=1e-12)


def test_the_lobe_sum_is_what_the_fit_means_by_it() -> None:
    random = np.random.default_rng(2)
    exponents = np.array([1.0, 16.0, 400.0])
    kd, kdd, kg = random.random(3), random.random((3, 3)), random.random((3, 3))
    wi, wo = spherical(random.uniform(0, 1.5, (2, 300)), random.uniform(-3, 3, (2, 300)))
    fitted = LobeWeights(exponents, kd, kdd, kg, 0.78, 1.5)
    np.testing.assert_allclose(
        CosineLobes(kd, exponents, kdd, kg).eval(wi, wo), fitted.eval(wi, wo), rtol=1e-12
    )


def test_the_coated_phong_by_hand() -> None:
    """Along the normal, n = 1.5: T² (kd + ks (n+2)/2)/π + F (N+1)/2π with F = .04 and T = .96."""
    model = CoatedPhong(0.1, 0.2, 8.0, 1.5, 999.0)
    expected = 0.9216 * (0.1 + 0.2 * 5.0) / math.pi + 0.04 * 1000.0 / (2.0 * math.pi)
    np.testing.assert_allclose(model.eval(NORMAL, NORMAL), expected, rtol=1e-12)


@pytest.mark.parametrize("angle", [0.0, 45.0, 70.0])
def test_the_coat_of_the_coated_phong_reflects_fresnels_share(angle: float) -> None:
    found = directional_albedo(CoatedPhong(0.0, 0.0, 1.0, 1.5, 50_000.0), illumination(angle))
    np.testing.assert_allclose(found, fresnel_at(angle, 1.5), rtol=6e-3)


def test_ggx_by_hand() -> None:
    """Single form, mirror pair at 45°, α = .5: D = 1/(π α²) = 4/π; the shadowing term ½/(2 cosθ √(α² + (1-α²) cos²θ))
    = ½/(2 · .70711 √(.25 + .375)) = .44721; F = .5 + .5 (1 - .70711)⁵ = .50108."""
    fresnel = 0.5 + 0.5 * (1.0 - math.sqrt(0.5)) ** 5
    expected = 4.0 / math.pi * 0.5 / (2.0 * math.sqrt(0.5) * math.sqrt(0.625)) * fresnel
    assert expected == pytest.approx(4.0 / math.pi * 0.447214 * 0.501078, rel=1e-5)
    found = Ggx(0.0, 0.5, 0.5, "single").eval(AT_45, mirror(AT_45))
    np.testing.assert_allclose(found, expected, rtol=1e-12)


@settings(max_examples=settings.default.max_examples // 2)
@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(0.02, 1.0), st.floats(0.0, 88.0))
def test_ggx_never_makes_light(kd: float, f0: float, alpha: float, angle: float) -> None:
    assert directional_albedo(Ggx(kd, f0, alpha), illumination(angle)).max() <= 1.003


@settings(max_examples=settings.default.max_examples // 2)
@given(
    st.floats(0.0, 1.0),
    st.floats(0.0, 1.0),
    st.floats(0.0, 300.0),
    st.floats(1.05, 2.0),
    st.floats(0.0, 88.0),
)
def test_the_coated_phong_never_makes_light(
    kd: float, share: float, n: float, ior: float, angle: float
) -> None:
    model = CoatedPhong(kd, (1.0 - kd) * share, n, ior, 100.0)
    assert model.energy_conserving
    assert directional_albedo(model, illumination(angle)).max() <= 1.003


@settings(max_examples=settings.default.max_examples // 2)
@given(
    st.lists(st.tuples(*[st.floats(-1.2, 1.2)] * 3, st.floats(0.0, 60.0)), min_size=1, max_size=3),
    st.floats(0.0, 88.0),
)
def test_a_lafortune_that_claims_to_conserve_energy_does(rows: list, angle: float) -> None:
    model = Lafortune(0.1, tuple(LafortuneLobe(0.1, x, y, z, n) for x, y, z, n in rows))
    if model.energy_conserving:
        assert directional_albedo(model, illumination(angle)).max() <= 1.003


@pytest.mark.parametrize(
    ("make", "place"),
    [
        (lambda: Lambertian(1.5), r"albedo\[0\]"),
        (lambda: Lambertian((0.1, float("nan"), 0.1)), r"albedo\[1\]"),
        (lambda: Lambertian((0.1, 0.2)), "albedo"),
        (lambda: Phong(0.1, 0.1, -1.0), "exponent"),
        (lambda: Phong(0.1, 0.1, 5.0, "blinn"), "form"),  # type: ignore[arg-type] - what is tested
        (lambda: CosineLobes(0.1, (1.0, 2.0), ((0.1,) * 3,), ((0.1,) * 3,)), "kdd"),
        (lambda: CosineLobes(0.1, (1.0,), ((0.1,) * 3,), ((-0.1,) * 3,)), r"kg\[0\]\[0\]"),
        (lambda: LafortuneLobe(0.1, cx=9.0), "cx"),
        (lambda: Lafortune(0.1, ("lobe",)), r"lobes\[0\]"),  # type: ignore[arg-type] - what is tested
        (lambda: CoatedPhong(ior=0.9), "ior"),
        (lambda: Ggx(alpha=0.0), "alpha"),
    ],
)
def test_a_bad_parameter_is_named(make, place: str) -> None:
    with pytest.raises(ValueRangeError, match=f"^{place}:"):
        make()

"""The base of a paint seen through its coat."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.geometry.directions import aspecular_angle, aspecular_view, illumination, spherical
from brdf_suite.geometry.fresnel import fresnel_at
from brdf_suite.reflectance.albedo import normal_albedo
from brdf_suite.reflectance.designed.aspecular_base import AspecularBase
from brdf_suite.reflectance.designed.rules import PolynomialRule

LIGHT = math.radians(45.0)
directions = st.builds(spherical, st.floats(0.0, 1.56), st.floats(-3.1, 3.1))


def base_of(rho: tuple = (1.0, 0.5, 0.3), near: float = 1.0, ior: float = 1.5) -> AspecularBase:
    angles = np.radians([15.0, 45.0, 110.0])
    rule = PolynomialRule.through(angles, np.array(rho)[:, None] * [1.0, 0.8, 0.5])
    return AspecularBase(rule, float(angles[0]), float(angles[-1]), near, LIGHT, ior)


def test_under_the_instruments_light_a_reading_is_returned_as_taken() -> None:
    found = math.pi * base_of().eval(illumination(45.0), aspecular_view(45.0, [15.0, 45.0, 110.0]))
    np.testing.assert_allclose(found, np.outer([1.0, 0.5, 0.3], [1.0, 0.8, 0.5]), rtol=1e-12)


def test_elsewhere_the_light_passes_the_coat_with_other_shares() -> None:
    """Light at 60°, view at 15° on its other side: γ = 45°, so ρ(45) T(60) T(15) / (T(45) T(0))."""
    t = {angle: 1.0 - fresnel_at(angle, 1.5) for angle in (0, 15, 45, 60)}
    found = base_of().eval(illumination(60.0), aspecular_view(60.0, 45.0))
    expected = 0.5 / math.pi * t[60] * t[15] / (t[45] * t[0])
    np.testing.assert_allclose(found, expected * np.array([1.0, 0.8, 0.5]), rtol=1e-12)


def test_beyond_the_last_reading_the_value_is_held() -> None:
    base = base_of()
    far = base.reflectance_factor(np.radians([110.0, 125.0, 170.0]))
    np.testing.assert_allclose(far, np.broadcast_to(far[0], (3, 3)), rtol=1e-12)
    # γ = 140°, light 75° and view 65° on the same side: only the transmissions differ from γ = 110°.
    t = {angle: 1.0 - fresnel_at(angle, 1.5) for angle in (45, 65, 75)}
    found = base.eval(illumination(75.0), aspecular_view(75.0, 140.0))
    np.testing.assert_allclose(found[0], 0.3 / math.pi * t[75] * t[65] / (t[45] * t[65]), rtol=1e-12)


def test_out_of_the_plane_only_the_aspecular_angle_counts() -> None:
    base = base_of(ior=1.0)
    rng = np.random.default_rng(4)
    wi = spherical(rng.uniform(0.2, 1.4, 200), rng.uniform(-3, 3, 200))
    wo = spherical(rng.uniform(0.2, 1.4, 200), rng.uniform(-3, 3, 200))
    expected = base.reflectance_factor(aspecular_angle(wi, wo)) / math.pi
    np.testing.assert_allclose(base.eval(wi, wo), expected, rtol=1e-7)


def test_near_specular_scales_the_mirror_direction_and_fades_to_the_first_reading() -> None:
    plain, scaled = base_of(), base_of(near=1.6)
    angles = np.radians(np.linspace(0.0, 110.0, 221))
    ratio = scaled.reflectance_factor(angles)[:, 0] / np.maximum(plain.reflectance_factor(angles)[:, 0], 1e-9)
    assert ratio[0] == pytest.approx(1.6)
    assert np.all(np.diff(ratio[:31]) < 0.0), "it falls all the way to 15°"
    np.testing.assert_array_equal(
        scaled.reflectance_factor(angles[30:]), plain.reflectance_factor(angles[30:])
    )


@given(directions, directions)
def test_it_is_reciprocal_and_never_negative(wi, wo) -> None:
    base = base_of((1.3, 0.32, 0.09))
    there = base.eval(wi, wo)
    assert there.min() >= 0.0
    np.testing.assert_allclose(there, base.eval(wo, wi), rtol=1e-7, atol=1e-12)


def test_a_rule_below_zero_is_black_there() -> None:
    rho = base_of((1.3, 0.32, 0.09)).reflectance_factor(np.radians(80.0))
    np.testing.assert_array_equal(rho, 0.0)


def test_below_the_horizon_there_is_nothing() -> None:
    up, down = np.array([0.0, 0.6, 0.8]), np.array([0.0, -0.6, -0.8])
    for wi, wo in ((up, down), (down, up), (down, down), ([1.0, 0, 0], up), (up, [1.0, 0, 0])):
        np.testing.assert_array_equal(base_of().eval(wi, wo), 0.0)


def test_the_albedo_of_a_perfect_diffuser_is_one() -> None:
    rule = PolynomialRule(np.array([[1.0, 1.0, 1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]))
    bare = AspecularBase(rule, 0.2, 1.9, 1.0, LIGHT, 1.0)
    np.testing.assert_allclose(normal_albedo(bare), 1.0, rtol=1e-12)
    # Under a coat of n = 1.5 the light along the normal leaves as T(0)T(θ)/(T(45)T(45-θ)); by a fine sum:
    coated = AspecularBase(rule, 0.2, 1.9, 1.0, LIGHT, 1.5)
    theta = (np.arange(20_000) + 0.5) * math.pi / 40_000
    wo = np.stack((np.sin(theta), 0.0 * theta, np.cos(theta)), axis=-1)
    value = coated.eval([0.0, 0.0, 1.0], wo)[:, 0]
    expected = 2.0 * math.pi * np.sum(value * np.cos(theta) * np.sin(theta)) * math.pi / 40_000
    assert normal_albedo(coated)[0] == pytest.approx(expected, rel=5e-4)


def test_directions_broadcast() -> None:
    wi, wo = spherical(np.linspace(0, 1, 4), 0.0)[:, None], spherical(np.linspace(0, 1, 5), 1.0)
    assert base_of().eval(wi, wo).shape == (4, 5, 3)
    np.testing.assert_allclose(base_of().eval(wi, wo)[2, 3], base_of().eval(wi[2, 0], wo[3]), rtol=1e-12)

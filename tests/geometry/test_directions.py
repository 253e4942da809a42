"""Directions, the aspecular angle and half-angle coordinates."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.geometry.directions import (
    angle_between,
    aspecular_angle,
    aspecular_view,
    from_half_angle_coordinates,
    half_angle_coordinates,
    illumination,
    mirror,
    spherical,
)

polar = st.floats(0.0, 1.55)
azimuth = st.floats(-math.pi, math.pi)


def test_the_frame() -> None:
    np.testing.assert_allclose(spherical(0.0, 1.0), [0, 0, 1], atol=1e-15)
    np.testing.assert_allclose(spherical(math.pi / 2, 0.0), [1, 0, 0], atol=1e-15)
    np.testing.assert_allclose(spherical(math.pi / 2, math.pi / 2), [0, 1, 0], atol=1e-15)
    assert spherical(np.zeros((4, 1)), np.zeros(3)).shape == (4, 3, 3)
    np.testing.assert_array_equal(mirror([0.6, -0.1, 0.7]), [-0.6, 0.1, 0.7])


@pytest.mark.parametrize(
    ("gamma", "view_polar"), [(15, 30), (45, 0), (110, -65), (-15, 60), (25, 20), (75, -30)]
)
def test_the_instrument_looks_where_the_standard_says(gamma: float, view_polar: float) -> None:
    """E2194: light at 45°, view polar = 45° - γ, and the mirror direction at +45°."""
    wi, wo = illumination(45.0), aspecular_view(45.0, gamma)
    theta = math.radians(view_polar)
    np.testing.assert_allclose(wo, [math.sin(theta), 0.0, math.cos(theta)], atol=1e-15)
    np.testing.assert_allclose(mirror(wi), [math.sqrt(0.5), 0.0, math.sqrt(0.5)], atol=1e-15)
    assert math.degrees(aspecular_angle(wi, wo)) == pytest.approx(gamma, abs=1e-12)


@pytest.mark.parametrize(("gamma", "theta_h", "theta_d"), [(15, 7.5, 37.5), (45, 22.5, 22.5), (110, 55, 10)])
def test_half_angles_of_the_instrument(gamma: float, theta_h: float, theta_d: float) -> None:
    found = half_angle_coordinates(illumination(45.0), aspecular_view(45.0, gamma))
    assert math.degrees(found[0]) == pytest.approx(theta_h, abs=1e-12)
    assert math.degrees(found[2]) == pytest.approx(theta_d, abs=1e-12)


@given(polar, azimuth, polar, azimuth)
def test_half_angles_and_back(ti: float, pi: float, to: float, po: float) -> None:
    wi, wo = spherical(ti, pi), spherical(to, po)
    again_i, again_o = from_half_angle_coordinates(*half_angle_coordinates(wi, wo))
    np.testing.assert_allclose(again_i, wi, atol=1e-12)
    np.testing.assert_allclose(again_o, wo, atol=1e-12)


@given(polar, azimuth, polar, azimuth, azimuth)
def test_the_aspecular_angle_turns_with_the_frame(
    ti: float, pi: float, to: float, po: float, turn: float
) -> None:
    plain = aspecular_angle(spherical(ti, pi), spherical(to, po))
    turned = aspecular_angle(spherical(ti, pi + turn), spherical(to, po + turn))
    assert abs(plain) == pytest.approx(abs(turned), abs=1e-12)
    assert abs(plain) == pytest.approx(float(angle_between(mirror(spherical(ti, pi)), spherical(to, po))))


def test_it_is_signed_in_the_plane_only_and_in_any_plane() -> None:
    for turn in (0.0, 0.7, -2.0, math.pi):
        wi = spherical(math.radians(45), turn + math.pi)
        assert math.degrees(aspecular_angle(wi, spherical(math.radians(60), turn))) == pytest.approx(-15)
        assert math.degrees(aspecular_angle(wi, spherical(math.radians(30), turn))) == pytest.approx(15)
        assert aspecular_angle(wi, spherical(math.radians(60), turn + 0.01)) > 0.0


def test_tiny_angles_are_exact() -> None:
    u = np.array([0.0, 0.0, 1.0])
    v = np.array([1e-10, 0.0, 1.0])
    assert float(angle_between(u, v)) == pytest.approx(1e-10, rel=1e-9)
    assert float(angle_between(u, -u)) == pytest.approx(math.pi)

"""Glare as the eye scatters it: against the CIE's simpler formula, and without a change of the light there is."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.appearance.glare import (
    WHITE,
    WIDEST_DEG,
    gaussian_shares,
    pixel_angle,
    scattered_light,
    spread_glare,
)
from brdf_suite.errors import ValueRangeError


@pytest.mark.parametrize(("age", "pigmentation"), [(25.0, 0.0), (35.0, 0.5), (70.0, 1.2)])
def test_it_is_the_general_disability_glare_of_the_cie(age: float, pigmentation: float) -> None:
    # CIE 146:2002, equation for .1 to 100 degrees, within the difference of the two formulas.
    angle = np.array([2.0, 5.0, 10.0, 20.0, 30.0])
    cie = (
        10.0 / angle**3
        + (5.0 / angle**2 + 0.1 * pigmentation / angle) * (1.0 + (age / 62.5) ** 4)
        + 2.5e-3 * pigmentation
    )
    np.testing.assert_allclose(scattered_light(angle, age, pigmentation) / cie, 1.0, atol=0.22)


def test_old_and_light_eyes_scatter_more() -> None:
    young = scattered_light([3.0, 10.0])
    assert (scattered_light([3.0, 10.0], age_years=70.0) > 1.3 * young).all()
    assert (scattered_light([3.0, 10.0], pigmentation=1.2) > young).all()


def test_no_light_is_added_and_what_is_below_white_stays() -> None:
    rng = np.random.default_rng(5)
    dark = rng.random((40, 60, 3))
    assert np.array_equal(spread_glare(dark, 0.05), dark)
    light = np.full((160, 200, 3), 0.2)
    light[80, 100] = [900.0, 300.0, 30.0]
    found = spread_glare(light, 0.8)
    # The light is in the middle, farther than glare reaches from every edge.
    assert min(80, 100) * 0.8 > WIDEST_DEG
    excess = light[80, 100] - WHITE
    assert np.abs((found - light).sum(axis=(0, 1)) / excess).max() < 1e-6
    beside = found[80, 105] - 0.2
    expected = scattered_light(4.0) * np.radians(0.8) ** 2 * excess
    np.testing.assert_allclose(beside, expected, rtol=1e-6)
    assert (found[80, 100] < light[80, 100]).all()


@pytest.mark.parametrize("angle", [0.0002, 0.0499, 0.0501])
def test_what_is_taken_hangs_little_on_the_size_of_pixels(angle: float) -> None:
    light = np.zeros((3, 3, 3))
    light[1, 1] = 1.0 + 1e4
    found = spread_glare(light, angle)
    assert (1e4 + 1.0 - found[1, 1, 0]) / 1e4 == pytest.approx(0.42, abs=0.02)


def test_a_large_picture_has_the_glare_of_a_small_one() -> None:
    large = np.full((150, 2600, 3), 0.2)
    large[60:75, 900:930] = 700.0
    small = large.reshape(30, 5, 520, 5, 3).mean(axis=(1, 3))
    found = spread_glare(large, 0.02).reshape(30, 5, 520, 5, 3).mean(axis=(1, 3))
    expected = spread_glare(small, 0.1)
    far = np.abs(np.arange(520) - 183) > 8
    np.testing.assert_allclose(found[:, far] - 0.2, expected[:, far] - 0.2, rtol=0.05, atol=1e-4)
    assert found[:, far].max() > 0.25


def test_gaussians_have_the_shape_of_the_glare() -> None:
    spreads = tuple(0.15 * 2.0**k for k in range(8))
    shares = np.array(gaussian_shares(spreads))
    assert (shares >= 0.0).all()
    angle = np.geomspace(0.3, 20.0, 40)[:, None]
    bells = np.exp(-0.5 * (angle / spreads) ** 2) / (2.0 * np.pi * np.radians(spreads) ** 2)
    assert np.abs(bells @ shares / scattered_light(angle[:, 0]) - 1.0).max() < 0.2


def test_the_angle_of_a_pixel() -> None:
    assert pixel_angle(50.0, 1280, 36.0) == pytest.approx(np.degrees(36.0 / 50.0 / 1280.0))


@pytest.mark.parametrize(
    ("light", "angle"),
    [
        (np.ones((4, 4)), 0.1),
        (np.ones((4, 4, 4)), 0.1),
        (np.ones((4, 4, 3)), 0.0),
        (np.ones((4, 4, 3)), 31.0),
    ],
)
def test_other_arrays_are_refused(light: np.ndarray, angle: float) -> None:
    with pytest.raises(ValueRangeError):
        spread_glare(light, angle)

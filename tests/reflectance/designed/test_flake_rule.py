"""The bell of flake tilts."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import lab_to_working
from brdf_suite.reflectance.designed.rules import FlakeRule, squared_tilt

LIGHT = math.radians(45.0)
ANGLES = np.radians([15.0, 45.0, 110.0])


def test_the_tilts_of_the_table() -> None:
    """With n = 1.5 the light leans 28.126° inside; the views 19.471°, 0° and -37.171°; half the sums."""
    tilts = np.degrees(np.arctan(np.sqrt(squared_tilt(ANGLES, LIGHT, 1.5))))
    np.testing.assert_allclose(tilts, [4.33, 14.06, 32.65], atol=0.005)
    assert float(squared_tilt(np.array(0.0), LIGHT, 1.5)) == pytest.approx(0.0, abs=1e-30)


def test_every_paint_is_solved_with_a_physical_spread(
    computed_labs: dict[str, np.ndarray], invented_labs: dict[str, np.ndarray]
) -> None:
    spreads = {}
    for name, labs in (computed_labs | invented_labs).items():
        rule = FlakeRule.through(ANGLES, lab_to_working(labs), LIGHT, 1.5)
        assert rule is not None, name
        np.testing.assert_allclose(rule(ANGLES), lab_to_working(labs), rtol=1e-9, atol=1e-12)
        spreads[name] = rule.spread
    found = np.array(list(spreads.values()))
    assert found.min() == pytest.approx(0.146, abs=0.0011)
    assert found.max() == pytest.approx(0.191, abs=0.0011)
    for name in computed_labs:
        assert max(spreads[name]) - min(spreads[name]) < 0.001, f"{name}: one set of flakes, one spread"


def test_it_flattens_towards_the_mirror_direction() -> None:
    """ρ(0) of L* 128/62/36 is 2.35 by this rule, less than by any rule that runs away."""
    greys = lab_to_working([(128.0, 0.0, 0.0), (62.0, 0.0, 0.0), (36.0, 0.0, 0.0)])
    rule = FlakeRule.through(ANGLES, greys, LIGHT, 1.5)
    assert rule is not None
    np.testing.assert_allclose(rule(np.array(0.0)), 2.35, atol=0.005)


@settings(max_examples=2 * settings.default.max_examples)
@given(st.floats(0.0, 0.5), st.floats(0.01, 3.0), st.floats(0.09, 0.6), st.floats(1.4, 1.6))
def test_a_known_bell_comes_back(ground: float, height: float, m: float, ior: float) -> None:
    bell = np.exp(-squared_tilt(ANGLES, LIGHT, ior) / m**2)
    rho = np.repeat((ground + height * bell)[:, None], 3, axis=1)
    rule = FlakeRule.through(ANGLES, rho, LIGHT, ior)
    assert rule is not None
    assert rule.spread[0] == pytest.approx(m, rel=1e-5)
    np.testing.assert_allclose(rule.ground, ground, atol=1e-6)
    np.testing.assert_allclose(rule.height, height, rtol=1e-5)


@settings(max_examples=settings.default.max_examples // 2)
@given(st.floats(0.0, 0.5), st.floats(0.1, 3.0), st.floats(0.1, 0.5))
def test_more_angles_are_fitted_by_least_squares(ground: float, height: float, m: float) -> None:
    angles = np.radians([15.0, 25.0, 45.0, 75.0, 110.0])
    rho = np.repeat((ground + height * np.exp(-squared_tilt(angles, LIGHT, 1.5) / m**2))[:, None], 3, axis=1)
    rule = FlakeRule.through(angles, rho, LIGHT, 1.5)
    assert rule is not None
    assert rule.spread[0] == pytest.approx(m, rel=1e-4)
    np.testing.assert_allclose(rule(angles), rho, atol=1e-6)


def test_it_is_solvable_where_the_ratio_exceeds_its_limit() -> None:
    """The limit for 15/45/110° and n = 1.5 is (x45 - x15)/(x110 - x45) = .164, stated as .165."""

    def solvable(ratio: float) -> bool:
        rho = np.repeat(np.array([[1.0 + ratio], [1.0], [0.0]]), 3, axis=1)
        return FlakeRule.through(ANGLES, rho, LIGHT, 1.5) is not None

    assert not solvable(0.160)
    assert solvable(0.170)
    assert solvable(50.0)


@pytest.mark.parametrize(
    "values",
    [
        (0.5, 0.7, 0.4),  # a hump
        (0.5, 0.3, 0.4),  # a dip
        (0.50, 0.49, 0.1),  # flat, then steep: no bell
        (0.0, 0.1, 0.101),  # rising so fast that it would be negative in the mirror direction
    ],
)
def test_what_no_flakes_give_is_not_solved(values: tuple) -> None:
    assert FlakeRule.through(ANGLES, np.repeat(np.array(values)[:, None], 3, axis=1), LIGHT, 1.5) is None


@pytest.mark.parametrize("degrees", [(60.0, 80.0, 100.0), (50.0, 60.0, 70.0, 80.0)])
def test_readings_far_out_do_not_invent_a_mirror_direction(degrees: tuple) -> None:
    """They see only the foot of a steep bell; its top would be thousands of times brighter."""
    rho = np.repeat(10.0 ** -np.arange(0.0, 3.0 * len(degrees), 3.0)[:, None], 3, axis=1)
    assert FlakeRule.through(np.radians(degrees), rho, LIGHT, 1.5) is None


def test_a_flat_channel_has_no_spread() -> None:
    rule = FlakeRule.through(
        ANGLES, np.array([[0.5, 0.6, 0.0], [0.5, 0.3, 0.0], [0.5, 0.2, 0.0]]), LIGHT, 1.5
    )
    assert rule is not None
    assert rule.spread[0] is None
    assert rule.spread[1] is not None
    assert rule.spread[2] is None
    np.testing.assert_array_equal(rule(np.linspace(0, 2, 7))[:, [0, 2]], [[0.5, 0.0]] * 7)

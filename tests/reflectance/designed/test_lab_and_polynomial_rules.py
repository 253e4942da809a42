"""The monotone and the polynomial rule, against scipy and numbers worked out by hand."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.interpolate import PchipInterpolator

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, lab_to_working, working_to_lab
from brdf_suite.reflectance.designed.rules import MonotoneRule, PolynomialRule, pchip_slopes

ANGLES = np.radians([15.0, 45.0, 110.0])
SILVER = lab_to_working([(128.0, 0.0, 0.0), (62.0, 0.0, 0.0), (36.0, 0.0, 0.0)])


@example([(20.0, 0.0, 0.0), (20.0, 0.0, 2.2e-313), (20.0, 0.0, 0.0)], Random(0))
@example([(20.0, 0.0, 0.0), (20.0, 0.0, 0.0), (20.0, 0.0, 2.2e-309)], Random(0))
@example([(20.0, 0.0, 0.0), (20.0, 0.0, 2.2e-313), (20.0, 0.0, 40.0)], Random(0))
@given(
    st.lists(
        st.tuples(st.floats(20.0, 130.0), st.floats(-40.0, 40.0), st.floats(-40.0, 40.0)),
        min_size=2,
        max_size=6,
    ),
    st.randoms(use_true_random=False),
)
def test_the_monotone_rule_is_pchip_in_lab(labs: list, random) -> None:
    knots = np.cumsum([random.uniform(0.1, 0.7) for _ in labs])
    angles = np.linspace(knots[0], knots[-1], 37)
    rule = MonotoneRule.through(knots, lab_to_working(labs))
    with np.errstate(
        over="ignore"
    ):  # scipy divides by the secants; where that gives inf its slope is 0 as it should
        expected = PchipInterpolator(knots, labs)(angles)
    np.testing.assert_allclose(working_to_lab(rule(angles)), expected, atol=1e-7)
    np.testing.assert_allclose(rule(knots), lab_to_working(labs), atol=1e-9)


@pytest.mark.parametrize(
    ("left", "right"),
    [(2.2e-313, 1e-5), (40.0, 2.2e-313), (2.2e-313, 4.4e-313), (-1e-309, -1e300), (1e300, 1e300), (2.0, 5.0)],
)
def test_slopes_are_the_weighted_harmonic_mean_however_flat_or_steep(left: float, right: float) -> None:
    width = [0.25, 0.75]
    slope = pchip_slopes(np.array(width)[:, None], np.array([[left], [right]]))[1, 0]
    first, second = (Fraction(w) for w in width)
    weights = 2 * second + first, second + 2 * first
    mean = sum(weights) / (weights[0] / Fraction(left) + weights[1] / Fraction(right))
    assert slope == pytest.approx(float(mean), rel=1e-12, abs=1e-322)


def test_towards_the_mirror_direction_it_runs_away() -> None:
    """ρ(0) of L* 128/62/36 is 3.7 by PCHIP carried on."""
    np.testing.assert_allclose(MonotoneRule.through(ANGLES, SILVER)(np.array(0.0)), 3.7, atol=0.05)


def test_a_lightness_below_zero_is_black() -> None:
    rule = MonotoneRule.through(ANGLES, lab_to_working([(5.0, 0, 0), (60.0, 0, 0), (90.0, 0, 0)]))
    np.testing.assert_allclose(rule(np.array([0.0])), 0.0, atol=1e-12)


def test_the_polynomial_passes_the_readings_and_may_turn_negative() -> None:
    """L* 128/62/36 gives Y(80°) = -0.37 and Y(0°) = 3.1."""
    rule = PolynomialRule.through(ANGLES, SILVER)
    np.testing.assert_allclose(rule(ANGLES), SILVER, atol=1e-13)
    luminance = rule(np.radians([80.0, 0.0])) @ LUMINANCE
    assert luminance[0] == pytest.approx(-0.37, abs=0.005)
    assert luminance[1] == pytest.approx(3.1, abs=0.05)


def test_more_angles_give_the_least_squares_polynomial() -> None:
    rng = np.random.default_rng(2)
    angles, rho = np.radians([15.0, 25.0, 45.0, 75.0, 110.0]), rng.uniform(0.1, 1.0, (5, 3))
    rule = PolynomialRule.through(angles, rho)
    for channel in range(3):
        expected = np.polyfit(angles, rho[:, channel], 2)[::-1]
        np.testing.assert_allclose(rule.coefficients[:, channel], expected, rtol=1e-9)

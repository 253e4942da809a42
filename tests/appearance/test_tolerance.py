"""Differences per angle with the user's tolerances."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.difference import delta_e_76, delta_e_2000
from brdf_suite.appearance.tolerance import DIFFERENCES, Tolerances, judge
from brdf_suite.errors import ValueRangeError

ANGLES = (15.0, 45.0, 110.0)
STANDARD = np.array([[62.0, -4.0, -45.0], [25.0, 4.0, -38.0], [9.0, 8.0, -28.0]])


def test_each_angle_has_its_own_tolerance() -> None:
    batch = STANDARD + np.array([[1.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.0, 0.0, 0.0]])
    verdict = judge(ANGLES, STANDARD, batch, Tolerances({15.0: 1.2, 45.0: 0.4}, difference="76"))
    assert [row.passes for row in verdict.angles] == [True, False, None]
    assert [row.difference for row in verdict.angles] == pytest.approx([1.0, 0.5, 0.0])
    assert verdict.passes is False
    assert judge(ANGLES, STANDARD, batch, Tolerances({}, 1.2, "76")).passes is True
    assert judge(ANGLES, STANDARD, batch, Tolerances({})).passes is None


def test_components_by_hand() -> None:
    """From (3, 4) to (4, 3): chroma stays 5, the hue turns back by 16.26°, ΔH = 2·5·sin(8.13°) = √2."""
    verdict = judge([45.0], [[50.0, 3.0, 4.0]], [[52.0, 4.0, 3.0]], Tolerances({}))
    row = verdict.angles[0]
    assert (row.lightness, row.chroma) == (2.0, pytest.approx(0.0, abs=1e-12))
    assert row.hue == pytest.approx(-np.sqrt(2.0))
    # Across hue 0 the turn is short, not 356°.
    row = judge([45.0], [[50.0, 10.0, -0.3]], [[50.0, 10.0, 0.3]], Tolerances({})).angles[0]
    assert row.hue == pytest.approx(0.6, abs=1e-3)


@settings(max_examples=60, deadline=None)
@given(*[st.tuples(st.floats(0, 120), st.floats(-90, 90), st.floats(-90, 90)) for _ in range(2)])
def test_the_components_make_up_the_difference(first: tuple, second: tuple) -> None:
    row = judge([45.0], [first], [second], Tolerances({}, difference="76")).angles[0]
    whole = np.sqrt(row.lightness**2 + row.chroma**2 + row.hue**2)
    assert whole == pytest.approx(float(delta_e_76(first, second)), abs=1e-5)


def test_every_difference_can_be_chosen() -> None:
    batch = STANDARD + 0.7
    seen = {name: judge(ANGLES, STANDARD, batch, Tolerances({}, 1.0, name)).angles for name in DIFFERENCES}
    first = [rows[0].difference for rows in seen.values()]
    assert len({round(value, 6) for value in first}) == len(DIFFERENCES)
    assert seen["2000"][1].difference == pytest.approx(float(delta_e_2000(STANDARD[1], batch[1])))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (({15.0: -1.0},), "tolerance at 15°"),
        (({}, float("nan")), "a number from 0"),
        (({}, 1.0, "DIN 6175"), "2000, 76, cmc21, cmc11, cam02ucs"),
    ],
)
def test_bad_tolerances_are_refused(arguments: tuple, words: str) -> None:
    with pytest.raises(ValueRangeError, match=words):
        Tolerances(*arguments)


def test_readings_must_fit_the_angles() -> None:
    with pytest.raises(ValueRangeError, match="3 L\\*a\\*b\\* values"):
        judge(ANGLES, STANDARD[:2], STANDARD[:2], Tolerances({}))

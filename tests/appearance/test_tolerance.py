"""Differences per angle with the user's tolerances."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.difference.formulas import delta_e_76, delta_e_2000, delta_e_cmc
from brdf_suite.appearance.difference.tolerance import (
    DIFFERENCES,
    TITLES,
    Limits,
    Tolerances,
    difference_title,
    judge,
)
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


def test_components_have_limits_of_their_own() -> None:
    batch = STANDARD + np.array([[0.6, 0.0, 0.0], [0.0, 0.0, 0.9], [0.0, 0.3, 0.0]])
    limits = Limits(lightness=0.5, chroma=0.8, hue=0.4)
    verdict = judge(ANGLES, STANDARD, batch, Tolerances({15.0: limits, 45.0: limits}, Limits(difference=2.0)))
    assert [row.exceeded for row in verdict.angles] == [("lightness",), ("chroma",), ()]
    assert [row.passes for row in verdict.angles] == [False, False, True]
    assert verdict.passes is False
    # Each size counts, whichever way the difference goes.
    back = judge(ANGLES, batch, STANDARD, Tolerances({}, limits))
    assert back.angles[0].exceeded == ("lightness",)


def test_an_ellipsoid_judges_the_components_together() -> None:
    """Each 0.8 of its half axis: alone all pass, together 3 · 0.64 is beyond 1."""
    reference, sample = (50.0, 10.0, 0.0), (50.8, 10.8, 0.0)
    box = Limits(lightness=1.0, chroma=1.0)
    assert judge([45.0], [reference], [sample], Tolerances({}, box)).passes is True
    verdict = judge([45.0], [reference], [sample], Tolerances({}, replace(box, ellipsoid=True)))
    assert verdict.angles[0].exceeded == ("ellipsoid",)
    inside = replace(box, lightness=1.2, chroma=1.2, ellipsoid=True)
    assert judge([45.0], [reference], [sample], Tolerances({}, inside)).passes is True
    none = Limits(lightness=0.0, ellipsoid=True)
    assert judge([45.0], [reference], [reference], Tolerances({}, none)).passes is True
    assert judge([45.0], [reference], [sample], Tolerances({}, none)).passes is False


def test_cmc_takes_weights_of_ones_own() -> None:
    own = judge(ANGLES, STANDARD, STANDARD + 1.0, Tolerances({}, difference="cmc:1.4:0.7"))
    expected = delta_e_cmc(STANDARD, STANDARD + 1.0, 1.4, 0.7)
    assert [row.difference for row in own.angles] == pytest.approx(expected.tolist())
    assert difference_title("cmc:1.4:0.7") == "CMC(1.4:0.7)"
    assert {difference_title(name) for name in DIFFERENCES} == set(TITLES.values())
    for wrong in ("cmc:0:1", "cmc:2", "cmc:-1:1", "din"):
        with pytest.raises(ValueRangeError, match="difference"):
            Tolerances({}, difference=wrong)


@pytest.mark.parametrize("value", [-0.1, float("nan"), float("inf")])
@pytest.mark.parametrize("part", ["difference", "lightness", "chroma", "hue"])
def test_a_limit_that_is_no_size_is_refused(part: str, value: float) -> None:
    with pytest.raises(ValueRangeError, match=part):
        Limits(**{part: value})

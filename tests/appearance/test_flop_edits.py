"""Moves of all readings in step, and of the flop about a face that stays."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.spaces import lab_to_lch, lch_to_lab
from brdf_suite.appearance.flop.edits import (
    flop_ends,
    hue_difference,
    measure_flop,
    shift_labs,
    shift_lchs,
    unwrap_hues,
    with_flop_index,
    with_flop_travel,
)
from brdf_suite.appearance.flop.travel import flop_index, travel
from brdf_suite.errors import ValueRangeError

THREE = (15.0, 45.0, 110.0)
SIX = (-15.0, 15.0, 25.0, 45.0, 75.0, 110.0)
BLUE = np.array([[62.0, -4.0, -45.0], [25.0, 4.0, -38.0], [9.0, 8.0, -28.0]])
labs = st.tuples(st.floats(1.0, 140.0), st.floats(-90.0, 90.0), st.floats(-90.0, 90.0))
angle_sets = st.sampled_from([THREE, SIX])


@st.composite
def readings(draw: st.DrawFn) -> tuple[tuple[float, ...], np.ndarray]:
    angles = draw(angle_sets)
    return angles, np.array([draw(labs) for _ in angles])


@given(labs)
def test_lch_and_back_is_the_same_colour(lab: tuple[float, float, float]) -> None:
    lch = lab_to_lch(lab)
    assert 0.0 <= lch[2] < 360.0
    assert lch[1] >= 0.0
    assert lch_to_lab(lch) == pytest.approx(lab, abs=1e-9)


@given(readings(), st.floats(0.0, 40.0))
def test_the_flop_index_is_the_one_asked_for_and_the_face_stays(given_readings, wanted: float) -> None:
    angles, lab = given_readings
    moved = with_flop_index(angles, lab, wanted)
    face = angles.index(45.0)
    assert moved[face].tolist() == lab[face].tolist()
    assert moved[:, 1:].tolist() == lab[:, 1:].tolist()
    assert moved[:, 0].min() >= 0.0
    l15, l45, l110 = (float(moved[angles.index(angle), 0]) for angle in THREE)
    assert flop_index(l15, l45, l110).value == pytest.approx(wanted, abs=1e-6)


@given(readings(), st.integers(0, 2), st.floats(-60.0, 60.0))
def test_a_travel_is_the_one_asked_for_and_the_face_stays(
    given_readings, component: int, wanted: float
) -> None:
    angles, lab = given_readings
    assume(np.hypot(lab[:, 1], lab[:, 2]).min() > 1.0)
    moved = with_flop_travel(angles, lab, component, wanted)
    face = angles.index(45.0)
    assert moved[face].tolist() == lab[face].tolist()
    now = measure_flop(angles, moved)
    got = (now.lightness, now.chroma, now.hue_deg)[component]
    if component == 2:
        # Beyond a half turn on one side of the face the short way is another one.
        turn = travel(angles, moved).hue_deg if angles == THREE else got
        assert hue_difference(wanted, got) == pytest.approx(0.0, abs=1e-6)
        assert abs(hue_difference(wanted, turn)) < 1e-6
    else:
        assert got == pytest.approx(wanted, abs=1e-6)
    kept = [c for c in range(3) if c != component]
    before, after = lab_to_lch(lab), lab_to_lch(moved)
    grey = after[:, 1] < 1e-6
    for c in kept:
        if c == 2:
            turned = [hue_difference(a, b) for a, b in zip(before[~grey, 2], after[~grey, 2], strict=True)]
            assert np.abs(turned).max(initial=0.0) < 1e-6
        else:
            assert after[:, c] == pytest.approx(before[:, c], abs=1e-9)


def test_known_moves_of_the_blue() -> None:
    assert measure_flop(THREE, BLUE).index == pytest.approx(2.69 * 53.0**1.11 / 25.0**0.86)
    assert measure_flop(THREE, BLUE).hue_deg == pytest.approx(travel(THREE, BLUE).hue_deg)
    flat = with_flop_index(THREE, BLUE, 0.0)
    assert flat[:, 0].tolist() == [25.0, 25.0, 25.0]
    # From a solid a travel parts as a metallic has it: 0.7 of it before the face.
    metallic = with_flop_travel(THREE, flat, 0, -40.0)
    assert metallic[:, 0] == pytest.approx([53.0, 25.0, 13.0])
    # What the far end cannot give is given by the near end.
    assert with_flop_travel(THREE, flat, 0, -100.0)[:, 0] == pytest.approx([100.0, 25.0, 0.0])
    # The course keeps its proportions.
    assert with_flop_travel(THREE, BLUE, 0, -26.5)[:, 0] == pytest.approx([43.5, 25.0, 17.0])


def test_all_together_is_one_step_at_every_angle() -> None:
    assert shift_labs(BLUE, (1.0, -2.0, 3.0)) == pytest.approx(BLUE + np.array([1.0, -2.0, 3.0]))
    assert shift_labs(BLUE, (-10.0, 0.0, 0.0))[:, 0].tolist() == [52.0, 15.0, 0.0]
    turned = lab_to_lch(shift_lchs(BLUE, (1.0, -2.0, 90.0)))
    before = lab_to_lch(BLUE)
    assert turned[:, 0] == pytest.approx(before[:, 0] + 1.0)
    assert turned[:, 1] == pytest.approx(before[:, 1] - 2.0)
    assert turned[:, 2] == pytest.approx((before[:, 2] + 90.0) % 360.0)
    grey = shift_lchs([[50.0, 0.0, 0.0]], (0.0, 10.0, 0.0), grey_hue_deg=90.0)
    assert grey[0] == pytest.approx([50.0, 0.0, 10.0], abs=1e-12)


def test_hues_unwrap_over_greys() -> None:
    hues = unwrap_hues([[50, 10, 1], [50, 0, 0], [50, 10, -1], [50, -10, -1]])
    assert hues[0] == pytest.approx(5.711, abs=1e-3)
    assert np.isnan(hues[1])
    assert hues[2] == pytest.approx(-5.711, abs=1e-3)
    assert hues[3] == pytest.approx(-174.289, abs=1e-3)
    assert np.isnan(unwrap_hues([[50, 0, 0]] * 2)).all()


def test_a_flop_that_cannot_be_reported_is_refused() -> None:
    with pytest.raises(ValueRangeError, match="before the face"):
        flop_ends([45.0, 75.0, 110.0])
    with pytest.raises(ValueRangeError, match="15, 45 and 110"):
        with_flop_index((15.0, 40.0, 110.0), BLUE, 5.0)
    with pytest.raises(ValueRangeError, match="at least 0"):
        with_flop_index(THREE, BLUE, -1.0)
    with pytest.raises(ValueRangeError, match="grey"):
        with_flop_travel(THREE, [[60, 0, 0], [30, 5, 5], [9, 3, 3]], 2, 10.0)
    with pytest.raises(ValueRangeError, match="is 0"):
        with_flop_index(THREE, [[60, 0, 0], [0, 0, 0], [0, 0, 0]], 3.0)

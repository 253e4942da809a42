"""Neighbours of a paint, and paints between two."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.difference.tolerance import difference_parts
from brdf_suite.appearance.flop.travel import flop_index
from brdf_suite.documents.paint import (
    STEEPEST_PEEL_DEG,
    Flakes,
    Gloss,
    Measurement,
    OrangePeel,
    Paint,
    solid_paint,
)
from brdf_suite.errors import SuiteError, ValueRangeError
from brdf_suite.paint_design.mix import mixed, second_end
from brdf_suite.paint_design.standard import Standard
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.paint_design.variations import (
    DIRECTIONS,
    FLAKE_RATIO,
    examined,
    flop_shares,
    variations,
)
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint

ANGLES = (15.0, 45.0, 110.0)
STEEPEST_UM = math.floor(100.0 * math.tan(math.radians(STEEPEST_PEEL_DEG)) * 1e3 / (2.0 * math.pi)) / 100.0


@pytest.fixture(scope="module")
def blue() -> Paint:
    return load_shipped_paint("blue")


def named(paint: Paint, step: float = 2.0) -> dict:
    return {one.direction: one for one in variations(paint, step)}


def flop_of(paint: Paint) -> float:
    return flop_index(*(paint.lab_at(angle)[0] for angle in ANGLES)).value


def test_each_neighbour_goes_one_step_its_way(blue: Paint) -> None:
    found = named(blue)
    assert tuple(found) == DIRECTIONS
    for angle in ANGLES:
        old = blue.lab_at(angle)
        parts = {key: difference_parts(old, one.paint.lab_at(angle)) for key, one in found.items()}
        assert parts["lighter"] == pytest.approx((2.0, 0.0, 0.0), abs=0.02)
        assert parts["darker"] == pytest.approx((-2.0, 0.0, 0.0), abs=0.02)
        assert parts["cleaner"] == pytest.approx((0.0, 2.0, 0.0), abs=0.02)
        assert parts["dirtier"] == pytest.approx((0.0, -2.0, 0.0), abs=0.02)
        assert parts["hue_forward"][2] > 0.5
        assert parts["hue_back"][2] < -0.5
        assert abs(parts["hue_forward"][2]) <= 2.01
    # The chroma is largest at 15°: there ΔH is the step.
    turned = found["hue_forward"].paint.lab_at(15.0)
    assert difference_parts(blue.lab_at(15.0), turned)[2] == pytest.approx(2.0, abs=0.02)
    assert flop_of(found["more_flop"].paint) > flop_of(blue) > flop_of(found["less_flop"].paint)
    assert found["more_flop"].paint.lab_at(45.0) == pytest.approx(blue.lab_at(45.0), abs=0.006)
    assert (found["hue_forward"].word, found["hue_back"].word) == ("redder", "greener")
    assert all(one.paint.gloss == blue.gloss for one in found.values())
    assert all(one.paint.flakes == blue.flakes for key, one in found.items() if "flakes" not in key)


def test_what_is_no_colour_is_said(blue: Paint) -> None:
    found = named(blue, 12.0)
    assert found["darker"].paint is None
    assert "L* at 110° would be -3.0" in found["darker"].reason
    grey = named(solid_paint("grey", (50.0, 0.0, 0.0)))
    assert {key for key, one in grey.items() if one.paint is None} == {
        "cleaner",
        "dirtier",
        "hue_forward",
        "hue_back",
        "less_flop",
        "finer_flakes",
        "coarser_flakes",
    }
    assert all(one.reason for one in grey.values() if one.paint is None)
    dull = named(solid_paint("dull", (50.0, 1.5, 0.0)))
    assert "less than the step" in dull["dirtier"].reason
    for step in (0.0, 21.0, float("nan")):
        with pytest.raises(ValueRangeError, match="step"):
            variations(blue, step)


def test_a_neighbour_that_no_paint_can_have_is_found_by_the_fit(blue: Paint) -> None:
    fitter = PaintFitter(time_limit_s=60.0)
    try:
        fine = [examined(one, fitter) for one in variations(blue)]
        assert all(one.paint is not None and not one.is_missed for one in fine)
        # Under so high a gloss there is no paint at all.
        impossible = replace(blue, gloss=Gloss(199.0))
        gone = examined(variations(impossible)[0], fitter)
        assert gone.paint is None
        assert "199" in gone.reason
        # Farther from the mirror direction it is lighter: a sum of lobes cannot do that.
        rising = replace(blue, measurements=tuple(Measurement(45.0, a, (30.0 + a, 0.0, 0.0)) for a in ANGLES))
        assert examined(variations(rising)[0], fitter).is_missed
    finally:
        fitter.close()


def test_deeper_goes_away_from_white_and_warmer_to_orange_and_not_past_it(blue: Paint) -> None:
    found = named(blue)
    for angle in ANGLES:
        old, deep = (lab_to_lch(paint.lab_at(angle)) for paint in (blue, found["deeper"].paint))
        depths = [math.hypot(100.0 - lch[0], lch[1]) for lch in (old, deep)]
        assert depths[1] - depths[0] == pytest.approx(2.0, abs=0.02)
        assert deep[2] == pytest.approx(old[2], abs=0.1)
        assert deep[0] < old[0]
        warm = difference_parts(blue.lab_at(angle), found["warmer"].paint.lab_at(angle))
        # The nearer way from a blue to orange goes over red.
        assert warm[:2] == pytest.approx((0.0, 0.0), abs=0.02)
        assert warm[2] > 0.5
    nearly = solid_paint("orange", (60.0, *(30.0 * math.sin(math.radians(a)) for a in (90.0 - 52.0, 52.0))))
    turned = named(nearly)["warmer"].paint
    assert lab_to_lch(turned.lab_at(45.0))[2] == pytest.approx(50.0, abs=0.05)
    assert named(turned)["warmer"].paint is None
    grey = named(solid_paint("grey", (50.0, 0.0, 0.0)))
    assert lab_to_lch(grey["warmer"].paint.lab_at(45.0)) == pytest.approx((50.0, 2.0, 50.0), abs=0.2)
    assert grey["deeper"].paint.lab_at(45.0) == (48.0, 0.0, 0.0)
    assert "white" in named(solid_paint("white", (100.0, 0.0, 0.0)))["deeper"].reason


def test_finer_and_coarser_flakes_cover_the_same_area(blue: Paint) -> None:
    found, flakes = named(blue), blue.flakes
    for key, ratio in (("finer_flakes", 1.0 / FLAKE_RATIO), ("coarser_flakes", FLAKE_RATIO)):
        paint = found[key].paint
        assert paint.measurements == blue.measurements
        assert paint.flakes.size_um == pytest.approx(ratio * flakes.size_um, abs=0.01)
        covered = [one.density_per_mm2 * one.size_um**2 for one in (flakes, paint.flakes)]
        assert covered[1] == pytest.approx(covered[0], rel=1e-3)
    assert "no flakes" in named(replace(blue, flakes=None))["finer_flakes"].reason
    largest = replace(blue, flakes=replace(flakes, size_um=1900.0))
    assert "Flake size would be" in named(largest)["coarser_flakes"].reason


def test_flop_shares_with_more_angles() -> None:
    shares = flop_shares(np.array([25.0, 15.0, 45.0, 75.0, 110.0]))
    np.testing.assert_allclose(shares, [2.0 / 3.0, 1.0, 0.0, -30.0 / 65.0, -1.0])
    np.testing.assert_allclose(flop_shares(np.array([45.0, 75.0, 110.0])), [1.0, 2.5 / 32.5, -1.0])


@settings(max_examples=settings.default.max_examples // 2)
@given(
    st.tuples(*[st.tuples(st.floats(20, 80), st.floats(-40, 40), st.floats(-40, 40))] * 3),
    st.floats(0.1, 5.0),
)
def test_a_step_and_its_opposite_meet_again(labs: tuple, step: float) -> None:
    paint = Paint(
        "p", tuple(Measurement(45.0, a, lab) for a, lab in zip(ANGLES, labs, strict=True)), Gloss(90.0)
    )
    there = named(paint, step)["lighter"].paint
    back = named(there, step)["darker"].paint
    for angle in ANGLES:
        assert back.lab_at(angle) == pytest.approx(paint.lab_at(angle), abs=0.021)


def test_halfway_is_the_mean_and_the_ends_are_themselves(blue: Paint) -> None:
    red = load_shipped_paint("red")
    assert mixed(blue, red, 0.0, blue.name) == blue
    assert mixed(blue, red, 1.0, red.name) == red
    half = mixed(blue, red, 0.5)
    assert half.lab_at(45.0) == (27.5, 24.0, -6.0)
    assert half.gloss.gu_20 == 0.5 * (blue.gloss.gu_20 + red.gloss.gu_20)
    assert half.gloss.gu_60 is None
    assert half.name == "Blue 50 % Red"
    assert half.flakes.density_per_mm2 == pytest.approx(
        (blue.flakes.density_per_mm2 * red.flakes.density_per_mm2) ** 0.5
    )
    beyond = mixed(blue, red, 1.5)
    assert beyond.lab_at(45.0) == (32.5, 64.0, 58.0)
    assert mixed(blue, red, -0.5).lab_at(110.0)[0] == pytest.approx(5.5)
    with pytest.raises(ValueRangeError, match="share"):
        mixed(blue, red, 1.6)


def test_flakes_and_peel_fade_in(blue: Paint) -> None:
    plain = solid_paint("plain", (50.0, 0.0, 0.0))
    flaky = replace(plain, flakes=Flakes(200.0, 40.0), orange_peel=OrangePeel(0.8, 4.0))
    densities = [mixed(plain, flaky, share).flakes for share in (0.0, 0.2, 0.6, 1.0)]
    assert densities[0] is None
    assert [one.density_per_mm2 for one in densities[1:]] == pytest.approx([1.657, 18.21, 200.0], rel=1e-3)
    assert [one.size_um for one in densities[1:]] == pytest.approx([40.0] * 3)
    assert mixed(plain, flaky, -0.3).flakes is None
    assert mixed(plain, flaky, 0.5).orange_peel == OrangePeel(0.4, 4.0)
    assert mixed(plain, plain, 0.5).orange_peel is None
    # Beyond a paint whose waves are as steep as waves can be, they stay that steep.
    steep = replace(plain, orange_peel=OrangePeel(STEEPEST_UM, 1.0))
    assert mixed(plain, steep, 1.5).orange_peel.amplitude_um == pytest.approx(STEEPEST_UM, abs=0.01)


def test_the_second_paint_is_read_at_the_first_ones_angles(blue: Paint) -> None:
    five = replace(
        blue,
        measurements=tuple(
            Measurement(45.0, a, (60.0 - a / 2.5, 0.0, 0.0)) for a in (15.0, 25.0, 45.0, 75.0, 110.0)
        ),
    )
    read = second_end(five, blue)
    assert [m.aspecular_deg for m in read.measurements] == [15.0, 25.0, 45.0, 75.0, 110.0]
    assert read.lab_at(45.0) == blue.lab_at(45.0)
    assert read.lab_at(25.0)[0] == pytest.approx(51.8, abs=0.1)
    assert mixed(five, read, 0.5).lab_at(25.0)[0] == pytest.approx(
        0.5 * (50.0 + read.lab_at(25.0)[0]), abs=0.01
    )
    assert second_end(five, five) is five
    with pytest.raises(ValueRangeError, match="same angles"):
        mixed(five, blue, 0.5)
    (fitted,) = load_standards("table1_blue")
    assert second_end(five, fitted).lab_at(45.0) == pytest.approx((17.31, 5.42, -34.83), abs=0.01)
    with pytest.raises(SuiteError, match="no reading at 45as25"):
        second_end(five, replace(blue, gloss=Gloss(199.0)))
    with pytest.raises(SuiteError, match="no reading at 45as25"):
        second_end(five, Standard("instrument", "", blue.measurements))


@settings(max_examples=settings.default.max_examples // 2)
@given(
    st.floats(-0.5, 1.5), st.sampled_from(["red", "fine_silver", "satin_white", "solid_black", "white_pearl"])
)
def test_every_share_is_a_valid_paint(share: float, other: str) -> None:
    blue, second = load_shipped_paint("blue"), load_shipped_paint(other)
    found = mixed(blue, second, share)
    assert len(found.measurements) == 3
    assert min(m.lab[0] for m in found.measurements) >= 0.0

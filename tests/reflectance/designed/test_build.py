"""From a paint to its reflectance, and measured back."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.clearcoat_gloss import gloss_units
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.paint import Gloss, Measurement, Paint, solid_paint
from brdf_suite.errors import UnreachableError
from brdf_suite.fitting.metrics import aspecular_lab
from brdf_suite.geometry.directions import aspecular_view, illumination, spherical
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.designed.rules import FlakeRule, MonotoneRule
from brdf_suite.reflectance.instruments.glossmeter import base_gloss, total_gloss

ANGLES = (15.0, 45.0, 110.0)


def paint_of(labs, gu_20: float = 90.0, gu_60: float | None = None, **fields) -> Paint:
    measurements = tuple(Measurement(45.0, g, tuple(lab)) for g, lab in zip(ANGLES, labs, strict=True))
    return Paint("p", measurements, Gloss(gu_20, gu_60), **fields)


def worst_difference(paint: Paint, reflectance: PaintReflectance) -> float:
    return max(
        float(delta_e_2000(aspecular_lab(reflectance, m.aspecular_deg, m.illumination_deg), m.lab))
        for m in paint.measurements
    )


SILVER = ((128.0, 0.0, 0.0), (62.0, 0.0, 0.0), (36.0, 0.0, 0.0))


@pytest.mark.parametrize("interpolation", ["flake", "monotone", "polynomial"])
@pytest.mark.parametrize("gu_20", [30.0, 90.0])
def test_measured_back_a_paint_gives_its_own_colours_and_gloss(
    computed_labs, invented_labs, interpolation: str, gu_20: float
) -> None:
    for name, labs in (computed_labs | invented_labs).items():
        paint = paint_of(labs, gu_20, interpolation=interpolation)
        built = build_paint(paint)
        assert worst_difference(paint, built) < 0.001, name
        assert total_gloss(built.base, built.coat)[0] == pytest.approx(gu_20, abs=0.05), name


@given(
    st.tuples(st.floats(30.0, 130.0), st.floats(0.25, 0.9), st.floats(0.2, 0.95)),
    st.lists(st.floats(-0.25, 0.25), min_size=6, max_size=6),
    st.floats(8.0, 100.0),
)
def test_so_does_any_paint_that_can_be_built(lightness: tuple, chroma: list, gu_20: float) -> None:
    top, second, third = lightness[0], lightness[0] * lightness[1], lightness[0] * lightness[1] * lightness[2]
    sizes = (top, second, third)
    labs = [(size, size * chroma[2 * i], size * chroma[2 * i + 1]) for i, size in enumerate(sizes)]
    paint = paint_of(labs, gu_20)
    try:
        built = build_paint(paint)
    except UnreachableError:
        assume(False)
    assume(not any("saturated" in notice for notice in built.notices))
    assert worst_difference(paint, built) < 0.05
    assert total_gloss(built.base, built.coat)[0] == pytest.approx(gu_20, abs=0.5)
    wi = spherical(np.linspace(0.0, 1.5, 9), 0.3)[:, None]
    assert build_paint(paint).eval(wi, spherical(np.linspace(0.0, 1.5, 11), -2.5)).min() >= 0.0


def test_base_and_coat_add_up(invented_labs) -> None:
    built = build_paint(paint_of(invented_labs["blue"], 25.0))
    wi, wo = illumination(45.0), aspecular_view(45.0, np.linspace(-20.0, 130.0, 31))
    np.testing.assert_allclose(
        built.eval(wi, wo), built.base.eval(wi, wo) + built.coat.eval(wi, wo), rtol=1e-14
    )
    assert (built.ior, built.roughness) == (built.coat.ior, built.coat.roughness)
    assert built.base.ior == built.coat.ior


def test_gloss_is_the_coats_and_the_bases(computed_labs) -> None:
    """A glossmeter sees 2 to 8 GU of a silver's base at 20°, 5 to 17 GU at 60°."""
    built = build_paint(paint_of(SILVER, 90.0))
    at_20, at_60 = base_gloss(built.base)
    assert 2.0 < at_20 < 8.0
    assert 5.0 < at_60 < 17.0
    assert at_20 + gloss_units(20, built.ior, built.roughness) == pytest.approx(90.0, abs=0.02)
    assert built.ior < 1.53, "less than a black paint of 90 GU needs"
    black = build_paint(solid_paint("black", (1.0, 0.0, 0.0), Gloss(90.0)))
    assert black.ior == pytest.approx(1.53, abs=0.002)


def test_the_bases_flux_of_a_diffuser_by_hand() -> None:
    """ρ/π cosθ Ω / F of black glass, Ω = 1.8° by 3.6°; the base dims by T(20)² / (T(45) T(45))."""
    built = build_paint(solid_paint("white", (100.0, 0.0, 0.0), Gloss(90.0)))
    solid_angle = math.radians(1.8) * math.radians(3.6)
    expected = 100.0 / math.pi * math.cos(math.radians(20.0)) * solid_angle / 0.04908
    assert base_gloss(built.base)[0] == pytest.approx(expected, rel=0.03)


def test_both_gloss_readings_are_met() -> None:
    built = build_paint(paint_of(SILVER, 80.0, 98.0))
    assert total_gloss(built.base, built.coat) == pytest.approx((80.0, 98.0), abs=0.1)


def test_near_specular_leaves_the_readings_alone() -> None:
    plain, doubled = build_paint(paint_of(SILVER)), build_paint(paint_of(SILVER, near_specular=2.0))
    assert worst_difference(paint_of(SILVER), doubled) < 0.001
    ratio = doubled.base.reflectance_factor(0.0) / plain.base.reflectance_factor(0.0)
    np.testing.assert_allclose(ratio, 2.0, rtol=0.01)
    assert total_gloss(doubled.base, doubled.coat)[0] == pytest.approx(90.0, abs=0.05)


def test_where_no_flakes_give_the_colours_the_monotone_rule_is_used_and_said() -> None:
    built = build_paint(paint_of(((40.0, 0, 0), (50.0, 0, 0), (30.0, 0, 0))))
    assert isinstance(built.base.rule, MonotoneRule)
    assert any("monotone rule is used" in notice for notice in built.notices)
    flakes = build_paint(paint_of(SILVER))
    assert isinstance(flakes.base.rule, FlakeRule)
    assert flakes.notices == ()


def test_odd_paints_deserve_a_notice() -> None:
    wide = build_paint(paint_of(((80.0, 0, 0), (70.0, 0, 0), (30.0, 0, 0))))
    assert any("flake tilts spread by" in notice for notice in wide.notices)
    dipping = build_paint(paint_of(SILVER, interpolation="polynomial"))
    assert any("polynomial turns negative between 5" in notice for notice in dipping.notices)
    bright = build_paint(paint_of(((180.0, 0, 0), (140.0, 0, 0), (120.0, 0, 0))))
    assert any("times the light" in notice for notice in bright.notices)


def test_a_colour_outside_the_working_space_is_clamped_and_said() -> None:
    scarlet = (40.0, 120.0, 60.0)
    built = build_paint(paint_of((scarlet, (20.0, 30.0, 15.0), (9.0, 15.0, 8.0))))
    [notice] = [notice for notice in built.notices if "saturated" in notice]
    assert notice.startswith("The colour at 15° ")
    shown = float(delta_e_2000(aspecular_lab(built, 15.0), scarlet))
    assert f"ΔE00 {shown:.2f}" in notice


def test_a_coat_brighter_than_the_paint_is_refused_by_angle_and_channel() -> None:
    labs = ((20.0, 25.0, 10.0), (15.0, 20.0, 8.0), (10.0, 15.0, 6.0))
    with pytest.raises(UnreachableError, match=r"At 15° the clearcoat .* in the (green|blue) channel"):
        build_paint(paint_of(labs, 1.5))


@pytest.mark.parametrize(
    ("labs", "gloss", "words"),
    [
        (SILVER, (180.0, None), r"180 GU at 20° cannot be reached.*from .* to 14\d\.\d GU"),
        (SILVER, (90.0, 40.0), r"40 GU cannot be reached"),
        (SILVER, (0.0, None), r"0 GU at 20° cannot be reached"),
    ],
)
def test_a_gloss_out_of_reach_is_refused(labs, gloss: tuple, words: str) -> None:
    with pytest.raises(UnreachableError, match=words):
        build_paint(paint_of(labs, *gloss))


def test_readings_in_any_order_and_more_of_them() -> None:
    paint = paint_of(SILVER)
    turned = dataclasses.replace(paint, measurements=paint.measurements[::-1])
    wi, wo = illumination(30.0), aspecular_view(30.0, np.linspace(0.0, 110.0, 12))
    np.testing.assert_array_equal(build_paint(paint).eval(wi, wo), build_paint(turned).eval(wi, wo))

    truth = build_paint(paint)
    five = [Measurement(45.0, g, tuple(aspecular_lab(truth, g).tolist())) for g in (15, 25, 45, 75, 110)]
    built = build_paint(dataclasses.replace(paint, measurements=tuple(five)))
    assert worst_difference(dataclasses.replace(paint, measurements=tuple(five)), built) < 0.05
    np.testing.assert_allclose(built.base.eval(wi, wo), truth.base.eval(wi, wo), rtol=1e-3)


def test_readings_on_both_sides_of_the_mirror_direction_are_joined() -> None:
    paint = paint_of(SILVER)
    both = (*paint.measurements, Measurement(45.0, -15.0, (126.0, 0.0, 0.0)))
    built = build_paint(dataclasses.replace(paint, measurements=both))
    # Less light leaves the coat to 60° than to 30°: for 128 on the near side, 126 beyond is too much.
    near, beyond = aspecular_lab(built, [15.0, -15.0])[:, 0]
    assert near > 128.0
    assert beyond < 126.0


def test_three_readings_of_one_light_are_needed() -> None:
    scattered = tuple(Measurement(light, 45.0, (50.0, 0.0, 0.0)) for light in (15.0, 30.0, 45.0))
    with pytest.raises(UnreachableError, match="at least 3 readings with the same light angle"):
        build_paint(dataclasses.replace(paint_of(SILVER), measurements=scattered))


lab_values = st.tuples(st.floats(0.0, 250.0), st.floats(-250.0, 250.0), st.floats(-250.0, 250.0))


@settings(max_examples=2 * settings.default.max_examples)
@given(
    st.lists(lab_values, min_size=3, max_size=3),
    st.floats(0.0, 200.0),
    st.none() | st.floats(0.0, 200.0),
    st.sampled_from(["flake", "monotone", "polynomial"]),
    st.floats(0.0, 10.0),
)
def test_any_valid_paint_is_finite_or_refused(labs, gu_20, gu_60, interpolation, near_specular) -> None:
    paint = paint_of(labs, gu_20, gu_60, interpolation=interpolation, near_specular=near_specular)
    try:
        built = build_paint(paint)
    except UnreachableError as error:
        assert str(error).endswith(".")  # noqa: PT017 - either outcome is right
        return
    value = built.eval(
        spherical(np.linspace(0.0, 1.57, 13), 0.3)[:, None], spherical(np.linspace(0.0, 1.57, 9), -2.9)
    )
    assert np.isfinite(value).all()
    assert value.min() >= 0.0

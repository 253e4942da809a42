"""Paints at other sets of angles: the look stays, and what was measured stays to the last digit."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import GEOMETRY_SETS, Geometry
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.errors import UnreachableError, ValueRangeError
from brdf_suite.paint_design.angle_sets import at_geometries, set_name, with_angle, without_angle
from brdf_suite.pipeline.material import load_shipped_paint, paint_names
from brdf_suite.reflectance.designed.build import build_paint

ONE_LIGHT = ("e2194", "five", "six")
THREE_ANGLES = [name for name in paint_names() if set_name(load_shipped_paint(name)) == "e2194"]


def geometries(name: str) -> tuple[Geometry, ...]:
    return GEOMETRY_SETS[name].geometries


@pytest.mark.parametrize("name", ["blue", "fine_silver", "white_pearl", "solid_red"])
def test_a_paint_at_more_angles_keeps_its_look(name: str) -> None:
    paint = load_shipped_paint(name)
    six = at_geometries(paint, geometries("six"))
    assert set_name(paint) == "e2194"
    assert set_name(six) == "six"
    for angle in (15.0, 45.0, 110.0):
        assert six.lab_at(angle) == paint.lab_at(angle)
    between = at_geometries(paint, [Geometry(45.0, a) for a in (20.0, 35.0, 60.0, 90.0)])
    again = at_geometries(six, [Geometry(45.0, a) for a in (20.0, 35.0, 60.0, 90.0)])
    for one, other in zip(between.measurements, again.measurements, strict=True):
        # Six readings are met by least squares, the one beyond the mirror direction among them.
        assert delta_e_2000(one.lab, other.lab) < 0.25


@settings(max_examples=settings.default.max_examples // 2)
@given(st.sampled_from(THREE_ANGLES), st.lists(st.sampled_from(ONE_LIGHT), min_size=1, max_size=4))
def test_any_way_through_the_sets_comes_back_to_the_same_readings(name: str, way: list[str]) -> None:
    paint = load_shipped_paint(name)
    moved = paint
    for stop in way:
        moved = at_geometries(moved, geometries(stop))
        assert set_name(moved) == stop
    assert at_geometries(moved, geometries("e2194")) == paint


def test_angles_are_added_in_order_and_taken_away() -> None:
    paint = load_shipped_paint("blue")
    more = with_angle(paint, Geometry(45.0, 60.0))
    assert [m.aspecular_deg for m in more.measurements] == [15.0, 45.0, 60.0, 110.0]
    assert without_angle(more, 2) == paint
    with pytest.raises(ValueRangeError, match="already"):
        with_angle(more, Geometry(45.0, 60.0))
    with pytest.raises(ValueRangeError, match="at least 3"):
        without_angle(paint, 0)
    with pytest.raises(ValueRangeError, match="at least 3"):
        at_geometries(paint, geometries("six")[:2])
    assert set_name(more) is None


def test_a_second_light_is_a_set_too() -> None:
    paint = at_geometries(load_shipped_paint("blue"), geometries("e2539"))
    assert set_name(paint) == "e2539"
    assert [m.illumination_deg for m in paint.measurements] == [45.0] * 6 + [15.0] * 2
    build_paint(paint)
    # Both readings under the second light may go: one light is enough.
    assert set_name(without_angle(without_angle(paint, 7), 6)) == "six"


def test_a_paint_without_a_reflectance_has_nothing_between_its_readings() -> None:
    readings = tuple(Measurement(45.0, angle, (50.0, 0.0, 0.0)) for angle in (15.0, 45.0, 110.0))
    impossible = Paint("No coat", readings, Gloss(199.0))
    with pytest.raises(UnreachableError, match="199 GU"):
        at_geometries(impossible, geometries("six"))
    # What is there already needs no model.
    assert at_geometries(impossible, geometries("e2194")) == impossible

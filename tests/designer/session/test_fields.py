"""Edits of a paint by field key."""

from __future__ import annotations

import pytest
from brdf_designer.session.fields import apply_edit, by_angle, step_name

from brdf_suite.documents.paint import Flakes, Gloss, Measurement, Paint, solid_paint
from brdf_suite.errors import ValueRangeError

PAINT = solid_paint("x", (50.0, 1.0, 2.0))


@pytest.mark.parametrize(
    ("key", "value", "read", "name"),
    [
        (("lab", 1, 0), 61.5, lambda p: p.lab_at(45.0), "Change L* at 45°"),
        (("colour", 0), (1.0, 2.0, 3.0), lambda p: p.lab_at(15.0), "Pick Colour at 15°"),
        (("gloss", "gu_20"), 70.0, lambda p: p.gloss.gu_20, "Change Gloss 20°"),
        (("gloss", "gu_60"), None, lambda p: p.gloss.gu_60, "Change Gloss 60°"),
        (("flakes", "size_um"), 9.0, lambda p: p.flakes.size_um, "Change Flake size"),
        (("flakes",), Flakes(), lambda p: p.flakes, "Flakes On"),
        (("interpolation",), "monotone", lambda p: p.interpolation, "Change Interpolation"),
        (("near_specular",), 1.5, lambda p: p.near_specular, "Change Near-Specular Factor"),
        (("name",), "y", lambda p: p.name, "Rename Paint"),
        (("notes",), "n\nm", lambda p: p.notes, "Edit Notes"),
        (("source",), "s", lambda p: p.source, "Edit Source"),
    ],
)
def test_every_field_is_set_and_named(key, value, read, name):
    after = apply_edit(PAINT, key, value)
    assert read(after) == ((61.5, 1.0, 2.0) if key[0] == "lab" else value)
    assert step_name(PAINT, key) == name


def test_make_solid_takes_one_reading_for_all():
    paint = apply_edit(PAINT, ("lab", 2, 0), 10.0)
    assert {m.lab for m in apply_edit(paint, ("solid",), 2).measurements} == {(10.0, 1.0, 2.0)}


def test_a_value_out_of_range_is_refused_by_name():
    with pytest.raises(ValueRangeError, match="lab"):
        apply_edit(PAINT, ("lab", 0, 0), 300.0)
    with pytest.raises(ValueRangeError, match="name"):
        apply_edit(PAINT, ("name",), " ")


def test_readings_are_shown_by_light_then_angle():
    readings = tuple(Measurement(*m, (50.0, 0.0, 0.0)) for m in ((45, 110), (20, 30), (45, 15)))
    paint = Paint("x", readings, Gloss(90.0))
    assert by_angle(paint) == (1, 2, 0)
    assert step_name(paint, ("lab", 1, 0)) == "Change L* at 30°, light 20°"

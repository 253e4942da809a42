"""Edits of a paint: each sets its field and has a name."""

from __future__ import annotations

import pytest
from brdf_designer.session.edits import (
    MakeSolid,
    PickColour,
    SetField,
    SetLab,
    SetNumber,
)
from brdf_designer.session.state import by_angle

from brdf_suite.documents.paint import Flakes, Gloss, Measurement, Paint, solid_paint
from brdf_suite.errors import ValueRangeError

PAINT = solid_paint("x", (50.0, 1.0, 2.0))


@pytest.mark.parametrize(
    ("edit", "read", "value", "name"),
    [
        (SetLab(1, 0, 61.5), lambda p: p.lab_at(45.0), (61.5, 1.0, 2.0), "Change L* at 45°"),
        (PickColour(0, (1.0, 2.0, 3.0)), lambda p: p.lab_at(15.0), (1.0, 2.0, 3.0), "Pick Colour at 15°"),
        (SetNumber("gloss.gu_20", 70.0), lambda p: p.gloss.gu_20, 70.0, "Change Gloss 20°"),
        (SetNumber("gloss.gu_60", None), lambda p: p.gloss.gu_60, None, "Change Gloss 60°"),
        (SetNumber("flakes.size_um", 9.0), lambda p: p.flakes.size_um, 9.0, "Change Flake size"),
        (SetField("flakes", Flakes()), lambda p: p.flakes, Flakes(), "Flakes On"),
        (
            SetField("interpolation", "monotone"),
            lambda p: p.interpolation,
            "monotone",
            "Change Interpolation",
        ),
        (SetNumber("near_specular", 1.5), lambda p: p.near_specular, 1.5, "Change Near-Specular Factor"),
        (SetField("name", "y"), lambda p: p.name, "y", "Rename Paint"),
        (SetField("notes", "n\nm"), lambda p: p.notes, "n\nm", "Edit Notes"),
        (SetField("source", "s"), lambda p: p.source, "s", "Edit Source"),
    ],
)
def test_every_field_is_set_and_named(edit, read, value, name):
    assert read(edit.apply(PAINT)) == value
    assert edit.step(PAINT) == name


def test_make_solid_takes_one_reading_for_all():
    paint = SetLab(2, 0, 10.0).apply(PAINT)
    assert {m.lab for m in MakeSolid(2).apply(paint).measurements} == {(10.0, 1.0, 2.0)}


def test_a_value_out_of_range_is_refused_by_name():
    with pytest.raises(ValueRangeError, match="lab"):
        SetLab(0, 0, 300.0).apply(PAINT)
    with pytest.raises(ValueRangeError, match="name"):
        SetField("name", " ").apply(PAINT)


def test_readings_are_shown_by_light_then_angle():
    readings = tuple(Measurement(*m, (50.0, 0.0, 0.0)) for m in ((45, 110), (20, 30), (45, 15)))
    paint = Paint("x", readings, Gloss(90.0))
    assert by_angle(paint) == (1, 2, 0)
    assert SetLab(1, 0, 50.0).step(paint) == "Change L* at 30°, light 20°"

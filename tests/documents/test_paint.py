"""The paint value: what it holds, and how it refuses what it cannot hold."""

from __future__ import annotations

import dataclasses
import math

import pytest

from brdf_suite.documents.paint import (
    Flakes,
    Gloss,
    Measurement,
    OrangePeel,
    Paint,
    TextureTargets,
    solid_paint,
)
from brdf_suite.documents.store import paint_from_json, paint_to_json
from brdf_suite.errors import DocumentError, SuiteError, ValueRangeError
from brdf_suite.surface.orange_peel import height_rms_um

LABS = {15.0: (62.0, -4.0, -45.0), 45.0: (25.0, 4.0, -38.0), 110.0: (9.0, 8.0, -28.0)}


def blue(**changes: object) -> Paint:
    measurements = tuple(Measurement(45.0, angle, lab) for angle, lab in LABS.items())
    return dataclasses.replace(Paint("Blue", measurements, Gloss(90.0), Flakes()), **changes)


def test_colours_are_found_and_replaced_by_angle() -> None:
    paint = blue()
    changed = paint.with_lab(45.0, (26.0, 4.0, -38.0))
    assert changed.lab_at(45.0) == (26.0, 4.0, -38.0)
    assert changed.lab_at(15.0) == LABS[15.0]
    assert paint.lab_at(45.0) == LABS[45.0], "the old value is untouched"
    with pytest.raises(ValueRangeError, match=r"75° is not measured; there are 15, 45, 110°"):
        paint.lab_at(75.0)


def test_values_are_frozen_and_normalised() -> None:
    paint = Paint("x", [Measurement(45, a, [50, 1, 2]) for a in (15, 45, 110)], Gloss(90))
    assert paint.measurements[0].lab == (50.0, 1.0, 2.0)
    assert isinstance(paint.measurements, tuple)
    assert isinstance(paint.gloss.gu_20, float)
    assert hash(paint) == hash(dataclasses.replace(paint))
    with pytest.raises(dataclasses.FrozenInstanceError):
        paint.name = "y"


@pytest.mark.parametrize(
    ("build", "place", "words"),
    [
        (lambda: Measurement(45.0, 15.0, (math.nan, 0.0, 0.0)), "lab[0]", "finite"),
        (lambda: Measurement(45.0, 15.0, (50.0, math.inf, 0.0)), "lab[1]", "finite"),
        (lambda: Measurement(45.0, 15.0, (50.0, 0.0, 10**400)), "lab[2]", "finite"),
        (lambda: Measurement(45.0, 15.0, (-1.0, 0.0, 0.0)), "lab[0]", "range 0 to 250"),
        (lambda: Measurement(45.0, 15.0, (50.0, 0.0)), "lab", "three numbers"),
        (lambda: Measurement(45.0, 15.0, (50.0, True, 0.0)), "lab[1]", "not true"),
        (lambda: Measurement(45.0, 15.0, "red"), "lab", "'red'"),
        (lambda: Measurement(45.0, 140.0, (50.0, 0.0, 0.0)), "aspecular_deg", "below the surface"),
        (lambda: Measurement(95.0, 15.0, (50.0, 0.0, 0.0)), "illumination_deg", "0 to 85 °"),
        (lambda: Gloss(-1.0), "gu_20", "0 to 200 GU"),
        (lambda: Gloss(90.0, math.nan), "gu_60", "finite"),
        (lambda: Flakes(size_um=0.0), "size_um", "µm"),
        (lambda: blue(name="  "), "name", "empty"),
        (lambda: blue(name="a\nb"), "name", "not allowed"),
        (lambda: blue(name="x" * 201), "name", "201 characters"),
        (lambda: blue(notes="\ud800"), "notes", "not allowed"),
        (lambda: blue(interpolation="linear"), "interpolation", "flake, monotone, polynomial"),
        (lambda: blue(near_specular=-0.1), "near_specular", "0 to 10"),
        (lambda: blue(illuminant="A"), "illuminant", "D65"),
        (lambda: blue(observer_deg=2), "observer_deg", "10°"),
        (lambda: blue(gloss=90.0), "gloss", "90.0"),
        (lambda: blue(measurements=blue().measurements[:2]), "measurements", "found 2"),
        (lambda: blue(measurements=blue().measurements[:2] * 2), "measurements[2]", "same angles"),
        (lambda: blue(measurements=(*blue().measurements, None)), "measurements[3]", "null"),
    ],
)
def test_a_bad_value_is_refused_by_its_place(build, place: str, words: str) -> None:
    with pytest.raises(ValueRangeError) as caught:
        build()
    assert caught.value.place == place
    assert words in str(caught.value)
    assert isinstance(caught.value, SuiteError)
    assert isinstance(caught.value, ValueError)


def test_a_solid_paint_has_one_colour() -> None:
    paint = solid_paint("white", (95.0, 0.0, 1.0), Gloss(88.0))
    assert {m.lab for m in paint.measurements} == {(95.0, 0.0, 1.0)}
    assert [m.aspecular_deg for m in paint.measurements] == [15.0, 45.0, 110.0]
    assert paint.gloss.gu_20 == 88.0


def test_two_lights_at_one_aspecular_angle_are_distinguished() -> None:
    first, second = (50.0, 1.0, 2.0), (40.0, 3.0, 4.0)
    solid = solid_paint("p", first)
    paint = dataclasses.replace(solid, measurements=(*solid.measurements, Measurement(15.0, 15.0, second)))
    assert paint.lab_at(15.0) == paint.lab_at(15.0, 45.0) == first
    assert paint.lab_at(15.0, 15.0) == second
    changed = paint.with_lab(15.0, (30.0, 0.0, 0.0), illumination_deg=15.0)
    assert changed.lab_at(15.0, 45.0) == first
    assert changed.lab_at(15.0, 15.0) == (30.0, 0.0, 0.0)
    with pytest.raises(ValueRangeError, match="45° is not measured with the light at 15°; there are 15°"):
        paint.lab_at(45.0, 15.0)
    with pytest.raises(ValueRangeError, match="light at 20°; there are 15, 45°"):
        paint.lab_at(15.0, 20.0)


@pytest.mark.parametrize("version", range(1, 6))
def test_a_paint_of_an_older_version_has_no_targets_of_texture(version: int) -> None:
    old = {**paint_to_json(solid_paint("Old", (50.0, 1.0, 2.0))), "version": version}
    del old["texture"]
    assert paint_from_json(old) == solid_paint("Old", (50.0, 1.0, 2.0))


def test_targets_of_texture_are_checked() -> None:
    assert TextureTargets.of((None, 0.0, None, None)) is None
    assert TextureTargets.of((0.5, 0.0, None, 0.03)) == TextureTargets(0.5, None, None, 0.03)
    good = paint_to_json(solid_paint("New", (50.0, 1.0, 2.0)))
    for bad, place in (
        ({"grade_45": -1.0}, "texture.grade_45"),
        ({"grain": 1.0}, "texture"),
        (0.5, "texture"),
    ):
        with pytest.raises(DocumentError) as refused:
            paint_from_json({**good, "texture": bad}, "x.brdfpaint")
        assert refused.value.place == place


def test_a_paint_of_version_2_has_no_orange_peel() -> None:
    old = {**paint_to_json(solid_paint("Old", (50.0, 1.0, 2.0))), "version": 2}
    del old["orange_peel"]
    paint = paint_from_json(old)
    assert paint.orange_peel is None
    assert paint_to_json(paint)["version"] == 6


def test_a_paint_of_version_4_scatters_as_often_as_light_does() -> None:
    old = {**paint_to_json(solid_paint("Old", (50.0, 1.0, 2.0))), "version": 4}
    del old["scattering"]
    assert paint_from_json(old).scattering == "multiple"
    assert paint_from_json(
        {**paint_to_json(solid_paint("Old", (50.0, 1.0, 2.0))), "scattering": "single"}
    ) == dataclasses.replace(solid_paint("Old", (50.0, 1.0, 2.0)), scattering="single")


def test_the_slope_of_orange_peel_is_that_of_its_height() -> None:
    for peel in (OrangePeel(0.3, 2.0), OrangePeel(5.0, 20.0)):
        assert height_rms_um(peel.slope_deg, peel.wavelength_mm) == pytest.approx(peel.amplitude_um)
    with pytest.raises(ValueRangeError, match="steeper than 5°"):
        OrangePeel(20.0, 0.5)
    with pytest.raises(ValueRangeError, match="orange peel or nothing"):
        blue(orange_peel=0.5)


def test_the_main_light_is_the_one_that_most_readings_have() -> None:
    assert blue().main_light_deg == 45.0
    more = (*blue().measurements, Measurement(15.0, 15.0, LABS[15.0]))
    assert blue(measurements=more).main_light_deg == 45.0
    lab = LABS[45.0]
    even = tuple(Measurement(light, angle, lab) for light in (45.0, 20.0) for angle in (15.0, 45.0))
    assert blue(measurements=even).main_light_deg == 20.0

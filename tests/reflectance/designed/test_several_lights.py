"""Readings under more than one light: each comes back, and between them θd decides."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.fitting.metrics import aspecular_lab
from brdf_suite.geometry.directions import aspecular_view, illumination, spherical
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.aspecular_base import SeveralLights
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.rules import squared_tilt, squared_tilt_between

AT_45 = ((15.0, (62.0, -4.0, -45.0)), (45.0, (25.0, 4.0, -38.0)), (110.0, (9.0, 8.0, -28.0)))
AT_15 = ((15.0, (60.0, 14.0, -46.0)), (45.0, (25.0, 12.0, -37.0)), (80.0, (14.0, 9.0, -32.0)))


def paint_of(*lights: tuple[float, tuple], **fields) -> Paint:
    readings = tuple(Measurement(light, angle, lab) for light, rows in lights for angle, lab in rows)
    return Paint("shift", readings, Gloss(90.0), **fields)


def differences(paint: Paint) -> list[float]:
    built = build_paint(paint)
    return [
        float(delta_e_2000(aspecular_lab(built, m.aspecular_deg, m.illumination_deg), m.lab))
        for m in paint.measurements
    ]


@pytest.mark.parametrize("interpolation", ["flake", "monotone", "polynomial"])
@pytest.mark.parametrize("second", [AT_15, AT_15[:2], AT_15[:1]])
def test_every_reading_of_every_light_comes_back(interpolation: str, second: tuple) -> None:
    paint = paint_of((45.0, AT_45), (15.0, second), interpolation=interpolation)
    assert max(differences(paint)) < 0.001


def test_three_lights_too() -> None:
    at_60 = ((20.0, (55.0, -10.0, -40.0)), (45.0, (24.0, 0.0, -36.0)), (110.0, (9.0, 6.0, -27.0)))
    assert max(differences(paint_of((45.0, AT_45), (15.0, AT_15), (60.0, at_60)))) < 0.001


def test_halfway_between_two_lights_is_the_mean() -> None:
    """At γ = 30° lights at 45 and 15° have θd = 30 and 0°; a light at 30° has θd = 15°, halfway."""
    built = build_paint(paint_of((45.0, AT_45), (15.0, AT_15)))
    assert isinstance(built.base, SeveralLights)
    wi, wo = illumination(30.0), aspecular_view(30.0, 30.0)
    low, high = (base.eval(wi, wo) for base in built.base.bases)
    assert np.abs(low - high).max() > 0.01
    np.testing.assert_allclose(built.base.eval(wi, wo), 0.5 * (low + high), rtol=1e-12)


def test_one_light_is_not_changed_by_another_far_away() -> None:
    """Beyond the outermost θd the nearest light's base is held."""
    one, two = build_paint(paint_of((45.0, AT_45))), build_paint(paint_of((45.0, AT_45), (15.0, AT_15)))
    wi, wo = illumination(70.0), aspecular_view(70.0, 30.0)
    np.testing.assert_allclose(two.base.eval(wi, wo), one.base.eval(wi, wo), rtol=1e-3)


def test_there_is_no_seam_where_the_lights_cross() -> None:
    """γ = 60°: both lights have θd = 15° there. The readings disagree, and still nothing jumps."""
    base = build_paint(paint_of((45.0, AT_45), (15.0, AT_15))).base
    gamma = np.linspace(50.0, 70.0, 2001)
    for light in (35.0, 45.0, 60.0):
        value = base.eval(illumination(light), aspecular_view(light, gamma))
        assert np.abs(np.diff(value, axis=0)).max() < 0.02 * value.max()


@pytest.mark.parametrize("name", ["gold_green_shift", "teal_violet_shift"])
def test_two_readings_of_a_second_light_leave_no_hump_in_the_first(name: str) -> None:
    """Where the lights meet, at γ = 60°, what the second one borrows is the first one's by reciprocity."""
    base = build_paint(load_shipped_paint(name)).base
    assert isinstance(base, SeveralLights)
    second, first = base.bases
    meeting = np.radians(60.0)
    np.testing.assert_allclose(second.rule(meeting[None]), first.rule(meeting[None]), rtol=1e-9)
    gamma = np.linspace(45.0, 110.0, 400)
    luminance = base.eval(illumination(45.0), aspecular_view(45.0, gamma)) @ LUMINANCE
    assert np.diff(luminance).max() < 0.002 * luminance[0]


@pytest.mark.parametrize("count", [1, 2])
def test_a_borrowed_rule_is_held_before_its_own_view_grazes(count: int) -> None:
    """A view of a light at 15° is at grazing where γ is 105°, and no coat lets anything out there."""
    base = build_paint(paint_of((45.0, AT_45), (15.0, AT_15[:count]))).base
    gamma = np.linspace(80.0, 130.0, 501)
    value = np.pi * base.bases[0].eval(illumination(65.0), aspecular_view(65.0, gamma))
    assert value.max() < 0.1
    assert np.abs(np.diff(value, axis=0)).max() < 0.01


def test_a_second_light_keeps_the_model_reciprocal() -> None:
    base = build_paint(paint_of((45.0, AT_45), (15.0, AT_15))).base
    random = np.random.default_rng(3)
    wi, wo = spherical(random.uniform(0, 1.5, (2, 500)), random.uniform(-3, 3, (2, 500)))
    np.testing.assert_allclose(base.eval(wi, wo), base.eval(wo, wi), rtol=1e-9)


def test_the_tilt_in_the_plane_is_that_of_the_angles() -> None:
    """appearance.md's table: flakes seen at 15, 45 and 110° are tilted by 4.3, 14.1 and 32.7° (n = 1.5)."""
    gamma = np.array([15.0, 45.0, 110.0])
    wi, wo = illumination(45.0), aspecular_view(45.0, gamma)
    tilt = np.degrees(np.arctan(np.sqrt(squared_tilt_between(wi, wo, 1.5))))
    np.testing.assert_allclose(tilt, [4.3, 14.1, 32.7], atol=0.06)
    np.testing.assert_allclose(
        squared_tilt_between(wi, wo, 1.5),
        squared_tilt(np.radians(gamma), math.radians(45.0), 1.5),
        rtol=1e-12,
    )


def test_the_tilt_out_of_the_plane_by_snell_and_vectors() -> None:
    """Light at 45° from -x, view at 45° from +y: refracted by Snell's law, then the sum of the two."""
    wi, wo = illumination(45.0), spherical(math.radians(45.0), math.radians(90.0))
    inside = math.asin(math.sin(math.radians(45.0)) / 1.5)
    light = np.array([-math.sin(inside), 0.0, math.cos(inside)])
    view = np.array([0.0, math.sin(inside), math.cos(inside)])
    normal = (light + view) / np.linalg.norm(light + view)
    expected = (1.0 - normal[2] ** 2) / normal[2] ** 2
    assert float(squared_tilt_between(wi, wo, 1.5)) == pytest.approx(expected, rel=1e-12)


def test_out_of_the_plane_the_two_ways_differ_and_in_it_they_agree() -> None:
    plain = paint_of((45.0, AT_45))
    by_angle = build_paint(plain).base
    assert build_paint(dataclasses.replace(plain, out_of_plane="half_vector")).base.by_half_vector
    by_tilt = dataclasses.replace(by_angle, by_half_vector=True)
    wi = illumination(45.0)
    inside = aspecular_view(45.0, np.linspace(0.0, 110.0, 23))
    np.testing.assert_allclose(by_tilt.eval(wi, inside), by_angle.eval(wi, inside), rtol=1e-9)
    # The same γ of 60° out of the plane is another tilt: sideways the half vector turns less than in the plane.
    aside = spherical(math.radians(45.0), math.radians(90.0))
    tilt = float(squared_tilt_between(wi, aside, by_angle.ior))
    rule = by_angle.rule
    ratio = by_tilt.eval(wi, aside) / by_angle.eval(wi, aside)
    expected = rule.at_squared_tilt(np.array(tilt)) / rule(np.array(math.acos(0.5)))
    np.testing.assert_allclose(ratio, expected, rtol=1e-9)
    assert np.all(np.abs(ratio - 1.0) > 0.01)


def test_every_reading_comes_back_by_the_half_vector_too() -> None:
    assert max(differences(paint_of((45.0, AT_45), (15.0, AT_15), out_of_plane="half_vector"))) < 0.001


def test_the_half_vector_belongs_to_the_flake_rule() -> None:
    built = build_paint(paint_of((45.0, AT_45), interpolation="polynomial", out_of_plane="half_vector"))
    assert any("flake rule" in notice for notice in built.notices)
    assert (
        max(differences(paint_of((45.0, AT_45), interpolation="polynomial", out_of_plane="half_vector")))
        < 1e-3
    )

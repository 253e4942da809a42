"""Paints read on both sides of the mirror direction, where the coat passes different amounts of light."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Measurement, Paint
from brdf_suite.documents.store import load_paint
from brdf_suite.fitting.metrics import aspecular_lab
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.instruments.aperture import POINT
from brdf_suite.reflectance.instruments.through_aperture import build_through
from brdf_suite.resources import resource, resource_names

NAMES = resource_names("paints", ".brdfpaint")
FIVE = (15.0, 25.0, 45.0, 75.0, 110.0)
SIX = (-15.0, *FIVE)
STEEP = (-44.0, -30.0, -15.0, 15.0, 30.0, 45.0, 75.0, 110.0)


def shipped(name: str, **fields: object) -> Paint:
    """The paint, of one that was read under several lights what was read under that at 45°."""
    paint = load_paint(resource("paints", f"{name}.brdfpaint"))
    at_45 = tuple(m for m in paint.measurements if m.illumination_deg == 45.0)
    return replace(paint, measurements=at_45, **fields)


def read_at(paint: Paint, angles: tuple[float, ...]) -> Paint:
    """The paint as an instrument of other angles without aperture knows it."""
    labs = aspecular_lab(build_paint(paint), angles).tolist()
    read = tuple(Measurement(45.0, angle, tuple(lab)) for angle, lab in zip(angles, labs, strict=True))
    return replace(paint, measurements=read)


def misses(paint: Paint) -> Floats:
    asked = [m.lab for m in paint.measurements]
    angles = [m.aspecular_deg for m in paint.measurements]
    return delta_e_2000(aspecular_lab(build_paint(paint), angles), asked)


@pytest.mark.parametrize("out_of_plane", ["aspecular", "half_vector"])
@pytest.mark.parametrize("angles", [SIX, FIVE, STEEP], ids=["six", "five", "steep"])
@pytest.mark.parametrize("name", NAMES)
def test_a_real_paint_comes_back(name: str, angles: tuple[float, ...], out_of_plane: str) -> None:
    paint = read_at(shipped(name, out_of_plane=out_of_plane), angles)
    assert misses(paint).max() <= 0.05
    built = build_paint(paint)
    assert not [notice for notice in built.notices if "rule is used" in notice]
    # Also where nothing was read: it is the same paint.
    between = np.linspace(-40.0, 110.0, 31)
    np.testing.assert_allclose(
        aspecular_lab(built, between),
        aspecular_lab(build_paint(shipped(name, out_of_plane=out_of_plane)), between),
        atol=0.1,
    )


@pytest.mark.parametrize("name", ["fine_silver", "satin_graphite"])
@pytest.mark.parametrize("interpolation", ["monotone", "polynomial"])
def test_so_do_the_other_rules(name: str, interpolation: str) -> None:
    angles = (-15.0, 15.0, 45.0, 110.0)
    assert misses(read_at(shipped(name, interpolation=interpolation), angles)).max() <= 0.001


def test_the_factor_of_the_mirror_direction_leaves_both_sides_alone() -> None:
    paint = read_at(shipped("fine_silver"), SIX)
    doubled = build_paint(replace(paint, near_specular=2.0))
    assert misses(replace(paint, near_specular=2.0)).max() <= 0.05
    ratio = doubled.base.reflectance_factor(0.0) / build_paint(paint).base.reflectance_factor(0.0)
    np.testing.assert_allclose(ratio, 2.0, rtol=1e-3)


def test_readings_that_contradict_each_other_are_reported_one_by_one() -> None:
    paint = read_at(shipped("fine_silver"), SIX)
    first = paint.measurements[0]
    wrong = replace(first, lab=(first.lab[0] - 20.0, *first.lab[1:]))
    contradictory = replace(paint, measurements=(wrong, *paint.measurements[1:]))
    solved = build_through(contradictory, POINT)
    reported = misses(contradictory)
    np.testing.assert_allclose(solved.missed, reported, atol=1e-9)
    assert min(reported[:2]) > 1.0, "neither side is taken for the truth"
    fitted = PaintFitter(time_limit_s=60.0).fit(contradictory)
    for notices in (solved.notices, fitted.notices):
        [notice] = [notice for notice in notices if "does not pass through every reading" in notice]
        assert f"{reported[0]:.2f} at -15°" in notice
        assert f"{reported[1]:.2f} at 15°" in notice
        assert notice.index("at -15°") < notice.index("at 15°")
    assert not any("does not pass" in notice for notice in PaintFitter(time_limit_s=60.0).fit(paint).notices)


def test_a_reading_near_the_horizon_does_not_outweigh_the_others() -> None:
    """At 89° the coat passes next to nothing: what little is read there says little of the base."""
    paint = read_at(shipped("fine_silver"), (-44.0, 15.0, 44.0, 110.0))
    low = paint.measurements[0]
    off = replace(
        paint, measurements=(replace(low, lab=(low.lab[0] * 1.1, *low.lab[1:])), *paint.measurements[1:])
    )
    assert misses(off)[1:].max() < 0.5
    assert math.isfinite(misses(off)[0])

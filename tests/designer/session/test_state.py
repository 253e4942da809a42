"""What the window shows is what the paint says: checked against the readings themselves."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from brdf_designer.colour.display import component_tracks, lab_to_codes
from brdf_designer.colour.patches import lab_text
from brdf_designer.session.state import colours_of, curves_of

from brdf_suite.documents.paint import solid_paint
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.resources import resource_names


@pytest.fixture(scope="module")
def fitter() -> PaintFitter:
    return PaintFitter(time_limit_s=60.0)  # exact, however busy the machine is


def test_the_curve_passes_through_the_readings(fitter):
    for name in resource_names("paints", ".brdfpaint"):
        paint = load_shipped_paint(name)
        curves = curves_of(fitter.fit(paint))
        for m in paint.measurements:
            if m.illumination_deg != 45.0:
                continue  # the curves are those of the light that most readings have
            model = np.interp(m.aspecular_deg, curves.gamma_deg, curves.model[:, 0])
            assert model == pytest.approx(m.lab[0], abs=0.01), (name, m.aspecular_deg)


def test_the_strip_begins_and_ends_with_the_readings(fitter):
    paint = load_shipped_paint("blue")
    curves = curves_of(fitter.fit(paint))
    ends, _ = lab_to_codes([paint.lab_at(15.0), paint.lab_at(110.0)])
    assert np.abs(curves.strip_rgb[[0, -1]].astype(int) - ends.astype(int)).max() <= 1
    assert curves.measured_deg == (15.0, 110.0)


def test_white_black_and_grey_have_their_codes():
    codes, inside = lab_to_codes([[100, 0, 0], [0, 0, 0], [53.585, 0, 0], [128, 0, 0]])
    assert codes.tolist() == [[255] * 3, [0] * 3, [128] * 3, [255] * 3]
    assert inside.tolist() == [True, True, True, False]


def test_a_track_at_its_own_value_is_the_colour_itself():
    lab = (40.0, 20.0, -30.0)
    own, _ = lab_to_codes(lab)
    (own_tracks,) = component_tracks(np.array([lab]), [np.array([lab[i]]) for i in range(3)])
    for component, (codes, _) in enumerate(own_tracks):
        assert codes[0].tolist() == own.tolist(), component
    (((lightness, _), _, _),) = component_tracks(np.array([lab]), [np.array([0.0, 80.0])] * 3)
    assert lightness[1].sum() > lightness[0].sum()


def test_flop_of_a_solid_is_zero_and_needs_its_angles():
    paint = solid_paint("x", (50.0, 0.0, 0.0))
    assert colours_of(paint).flop.value == 0.0
    items = tuple(
        dataclasses.replace(m, aspecular_deg=25.0) if m.aspecular_deg == 15.0 else m
        for m in paint.measurements
    )
    assert colours_of(dataclasses.replace(paint, measurements=items)).flop is None


def test_gamut_is_shown_per_reading():
    paint = solid_paint("x", (60.0, 0.0, 0.0)).with_lab(110.0, (30.0, 0.0, -90.0))
    assert [angle.in_gamut for angle in colours_of(paint).angles] == [True, True, False]


def test_no_minus_stands_before_nothing():
    assert lab_text((50.0, -0.04, -0.06)) == "L* 50.0   a* 0.0   b* −0.1"

"""The plane of a* and b*: its picture, where the screen's colours end, and what a paint reaches."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.appearance.colour.spaces import DISPLAY_P3_SPACE, SRGB_SPACE, in_display_gamut
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.paint import Paint
from brdf_suite.paint_design.colour_plane import SIZE, colour_plane, hue_codes, is_reachable, reachable_box
from brdf_suite.paint_design.feasible import cone_of_lobes
from brdf_suite.paint_design.feasible_colours import nearest_in_cone
from brdf_suite.pipeline.lobe_fit import LobeFit, PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint


@pytest.fixture(scope="module")
def blue_fit() -> LobeFit:
    fitter = PaintFitter(time_limit_s=60.0)
    try:
        return fitter.fit(load_shipped_paint("blue"))
    finally:
        fitter.close()


def test_the_picture_has_the_colours_of_its_places() -> None:
    plane = colour_plane(60.0, 80.0)
    axis = np.linspace(-80.0, 80.0, SIZE)
    for row, column in ((SIZE // 2, SIZE // 2), (40, 60), (55, 30)):
        lab = np.array([60.0, axis[column], axis[::-1][row]])
        assert in_display_gamut(lab)
        rho = SRGB_SPACE.of_working(lab_to_working(lab))
        assert plane.codes[row, column] == pytest.approx(255.0 * SRGB_SPACE.encode(rho), abs=0.51)


@settings(max_examples=settings.default.max_examples // 4)
@given(st.floats(8.0, 92.0), st.sampled_from(["sRGB", "Display P3"]))
def test_the_boundary_lies_between_what_a_screen_can_show_and_what_not(lightness: float, name: str) -> None:
    space = SRGB_SPACE if name == "sRGB" else DISPLAY_P3_SPACE
    plane = colour_plane(lightness, 120.0, space=space)
    assert len(plane.gamut) > 20
    ends = plane.gamut.reshape(-1, 2)
    size = np.linalg.norm(ends, axis=-1, keepdims=True)
    outwards = ends / size
    step = 240.0 / (SIZE - 1)
    for away, shown in ((-step, True), (step, False)):
        beside = np.concatenate((np.full((len(ends), 1), lightness), ends + away * outwards), axis=-1)
        # Where the boundary runs nearly towards grey a step along it says nothing.
        assert np.mean(in_display_gamut(beside, name) == shown) > 0.9


def test_no_screen_shows_what_is_brighter_than_its_white() -> None:
    assert len(colour_plane(130.0, 100.0).gamut) == 0


def test_a_ring_begins_with_red_and_goes_on_to_yellow() -> None:
    red, yellow, green, blue = hue_codes(4).astype(int).tolist()
    assert red[0] > red[1]
    assert yellow[2] == min(yellow)
    assert green[0] < green[1]
    assert blue[2] == max(blue)


@pytest.mark.parametrize("index", [0, 1, 2])
def test_what_is_in_the_box_can_be_reached_and_what_is_not_cannot(blue_fit: LobeFit, index: int) -> None:
    box = reachable_box(blue_fit, index)
    labs = np.array([row.lab for row in blue_fit.readings])
    assert is_reachable(box, tuple(labs[index]))
    columns, share = cone_of_lobes(blue_fit)
    now = lab_to_working(labs[index])
    low, high = np.array(box.low), np.minimum(np.array(box.high), 3.0 * now)
    for place, reached in ((low + 0.05 * (high - low), True), (0.5 * low, False), (1.6 * high, False)):
        asked = labs.copy()
        asked[index] = working_to_lab(place)
        beyond = not reached and not np.all((place >= box.low) & (place <= box.high))
        missed = delta_e_2000(asked, nearest_in_cone(columns, share, asked)).max()
        if reached:
            assert missed < 1.0
        elif beyond and np.abs(place - now).max() > 1e-3:
            assert missed > 0.5


def test_no_box_where_no_lobes_meet_the_other_readings(blue_fit: LobeFit) -> None:
    paint: Paint = blue_fit.paint
    items = list(paint.measurements)
    # Lightness that rises again away from the mirror direction.
    items[1], items[2] = replace(items[1], lab=(10.0, 0.0, 0.0)), replace(items[2], lab=(40.0, 0.0, 0.0))
    fitter = PaintFitter(time_limit_s=60.0)
    try:
        fit = fitter.fit(replace(paint, measurements=tuple(items)))
    finally:
        fitter.close()
    assert reachable_box(fit, 0) is None
    assert reachable_box(fit, 2) is not None

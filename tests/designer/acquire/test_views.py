"""The views of the assistant: pictures with marks, the mask and its brush, curves, maps; fed by arrays."""

from __future__ import annotations

import os

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
import pytest
from brdf_designer.acquire.mask.history import MaskHistory
from brdf_designer.acquire.mask.view import MaskView
from brdf_designer.acquire.plots.lines_plot import Axis, Curve, LinesPlot
from brdf_designer.acquire.plots.map_plot import MapPlot
from brdf_designer.acquire.plots.marks import Area, Differences, Outline, Points
from brdf_designer.acquire.plots.tone import area_of, drawn, image_of, tones_of_codes, tones_of_linear
from brdf_designer.acquire.plots.view import PictureView
from brdf_designer.acquire.reconstruction.coverage_page import coverage_map
from brdf_designer.acquire.states import CoverageState
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

BLACK = image_of(np.zeros((40, 60), np.uint8))


def shown(widget, qtbot, size=(240, 200)):
    qtbot.addWidget(widget)
    widget.resize(*size)
    # A widget that is not on the screen yet may take another size, and with it other places of its picture.
    with qtbot.waitExposed(widget):
        widget.show()
    return widget


# Tones.


def test_a_code_is_drawn_as_its_share_of_full_scale_and_a_stop_doubles_it():
    codes = np.array([[0, 1024, 2048, 4095]], np.uint16)
    plain = drawn(tones_of_codes(codes, 12))
    brighter = drawn(tones_of_codes(codes, 12), 1.0)
    assert [plain.pixelColor(x, 0).red() for x in range(4)] == [0, 137, 188, 255]
    assert brighter.pixelColor(1, 0).red() == 188
    assert brighter.pixelColor(2, 0).red() == 255


def test_a_merged_picture_keeps_its_ratios_over_many_stops():
    linear = np.array([[1e-3, 1e-1, 10.0]])
    tones = tones_of_linear(linear, white=10.0)
    assert tones.values[tones.codes] == pytest.approx(linear / 10.0, rel=2e-4)
    assert drawn(tones).pixelColor(2, 0).red() == 255
    # What shows nothing yet does so a few stops brighter.
    assert drawn(tones, 13.3).pixelColor(0, 0).red() == 255


@pytest.mark.parametrize("bad", [np.nan, np.inf, -1.0])
def test_what_is_no_radiance_is_black(bad):
    assert drawn(tones_of_linear(np.array([[bad, 1.0]]), white=1.0)).pixelColor(0, 0).red() == 0


# The picture.


def test_a_picture_is_framed_zoomed_about_the_cursor_and_framed_again(qtbot):
    view = shown(PictureView("picture"), qtbot)
    view.show_image(BLACK)
    framed = view.scale
    at = QPointF(70.0, 60.0)
    under = view.to_picture(at)
    view.zoom(3.0, at)
    assert view.scale == pytest.approx(3.0 * framed)
    after = view.to_picture(at)
    assert (after.x(), after.y()) == pytest.approx((under.x(), under.y()))
    QTest.keyClick(view, Qt.Key.Key_F)
    assert view.scale == framed
    view.show_image(BLACK)  # another one of its size stays where it is
    assert view.scale == framed


def test_the_pixel_under_the_cursor_is_reported_and_none_outside(qtbot):
    view = shown(PictureView("picture"), qtbot)
    view.show_image(BLACK)
    at = view.to_screen.map(QPointF(12.5, 7.5))

    def is_there(*place):
        return place == pytest.approx((12.5, 7.5), abs=1.0)

    # The platform sends moves of its own, when it comes to it.
    with qtbot.waitSignal(view.hovered, check_params_cb=is_there):
        QTest.mouseMove(view, QPoint(round(at.x()), round(at.y())))
    with qtbot.waitSignal(view.left_picture):
        QTest.mouseMove(view, QPoint(1, 1))


def test_marks_are_drawn_over_the_picture_and_named(qtbot):
    view = shown(PictureView("picture"), qtbot)
    view.show_image(BLACK)
    before = view.grab().toImage()
    places = np.array([[10.0, 10.0], [50.0, 30.0]])
    for mark in (
        Outline(places, "outline", dashed=True),
        Points(places, "rings", "ring"),
        Points(places, "dots", "dot"),
        Differences(places, places + 4.0, "off", 2.0),
        Area(area_of(np.ones((40, 60), bool)), "left out"),
    ):
        view.show_marks([mark])
        assert mark.name in view.accessibleDescription()
        assert view.grab().toImage() != before, mark


def test_an_empty_picture_says_why(qtbot):
    view = shown(PictureView("picture", "Open one."), qtbot)
    assert view.accessibleDescription() == ""
    view.show_empty("None can be read.")
    assert view.accessibleDescription() == "None can be read."
    view.grab()


# The mask.

STROKES = st.lists(
    st.tuples(
        st.floats(-5.0, 45.0),
        st.floats(-5.0, 35.0),
        st.floats(-5.0, 45.0),
        st.floats(0.5, 20.0),
        st.booleans(),
    ),
    min_size=1,
    max_size=6,
)


@given(STROKES)
@settings(max_examples=settings.default.max_examples // 2)
def test_every_stroke_is_one_step_and_as_many_undos_give_the_mask_back(strokes):
    history = MaskHistory(np.ones((30, 40), bool))
    states = [history.used.copy()]
    for x, y, other, radius, use in strokes:
        history.begin()
        history.dab((x, y), (other, y), radius, use=use)
        history.dab((other, y), (x, x), radius, use=use)
        if history.end():
            states.append(history.used.copy())
    for state in reversed(states[:-1]):
        assert history.undo()
        assert np.array_equal(history.used, state)
    assert not history.undo()
    for state in states[1:]:
        assert history.redo()
        assert np.array_equal(history.used, state)


def test_a_dab_is_round_and_of_its_radius():
    history = MaskHistory(np.ones((41, 41), bool))
    history.dab((20.5, 20.5), (20.5, 20.5), 10.0, use=False)
    assert (~history.used).sum() == pytest.approx(np.pi * 100.0, rel=0.03)
    assert not history.used[20, 11]
    assert history.used[20, 9]


def test_the_brush_paints_by_mouse_and_ctrl_the_other_way_round(qtbot):
    view = shown(MaskView("mask"), qtbot)
    view.show_image(BLACK)
    view.show_mask(np.ones((40, 60), bool))
    view.set_radius(5.0)

    def drag(keys=Qt.KeyboardModifier.NoModifier):
        start, end = (view.to_screen.map(QPointF(*p)).toPoint() for p in ((15.0, 20.0), (45.0, 20.0)))
        QTest.mousePress(view, Qt.MouseButton.LeftButton, keys, start)
        QTest.mouseMove(view, end)
        QTest.mouseRelease(view, Qt.MouseButton.LeftButton, keys, end)

    with qtbot.waitSignal(view.mask_edited):
        drag()
    assert not view.history.used[20, 15:45].any()
    assert view.history.used[5].all()
    with qtbot.waitSignal(view.mask_edited):
        drag(Qt.KeyboardModifier.ControlModifier)
    assert view.history.used.all()
    view.undo()
    view.undo()
    assert view.history.used.all()
    view.redo()
    assert not view.history.used[20, 30]


def test_the_brush_paints_by_keys_alone(qtbot):
    view = shown(MaskView("mask"), qtbot)
    view.show_image(BLACK)
    view.show_mask(np.ones((40, 60), bool))
    with qtbot.waitSignals([view.radius_changed, view.mask_edited]):
        QTest.keyClick(view, Qt.Key.Key_BracketLeft)
        QTest.keyClick(view, Qt.Key.Key_Space)
    assert not view.history.used[20, 30]
    with qtbot.waitSignal(view.mode_changed):
        QTest.keyClick(view, Qt.Key.Key_X)
    QTest.keyClick(view, Qt.Key.Key_Space)
    assert view.history.used.all()


# Plots.


def test_a_gap_and_what_has_no_logarithm_are_left_out(qtbot):
    plot = shown(LinesPlot("plot", Axis("x"), Axis("y", log=True)), qtbot)
    plot.show_curves([Curve(np.arange(4.0), np.array([1.0, 0.0, np.nan, 100.0]), "one")], ((2.0, "mark"),))
    assert plot.accessibleDescription() == "one"
    assert np.isfinite(plot.plot.listDataItems()[0].getData()[1]).sum() == 2
    plot.grab()


def test_small_angles_have_room_on_a_root_axis(qtbot):
    plot = shown(LinesPlot("plot", Axis("x", root=True, reach=(0.0, 90.0)), Axis("y")), qtbot)
    plot.show_curves([Curve(np.array([0.0, 22.5, 90.0]), np.zeros(3), "one")])
    x = plot.plot.listDataItems()[0].getData()[0]
    assert x[1] / x[2] == pytest.approx(0.5)


def coverage() -> CoverageState:
    share = np.full((90, 90), np.nan)
    share[:60] = np.linspace(0.0, 1.0, 90)
    centres = np.arange(90) + 0.5
    return CoverageState(share, 100.0 * np.nan_to_num(share), 0.1 + 0.0 * share, centres, centres)


@pytest.mark.parametrize("what", ["share", "pixels", "error"])
def test_a_map_hatches_what_was_not_measured_and_names_its_scale(qtbot, what):
    drawn_map = coverage_map(coverage(), what)
    # The first column's share is 0: nothing was measured there.
    assert np.isnan(drawn_map.values[60:]).all()
    assert np.isnan(drawn_map.values[:, 0]).all()
    assert np.isfinite(drawn_map.values[:60, 1:]).all()
    assert drawn_map.scale
    assert all(0.0 <= share <= 1.0 for share, _ in drawn_map.scale_ticks)
    plot = shown(MapPlot("map"), qtbot, (400, 300))
    plot.show_map(drawn_map)
    assert "%" in plot.accessibleDescription()
    plot.grab()


def test_round_angles_lie_where_their_bins_are():
    ticks = {text: share for share, text in coverage_map(coverage(), "share").x_ticks}
    assert ticks["0"] == 0.0
    assert ticks["30"] == pytest.approx(1.0 / 3.0)
    assert ticks["90"] == 1.0


def test_the_cell_under_the_cursor_is_reported(qtbot):
    plot = shown(MapPlot("map"), qtbot, (400, 300))
    plot.show_map(coverage_map(coverage(), "share"))
    place = plot._place()

    def is_the_middle(*cell):
        return cell == pytest.approx((45, 45), abs=2)

    # The platform sends moves of its own, when it comes to it.
    with qtbot.waitSignal(plot.hovered, check_params_cb=is_the_middle):
        QTest.mouseMove(plot, place.center().toPoint())
    with qtbot.waitSignal(plot.hovered, check_params_cb=lambda *cell: cell == (-1, -1)):
        QTest.mouseMove(plot, QPoint(1, 1))

"""The plane of a reading: dragged by real mouse events, moved by keys, with what the paint reaches."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_designer.assembly import Designer
from brdf_designer.colour.plane_editor import PlaneEditor
from brdf_designer.colour.reach import ReachControl
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.documents.paint import solid_paint

LEFT = Qt.MouseButton.LeftButton
SHIFT, CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def plane(program: Designer, qtbot) -> PlaneEditor:
    program.window.activateWindow()
    program.window.section("colour").set_open(True)
    plane = program.window.editors.plane
    plane.view.clearFocus()  # ends the keys of another test
    index = program.session.paint.index_of(45.0, 45.0)
    plane.choose(index)
    program.window.command("edit_one").trigger()
    settle(program, qtbot)
    return plane


def settle(program: Designer, qtbot) -> None:
    qtbot.waitUntil(lambda: program.session.is_quiet and program.feature(ReachControl).is_idle)


def place(point: QPointF) -> QPoint:
    return point.toPoint()


def labs(program: Designer) -> dict[float, tuple[float, float, float]]:
    return {m.aspecular_deg: m.lab for m in program.session.paint.measurements}


def test_a_drag_changes_one_angle_in_one_step_and_keeps_lightness(program, plane, qtbot) -> None:
    before, view = labs(program), plane.view
    start = place(view.point_of(*before[45.0][1:]))
    QTest.mousePress(view, LEFT, pos=start)
    for far in (4, 9, 15):
        QTest.mouseMove(view, start + QPoint(far, -far))
    during = labs(program)
    # What is seen follows while the button is down.
    assert f"{during[45.0][1]:.1f}" in program.window.patches.patches[1].numbers.text()
    QTest.mouseRelease(view, LEFT, pos=start + QPoint(15, -15))
    after = labs(program)
    assert after[45.0][0] == before[45.0][0]
    assert after[45.0][1] > before[45.0][1]
    assert after[45.0][2] > before[45.0][2]
    assert {angle: after[angle] for angle in (15.0, 110.0)} == {a: before[a] for a in (15.0, 110.0)}
    assert program.store.stack.count() == 1
    assert program.window.undo_action.text() == "&Undo Change Chroma and Hue at 45°"
    program.window.undo_action.trigger()
    assert labs(program) == before


def test_a_click_beside_the_handle_brings_it_there(program, plane) -> None:
    view = plane.view
    QTest.mouseClick(view, LEFT, pos=place(view.point_of(20.0, 10.0)))
    _, a, b = labs(program)[45.0]
    # A pixel is about half a unit.
    assert (a, b) == pytest.approx((20.0, 10.0), abs=1.0)
    assert program.store.stack.count() == 1


def test_lightness_is_typed_after_a_press_on_an_angle(program, plane, qtbot) -> None:
    last = max(plane.buttons)
    QTest.mouseClick(plane.buttons[last], LEFT)
    assert plane.index == last
    for key in "37":
        QTest.keyClick(plane.field.lineEdit(), key)
    QTest.keyClick(plane.field.lineEdit(), Qt.Key.Key_Return)
    settle(program, qtbot)
    assert program.session.paint.measurements[last].lab[0] == 37.0


def test_a_mark_of_another_angle_is_taken_by_a_press(program, plane) -> None:
    view, before = plane.view, labs(program)
    QTest.mouseClick(view, LEFT, pos=place(view.point_of(*before[15.0][1:])))
    assert program.session.paint.measurements[plane.index].aspecular_deg == 15.0
    assert plane.buttons[plane.index].isChecked()
    assert labs(program) == before


def test_the_ring_turns_all_hues_and_keeps_lightness_and_chroma(program, plane) -> None:
    view = plane.view
    before = lab_to_lch([m.lab for m in program.session.paint.measurements])
    hue = float(before[plane.index, 2])
    QTest.mousePress(view, LEFT, pos=place(view.ring_point(hue)))
    for by in (10.0, 25.0, 40.0):
        QTest.mouseMove(view, place(view.ring_point(hue + by)))
    QTest.mouseRelease(view, LEFT, pos=place(view.ring_point(hue + 40.0)))
    after = lab_to_lch([m.lab for m in program.session.paint.measurements])
    np.testing.assert_allclose(after[:, :2], before[:, :2], atol=1e-3)
    turned = (after[:, 2] - before[:, 2]) % 360.0
    assert turned == pytest.approx(np.full(len(turned), 40.0), abs=1.0)
    assert np.ptp(turned) < 0.01
    assert program.store.stack.count() == 1
    assert program.window.undo_action.text() == "&Undo Turn Hue at All Angles"


def test_keys_move_the_handle_turn_the_ring_and_go_to_the_next_angle(program, plane, qtbot) -> None:
    view, before = plane.view, labs(program)
    view.setFocus()
    for _ in range(3):
        QTest.keyClick(view, Qt.Key.Key_Right)
    QTest.keyClick(view, Qt.Key.Key_Up, SHIFT)
    lightness, a, b = before[45.0]
    assert labs(program)[45.0] == pytest.approx((lightness, a + 1.5, b + 0.05))
    # A burst of keys is one step.
    assert program.store.stack.count() == 1
    QTest.keyClick(view, Qt.Key.Key_PageDown)
    assert program.session.paint.measurements[plane.index].aspecular_deg == 110.0
    QTest.keyClick(view, Qt.Key.Key_Left, CONTROL)
    QTest.keyClick(view, Qt.Key.Key_Left, CONTROL)
    hues = [float(lab_to_lch(one[15.0])[2]) for one in (before, labs(program))]
    assert hues[1] - hues[0] == pytest.approx(2.0, abs=0.01)
    assert program.store.stack.count() == 2


def test_with_all_the_other_angles_go_along(program, plane) -> None:
    program.window.command("edit_all").trigger()
    view, before = plane.view, labs(program)
    view.setFocus()
    QTest.keyClick(view, Qt.Key.Key_Up)
    for angle, lab in labs(program).items():
        assert lab == pytest.approx((before[angle][0], before[angle][1], before[angle][2] + 0.5))
    assert program.window.undo_action.text() == "&Undo Change Chroma and Hue at All Angles"
    program.window.command("edit_one").trigger()


def test_what_is_reachable_is_drawn_and_said(program, plane, qtbot) -> None:
    assert "what this paint can reach" in plane.legend.text()
    seen = plane.view.grab().toImage()
    # Yellow light cannot come between a blue near the mirror direction and a blue at grazing.
    QTest.mouseClick(plane.view, LEFT, pos=place(plane.view.point_of(0.0, 20.0)))
    settle(program, qtbot)
    assert "outside what this paint can reach" in plane.legend.text()
    program.window.undo_action.trigger()
    settle(program, qtbot)
    program.session.set_paint(solid_paint("grey", (50.0, 0.0, 0.0)), "Grey")
    settle(program, qtbot)
    assert plane.view.grab().toImage() != seen


def test_the_disc_is_of_the_lightness_that_the_slider_gives(program, plane, qtbot) -> None:
    middle = place(plane.view.point_of(-3.0, -3.0))
    dark = plane.view.grab().toImage().pixelColor(middle)
    plane.field.setValue(80.0)
    settle(program, qtbot)
    assert labs(program)[45.0][0] == 80.0
    light = plane.view.grab().toImage().pixelColor(middle)
    assert light.red() > dark.red() + 80


def test_folded_numbers_are_right_when_they_are_unfolded(program, plane, qtbot) -> None:
    numbers, editor = program.window.editors.numbers, program.window.editors.editors[1]
    numbers.set_open(False)
    plane.field.setValue(33.0)
    numbers.set_open(True)
    qtbot.waitUntil(lambda: editor.fields[0].value() == 33.0)

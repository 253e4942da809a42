"""The flop moved on its strip: grips that are dragged, stepped by keys and turned back; one named step a gesture."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from brdf_designer.colour.flop_grips import GRIPS, flop_of
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QHelpEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolTip

from brdf_suite.appearance.flop.edits import measure_flop


def place(key: str, end: int) -> int:
    return next(i for i, grip in enumerate(GRIPS) if (grip.key, grip.end) == (key, end))


def now(designer):
    paint = designer.store.value
    return measure_flop([m.aspecular_deg for m in paint.measurements], [m.lab for m in paint.measurements])


def steps(designer) -> list[str]:
    stack = designer.store.stack
    return [stack.text(i) for i in range(stack.count())]


def move(band, start: QPoint, up: int, keys=Qt.KeyboardModifier.NoModifier) -> None:
    """Move the mouse with the button down; QTest.mouseMove knows of no keys."""
    point = QPointF(start - QPoint(0, up))
    left = Qt.MouseButton.LeftButton
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        point,
        QPointF(band.mapToGlobal(point.toPoint())),
        Qt.MouseButton.NoButton,
        left,
        keys,
    )
    QApplication.sendEvent(band, event)


def drag(band, grip: int, *ups: int, keys=Qt.KeyboardModifier.NoModifier) -> None:
    start = band.grip_centres()[grip].toPoint()
    QTest.mousePress(band, Qt.MouseButton.LeftButton, pos=start)
    for up in ups:
        move(band, start, up, keys)
    QTest.mouseRelease(band, Qt.MouseButton.LeftButton, pos=start)


@pytest.mark.parametrize(
    ("key", "end", "name", "sense"),
    [
        ("lightness", 1, "Change Lightness Travel", 1.0),
        ("lightness", -1, "Change Lightness Travel", -1.0),
        ("chroma", 1, "Change Chroma Travel", 1.0),
        ("hue", -1, "Change Hue Travel", -1.0),
        ("index", 0, "Change Flop Index", 1.0),
    ],
)
def test_a_grip_is_dragged_as_one_named_step(desk, key, end, name, sense):
    band, grip = desk.window.strip.band, place(key, end)
    before, asked = desk.store.value, band.amount(grip)
    face = before.lab_at(45.0)
    drag(band, grip, 4, 9, 20)
    assert steps(desk) == [name]
    change = band.amount(grip) - asked
    assert change * sense > 0.5, "up is more of it at this end"
    assert desk.store.value.lab_at(45.0) == face
    name_of_value = {"lightness": "lightness", "chroma": "chroma", "hue": "hue_deg", "index": "index"}[key]
    assert getattr(now(desk), name_of_value) == pytest.approx(asked + change)
    desk.desk.undo()
    assert desk.store.value == before


def test_a_drag_that_comes_back_leaves_no_step(desk):
    drag(desk.window.strip.band, place("lightness", 1), 12, 5, 0)
    assert steps(desk) == []


def test_shift_drags_finely(desk):
    band, grip = desk.window.strip.band, place("lightness", 1)
    asked = band.amount(grip)
    drag(band, grip, 20, keys=Qt.KeyboardModifier.ShiftModifier)
    assert 0.0 < band.amount(grip) - asked <= 0.5


def test_the_keys_choose_a_grip_and_move_it_in_one_step(desk):
    band = desk.window.strip.band
    band.setFocus(Qt.FocusReason.TabFocusReason)
    QTest.mouseClick(band, Qt.MouseButton.LeftButton, pos=band.grip_centres()[0].toPoint())
    QApplication.sendEvent(band, QEvent(QEvent.Type.Leave))
    for _ in range(place("chroma", 1)):
        QTest.keyClick(band, Qt.Key.Key_Right)
    asked = band.amount(place("chroma", 1))
    for _ in range(3):
        QTest.keyClick(band, Qt.Key.Key_Up)
    QTest.keyClick(band, Qt.Key.Key_Down)
    assert band.amount(place("chroma", 1)) == pytest.approx(asked + 1.0)
    QTest.keyClick(band, Qt.Key.Key_Left)
    assert steps(desk) == ["Change Chroma Travel"]
    assert "travel" in band.accessibleDescription()
    QTest.keyClick(band, Qt.Key.Key_Right)
    QTest.keyClick(band, Qt.Key.Key_Right)
    assert "Δh travel" in band.accessibleDescription()
    QTest.keyClick(band, Qt.Key.Key_Right)
    assert "ΔL* travel" in band.accessibleDescription(), "round and round"


def test_a_double_click_goes_back_to_what_was_opened(desk):
    band, grip = desk.window.strip.band, place("lightness", 1)
    asked = band.amount(grip)
    drag(band, grip, 25)
    assert band.amount(grip) != asked
    QTest.mouseDClick(band, Qt.MouseButton.LeftButton, pos=band.grip_centres()[grip].toPoint())
    assert band.amount(grip) == pytest.approx(asked)
    assert len(steps(desk)) == 2


def test_a_grip_says_what_it_is_with_its_unit(desk, qtbot):
    band, strip = desk.window.strip.band, desk.window.strip
    band.clearFocus()
    grip = place("hue", 1)
    at = band.grip_centres()[grip]
    move_to = QMouseEvent(
        QEvent.Type.MouseMove,
        at,
        QPointF(band.mapToGlobal(at.toPoint())),
        Qt.MouseButton.NoButton,
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(band, move_to)
    said = strip.caption.accessibleName()
    assert said.startswith(f"Δh travel {band.amount(grip):.1f}°")
    assert "from 15° to 110°" in said
    QApplication.sendEvent(
        band, QHelpEvent(QEvent.Type.ToolTip, at.toPoint(), band.mapToGlobal(at.toPoint()))
    )
    assert "degrees" in QToolTip.text()
    QToolTip.hideText()
    QApplication.sendEvent(band, QEvent(QEvent.Type.Leave))
    assert strip.caption.accessibleName().startswith("Flop (target above")


def test_what_a_paint_has_none_of_is_not_moved(desk):
    band = desk.window.strip.band
    desk.documents.new()  # a grey: no hue to travel
    assert math.isnan(band.amount(place("hue", 1)))
    drag(band, place("hue", 1), 20)
    assert steps(desk) == []
    drag(band, place("lightness", 1), -20)
    assert steps(desk) == ["Change Lightness Travel"]
    assert desk.store.value.lab_at(110.0)[0] < 50.0 < desk.store.value.lab_at(15.0)[0]


def test_without_an_end_beyond_the_face_there_are_no_grips(desk):
    paint = desk.store.value
    readings = tuple(
        type(m)(m.illumination_deg, angle, m.lab)
        for m, angle in zip(paint.measurements, (15.0, 25.0, 45.0), strict=True)
    )
    desk.desk.set_paint(replace(paint, measurements=readings), "Other angles")
    assert flop_of(desk.store.value) is None
    assert desk.window.strip.band.grip_at(desk.window.strip.band.grip_centres()[0]) is None

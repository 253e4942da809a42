"""Number field and colour slider through real events."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_qt.fields.colour_slider import ColourSlider
from brdf_qt.fields.number import NumberField, parse_number
from brdf_qt.fields.text import TextLine, TextNotes
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolTip


class Heard:
    """What a field said, in order."""

    def __init__(self, field) -> None:
        self.log: list[object] = []
        field.edited.connect(self.log.append)
        field.gesture_started.connect(lambda: self.log.append("start"))
        field.gesture_finished.connect(lambda: self.log.append("finish"))

    @property
    def values(self) -> list[float]:
        return [entry for entry in self.log if not isinstance(entry, str)]


@pytest.fixture
def field(qtbot) -> NumberField:
    field = NumberField("Gloss", "GU", 0.0, 200.0, 0.5, 1, 90.0)
    field.resize(120, 26)
    qtbot.addWidget(field)
    with qtbot.waitExposed(field):
        field.show()
    return field


def type_in(field: NumberField, text: str) -> None:
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)


@pytest.mark.parametrize(
    ("text", "number"),
    [("12.5", 12.5), ("12,5 GU", 12.5), ("−3", -3.0), (" .5", 0.5), ("1e2", 100.0), ("GU", None), ("", None)],
)
def test_parse_number(text, number):
    assert parse_number(text) == number


def test_a_typed_value_is_one_edit_without_a_gesture(field):
    heard = Heard(field)
    type_in(field, "82,5")
    assert heard.log == [82.5]
    assert field.text() == "82.5 GU"


@pytest.mark.parametrize(
    ("text", "value", "reported"),
    [
        ("999", 200.0, ["999 GU is above the maximum; the value was set to 200.0 GU."]),
        ("-3", 0.0, ["-3 GU is below the minimum; the value was set to 0.0 GU."]),
        ("200", 200.0, []),
        ("200.04", 200.0, []),
        ("12", 12.0, []),
    ],
)
def test_a_typed_value_beyond_the_range_goes_to_its_end_and_says_so(field, text, value, reported):
    heard = []
    field.limited.connect(heard.append)
    type_in(field, text)
    assert (field.value(), heard) == (value, reported)
    if reported:
        assert QToolTip.text() == reported[0]
    QToolTip.hideText()


def test_a_million_digits_are_bounded(field):
    heard = Heard(field)
    QGuiApplication.clipboard().setText("1" * 1_000_000)
    field.setFocus()
    QTest.keySequence(field, "Ctrl+V")
    assert field.value() == 200.0
    field.lineEdit().selectAll()
    field.lineEdit().insert("2" * 1_000_000)
    assert len(field.lineEdit().text()) <= 64
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert field.value() == 200.0
    assert heard.values == [200.0]


@pytest.mark.parametrize("text", ["1e400", "-1e400", "nan", "inf", "1e", ""])
def test_what_is_no_finite_number_changes_nothing(field, text):
    assert parse_number(text) in (None, 1.0)
    QGuiApplication.clipboard().setText(text)
    field.setFocus()
    if text != "1e":
        QTest.keySequence(field, "Ctrl+V")
        field.lineEdit().selectAll()
        field.lineEdit().insert(text)
        QTest.keyClick(field, Qt.Key.Key_Return)
        assert field.value() == 90.0


def test_a_pasted_value_beyond_the_range_says_so_too(field):
    heard = []
    field.limited.connect(heard.append)
    field.setFocus()
    field.selectAll()
    QGuiApplication.clipboard().setText("1e6 GU")
    QTest.keySequence(field, "Ctrl+V")
    assert field.value() == 200.0
    assert len(heard) == 1
    type_in(field, "20")
    assert len(heard) == 1
    QToolTip.hideText()


def test_an_angle_that_is_typed_beyond_its_range_is_the_same_angle_within(qtbot):
    field = NumberField("Azimuth", "°", -180.0, 180.0, 1.0, 1, 0.0)
    field.setWrapping(True)
    qtbot.addWidget(field)
    with qtbot.waitExposed(field):
        field.show()
    heard = []
    field.limited.connect(heard.append)
    type_in(field, "270")
    assert (field.value(), heard) == (-90.0, [])


def test_a_double_click_goes_back_to_what_the_document_had_when_it_was_opened(field):
    field.set_default(62.5)
    field.set_value(12.0)
    heard = Heard(field)
    QTest.mouseDClick(field.lineEdit(), Qt.MouseButton.LeftButton, pos=QPoint(30, 10))
    assert heard.log == [62.5]
    field.set_default(1e9)
    assert field.default == 200.0


def test_escape_takes_typing_back(field):
    heard = Heard(field)
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "12")
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert (field.value(), heard.log) == (90.0, [])


def test_a_value_that_is_set_says_nothing(field):
    heard = Heard(field)
    field.set_value(12.0)
    assert heard.log == []


def drag(widget, start: QPoint, moves: list[int], modifier=Qt.KeyboardModifier.NoModifier) -> None:
    QTest.mousePress(widget, Qt.MouseButton.LeftButton, modifier, start)
    for dx in moves:
        send_move(widget, start + QPoint(dx, 0), modifier)
    QTest.mouseRelease(widget, Qt.MouseButton.LeftButton, modifier, start + QPoint(moves[-1], 0))


def send_move(widget, place: QPoint, modifier) -> None:
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QMouseEvent

    event = QMouseEvent(
        QEvent.Type.MouseMove,
        QPointF(place),
        QPointF(widget.mapToGlobal(place)),
        Qt.MouseButton.NoButton,
        Qt.MouseButton.LeftButton,
        modifier,
    )
    QApplication.sendEvent(widget, event)


def test_a_sideways_drag_is_one_gesture(field):
    heard = Heard(field)
    drag(field.lineEdit(), QPoint(40, 10), [8, 20, 40])
    assert heard.log[0] == "start"
    assert heard.log[-1] == "finish"
    assert heard.log.count("start") == heard.log.count("finish") == 1
    assert field.value() == 95.0  # 40 pixels, 4 a step of .5


def test_shift_drags_finely(field):
    drag(field.lineEdit(), QPoint(40, 10), [8, 40], Qt.KeyboardModifier.ShiftModifier)
    assert field.value() == 90.5


def test_a_double_click_resets(field):
    field.set_value(12.0)
    heard = Heard(field)
    QTest.mouseDClick(field.lineEdit(), Qt.MouseButton.LeftButton, pos=QPoint(30, 10))
    assert heard.log == [90.0]


def test_copy_and_paste_carry_the_unit(field):
    field.setFocus()
    field.selectAll()
    QTest.keySequence(field, "Ctrl+C")
    assert QGuiApplication.clipboard().text() == "90.0 GU"
    QGuiApplication.clipboard().setText("  45,5 GU ")
    QTest.keySequence(field, "Ctrl+V")
    assert field.value() == 45.5


def turn_wheel(widget, clicks: int) -> None:
    place = QPointF(widget.rect().center())
    event = QWheelEvent(
        place,
        QPointF(widget.mapToGlobal(place.toPoint())),
        QPoint(0, 0),
        QPoint(0, 120 * clicks),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)


def test_wheel_turns_make_one_gesture_that_ends_after_a_pause(field, qtbot):
    heard = Heard(field)
    field.setFocus()
    for _ in range(3):
        turn_wheel(field, 1)
    assert field.value() == 91.5
    assert heard.log.count("start") == 1
    qtbot.waitUntil(lambda: "finish" in heard.log)


def test_the_wheel_over_a_field_without_focus_changes_nothing(field):
    field.clearFocus()
    turn_wheel(field, 3)
    assert field.value() == 90.0


@pytest.fixture
def slider(qtbot) -> ColourSlider:
    slider = ColourSlider("L*", "", 0.0, 150.0, 0.1)
    slider.resize(310, 22)
    qtbot.addWidget(slider)
    with qtbot.waitExposed(slider):
        slider.show()
    return slider


def test_a_slider_drag_moves_with_the_mouse_as_one_gesture(slider):
    slider.set_amount(75.0)
    heard = Heard(slider)
    drag(slider, QPoint(155, 11), [30, 60])
    assert heard.log[0] == "start"
    assert heard.log[-1] == "finish"
    assert slider.amount() == pytest.approx(105.0, abs=0.06)  # 300 pixels are 150 units


def test_a_click_jumps_to_its_place(slider):
    drag(slider, QPoint(5 + 100, 11), [0])
    assert slider.amount() == pytest.approx(50.0, abs=0.3)


def test_keys_step_the_slider_and_reach_its_ends(slider, qtbot):
    slider.set_amount(10.0)
    heard = Heard(slider)
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert slider.amount() == pytest.approx(10.5)
    QTest.keyClick(slider, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert slider.amount() == pytest.approx(10.6)
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert slider.amount() == 150.0
    assert heard.log.count("start") == 1
    slider.clearFocus()
    assert heard.log[-1] == "finish"


def test_an_amount_beyond_the_track_is_kept_exactly(slider):
    slider.set_amount(180.25)
    assert slider.amount() == 180.25


def test_the_track_shows_its_colours_and_hatches_what_is_outside(slider):
    rgb = np.tile(np.array([[200, 30, 30]], np.uint8), (48, 1))
    inside = np.arange(48) < 24
    slider.set_amount(0.0)
    slider.set_track(rgb, inside)
    picture = slider.grab().toImage()
    left = {picture.pixelColor(x, 11).name() for x in range(40, 140)}
    right = {picture.pixelColor(x, 11).name() for x in range(180, 290)}
    assert left == {"#c81e1e"}
    assert len(right) > 1


def test_a_number_that_changes_under_the_button_is_dragged_from_there(field):
    line, start = field.lineEdit(), QPoint(40, 10)
    QTest.mousePress(line, Qt.MouseButton.LeftButton, pos=start)
    field.set_value(20.0)
    send_move(line, start + QPoint(40, 0), Qt.KeyboardModifier.NoModifier)
    QTest.mouseRelease(line, Qt.MouseButton.LeftButton, pos=start)
    assert field.value() == 25.0


@pytest.mark.parametrize("kind", ["number", "line", "notes"])
@pytest.mark.parametrize(
    ("key", "shift"), [(Qt.Key.Key_E, False), (Qt.Key.Key_E, True), (Qt.Key.Key_Z, False)]
)
def test_a_field_leaves_keys_of_commands_to_the_window(qtbot, kind, key, shift):
    made = {"number": NumberField, "line": lambda name: TextLine(name, 20), "notes": TextNotes}
    widget = made[kind]("Field")
    qtbot.addWidget(widget)
    held = Qt.KeyboardModifier.ControlModifier
    if shift:
        held |= Qt.KeyboardModifier.ShiftModifier
    event = QKeyEvent(QEvent.Type.ShortcutOverride, key, held)
    # Not every platform has Ctrl+E for the end of a line: the field itself has to say no.
    event.accept()
    QApplication.sendEvent(widget, event)
    assert not event.isAccepted()
    letter = QKeyEvent(QEvent.Type.ShortcutOverride, Qt.Key.Key_1, Qt.KeyboardModifier.NoModifier, "1")
    letter.ignore()
    QApplication.sendEvent(widget, letter)
    assert letter.isAccepted(), "what is typed is not a command"

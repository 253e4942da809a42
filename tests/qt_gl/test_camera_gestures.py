"""Mouse and keys become intents."""

from __future__ import annotations

import pytest
from brdf_qt.gl.gestures import LIGHT_DEG_PER_PIXEL, ORBIT_DEG_PER_PIXEL, ZOOM_PER_NOTCH, CameraGestures
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

LEFT, MIDDLE, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton, Qt.MouseButton.RightButton
NONE, SHIFT, ALT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)
CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def widget(qtbot) -> QWidget:
    widget = QWidget()
    widget.resize(400, 200)
    widget.setMouseTracking(True)
    qtbot.addWidget(widget)
    with qtbot.waitExposed(widget):
        widget.show()
    return widget


@pytest.fixture
def heard(widget) -> list[tuple]:
    gestures = CameraGestures(widget)
    heard: list[tuple] = []
    for name in ("orbited", "panned", "zoomed", "light_turned", "framed", "started", "finished"):
        getattr(gestures, name).connect(lambda *args, name=name: heard.append((name, *args)))
    return heard


def drag(widget, button, modifiers, dx, dy, then=NONE) -> None:
    QTest.mousePress(widget, button, modifiers, QPoint(100, 100))
    # QTest.mouseMove knows no held buttons: send the event that a held button gives.
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QMouseEvent

    place = QPointF(100 + dx, 100 + dy)
    event = QMouseEvent(
        QEvent.Type.MouseMove, place, widget.mapToGlobal(place), Qt.MouseButton.NoButton, button, modifiers
    )
    QApplication.sendEvent(widget, event)
    QTest.mouseRelease(widget, button, then, QPoint(100 + dx, 100 + dy))


def wheel(widget, notches, sideways=False, modifiers=NONE) -> None:
    turn = QPoint(round(120 * notches), 0) if sideways else QPoint(0, round(120 * notches))
    place = QPointF(50, 50)
    event = QWheelEvent(
        place,
        widget.mapToGlobal(place),
        QPoint(),
        turn,
        Qt.MouseButton.NoButton,
        modifiers,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)


@pytest.mark.parametrize(
    ("button", "modifiers", "intent"),
    [
        (LEFT, NONE, ("orbited", -40 * ORBIT_DEG_PER_PIXEL, 10 * ORBIT_DEG_PER_PIXEL)),
        (LEFT, SHIFT, ("panned", 0.2, -0.05)),
        (MIDDLE, NONE, ("panned", 0.2, -0.05)),
        (LEFT, ALT, ("light_turned", 40 * LIGHT_DEG_PER_PIXEL)),
        (RIGHT, NONE, ("light_turned", 40 * LIGHT_DEG_PER_PIXEL)),
        (LEFT, CTRL, ("orbited", -4 * ORBIT_DEG_PER_PIXEL, ORBIT_DEG_PER_PIXEL)),
        (MIDDLE, CTRL, ("panned", 0.02, -0.005)),
        (RIGHT, CTRL, ("light_turned", 4 * LIGHT_DEG_PER_PIXEL)),
    ],
)
def test_a_drag(widget, heard, button, modifiers, intent) -> None:
    drag(widget, button, modifiers, 40, 10)
    assert [h[0] for h in heard] == ["started", intent[0], "finished"]
    assert heard[1][1:] == pytest.approx(intent[1:])


def test_what_a_drag_does_is_settled_at_its_start(widget, heard) -> None:
    drag(widget, LEFT, ALT, 40, 0, then=NONE)
    assert [h[0] for h in heard] == ["started", "light_turned", "finished"]


def test_other_buttons_and_moves_without_one_do_nothing(widget, heard) -> None:
    drag(widget, Qt.MouseButton.BackButton, NONE, 40, 10)
    QTest.mouseMove(widget, QPoint(10, 10))
    assert heard == []


def test_the_wheel_zooms_in_and_back(widget, heard) -> None:
    wheel(widget, 1)
    wheel(widget, -1)
    wheel(widget, 0.25)
    wheel(widget, 1, sideways=True)
    factors = [h[1] for h in heard]
    assert {h[0] for h in heard} == {"zoomed"}
    assert factors[0] == pytest.approx(ZOOM_PER_NOTCH)
    assert factors[0] < 1
    assert factors[0] * factors[1] == pytest.approx(1)
    assert factors[2] == pytest.approx(ZOOM_PER_NOTCH**0.25)
    assert factors[3] == pytest.approx(ZOOM_PER_NOTCH)
    # The cursor at (50, 50) of 400 x 200: left of the middle and above it.
    assert heard[0][2:] == pytest.approx((-0.75, 0.25))


def test_ctrl_zooms_finely(widget, heard) -> None:
    wheel(widget, 1, modifiers=CTRL)
    assert heard[0][1] == pytest.approx(ZOOM_PER_NOTCH**0.1)


def test_f_frames(widget, heard) -> None:
    QTest.keyClick(widget, Qt.Key.Key_F)
    QTest.keyClick(widget, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    assert heard == [("framed",)]


def test_a_drag_ends_when_the_widget_goes(widget, heard) -> None:
    QTest.mousePress(widget, LEFT, NONE, QPoint(100, 100))
    widget.hide()
    assert [h[0] for h in heard] == ["started", "finished"]
    # A button that stays down is down for every later test of this process.
    QTest.mouseRelease(widget, LEFT, NONE, QPoint(100, 100))

"""The path of docs/start/first_paint.md by keys alone: from an empty start to the file that is handed over."""

from __future__ import annotations

import pytest
from brdf_designer.export.control import HandoverControl
from brdf_designer.standard_comparison.control import StandardControl
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.reports.handover import read_paints

CONTROL = Qt.KeyboardModifier.ControlModifier
LABS = {15.0: (62.0, -4.0, -45.0), 45.0: (25.0, 4.0, -38.0), 110.0: (9.0, 8.0, -28.0)}


def press(key: Qt.Key, keys: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
    QTest.keyClick(QApplication.focusWidget(), key, keys)


def write(text: str) -> None:
    QTest.keyClicks(QApplication.focusWidget(), text)


def tab_to(name: str, most: int = 12) -> None:
    """Press Tab until what is called ``name`` has the focus."""
    for _ in range(most):
        press(Qt.Key.Key_Tab)
        now = QApplication.focusWidget()
        if name in (now.accessibleName(), now.objectName(), getattr(now, "text", str)()):
            return
    pytest.fail(f"{name} is not reached by {most} times Tab")


@pytest.fixture
def started(fresh, qtbot):
    designer, dialogs = fresh
    window = designer.window
    window.activateWindow()
    window.tabs.setFocus()
    qtbot.waitUntil(lambda: QApplication.focusWidget() is window.tabs)
    return designer, dialogs


def test_from_an_empty_start_to_the_hand_over(started, tmp_path, qtbot) -> None:
    designer, dialogs = started
    press(Qt.Key.Key_N, CONTROL)
    assert designer.documents.front.title == "Untitled"
    # The numbers wait to be typed; Tab goes from one to the next.
    for angle, lab in LABS.items():
        for name, value in zip(("L*", "a*", "b*"), lab, strict=True):
            if (angle, name) != (15.0, "L*"):
                tab_to(f"{name} at {angle:g}°, number", most=1)
            write(f"{value:g}")
    press(Qt.Key.Key_Return)
    assert {m.aspecular_deg: m.lab for m in designer.store.value.measurements} == LABS
    tab_to("Gloss 20°, GU")
    write("90")
    press(Qt.Key.Key_Return)
    press(Qt.Key.Key_D, CONTROL | Qt.KeyboardModifier.ShiftModifier)
    control = designer.feature(StandardControl)
    assert control.standard.paint == designer.store.value
    press(Qt.Key.Key_0, Qt.KeyboardModifier.AltModifier)
    tab_to("L* at 110°, number")
    write("6")
    press(Qt.Key.Key_Return)
    assert control.section.sentence.text() == "darker at 110°; slightly more flop"
    dialogs.path = tmp_path / "blue.cxf"
    press(Qt.Key.Key_E, CONTROL)
    assert QApplication.focusWidget().text().startswith("CxF3")
    section = designer.feature(HandoverControl).section
    qtbot.waitUntil(section.export.isEnabled)  # what is lost is read first
    tab_to("Export…")
    press(Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: "handover" in designer.window.messages.shown())
    (back,) = read_paints(dialogs.path).paints
    assert {m.aspecular_deg: m.lab for m in back.measurements} == LABS | {110.0: (6.0, 8.0, -28.0)}
    names = [designer.store.stack.text(i) for i in range(designer.store.stack.count())]
    assert names[-1] == "Change L* at 110°"
    press(Qt.Key.Key_Z, CONTROL)
    assert designer.store.value.lab_at(110.0) == LABS[110.0]


@pytest.mark.usefixtures("started")
def test_the_first_number_of_the_flop_where_that_is_edited() -> None:
    press(Qt.Key.Key_3, Qt.KeyboardModifier.AltModifier)
    press(Qt.Key.Key_0, Qt.KeyboardModifier.AltModifier)
    assert QApplication.focusWidget().objectName() == "flop_index"
    press(Qt.Key.Key_1, Qt.KeyboardModifier.AltModifier)


def test_the_plots_come_between_the_patches_and_the_inspector(started) -> None:
    designer, _ = started
    first = designer.window.plot.plots[0]
    tab_to(first.accessibleName())
    assert QApplication.focusWidget() is first
    tab_to("history_strip")

"""Labels that draw their text themselves: what a new text asks of the window, what is drawn, what is read aloud."""

from __future__ import annotations

import pytest
from brdf_qt.fields.labels import DrawnLabel, ElidedLabel
from brdf_qt.fields.marks import SIZE, Mark
from brdf_qt.window.status_line import StatusLine
from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QApplication, QHBoxLayout, QLabel, QMainWindow, QWidget


class Layouts(QObject):
    """Counts the layouts that a window is asked for."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self.count = 0
        window.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:  # noqa: N802 - the name is Qt's
        self.count += event.type() == QEvent.Type.LayoutRequest
        return False

    def of(self, act) -> int:
        QApplication.processEvents()
        self.count = 0
        act()
        QApplication.processEvents()
        return self.count


@pytest.fixture
def window(qtbot) -> QWidget:
    made = QWidget()
    made.setLayout(QHBoxLayout())
    qtbot.addWidget(made)
    return made


@pytest.mark.parametrize("kind", [DrawnLabel, ElidedLabel])
def test_only_a_text_of_another_width_asks_for_a_layout(window, qtbot, kind) -> None:
    label = kind("ΔE00 0.12")
    window.layout().addWidget(label)
    window.show()
    layouts = Layouts(window)
    assert layouts.of(lambda: label.setText("ΔE00 9.87")) == 0
    assert label.text() == "ΔE00 9.87"
    assert layouts.of(lambda: label.setText("ΔE00 9.87, stopped by the time limit")) > 0
    assert layouts.of(lambda: label.set_mark(Mark.LIMITED)) > 0


def test_a_status_cell_keeps_the_room_of_its_longest_text(qtbot) -> None:
    window = QMainWindow()
    qtbot.addWidget(window)
    line = StatusLine()
    window.setStatusBar(line)
    cell = line.cell("Fit")
    cell.set("Fit ΔE00 ≤ 0.12, 1.5 ms")
    window.show()
    layouts = Layouts(line)
    assert layouts.of(lambda: cell.set("Fit ΔE00 ≤ 0.2")) == 0
    assert layouts.of(lambda: cell.set("Fit ΔE00 ≤ 0.13, 2.5 ms", "what it is")) == 0
    assert "what it is" in cell.toolTip()
    assert layouts.of(lambda: cell.set("Fit ΔE00 ≤ 0.13, 2.5 ms, stopped by the time limit")) > 0


def test_a_mark_that_comes_before_the_first_showing_keeps_its_room(qtbot) -> None:
    window = QMainWindow()
    qtbot.addWidget(window)
    line = StatusLine()
    window.setStatusBar(line)
    window.show()
    cell = line.cell("Gamut", elastic=True)
    cell.set("Outside sRGB: 110°", mark=Mark.OUTSIDE)
    QApplication.processEvents()
    assert cell.isVisible()
    assert cell.contentsRect().left() >= SIZE


def test_it_wants_the_room_that_a_label_of_qt_wants(window) -> None:
    for text in ("", "Fit", "L* 25.0   a* −3.1   b* 7.9"):
        drawn, usual = DrawnLabel(text, window), QLabel(text, window)
        assert drawn.sizeHint().width() == pytest.approx(usual.sizeHint().width() if text else 0, abs=1)
        assert drawn.sizeHint().height() == usual.fontMetrics().height()


def test_it_is_drawn_as_a_label_of_qt_draws_it(window) -> None:
    drawn, usual = DrawnLabel("Fit ΔE00 0.12", window), QLabel("Fit ΔE00 0.12", window)
    for label in (drawn, usual):
        label.resize(160, 24)
    assert drawn.grab().toImage() == usual.grab().toImage()
    drawn.setText("Fit ΔE00 0.13")
    assert drawn.grab().toImage() != usual.grab().toImage()


def test_its_text_is_read_aloud_until_it_has_a_name(window) -> None:
    def spoken(label: QWidget) -> str:
        return QAccessible.queryAccessibleInterface(label).text(QAccessible.Text.Name)

    label = DrawnLabel("one", window)
    assert spoken(label) == "one"
    label.setText("two")
    assert spoken(label) == "two"
    label.setAccessibleName("Fit")
    label.setText("three")
    assert (spoken(label), label.text()) == ("Fit", "three")

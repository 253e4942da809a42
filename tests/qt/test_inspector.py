"""The inspector keeps in sight what was asked for, until the user looks elsewhere."""

from __future__ import annotations

import pytest
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.section import Inspector, Section
from brdf_qt.window.tab_panel import standard_tabs
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QAbstractSlider, QLineEdit, QWidget

TABS = standard_tabs("paint", "light", "form", "compare", "export")


@pytest.fixture
def inspector(qtbot) -> Inspector:
    """Three sections, together longer than the room; the last one holds a field and a filling."""
    inspector = Inspector()
    qtbot.addWidget(inspector)
    for name, height in (("first", 300), ("second", 300), ("last", 40)):
        section = inspector.add_section(Section(name, f"of_a_test_{name}"))
        section.add(QLineEdit())
        filling = section.add(QWidget())
        filling.setObjectName(f"filling_{name}")
        filling.setFixedHeight(height)
    inspector.resize(300, 400)
    inspector.show()
    qtbot.waitUntil(lambda: inspector.verticalScrollBar().maximum() > 0)
    return inspector


def foot(inspector: Inspector) -> int:
    """Return how far the end of the last section lies above the lower edge of the room, pixels."""
    section = inspector.sections[-1]
    end = section.mapTo(inspector.viewport(), QPoint(0, section.height())).y()
    return inspector.viewport().height() - end


def grow(inspector: Inspector, qtbot) -> None:
    before = inspector.verticalScrollBar().maximum()
    inspector.findChild(QWidget, "filling_last").setFixedHeight(200)
    qtbot.waitUntil(lambda: inspector.verticalScrollBar().maximum() >= before + 150)


def test_a_section_that_grows_later_stays_in_sight(inspector, qtbot) -> None:
    inspector.sections[-1].findChild(QLineEdit).setFocus()
    inspector.bring_in_sight(inspector.sections[-1])
    assert foot(inspector) >= 0
    grow(inspector, qtbot)
    assert foot(inspector) >= 0


def test_of_a_section_longer_than_the_room_the_beginning_is_in_sight(inspector, qtbot) -> None:
    inspector.findChild(QWidget, "filling_last").setFixedHeight(900)
    qtbot.waitUntil(lambda: inspector.verticalScrollBar().maximum() > 900)
    inspector.bring_in_sight(inspector.sections[-1])
    assert inspector.sections[-1].mapTo(inspector.viewport(), QPoint(0, 0)).y() == 0


@pytest.mark.parametrize("leaves", ["by scrolling", "by the keyboard"])
def test_who_has_gone_elsewhere_is_not_brought_back(inspector, qtbot, leaves: str) -> None:
    inspector.sections[-1].findChild(QLineEdit).setFocus()
    inspector.bring_in_sight(inspector.sections[-1])
    bar = inspector.verticalScrollBar()
    if leaves == "by scrolling":
        bar.triggerAction(QAbstractSlider.SliderAction.SliderToMinimum)
    else:
        inspector.sections[0].findChild(QLineEdit).setFocus()
        bar.setValue(0)
    grow(inspector, qtbot)
    assert bar.value() == 0


def test_the_panel_is_never_narrower_than_what_it_shows(qtbot) -> None:
    window = SuiteWindow("Trial", tabs=TABS)
    qtbot.addWidget(window)
    window.resize(1280, 720)
    page = window.panel.page
    wide = page.add_section(Section("wide", "of_a_test_wide")).add(QWidget())
    with qtbot.waitExposed(window):
        window.show()
    wide.setMinimumWidth(500)
    qtbot.waitUntil(lambda: page.widget().width() >= 500)
    bar = page.verticalScrollBar()
    edge = bar.mapTo(window, QPoint(bar.width(), 0)).x()
    assert page.viewport().width() >= page.widget().width()
    assert edge <= window.inspector_dock.geometry().right() + 1 <= window.width()

"""The strip of states: what is shown, and that going back loses nothing."""

from __future__ import annotations

import pytest
from brdf_designer.assembly import Designer
from brdf_designer.history.control import HistoryControl
from brdf_designer.history.strip import name_lines
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.program.settings import settings
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from brdf_suite.pipeline.material import load_shipped_paint


@pytest.fixture
def designer(program) -> Designer:
    """The Designer of the module: a window of its own for each test would take most of the time."""
    return program


@pytest.fixture
def history(designer, qtbot) -> HistoryControl:
    history = designer.feature(HistoryControl)
    qtbot.waitUntil(lambda: shown(history) == ["Opened"])  # filled when the program is idle
    return history


def shown(history) -> list[str]:
    model = history.strip.states
    return [model.index(row).data() for row in range(model.rowCount())]


def lighten(designer, *values: float) -> None:
    for value in values:
        paint = designer.store.value
        designer.session.set_paint(
            paint.with_lab(15.0, (value, *paint.lab_at(15.0)[1:])), f"Lighten to {value:g}"
        )


def test_every_step_is_a_state_once_the_edits_pause(designer, history, qtbot):
    qtbot.waitUntil(lambda: shown(history) == ["Opened"])
    designer.session.begin_gesture()
    for value in (63.0, 64.0, 65.0):
        paint = designer.store.value
        designer.session.set_paint(paint.with_lab(15.0, (value, 0.0, 0.0)), "Drag")
    designer.session.end_gesture()
    lighten(designer, 70)
    qtbot.waitUntil(lambda: shown(history) == ["Opened", "Drag", "Lighten to 70"])
    assert history.strip.states.present == 2
    assert history.strip.states.states[1].paint.lab_at(15.0)[0] == 65.0


def test_a_click_goes_to_a_state_at_once_and_undone_ones_stay(designer, history, qtbot):
    lighten(designer, 61, 62, 63, 64)
    qtbot.waitUntil(lambda: len(shown(history)) >= 5)
    assert len(shown(history)) == 5
    fits = []
    designer.session.fit_changed.connect(fits.append)
    strip = history.strip
    place = strip.visualRect(strip.states.index(1)).center()
    qtbot.mouseClick(strip.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert designer.store.value.lab_at(15.0)[0] == 61.0
    # One fit and not one for every step between.
    assert len(fits) == 1
    qtbot.waitUntil(lambda: strip.states.present == 1)
    assert len(shown(history)) == 5
    assert "undone" in strip.states.index(3).data(Qt.ItemDataRole.AccessibleTextRole)
    assert designer.window.redo_action.text() == "&Redo Lighten to 62"
    strip.setCurrentIndex(strip.states.index(4))
    QTest.keyClick(strip, Qt.Key.Key_Return)
    assert designer.store.value.lab_at(15.0)[0] == 64.0


def test_an_earlier_state_can_be_a_new_step_or_a_tab(designer, history, qtbot):
    lighten(designer, 61, 63)
    qtbot.waitUntil(lambda: len(shown(history)) >= 3)
    assert len(shown(history)) == 3
    to, step, tab = history.menu_of(0).actions()
    step.trigger()
    qtbot.waitUntil(lambda: shown(history)[-1] == "Restore Earlier State")
    assert designer.store.value == load_shipped_paint("blue")
    assert designer.store.stack.count() == 3
    history.menu_of(1).actions()[2].trigger()
    assert designer.store.value.lab_at(15.0)[0] == 61.0
    assert len(designer.documents.row) == 2
    assert (to.text(), tab.text()) == ("&Go to This State", "&Open in New Tab")


def test_each_tab_shows_its_own_history(designer, history, qtbot):
    lighten(designer, 61)
    designer.open("red")
    qtbot.waitUntil(lambda: shown(history) == ["Opened"])
    designer.window.tabs.setCurrentIndex(0)
    qtbot.waitUntil(lambda: shown(history) == ["Opened", "Lighten to 61"])


def test_it_is_hidden_and_shown_and_that_is_remembered(designer, history, qtbot):
    qtbot.waitUntil(lambda: shown(history) == ["Opened"])
    action = designer.window.command("drawer_history")
    action.trigger()
    qtbot.waitUntil(lambda: not history.strip.isVisible())
    assert settings().value("drawer/history", type=bool) is False
    lighten(designer, 61)
    qtbot.wait(80)
    assert shown(history) == ["Opened"]
    action.trigger()
    assert settings().value("drawer/history", type=bool) is True
    qtbot.waitUntil(lambda: len(shown(history)) >= 2)
    assert len(shown(history)) == 2


def test_the_names_of_steps_are_whole_or_end_in_an_ellipsis(history):
    strip = history.strip
    strip.set_compact(False)
    width = strip.sizeHintForIndex(strip.states.index(0)).width() - 8
    metrics = strip.fontMetrics()
    assert name_lines("Change Lightness Travel", metrics, width) == ["Change Lightness", "Travel"]
    first, last = name_lines("Change " + "Lightness " * 9, metrics, width)
    assert first == "Change Lightness"
    assert last.endswith("…")
    assert metrics.horizontalAdvance(last) <= width


def test_in_a_low_window_it_gives_way(designer, history, qtbot):
    designer.window.resize(1000, 640)
    qtbot.waitUntil(lambda: history.strip.is_compact)
    low = history.strip.height()
    designer.window.resize(1400, 900)
    qtbot.waitUntil(lambda: not history.strip.is_compact)
    assert low < history.strip.height() - 20


@given(
    values=st.lists(st.integers(0, 4), min_size=1, max_size=8),
    places=st.lists(st.integers(0, 8), max_size=6),
)
def test_any_state_is_reached_from_any_other(values, places):
    store = DocumentStore(-1)
    for value in values:
        store.set(value, str(value))
    states = store.states()
    assert [value for _, value in states][-1] == store.value
    changes = []
    store.changed.connect(lambda old, new: changes.append((old, new)))
    for place in places:
        place = min(place, len(states) - 1)
        before = store.value
        changes.clear()
        store.go_to(place)
        assert store.value == states[place][1]
        assert changes == ([] if before == store.value else [(before, store.value)])
        assert store.states() == states
        assert store.stack.index() == place

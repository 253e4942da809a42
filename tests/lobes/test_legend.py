"""The legend: what is done in it by mouse and key, the menu's commands, and the errors beside the rows."""

from __future__ import annotations

import pytest
from brdf_lobe_visualizer.legend.legend import ERROR, REFERENCE, SOLO, TITLE
from brdf_lobe_visualizer.subjects.subjects import DASHES, LINE_COLOURS, PlottedMaterial
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QColorDialog

from brdf_suite.inspection.figures.figures import errors_between
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian

CHECKED, UNCHECKED = Qt.CheckState.Checked, Qt.CheckState.Unchecked


@pytest.fixture
def three(program, monkeypatch):
    """Three matt reflectances in the session, the first in front; nothing is fitted."""
    monkeypatch.setattr(program.fits, "_fit", lambda _subject: None)
    for share in (0.2, 0.4, 0.8):
        program.sources.add(
            PlottedMaterial("", f"Matt {share}", Material(f"Matt {share}", Lambertian((share,) * 3)))
        )
    return program


def titles(program) -> list[str]:
    return [s.title for s in program.session.subjects]


def item(program, place: int):
    return program.legend.legend.rows.topLevelItem(place)


def command(program, name: str):
    found = program.window.findChild(object, f"action_{name}")
    assert found is not None, name
    return found


def press(program, qtbot, key, modifier=Qt.KeyboardModifier.NoModifier) -> None:
    qtbot.keyClick(program.legend.legend.rows, key, modifier)


def test_rows_show_the_session_and_ticks_change_it(three) -> None:
    session = three.session
    keys = [s.key for s in session.subjects]
    assert [item(three, k).text(TITLE) for k in range(3)] == titles(three)
    assert three.legend.legend.rows.currentItem() is item(three, 0)
    item(three, 1).setCheckState(TITLE, UNCHECKED)
    assert session.is_hidden(keys[1])
    item(three, 2).setCheckState(SOLO, CHECKED)
    assert [s.key for s in session.visible] == [keys[2]]
    item(three, 0).setCheckState(REFERENCE, CHECKED)
    item(three, 1).setCheckState(REFERENCE, CHECKED)
    assert session.reference.key == keys[1]
    assert item(three, 0).checkState(REFERENCE) == UNCHECKED
    item(three, 1).setCheckState(REFERENCE, UNCHECKED)
    assert session.reference is None


def test_everything_can_be_done_by_key(three, qtbot) -> None:
    session = three.session
    first, second, third = (s.key for s in session.subjects)
    three.legend.legend.rows.setFocus()
    press(three, qtbot, Qt.Key.Key_Down)
    assert session.front.key == second
    press(three, qtbot, Qt.Key.Key_Space)
    assert session.is_hidden(second)
    press(three, qtbot, Qt.Key.Key_S)
    assert session.is_solo(second)
    press(three, qtbot, Qt.Key.Key_R)
    assert session.reference.key == second
    colour, dash = session.front.colour, session.front.dash
    press(three, qtbot, Qt.Key.Key_C)
    press(three, qtbot, Qt.Key.Key_D)
    assert session.front.colour == LINE_COLOURS[(LINE_COLOURS.index(colour) + 1) % len(LINE_COLOURS)]
    assert session.front.dash == DASHES[(DASHES.index(dash) + 1) % len(DASHES)]
    press(three, qtbot, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert [s.key for s in session.subjects] == [second, first, third]
    assert session.front.key == second
    press(three, qtbot, Qt.Key.Key_Delete)
    assert [s.key for s in session.subjects] == [first, third]
    assert session.front.key == first


def test_a_title_is_typed_and_an_empty_one_is_not_taken(three, qtbot) -> None:
    rows = three.legend.legend.rows
    rows.setFocus()
    press(three, qtbot, Qt.Key.Key_F2)
    editor = rows.viewport().findChild(object, "") or rows.indexWidget(rows.currentIndex())
    item(three, 0).setText(TITLE, "  Wall   paint ")
    assert titles(three)[0] == "Wall paint"
    item(three, 0).setText(TITLE, "   ")
    assert titles(three)[0] == item(three, 0).text(TITLE) == "Wall paint"
    assert editor is not None


def test_a_row_that_is_dropped_elsewhere_moves_there(three) -> None:
    key = three.session.subjects[0].key
    three.legend.legend.rows.dropped.emit(key, 2)
    assert titles(three) == ["Matt 0.4", "Matt 0.8", "Matt 0.2"]
    assert three.session.front.key == key


def test_a_screen_reader_hears_name_and_state(three) -> None:
    role = Qt.ItemDataRole.AccessibleTextRole
    three.session.set_reference(three.session.subjects[0].key)
    three.session.set_hidden(three.session.subjects[1].key, True)
    assert item(three, 0).data(TITLE, role) == "Matt 0.2, shown, reference"
    assert item(three, 1).data(TITLE, role).startswith("Matt 0.4, hidden")
    assert three.legend.legend.rows.accessibleName()


def test_errors_against_the_reference_stand_beside_the_others(three, qtbot) -> None:
    first, second, third = three.session.subjects
    three.session.set_reference(first.key)
    qtbot.waitUntil(lambda: item(three, 2).text(ERROR) not in ("", "(300 %)"))
    assert [item(three, k).text(ERROR) for k in range(3)] == ["", "100 %", "300 %"]
    assert [item(three, k).icon(ERROR).isNull() for k in range(3)] == [True, False, False]
    assert "out of tolerance" in item(three, 2).toolTip(ERROR)
    found = three.legend.errors.error(third.key)
    assert found.errors == errors_between(first.reflectance, third.reflectance)
    assert found.delta_e > 10.0
    three.session.set_reference(second.key)
    qtbot.waitUntil(lambda: item(three, 0).text(ERROR) == "50 %")
    three.session.set_reference(None)
    qtbot.waitUntil(lambda: not any(item(three, k).text(ERROR) for k in range(3)))
    assert three.legend.legend.rows.isColumnHidden(ERROR)


def test_the_menu_acts_on_the_one_in_front(three) -> None:
    session = three.session
    _first, second, third = (s.key for s in session.subjects)
    session.set_front(second)
    command(three, "Show").trigger()
    assert session.is_hidden(second)
    command(three, "Show All").trigger()
    assert not session.is_hidden(second)
    command(three, "Set as Reference").trigger()
    assert session.reference.key == second
    command(three, "Next Reflectance").trigger()
    assert session.front.key == third
    command(three, "Alternate with Reference").trigger()
    assert [s.key for s in session.visible] == [third]
    command(three, "Alternate with Reference").trigger()
    assert [s.key for s in session.visible] == [second]
    command(three, "Show All").trigger()
    command(three, "Move Up").trigger()
    assert titles(three) == ["Matt 0.2", "Matt 0.8", "Matt 0.4"]
    command(three, "Remove All Others").trigger()
    assert titles(three) == ["Matt 0.8"]
    command(three, "Remove").trigger()
    assert titles(three) == []
    assert not command(three, "Remove").isEnabled()
    assert three.legend.legend.pages.currentIndex() == 1


def test_lines_take_another_colour_and_go_back(three) -> None:
    control, session = three.legend, three.session
    key = session.subjects[1].key
    control.choose_colour(session.subjects[1].key)
    dialog = three.window.findChild(QColorDialog)
    dialog.setCurrentColor(Qt.GlobalColor.red)
    assert session.subject(key).colour == (1.0, 0.0, 0.0)
    dialog.reject()
    assert session.subject(key).colour == LINE_COLOURS[1]
    session.change(key, colour=(0.1, 0.2, 0.3))
    control.reset_lines()
    assert [s.colour for s in session.subjects] == list(LINE_COLOURS[:3])
    assert len({s.dash for s in session.subjects}) == 3


def test_more_subjects_than_colours_still_have_lines_of_their_own(three) -> None:
    for _ in range(20):
        three.sources.add(PlottedMaterial("", "More", Material("More", Lambertian((0.1, 0.1, 0.1)))))
    lines = [(s.colour, s.dash) for s in three.session.subjects]
    assert len(set(lines)) == len(lines) == 23

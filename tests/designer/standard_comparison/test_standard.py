"""A standard beside the paint: taken, loaded, judged against, swapped and kept with its tab, by real widgets."""

from __future__ import annotations

from dataclasses import replace

import pytest
from brdf_designer.standard_comparison.control import StandardControl
from brdf_designer.standard_comparison.settings import ToleranceSettings, load, save
from brdf_designer.standard_comparison.state import MARKED, state_of
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QLineEdit

from brdf_suite.appearance.difference.formulas import delta_e_2000, delta_e_cmc
from brdf_suite.appearance.difference.tolerance import Limits
from brdf_suite.appearance.difference.words import PATTERNS, WORDS
from brdf_suite.documents.paint import Measurement
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import ValueRangeError
from brdf_suite.paint_design.standard import Standard, judge_batch, standard_of
from brdf_suite.pipeline.material import load_shipped_paint


@pytest.fixture
def control(program) -> StandardControl:
    control = program.feature(StandardControl)
    control.judge_by(load())
    return control


@pytest.fixture
def dialogs_of_module(fresh):
    return fresh[1]


def click(button) -> None:
    assert button.isEnabled()
    button.click()


def darker_at_flop(program, by: float) -> None:
    paint = program.session.paint
    lightness, a, b = paint.lab_at(110.0)
    program.session.set_paint(paint.with_lab(110.0, (lightness - by, a, b)), "Darken")


def entry(control, text: str) -> QAction:
    """An entry of the menu of Load, which is filled as it opens."""
    menu = control.section.load.menu()
    menu.aboutToShow.emit()
    inside = next(action.menu() for action in menu.actions() if action.menu())
    return next(action for action in (*menu.actions(), *inside.actions()) if action.text() == text)


def column(table, number: int) -> list[str]:
    return [table.item(row, number).text() for row in range(table.rowCount())]


def test_a_loaded_standard_leads_to_the_reading_that_is_farthest_from_it(
    program, control, dialogs_of_module, qtbot, tmp_path
) -> None:
    window, plane = program.window, program.window.editors.plane
    save_paint(program.session.paint, tmp_path / "standard.brdfpaint")
    darker_at_flop(program, 3.0)
    dialogs_of_module.path = tmp_path / "standard.brdfpaint"
    assert window.load_standard.isVisible()
    assert plane.index != 2
    qtbot.mouseClick(window.load_standard, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: control.standard is not None)
    assert plane.index == 2
    field = window.focusWidget()
    assert plane.field is field or plane.field.isAncestorOf(field)
    assert plane.standard.text().splitlines()[1] == "L* 9.00"
    qtbot.keyClicks(field, "9")
    qtbot.keyClick(field, Qt.Key.Key_Tab)
    assert control.section.verdict.text().upper().startswith("PASS")
    control.remove()
    assert plane.standard.text() == ""


def test_a_standard_that_comes_late_leaves_the_keyboard_where_it_is(
    program, control, qtbot, tmp_path
) -> None:
    save_paint(program.session.paint, tmp_path / "standard.brdfpaint")
    darker_at_flop(program, 3.0)
    plane, name = program.window.editors.plane, program.window.texts.daily.findChild(QLineEdit)
    before = plane.index
    control.load(tmp_path / "standard.brdfpaint")
    name.setFocus()
    qtbot.waitUntil(lambda: control.standard is not None)
    assert program.window.focusWidget() is name
    assert plane.index == before


def test_the_present_state_becomes_the_standard_and_an_edit_is_judged(program, control) -> None:
    section, patches = control.section, program.window.patches
    assert not section.empty.isHidden()
    click(section.take)
    assert section.body.isVisibleTo(section)
    assert column(section.results, 1) == ["0.00"] * 3
    assert section.sentence.text() == "no visible difference"
    darker_at_flop(program, 3.0)
    expected = float(delta_e_2000((9.0, 8.0, -28.0), (6.0, 8.0, -28.0)))
    assert column(section.results, 1) == ["0.00", "0.00", f"{expected:.2f}"]
    assert column(section.results, 2) == ["0.00", "0.00", "−3.00"]
    assert column(section.results, 5) == ["pass", "pass", "FAIL"]
    assert [section.results.item(2, number).font().bold() for number in range(6)] == [
        True,
        True,
        False,
        False,
        False,
        True,
    ]
    assert section.sentence.text() == "darker at 110°; slightly more flop"
    assert section.verdict.text().startswith("FAIL: ΔE00 up to")
    darker = patches.patches[2]
    # In a narrow cell the name of the difference is left out, as wide as the font is.
    assert darker.against.text().split()[-2:] == [f"{expected:.2f}", "FAIL"]
    assert darker.words.text() == "darker"
    assert patches.patches[2].field.standard is not None
    click(section.remove)
    assert patches.patches[2].field.standard is None
    assert darker.against.isHidden()


def test_formula_and_tolerances_are_chosen_and_kept(program, control, qtbot) -> None:
    section = control.section
    click(section.take)
    darker_at_flop(program, 3.0)
    section.formula.setCurrentIndex(section.formula.findData("cmc21"))
    section.formula.activated.emit(section.formula.currentIndex())
    expected = float(delta_e_cmc((9.0, 8.0, -28.0), (6.0, 8.0, -28.0)))
    assert column(section.results, 1)[2] == f"{expected:.2f}"
    section.formula.setCurrentIndex(section.formula.findData("cmc"))
    section.formula.activated.emit(section.formula.currentIndex())
    section.lightness.setValue(1.4)
    expected = float(delta_e_cmc((9.0, 8.0, -28.0), (6.0, 8.0, -28.0), 1.4, 1.0))
    assert column(section.results, 1)[2] == f"{expected:.2f}"
    table = section.tolerances
    assert column(table, 0) == ["all angles", "15°", "45°", "110°"]
    table.item(0, 1).setText("9")
    assert column(section.results, 5) == ["pass"] * 3
    table.item(3, 2).setText("2,5")
    assert column(section.results, 5) == ["pass", "pass", "FAIL"]
    assert section.results.item(2, 2).font().bold()
    assert "ΔL*" in section.results.item(2, 5).toolTip()
    table.item(3, 2).setText("")
    assert column(section.results, 5) == ["pass"] * 3
    table.item(2, 3).setText("a lot")
    assert "not a tolerance" in program.window.messages.shown()["standard"].what
    assert table.item(2, 3).text() == ""
    table.item(3, 2).setText("2")
    assert load().tolerances() == control.tolerances
    assert load().by_angle == {110.0: Limits(lightness=2.0)}


def test_undo_of_a_swap_brings_both_back(program, control) -> None:
    click(control.section.take)
    first = program.session.paint
    darker_at_flop(program, 3.0)
    batch, standard = program.session.paint, control.standard
    click(control.section.swap)
    assert program.session.paint == first
    assert control.standard.paint is batch
    assert column(control.section.results, 2)[2] == "+3.00"
    program.window.undo_action.trigger()
    assert program.session.paint is batch
    assert control.standard is standard
    program.window.redo_action.trigger()
    assert program.session.paint == first
    assert control.standard.paint is batch


def test_each_tab_keeps_its_own_standard(program, control) -> None:
    # Also of the tab that the program began with, and that would give way to the first one opened.
    click(control.section.take)
    mine = control.standard
    program.session.open_paint(load_shipped_paint("red"), clean=True)
    assert control.standard is None
    assert program.window.patches.patches[0].field.standard is None
    program.documents.show(program.documents.row[0])
    assert control.standard is mine
    assert program.window.patches.patches[0].field.standard is not None


def test_an_open_tab_and_a_shipped_paint_are_standards(program, control, qtbot) -> None:
    darker_at_flop(program, 3.0)
    program.session.open_paint(load_shipped_paint("blue"), clean=True)
    entry(control, program.documents.row[0].title).trigger()
    assert control.standard.paint is program.documents.row[0].store.value
    assert control.section.sentence.text() == "lighter at 110°; slightly less flop"
    entry(control, "Red").trigger()
    qtbot.waitUntil(lambda: control.standard.name == "Red")


def test_a_palette_is_loaded_and_one_of_its_paints_chosen(program, control, asked, qtbot, tmp_path) -> None:
    path = tmp_path / "season.brdfpalette"
    save_palette(Palette("Season", tuple(Entry(load_shipped_paint(n)) for n in ("red", "blue"))), path)
    asked.path = path
    entry(control, "From a &File…").trigger()
    qtbot.waitUntil(lambda: control.standard is not None)
    choices = control.section.choices
    assert choices.count() == 2
    assert column(control.section.results, 5)[0].startswith("FAIL")
    choices.setCurrentIndex(1)
    choices.activated.emit(1)
    assert column(control.section.results, 1) == ["0.00"] * 3
    assert "season.brdfpalette" in control.section.origin.text()


def test_a_measured_file_is_a_standard_at_any_angle(program, control, qtbot, shared_data) -> None:
    control.load(shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf")
    qtbot.waitUntil(lambda: control.standard is not None)
    assert column(control.section.results, 0) == ["15°*", "45°*", "110°*"]
    click(control.section.swap)
    assert program.session.paint.lab_at(15.0)[0] == pytest.approx(101.13, abs=0.01)
    assert program.session.paint.gloss.gu_20 == pytest.approx(17.9, abs=0.05)


def test_what_cannot_be_read_is_reported_and_nothing_changes(program, control, qtbot, tmp_path) -> None:
    click(control.section.take)
    mine = control.standard
    broken = tmp_path / "broken.brdfpaint"
    broken.write_text("{")
    control.load(broken)
    qtbot.waitUntil(lambda: "standard" in program.window.messages.shown())
    assert "broken.brdfpaint" in program.window.messages.shown()["standard"].what
    assert control.standard is mine


def test_several_batches_are_judged(program, control, asked, qtbot, tmp_path) -> None:
    section = control.section
    click(section.take)
    section.batch_section.set_open(True)
    program.session.open_paint(load_shipped_paint("midnight_blue"), clean=True)
    program.documents.show(program.documents.row[0])
    path = tmp_path / "third.brdfpaint"
    save_paint(replace(load_shipped_paint("red"), name="third"), path)
    asked.path = path
    click(section.add_batches)
    qtbot.waitUntil(lambda: section.batches.rowCount() == 3)
    verdicts = column(section.batches, 3)
    assert verdicts == ["pass", "FAIL", "FAIL"]
    assert column(section.batches, 0)[2] == "third"
    section.batches.opened.emit(1)
    assert program.session.paint.name == program.documents.row[1].store.value.name
    program.documents.show(program.documents.row[0])
    click(section.clear_batches)
    assert section.batches.rowCount() == 2


def test_the_menu_does_the_same(program, control) -> None:
    def action(key: str) -> QAction:
        return program.window.findChild(QAction, f"action_{key}")

    assert not action("swap_standard").isEnabled()
    action("take_standard").trigger()
    assert control.standard is not None
    assert action("swap_standard").isEnabled()
    action("remove_standard").trigger()
    assert control.standard is None


def test_readings_that_the_standard_lacks_are_said(program, control) -> None:
    paint = program.session.paint
    control.set_standards([Standard("instrument", "a.cxf", paint.measurements[:2])])
    patches = program.window.patches
    assert patches.patches[2].field.standard is None
    assert "no reading" in patches.patches[2].against.toolTip()
    click(control.section.swap)
    assert "no reading at 45as110" in program.window.messages.shown()["standard"].what
    assert program.session.paint is paint


def test_every_word_of_the_core_can_be_translated() -> None:
    assert set(MARKED) == set(WORDS) | set(PATTERNS)


def test_settings_merge_an_angle_with_all_angles() -> None:
    chosen = ToleranceSettings().with_limit(110.0, "lightness", 2.0).with_limit(None, "hue", 0.5)
    limits = chosen.tolerances().limits_at(110.0)
    assert (limits.difference, limits.lightness, limits.hue) == (1.0, 2.0, 0.5)
    assert chosen.tolerances().limits_at(15.0).lightness is None
    with pytest.raises(ValueRangeError):
        chosen.with_limit(None, "chroma", -1.0)
    assert chosen.with_limit(110.0, "lightness", None).by_angle == {}


@pytest.mark.parametrize("text", ["", "{", "[]", '{"difference": "din"}', '{"by_angle": 3}'])
def test_damaged_settings_are_the_usual_ones(qapp, text: str) -> None:
    from brdf_qt.program.settings import settings

    save(ToleranceSettings("cmc:2:1"))
    assert load().difference == "cmc:2:1"
    settings().setValue("standard/tolerances", text)
    assert load() == ToleranceSettings()


def test_patches_follow_the_order_of_the_angles() -> None:
    blue = load_shipped_paint("blue")
    mixed = replace(
        blue,
        measurements=tuple(Measurement(45.0, angle, blue.lab_at(angle)) for angle in (110.0, 15.0, 45.0)),
    )
    batch = mixed.with_lab(110.0, (6.0, 8.0, -28.0))
    standard = standard_of(mixed)
    report = judge_batch(standard, batch, ToleranceSettings().tolerances())
    state = state_of(standard, batch, report)
    assert [row.cells[0] for row in state.rows] == ["15°", "45°", "110°"]
    assert [patch.passes for patch in state.patches] == [True, True, False]


def test_angles_without_a_sample_of_the_standard_are_marked(program, control, qtbot, shared_data) -> None:
    control.load(shared_data / "brdf" / "bird_example.json")
    qtbot.waitUntil(lambda: control.standard is not None)
    assert column(control.section.results, 0) == ["15°*†", "45°*†", "110°*†"]
    assert "nearest sample of the standard is 47° away" in control.section.results.item(0, 0).toolTip()

"""Neighbours and the way between two paints, taken by their widgets."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from brdf_designer.preview.thumbnails import Thumbnails, ThumbnailScene, thumbnails_of
from brdf_designer.variations.control import STEP_NAMES, VariationsControl
from brdf_designer.variations.interpolation_control import InterpolationControl
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from brdf_suite.appearance.difference.words import WORDS
from brdf_suite.documents.paint import Gloss, Measurement, solid_paint
from brdf_suite.documents.store import save_paint
from brdf_suite.paint_design.mix import mixed
from brdf_suite.pipeline.material import load_shipped_paint

PROGRAM = Path(__file__).parents[1] / "preview" / "thumbnail_program.py"


@pytest.fixture
def pictures(desk) -> Iterator[Thumbnails]:
    """The pictures of the window from the stand-in: what is drawn is tested with the process itself."""
    found = thumbnails_of(desk.window)
    found.program = [sys.executable, str(PROGRAM), "answers"]
    yield found
    found.program = []


def part(desk, kind):
    return desk.feature(kind)


@pytest.fixture
def control(desk, qtbot) -> VariationsControl:
    control = part(desk, VariationsControl)
    control.host.set_open(True)
    control.set_scene("booth", "sphere")
    control.section.step.setValue(2.0)
    qtbot.waitUntil(lambda: desk.desk.is_quiet)
    yield control
    control.host.set_open(False)


@pytest.fixture
def between(desk) -> InterpolationControl:
    control = part(desk, InterpolationControl)
    control.host.set_open(True)
    control.section.beyond.setChecked(False)
    return control


def test_a_click_takes_a_neighbour_as_one_named_step(desk, control, qtbot) -> None:
    before = desk.desk.paint
    button = control.section.buttons["darker"]
    assert button.text() == "darker"
    button.click()
    assert desk.desk.paint.lab_at(110.0) == (7.0, 8.0, -28.0)
    assert desk.window.undo_action.text() == "&Undo Darker"
    # A second click before anything was drawn goes on from there.
    button.click()
    assert desk.desk.paint.lab_at(110.0) == (5.0, 8.0, -28.0)
    qtbot.waitUntil(lambda: control.neighbours[0].paint.lab_at(110.0)[0] == 7.0)
    desk.window.undo_action.trigger()
    desk.window.undo_action.trigger()
    assert desk.desk.paint is before


def test_the_step_and_what_cannot_be_are_shown(desk, control, qtbot) -> None:
    section = control.section
    section.step.setValue(12.0)
    darker = section.buttons["darker"]
    assert not darker.isEnabled()
    assert darker.text() == "darker: none"
    assert "darker than black" in darker.toolTip()
    assert section.buttons["lighter"].isEnabled()
    section.step.setValue(1.0)
    assert darker.isEnabled()
    assert "8.0, 8.0" in darker.toolTip()


def test_neighbours_that_no_paint_can_have_are_marked_once_fitted(desk, control, qtbot) -> None:
    rising = tuple(Measurement(45.0, angle, (30.0 + angle, 0.0, 0.0)) for angle in (15.0, 45.0, 110.0))
    desk.desk.set_paint(replace(desk.desk.paint, measurements=rising), "Rise")
    lighter = control.section.buttons["lighter"]
    qtbot.waitUntil(lambda: lighter.text() == "lighter ≈")
    assert "ΔE00" in lighter.toolTip()
    desk.desk.set_paint(replace(desk.desk.paint, gloss=Gloss(199.0)), "Gloss")
    qtbot.waitUntil(lambda: lighter.text() == "lighter: none")
    assert "199" in lighter.toolTip()


def test_pictures_come_in_the_chosen_light(desk, pictures, control, qtbot) -> None:
    lighter = control.neighbours[0].paint
    qtbot.waitUntil(lambda: pictures.is_drawn(lighter))
    qtbot.waitUntil(
        lambda: control.section.buttons["lighter"].image.cacheKey() == pictures.picture(lighter).cacheKey()
    )
    light = control.section.environment
    light.setCurrentIndex(light.findData("sunny"))
    light.activated.emit(light.currentIndex())
    qtbot.waitUntil(lambda: pictures.is_drawn(lighter, ThumbnailScene("sunny", "sphere")))


def test_nothing_is_worked_out_while_the_section_is_closed(desk, control, qtbot) -> None:
    control.host.set_open(False)
    known = control.neighbours
    desk.desk.set_paint(solid_paint("grey", (50.0, 0.0, 0.0)), "Grey")
    control.refresh()
    assert control.neighbours is known
    control.host.set_open(True)
    qtbot.waitUntil(lambda: control.neighbours is not known)


def test_every_word_names_a_step() -> None:
    assert set(STEP_NAMES) == set(WORDS)


def test_the_slider_goes_between_two_paints_in_one_step(desk, between, qtbot) -> None:
    section = between.section
    blue, red = desk.desk.paint, load_shipped_paint("red")
    qtbot.waitUntil(lambda: section.others.findData("shipped red") >= 0)
    section.others.setCurrentIndex(section.others.findData("shipped red"))
    section.others.activated.emit(section.others.currentIndex())
    assert section.second.text() == red.name
    slider = section.slider
    slider.setSliderDown(True)
    for value in (100, 300, 500):
        slider.setValue(value)
    slider.setSliderDown(False)
    assert desk.desk.paint == mixed(blue, red, 0.5, blue.name)
    assert desk.window.undo_action.text() == "&Undo Interpolate"
    assert desk.store.stack.count() == 1
    section.stops[3].click()
    assert desk.desk.paint.lab_at(45.0) == mixed(blue, red, 0.75).lab_at(45.0)
    assert section.number.value() == 75.0
    desk.window.undo_action.trigger()
    assert slider.value() == 500
    desk.window.undo_action.trigger()
    assert desk.desk.paint is blue
    assert between.share == 0.0
    desk.window.redo_action.trigger()
    assert between.share == 0.5


def test_beyond_the_ends_and_an_edit_of_another_kind(desk, between, qtbot) -> None:
    between.choose("shipped red")
    section = between.section
    assert section.slider.maximum() == 1000
    section.beyond.setChecked(True)
    section.number.setValue(150.0)
    assert desk.desk.paint.lab_at(45.0)[0] == pytest.approx(32.5)
    desk.desk.set_paint(solid_paint("other", (40.0, 0.0, 0.0)), "Other")
    assert between.share is None
    assert section.body.isHidden()
    # Without a way nothing happens.
    between.set_share(0.5)
    assert desk.desk.paint.name == "other"


def test_keys_move_the_slider(desk, between) -> None:
    between.choose("shipped red")
    slider = between.section.slider
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert between.share == pytest.approx(0.01)
    QTest.keyClick(slider, Qt.Key.Key_PageUp)
    assert between.share == pytest.approx(0.11)


def test_a_file_and_a_tab_are_ends(desk, between, asked, qtbot, tmp_path) -> None:
    path = tmp_path / "mine.brdfpaint"
    save_paint(solid_paint("mine", (80.0, 0.0, 0.0)), path)
    asked.path = path
    between.choose("file")
    qtbot.waitUntil(lambda: between.share is not None)
    between.take(1.0)
    assert desk.desk.paint.lab_at(110.0) == (80.0, 0.0, 0.0)
    desk.desk.open_paint(load_shipped_paint("red"), clean=True)
    assert between.share is None
    key = desk.documents.row[0].key
    between.choose(f"tab {key}")
    between.take(1.0)
    assert desk.desk.paint.lab_at(110.0) == (80.0, 0.0, 0.0)


def test_an_end_that_cannot_be_read_is_reported(desk, between, qtbot, tmp_path) -> None:
    broken = tmp_path / "broken.brdfpaint"
    broken.write_text("{")
    between.load(broken)
    qtbot.waitUntil(lambda: "interpolation" in desk.window.messages.shown())
    assert between.share is None

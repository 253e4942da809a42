"""Neighbours and the way between two paints, taken by their widgets."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace

import pytest
from brdf_designer.variations.control import STEP_NAMES, WORDS_OF_OWN, VariationsControl
from brdf_designer.variations.interpolation_control import InterpolationControl
from brdf_designer.variations.section import DAILY
from brdf_qt.choosing.thumbnails import USUAL_LOOK, placeholder, thumbnail
from brdf_qt.work.pictures import Pictures
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QEnterEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.appearance.difference.words import WORDS
from brdf_suite.documents.paint import Gloss, Measurement, solid_paint
from brdf_suite.documents.store import save_paint
from brdf_suite.paint_design.mix import mixed
from brdf_suite.palettes.swatches.look import SwatchLook
from brdf_suite.pipeline.material import load_shipped_paint

GREY = """
import base64, json, sys
for line in sys.stdin:
    request = json.loads(line)
    picture = base64.b64encode(bytes([90]) * (3 * request["look"]["size"] ** 2)).decode()
    for answer in [*({"key": item["key"], "picture": picture} for item in request["items"]), {"done": True}]:
        print(json.dumps({"id": request["id"], **answer}), flush=True)
"""


@pytest.fixture
def pictures(program) -> Iterator[Pictures]:
    """The pictures of the window, all grey, from a stand-in: what is drawn is tested with the process itself."""
    found = program.window.pictures
    found.program = [sys.executable, "-c", GREY]
    yield found
    found.program = []


def part(program, kind):
    return program.feature(kind)


@pytest.fixture
def control(program, qtbot) -> VariationsControl:
    control = part(program, VariationsControl)
    program.window.panel.bring_in_sight(control.host)
    control.set_scene("booth", "sphere")
    control.section.step.setValue(2.0)
    control.section.more.set_open(True)
    control._waits = False
    control.refresh()
    qtbot.waitUntil(lambda: program.session.is_quiet)
    return control


@pytest.fixture
def between(program) -> InterpolationControl:
    control = part(program, InterpolationControl)
    program.window.panel.bring_in_sight(control.host)
    control.section.beyond.setChecked(False)
    return control


def test_a_click_takes_a_neighbour_as_one_named_step(program, control, qtbot) -> None:
    before = program.session.paint
    button = control.section.buttons["darker"]
    assert button.text() == "darker"
    button.click()
    assert program.session.paint.lab_at(110.0) == (7.0, 8.0, -28.0)
    assert program.window.undo_action.text() == "&Undo Darker"
    # A second click before anything was drawn goes on from there.
    button.click()
    assert program.session.paint.lab_at(110.0) == (5.0, 8.0, -28.0)
    qtbot.waitUntil(lambda: control.neighbours[0].paint.lab_at(110.0)[0] == 7.0)
    program.window.undo_action.trigger()
    program.window.undo_action.trigger()
    assert program.session.paint is before


def test_the_step_and_what_cannot_be_are_shown(program, control, qtbot) -> None:
    section = control.section
    section.step.setValue(12.0)
    darker = section.buttons["darker"]
    assert not darker.isEnabled()
    assert darker.accessibleName() == "darker: none"
    assert "darker than black" in darker.toolTip()
    assert section.buttons["lighter"].isEnabled()
    section.step.setValue(1.0)
    assert darker.isEnabled()
    assert "8.0, 8.0" in darker.toolTip()


def test_neighbours_that_no_paint_can_have_are_marked_once_fitted(program, control, qtbot) -> None:
    rising = tuple(Measurement(45.0, angle, (30.0 + angle, 0.0, 0.0)) for angle in (15.0, 45.0, 110.0))
    program.session.set_paint(replace(program.session.paint, measurements=rising), "Rise")
    lighter = control.section.buttons["lighter"]
    qtbot.waitUntil(lambda: lighter.accessibleName() == "lighter ≈")
    assert "ΔE00" in lighter.toolTip()
    program.session.set_paint(replace(program.session.paint, gloss=Gloss(199.0)), "Gloss")
    qtbot.waitUntil(lambda: not lighter.isEnabled())
    assert "199" in lighter.toolTip()


def test_pictures_come_in_the_chosen_light(program, control, qtbot, request) -> None:
    lighter = control.neighbours[0].paint
    button = control.section.buttons["lighter"]
    stand_in = thumbnail(program.window.pictures, lighter)
    assert stand_in.toImage() == placeholder(lighter, USUAL_LOOK.size).toImage()
    assert button.image.cacheKey() == stand_in.cacheKey()
    pictures = request.getfixturevalue("pictures")
    control.set_scene("booth", "sphere")
    qtbot.waitUntil(lambda: pictures.picture(lighter, USUAL_LOOK) is not None)
    picture = thumbnail(pictures, lighter)
    assert picture.toImage().pixelColor(64, 64).red() == 90
    qtbot.waitUntil(lambda: button.image.cacheKey() == picture.cacheKey())
    light = control.section.environment
    light.setCurrentIndex(light.findData("sunny"))
    light.activated.emit(light.currentIndex())
    qtbot.waitUntil(
        lambda: pictures.picture(lighter, SwatchLook("sphere", "sunny", USUAL_LOOK.size)) is not None
    )


def test_nothing_is_worked_out_while_the_section_is_closed(program, control, qtbot) -> None:
    control.host.set_open(False)
    known = control.neighbours
    program.session.set_paint(solid_paint("grey", (50.0, 0.0, 0.0)), "Grey")
    control.refresh()
    assert control.neighbours is known
    program.window.panel.bring_in_sight(control.host)
    qtbot.waitUntil(lambda: control.neighbours is not known)


def test_every_word_names_a_step() -> None:
    assert set(STEP_NAMES) == {*WORDS, *WORDS_OF_OWN}


def test_a_click_in_the_row_is_one_step_and_its_flakes_cover_the_same_area(program, control) -> None:
    before, buttons = program.session.paint, control.section.buttons
    assert [buttons[key].isVisible() for key in DAILY] == [True] * 7
    QTest.mouseClick(buttons["coarser_flakes"], Qt.MouseButton.LeftButton)
    assert program.session.paint.flakes.size_um > before.flakes.size_um
    assert program.window.undo_action.text() == "&Undo Coarser Flakes"
    QTest.mouseClick(buttons["deeper"], Qt.MouseButton.LeftButton)
    assert program.session.paint.lab_at(45.0)[0] < before.lab_at(45.0)[0]
    program.window.undo_action.trigger()
    program.window.undo_action.trigger()
    assert program.session.paint is before


def test_a_pointer_that_rests_shows_a_neighbour_until_it_leaves(program, control, qtbot) -> None:
    patch, paint = program.window.patches.patches[1], program.session.paint
    before = patch.numbers.text()
    button = control.section.buttons["lighter"]
    QTest.mouseMove(button, button.rect().center())
    QApplication.sendEvent(button, QEnterEvent(QPointF(5, 5), QPointF(5, 5), QPointF(5, 5)))
    qtbot.waitUntil(lambda: patch.numbers.text() != before)
    assert f"{paint.lab_at(45.0)[0] + 2.0:.1f}" in patch.numbers.text()
    # Nothing was edited.
    assert program.session.paint is paint
    assert program.store.stack.count() == 0
    QApplication.sendEvent(button, QEvent(QEvent.Type.Leave))
    qtbot.waitUntil(lambda: patch.numbers.text() == before)


def test_the_arrow_keys_go_along_the_row(program, control) -> None:
    buttons = control.section.buttons
    program.window.activateWindow()
    buttons["lighter"].setFocus()
    QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Right)
    assert QApplication.focusWidget() is buttons["deeper"]
    QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Left)
    QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Left)
    assert QApplication.focusWidget() is buttons["coarser_flakes"]


def test_the_slider_goes_between_two_paints_in_one_step(program, between, qtbot) -> None:
    section = between.section
    blue, red = program.session.paint, load_shipped_paint("red")
    qtbot.waitUntil(lambda: section.others.findData("shipped red") >= 0)
    section.others.setCurrentIndex(section.others.findData("shipped red"))
    section.others.activated.emit(section.others.currentIndex())
    assert section.second.text() == red.name
    slider = section.slider
    slider.setSliderDown(True)
    for value in (100, 300, 500):
        slider.setValue(value)
    slider.setSliderDown(False)
    assert program.session.paint == mixed(blue, red, 0.5, blue.name)
    assert program.window.undo_action.text() == "&Undo Interpolate"
    assert program.store.stack.count() == 1
    section.stops[3].click()
    assert program.session.paint.lab_at(45.0) == mixed(blue, red, 0.75).lab_at(45.0)
    assert section.number.value() == 75.0
    program.window.undo_action.trigger()
    assert slider.value() == 500
    program.window.undo_action.trigger()
    assert program.session.paint is blue
    assert between.share == 0.0
    program.window.redo_action.trigger()
    assert between.share == 0.5


def test_beyond_the_ends_and_an_edit_of_another_kind(program, between, qtbot) -> None:
    between.choose("shipped red")
    section = between.section
    assert section.slider.maximum() == 1000
    section.beyond.setChecked(True)
    section.number.setValue(150.0)
    assert program.session.paint.lab_at(45.0)[0] == pytest.approx(32.5)
    program.session.set_paint(solid_paint("other", (40.0, 0.0, 0.0)), "Other")
    assert between.share is None
    assert section.body.isHidden()
    # Without a way nothing happens.
    between.set_share(0.5)
    assert program.session.paint.name == "other"


def test_keys_move_the_slider(program, between) -> None:
    between.choose("shipped red")
    slider = between.section.slider
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert between.share == pytest.approx(0.01)
    QTest.keyClick(slider, Qt.Key.Key_PageUp)
    assert between.share == pytest.approx(0.11)


def test_a_file_and_a_tab_are_ends(program, between, asked, qtbot, tmp_path) -> None:
    path = tmp_path / "mine.brdfpaint"
    save_paint(solid_paint("mine", (80.0, 0.0, 0.0)), path)
    asked.path = path
    between.choose("file")
    qtbot.waitUntil(lambda: between.share is not None)
    between.take(1.0)
    assert program.session.paint.lab_at(110.0) == (80.0, 0.0, 0.0)
    program.session.open_paint(load_shipped_paint("red"), clean=True)
    assert between.share is None
    key = program.documents.row[0].key
    between.choose(f"tab {key}")
    between.take(1.0)
    assert program.session.paint.lab_at(110.0) == (80.0, 0.0, 0.0)


def test_an_end_that_cannot_be_read_is_reported(program, between, qtbot, tmp_path) -> None:
    broken = tmp_path / "broken.brdfpaint"
    broken.write_text("{")
    between.load(broken)
    qtbot.waitUntil(lambda: "interpolation" in program.window.messages.shown())
    assert between.share is None

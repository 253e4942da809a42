"""The start page over Designer, and the tour: what is asked for is done, nothing is in the way, and each is left."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest
from brdf_designer.session.edits import SetField
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import chosen
from brdf_qt.start.launch import Launch
from brdf_qt.window.dialogs import Answer
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QPushButton, QToolButton


@pytest.fixture
def start(program):
    """The start page of Designer, shown; the tour was seen."""
    settings().setValue("tour/seen", True)
    program.window.command("start_page").trigger()
    return program.window.start


def test_a_paint_of_the_gallery_is_opened_and_the_page_goes(program, start, qtbot):
    assert start.page.isVisible()
    qtbot.mouseClick(start.page.gallery.tiles["candy_red"], Qt.MouseButton.LeftButton)
    assert program.store.value.name == "Candy red"
    assert not start.page.isVisible()
    assert not start.tour


def test_new_paint_is_begun_and_the_other_beginnings_are_commands(program, start):
    program.documents.front.pristine = False
    count = len(program.documents.row)
    start.page.command_chosen.emit("New")
    assert len(program.documents.row) == count + 1
    for key in ("new_from_measurement", "acquire_sample", "open_project", "manual", "tour"):
        assert program.window.command(key).isEnabled()


def test_who_begins_something_is_not_led_through_the_window(program, qtbot):
    program.window.start.show()
    qtbot.mouseClick(program.window.start.page.findChild(QToolButton, "start_New"), Qt.MouseButton.LeftButton)
    assert program.documents.front.title == "Untitled"
    assert program.window.start.tour is None


def test_a_language_starts_the_program_again_unless_its_window_stays(own_designer, dialogs, qtbot):
    again = []
    start = own_designer.window.start
    start.again = again.append
    start.show()
    own_designer.session.edit(SetField("name", "Changed"))
    qtbot.mouseClick(start.page.languages["de"], Qt.MouseButton.LeftButton)
    assert dialogs.asked
    assert not again
    assert chosen() == "system"
    assert start.page.isVisible()
    assert start.page.languages["en"].isChecked()
    dialogs.answer = Answer.DISCARD
    qtbot.mouseClick(start.page.languages["de"], Qt.MouseButton.LeftButton)
    assert again == ["Designer"]
    assert chosen() == "de"
    assert not start.page.isVisible()


def test_a_language_chosen_before_there_is_a_window_makes_none(qtbot):
    again = []
    launch = Launch(QApplication.instance(), "Designer")
    qtbot.addWidget(launch.page)
    launch.again = again.append
    launch.page.painted.connect(lambda: QTimer.singleShot(0, lambda: launch.page.languages["de"].click()))
    assert launch.load("brdf_designer.assembly", lambda: "made") is None
    assert again == ["Designer"]
    assert chosen() == "de"


def test_edits_go_on_while_the_page_is_shown(program, start, qtbot):
    assert not start.page.isModal()
    program.window.shipped_requested.emit("pearl")
    assert program.store.value.name == "Pearl"
    assert start.page.isVisible()


def test_unsaved_work_of_a_kill_goes_before_the_page(program, start):
    program.window.show_message(Message("recovery", "Recover?"))
    assert not start.page.isVisible()
    program.window.dismiss_message("recovery")


def test_the_first_choice_begins_the_tour_which_points_at_three_parts_once(program, qtbot):
    window = program.window
    window.start.show()
    window.start.page.paint_chosen.emit("pearl")
    tour = window.start.tour
    seen = []
    while tour.is_running:
        callout = tour.callout
        assert callout.isVisible()
        assert window.rect().contains(callout.geometry())
        seen.append(callout.accessibleName().partition(".")[0])
        qtbot.mouseClick(callout.findChild(QPushButton, "tour_next"), Qt.MouseButton.LeftButton)
    assert seen == ["The picture", "The paint", "Compare and export"]
    assert window.panel.pages["compare"].isVisible()
    window.start.show()
    window.start.page.paint_chosen.emit("red")
    assert not window.start.tour.is_running


def test_the_tour_is_left_at_any_time_and_begun_again_from_help(program, qtbot):
    window = program.window
    window.command("tour").trigger()
    qtbot.keyClick(window.start.tour.callout, Qt.Key.Key_Escape)
    assert not window.start.tour.is_running
    window.command("tour").trigger()
    program.session.undo()  # nothing waits for it
    qtbot.mouseClick(
        window.start.tour.callout.findChild(QPushButton, "tour_leave"), Qt.MouseButton.LeftButton
    )
    assert not window.start.tour.is_running


def test_what_is_chosen_before_there_is_a_window_waits_for_it(program, qtbot):
    settings().setValue("tour/seen", True)
    launch = Launch(QApplication.instance(), "Designer")
    qtbot.addWidget(launch.page)
    launch.page.painted.connect(lambda: launch.page.paint_chosen.emit("emerald_pearl"))
    assert launch.load("brdf_designer.assembly", lambda: "made") == "made"
    assert launch.shown_s > 0.0
    assert program.store.value.name != "Emerald pearl"
    before = program.window.start.page
    launch.hand_over(program.window.start)
    assert program.store.value.name == "Emerald pearl"
    program.window.start.page = before


@pytest.mark.parametrize(("words", "shown"), [(["--start-page"], True), ([], False), (["pearl"], False)])
def test_a_process_shows_the_page_before_it_has_a_window(tmp_path, words, shown):
    command = [sys.executable, "-m", "brdf_designer", "--report-startup", "--quit-after", "0", *words]
    done = subprocess.run(
        command, capture_output=True, text=True, check=True, timeout=120, env={**os.environ}
    )
    times = json.loads(done.stdout.splitlines()[-1])
    assert ("start_page_s" in times) is shown
    if shown:
        assert times["start_page_s"] < times["ready_s"]

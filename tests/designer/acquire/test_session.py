"""The assistant on a simulated session: opened, checked, looked at, corrected by hand; and its window walked."""

from __future__ import annotations

import shutil
import threading
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from brdf_designer.acquire.assistant import Assistant
from brdf_designer.acquire.control import AcquireControl
from brdf_designer.acquire.session import control as session_control
from brdf_designer.acquire.session.start_page import RigSketch
from brdf_designer.acquire.window import KEYS
from brdf_qt.fields.number import NumberField
from brdf_qt.program.settings import state_folder
from brdf_qt.window.dialogs import QtDialogs
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QFileDialog,
    QLabel,
    QScrollBar,
    QWidget,
)

from brdf_suite.acquisition.session import template as session_template
from brdf_suite.acquisition.session.series import read_mask
from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.acquisition.session.template import write_template

CONTROLS = (QAbstractButton, QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox)


@pytest.fixture
def folder(simulated, tmp_path) -> Path:
    """A copy of it that may be changed."""
    return Path(shutil.copytree(simulated, tmp_path / "photographs"))


@pytest.fixture
def assistant(fresh, qtbot) -> Assistant:
    """The assistant of the module's Designer, with nothing open."""
    designer, _ = fresh
    control = designer.feature(AcquireControl)
    found = control.open()
    found.bench.open(None, None)
    for key in found.window.messages.shown():
        found.window.messages.dismiss(key)
    found.window.show_page("session")
    qtbot.waitUntil(lambda: found.bench.is_quiet)
    return found


@pytest.fixture
def opened(assistant, folder, qtbot) -> Assistant:
    """The assistant with the copy open, and its first photographs read."""
    open_folder(assistant, folder, qtbot)
    return assistant


def open_folder(assistant, folder, qtbot):
    with qtbot.waitSignal(assistant.bench.opened):
        assistant.sessions.open(folder)
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)


def shown_keys(assistant) -> set[str]:
    return set(assistant.window.messages.shown())


def shows_position(assistant, index: int) -> bool:
    """Whether the photographs of a position are what the page of the exposures shows."""
    strip = assistant.window.exposures.strip
    files = assistant.bench.session.positions[index].photographs
    return strip.count() > 0 and strip.item(0).toolTip() in files


# Opening.


def test_the_command_opens_the_window_once(fresh, qtbot):
    designer, _ = fresh
    control = designer.feature(AcquireControl)
    control.action.trigger()
    first = control.assistant
    control.action.trigger()
    assert control.assistant is first
    assert first.window.isVisible()


def test_nothing_open_says_what_to_do_and_no_step_fails(assistant, qtbot):
    assert not assistant.window.session.picture.marks
    assistant.window.all.click()
    assert "session" in shown_keys(assistant)
    for button in (assistant.window.response.start, assistant.window.geometry_page.start):
        button.click()
    assert assistant.bench.is_quiet


def test_open_folder_asks_for_a_folder_and_keeps_the_assistant_in_front(
    assistant, folder, qtbot, monkeypatch
):
    start, asked = assistant.window.session.start, []

    def exec_(dialog: QFileDialog) -> int:
        asked.append((dialog.fileMode(), dialog.parentWidget()))
        dialog.setDirectory(str(folder.parent))
        dialog.selectFile(str(folder))
        return QFileDialog.DialogCode.Accepted

    monkeypatch.setattr(QFileDialog, "exec", exec_)
    dialogs = QtDialogs(assistant.window.parentWidget()).over(assistant.window)
    monkeypatch.setattr(assistant.sessions, "_dialogs", dialogs)
    assert start.isVisible()
    with qtbot.waitSignal(assistant.bench.opened):
        QTest.mouseClick(start.open, Qt.MouseButton.LeftButton)
    assert asked == [(QFileDialog.FileMode.Directory, assistant.window)]
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    assert assistant.bench.folder == folder
    assert not start.isVisible()
    assert assistant.window.session.picture.isVisible()


@pytest.fixture
def sample(simulated) -> Path:
    """Photographs that lie where those of the simulated rig are kept."""
    return Path(shutil.copytree(simulated, state_folder("acquire") / "sample_session"))


def test_a_simulated_session_is_made_once_and_opened(assistant, qtbot, monkeypatch):
    for name, number in (("_SAMPLE_POSITIONS", 4), ("_SAMPLE_EXPOSURES", 3), ("_SAMPLE_PX", 64)):
        monkeypatch.setattr(session_control, name, number)
    half = state_folder("acquire") / "sample_session"
    half.mkdir()
    (half / "half.png").write_bytes(b"half")  # of one that was stopped
    with qtbot.waitSignal(assistant.bench.opened):
        assistant.sessions.open_sample()
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    made = assistant.bench.folder
    assert not (made / "half.png").exists()
    assert len(assistant.bench.session.positions) == 4
    written = (made / "session.json").stat().st_mtime_ns
    assistant.bench.open(None, None)
    assert assistant.window.session.start.isVisible()
    with qtbot.waitSignal(assistant.bench.opened):
        assistant.sessions.open_sample()
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    assert (made / "session.json").stat().st_mtime_ns == written
    assert not assistant.bench.results


def test_trying_it_takes_all_steps_and_ends_where_the_paint_is_opened(assistant, sample, qtbot):
    window = assistant.window
    QTest.mouseClick(window.session.start.sample, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "fit" in assistant.bench.results or bool(window.messages.shown()))
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    assert not window.messages.shown()
    assert window.step == "fit"
    assert window.focusWidget() is window.fit.open
    place = window.fit.open.mapTo(window.fit.side.viewport(), window.fit.open.rect().center())
    assert window.fit.side.viewport().rect().contains(place)
    # Where all is there it leads to the same place, and works nothing out again.
    window.show_page("session")
    window.all.click()
    assert assistant.bench.is_quiet
    assert window.step == "fit"


def test_trying_it_ends_where_it_is_stopped(assistant, sample, qtbot):
    QTest.mouseClick(assistant.window.session.start.sample, Qt.MouseButton.LeftButton)
    assistant.bench.cancel("open")
    with qtbot.waitSignal(assistant.bench.opened):
        assistant.sessions.open_sample()
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    assert assistant.window.step == "session"
    assert not assistant.bench.results


@pytest.mark.parametrize("size", [(280, 220), (900, 500)])
def test_the_sketch_of_the_rig_fits_its_room(qtbot, size):
    sketch = RigSketch()
    qtbot.addWidget(sketch)
    sketch.resize(*size)
    picture = sketch.grab().toImage()
    ground = picture.pixelColor(0, picture.height() // 2)
    edges = [(x, y) for x in range(picture.width()) for y in (0, picture.height() - 1)]
    assert all(picture.pixelColor(x, y) == ground for x, y in edges)
    inside = [(x, y) for x in range(0, picture.width(), 4) for y in range(0, picture.height(), 4)]
    assert len({picture.pixelColor(x, y).rgb() for x, y in inside}) > 4


def test_a_session_is_opened_checked_and_shown(opened):
    page, window = opened.window.session, opened.window
    assert page.facts.texts["Positions"].startswith("8,")
    assert page.fields["sphere.radius_m"].value() == pytest.approx(60.0)
    assert not page.problems.isVisibleTo(page)
    assert not page.picture.image.isNull()
    assert "Test" in window.windowTitle()
    assert shown_keys(opened) == set()


def test_a_position_s_exposures_are_shown_with_what_is_clipped(opened, qtbot):
    page = opened.window.exposures
    assert page.strip.count() == 5
    assert page.table.rowCount() == 5
    clipped = [page.table.item(row, 2).text() for row in range(5)]
    shares = [float(text.removeprefix("< ").removesuffix(" %")) for text in clipped]
    assert shares == sorted(shares)
    assert shares[-1] > 0.0
    page.choose(4)
    assert [mark.name for mark in page.picture.marks] == ["clipped"]
    assert page.table.currentRow() == 4
    page.position.setValue(0)
    qtbot.waitUntil(lambda: shows_position(opened, 0))
    assert page.where.text().startswith("Lamp at 20°")


def test_what_is_missing_or_cut_off_is_named_with_its_reason(assistant, folder, qtbot):
    session = read_session(folder)
    lost, cut = session.positions[0].photographs[1], session.positions[1].photographs[2]
    (folder / lost).unlink()
    whole = (folder / cut).read_bytes()
    (folder / cut).write_bytes(whole[: len(whole) // 2])
    open_folder(assistant, folder, qtbot)
    rows = assistant.window.session.problems
    named = {
        rows.topLevelItem(i).text(1): rows.topLevelItem(i).text(2) for i in range(rows.topLevelItemCount())
    }
    assert {lost, cut} <= set(named)
    assert all(named.values())
    # What is there is shown all the same.
    assistant.series.show(0)
    qtbot.waitUntil(lambda: shows_position(assistant, 0))
    assert assistant.window.exposures.strip.count() == 4


def test_photographs_that_were_exchanged_are_named(assistant, folder, qtbot):
    names = read_session(folder).positions[0].photographs
    (folder / names[1]).rename(folder / "short.png")
    (folder / names[4]).rename(folder / names[1])
    (folder / "short.png").rename(folder / names[4])
    open_folder(assistant, folder, qtbot)
    assistant.series.show(0)
    page = assistant.window.exposures
    qtbot.waitUntil(lambda: shows_position(assistant, 0))
    named = [page.problems.topLevelItem(i).text(1) for i in range(page.problems.topLevelItemCount())]
    assert named
    assert set(named) <= set(names)


def test_a_folder_without_a_session_leaves_the_open_one(opened, tmp_path, qtbot):
    before = opened.bench.session
    opened.sessions.open(tmp_path)
    qtbot.waitUntil(lambda: "open" in shown_keys(opened))
    assert opened.bench.session is before
    message = opened.window.messages.shown()["open"]
    assert message.what.startswith(f"{tmp_path.name}: ")
    assert message.where == str(tmp_path.parent)


def test_a_new_folder_gets_the_template_and_one_that_has_a_session_is_refused(
    assistant, tmp_path, folder, qtbot, monkeypatch
):
    target = tmp_path / "new"
    threads = []

    def write(path):
        threads.append(threading.current_thread())
        return write_template(path)

    monkeypatch.setattr(session_template, "write_template", write)
    with qtbot.waitSignal(assistant.bench.opened):
        assistant.sessions.make(target)
    assert (target / "session.json").exists()
    assert assistant.bench.folder == target
    # It looks into every photograph of the folder, for which no window should wait.
    assert threading.main_thread() not in threads
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    # Its photographs are still to be taken: every one is listed as missing.
    assert assistant.window.session.problems.topLevelItemCount() > 0
    before = (folder / "session.json").read_bytes()
    assistant.sessions.make(folder)
    qtbot.waitUntil(lambda: "open" in shown_keys(assistant))
    assert (folder / "session.json").read_bytes() == before


# Correcting by hand.


def test_a_number_that_is_typed_is_in_the_file_and_undone_in_it(opened, folder, qtbot):
    field = opened.window.session.fields["sphere.radius_m"]
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "61.5")
    QTest.keyClick(field, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: read_session(folder).sphere.radius_m == pytest.approx(0.0615))
    opened.window.undo_requested.emit()
    assert read_session(folder).sphere.radius_m == pytest.approx(0.06)
    assert field.value() == pytest.approx(60.0)
    opened.window.redo_requested.emit()
    assert read_session(folder).sphere.radius_m == pytest.approx(0.0615)


def test_closing_asks_nothing_and_writes_what_was_typed(opened, folder, asked):
    opened.window.session.number_edited.emit("light.distance_m", 560.0)
    opened.window.close()
    assert read_session(folder).light.distance_m == pytest.approx(0.56)
    assert asked.asked == []
    assert opened.bench.session is not None


def test_a_number_that_cannot_be_is_reported_and_not_written(opened, folder):
    opened.window.session.number_edited.emit("camera.distance_m", 20.0)
    opened.sessions.write_pending()
    assert "edit" in shown_keys(opened)
    assert read_session(folder).camera.distance_m == pytest.approx(0.9)
    assert opened.window.session.fields["camera.distance_m"].value() == pytest.approx(900.0)


def test_what_another_program_has_written_is_not_overwritten(opened, folder):
    other = replace(read_session(folder), name="Other")
    write_session(other, folder)
    opened.window.session.number_edited.emit("light.distance_m", 560.0)
    opened.sessions.write_pending()
    assert read_session(folder) == other
    assert "edit" in shown_keys(opened)
    assert opened.window.session.fields["light.distance_m"].value() == pytest.approx(550.0)


def mask_page(assistant, qtbot):
    assistant.window.show_page("mask")
    page = assistant.window.mask_page
    qtbot.waitUntil(lambda: page.picture.history is not None)
    return page


def test_what_is_painted_is_the_mask_that_every_other_road_reads(opened, folder, qtbot):
    page = mask_page(opened, qtbot)
    QTest.keyClick(page.picture, Qt.Key.Key_Space)
    page.undo.click()
    page.redo.click()
    painted = page.picture.history.used.copy()
    assert not painted.all()
    opened.window.close()
    assert np.array_equal(read_mask(folder, read_session(folder)), painted)
    assert read_session(folder).mask == "mask.png"
    assert "mask.png" in page.kept.text()
    # It is there again when the session is opened the next time.
    opened.window.bring()
    opened.window.show_page("session")
    open_folder(opened, folder, qtbot)
    page = mask_page(opened, qtbot)
    assert np.array_equal(page.picture.history.used, painted)
    assert not page.picture.history.can_undo


def test_a_mask_of_another_name_is_left_as_it_was(assistant, folder, qtbot):
    from PIL import Image

    Image.fromarray(np.full((96, 96), 255, np.uint8)).save(folder / "arm.png")
    write_session(replace(read_session(folder), mask="arm.png"), folder)
    before = (folder / "arm.png").read_bytes()
    open_folder(assistant, folder, qtbot)
    page = mask_page(assistant, qtbot)
    QTest.keyClick(page.picture, Qt.Key.Key_Space)
    assistant.mask.write_pending()
    assert (folder / "arm.png").read_bytes() == before
    assert read_session(folder).mask == "mask.png"


# The window.


@pytest.fixture
def everything(opened):
    """All widgets that a user operates, of every page."""

    def inner(widget: QWidget) -> bool:
        around = widget.parentWidget()
        while around is not None and around is not opened.window:
            if isinstance(around, (QAbstractSpinBox, QComboBox, QAbstractItemView)):
                return True
            around = around.parentWidget()
        return isinstance(widget, QScrollBar) or widget.objectName().startswith("qt_")

    window = opened.window
    pages = [w for page in window.pages.values() for w in page.findChildren(QWidget)]
    around = [window.rail, window.all, window.back, window.next]
    return [*around, *(w for w in pages if isinstance(w, CONTROLS) and not inner(w))]


def test_every_control_is_named_explained_and_reached_by_keyboard(opened, everything):
    def said(widget) -> str:
        text = widget.text() if isinstance(widget, QAbstractButton) else ""
        return widget.accessibleName() or text

    tips = {label.buddy(): label.toolTip() for label in opened.window.findChildren(QLabel) if label.buddy()}
    assert len(everything) > 40
    assert [w for w in everything if not said(w)] == []
    silent = [said(w) for w in everything if not w.toolTip() and not tips.get(w)]
    assert [name for name in silent if not name.startswith("Section ")] == []
    assert [said(w) for w in everything if not w.focusPolicy() & Qt.FocusPolicy.TabFocus] == []


def test_every_number_says_its_unit(opened):
    fields = opened.window.findChildren(NumberField)
    assert len(fields) > 10
    assert all(field.unit and field.unit in field.accessibleName() for field in fields)


def test_the_steps_are_gone_through_by_keys(opened):
    window = opened.window
    for key in KEYS[1:]:
        window.next.click()
        assert window.step == key
    assert not window.next.isEnabled()
    window.back.click()
    assert window.step == KEYS[-2]
    window.rail.setFocus()
    QTest.keyClick(window.rail, Qt.Key.Key_Home)
    assert window.step == "session"

"""Several paints in tabs: each with its own history, file and autosave; the other programs get the one in front."""

from __future__ import annotations

import shutil
import threading
import time
from dataclasses import replace

import pytest
from brdf_designer.documents.tabs import MOST_CLOSED
from brdf_designer.documents.tabs_bar import DocumentTabs
from brdf_designer.session.state import TabState
from brdf_designer.standard_comparison.control import StandardControl
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.link.messages import OFFER
from brdf_qt.window.command_palette import commands
from brdf_qt.window.dialogs import Answer
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QTabBar

from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.project import NamedView, Project, load_project, save_project
from brdf_suite.documents.store import load_paint, paint_from_json, paint_to_json, save_paint
from brdf_suite.documents.view import View
from brdf_suite.pipeline.material import load_shipped_paint


def choose(designer, path: str) -> None:
    dict(commands(designer.window))[path].trigger()


def lighten(designer, lightness: float) -> None:
    field = designer.window.editors.editors[0].fields[0]
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, str(lightness))
    QTest.keyClick(field, Qt.Key.Key_Return)


def titles(designer) -> list[str]:
    bar = designer.window.tabs
    return [bar.tabText(place) for place in range(bar.count())]


def open_and_wait(designer, qtbot, path) -> None:
    designer.documents.open(path)
    wait_until_read(designer, qtbot)


def wait_until_read(designer, qtbot) -> None:
    qtbot.waitUntil(lambda: designer.reading.is_idle and designer.projects.is_idle)


@pytest.fixture
def three(designer):
    """Red, copper and champagne; the untouched first one has given way to red."""
    for name in ("red", "copper", "champagne"):
        designer.open(name)
    return designer


def test_what_is_opened_comes_in_a_tab_of_its_own_and_the_untouched_first_gives_way(three):
    assert titles(three) == ["Red", "Copper", "Champagne"]
    assert three.window.tabs.currentIndex() == 2
    assert three.store.value == load_shipped_paint("champagne")
    choose(three, "File ▸ New")
    assert titles(three) == ["Red", "Copper", "Champagne", "Untitled"]


def test_each_tab_has_its_own_paint_history_and_mark(three):
    lighten(three, 61)
    choose(three, "Window ▸ Next Tab")
    assert three.store.value == load_shipped_paint("red")
    assert not three.window.undo_action.isEnabled()
    lighten(three, 62)
    lighten(three, 63)
    assert titles(three) == ["• Red", "Copper", "• Champagne"]
    assert three.window.isWindowModified()
    choose(three, "Window ▸ Previous Tab")
    assert three.window.undo_action.text() == "&Undo Change L* at 15°"
    three.window.undo_action.trigger()
    assert three.store.value == load_shipped_paint("champagne")
    assert titles(three) == ["• Red", "Copper", "Champagne"]
    assert not three.window.isWindowModified()
    three.window.tabs.setCurrentIndex(0)
    assert three.store.value.lab_at(15.0)[0] == 63.0
    assert three.store.stack.count() == 2


def test_ctrl_tab_goes_round(three):
    seen = []
    for keys in ("Ctrl+Tab", "Ctrl+Tab", "Ctrl+Shift+Tab", "Ctrl+PgUp"):
        QTest.keySequence(three.window, keys)
        seen.append(three.documents.front.title)
    assert seen == ["Red", "Copper", "Red", "Champagne"]


def test_a_file_that_is_open_comes_to_the_front_also_by_another_name_of_it(
    designer, dialogs, tmp_path, qtbot
):
    file, link = tmp_path / "mine.brdfpaint", tmp_path / "link.brdfpaint"
    save_paint(load_shipped_paint("red"), file)
    link.symlink_to(file)
    open_and_wait(designer, qtbot, file)
    lighten(designer, 61)
    choose(designer, "File ▸ New")
    dialogs.path = link
    choose(designer, "File ▸ Open…")
    assert titles(designer) == ["• mine.brdfpaint", "Untitled"]
    assert designer.store.value.lab_at(15.0)[0] == 61.0


def test_files_are_read_off_the_windows_thread_in_the_order_of_the_requests(
    designer, tmp_path, qtbot, monkeypatch
):
    threads = set()
    real = designer.documents.find_opener

    def look(path):
        threads.add(threading.current_thread())
        return real(path)

    monkeypatch.setattr(designer.documents, "find_opener", look)
    files = [tmp_path / f"{name}.brdfpaint" for name in ("red", "copper")]
    for file in files:
        save_paint(load_shipped_paint(file.stem), file)
    for file in (*files, files[0]):
        designer.documents.open(file)
    wait_until_read(designer, qtbot)
    assert titles(designer) == ["red.brdfpaint", "copper.brdfpaint"], "no file is open twice"
    assert designer.documents.front.title == "red.brdfpaint"
    assert threading.main_thread() not in threads


def test_tabs_are_dragged_into_another_order(three):
    three.window.tabs.moveTab(0, 2)
    assert titles(three) == ["Copper", "Champagne", "Red"]
    assert [document.title for document in three.documents.row] == titles(three)
    assert three.documents.front.title == "Champagne"
    QTest.keySequence(three.window, "Ctrl+Tab")
    assert three.documents.front.title == "Red"
    assert three.store.value == load_shipped_paint("red")


@pytest.mark.parametrize("answer", list(Answer))
def test_closing_a_tab_asks_about_its_work_alone(three, dialogs, tmp_path, own_session, answer):
    lighten(three, 61)
    three.window.tabs.setCurrentIndex(0)
    lighten(three, 62)
    dialogs.answer, dialogs.path = answer, tmp_path / "saved"
    bar = three.window.tabs
    bar.tabButton(2, QTabBar.ButtonPosition.RightSide).click()
    assert dialogs.asked == ["Champagne"]
    assert len(titles(three)) == (3 if answer is Answer.CANCEL else 2)
    assert (tmp_path / "saved.brdfpaint").exists() == (answer is Answer.SAVE)
    # What is asked about is seen; the unsaved work of the other tab stays as it was.
    assert three.documents.front.title == ("Champagne" if answer is Answer.CANCEL else "Copper")
    assert three.documents.row[0].store.value.lab_at(15.0)[0] == 62.0
    assert not three.documents.row[0].store.is_clean


def test_a_closed_tab_is_had_back_with_its_history_and_what_was_not_saved(three, dialogs, own_session, qtbot):
    lighten(three, 61)
    lighten(three, 62)
    dialogs.answer = Answer.DISCARD
    QTest.keySequence(three.window, "Ctrl+W")
    assert titles(three) == ["Red", "Copper"]
    QTest.keySequence(three.window, "Ctrl+Shift+T")
    assert titles(three) == ["Red", "Copper", "• Champagne"]
    assert three.store.value.lab_at(15.0)[0] == 62.0
    # It is unsaved work again, and kept as such.
    (file,) = own_session.rglob("*.recovery.json")
    three.window.undo_action.trigger()
    three.window.undo_action.trigger()
    assert three.store.value == load_shipped_paint("champagne")
    qtbot.waitUntil(lambda: not file.exists())
    assert not three.window.reopen_action.isEnabled()


def test_the_last_tab_leaves_an_empty_paint_and_an_empty_one_stays(designer):
    designer.open("red")
    QTest.keySequence(designer.window, "Ctrl+W")
    assert titles(designer) == ["Untitled"]
    (document,) = designer.documents.row
    QTest.keySequence(designer.window, "Ctrl+W")
    assert designer.documents.row == (document,)
    QTest.keySequence(designer.window, "Ctrl+Shift+T")
    assert titles(designer) == ["Untitled", "Red"]
    assert not designer.window.reopen_action.isEnabled()


def test_all_tabs_close_together_and_what_is_shown_changes_once(three, dialogs):
    lighten(three, 61)
    shown, rows = [], []
    three.documents.front_changed.connect(lambda: shown.append(three.documents.front.title))
    choose(three, "File ▸ Close All Tabs")  # the answer is to cancel
    assert dialogs.asked == ["Champagne"]
    assert titles(three) == ["Red", "Copper", "• Champagne"]
    dialogs.answer = Answer.DISCARD
    three.documents.closed.connect(lambda document: rows.append(document.title))
    choose(three, "File ▸ Close All Tabs")
    assert (titles(three), shown) == (["Untitled"], ["Untitled"])
    assert rows == ["Red", "Copper", "Champagne"]
    choose(three, "File ▸ Close All Tabs")  # there is nothing to close
    assert len(rows) == 3
    QTest.keySequence(three.window, "Ctrl+Shift+T")
    assert titles(three) == ["Untitled", "• Champagne"]


def test_the_other_tabs_close_and_the_one_in_front_stays(three, dialogs):
    lighten(three, 61)
    three.window.tabs.setCurrentIndex(1)
    lighten(three, 62)
    dialogs.answer = Answer.DISCARD
    choose(three, "File ▸ Close Other Tabs")
    assert dialogs.asked == ["Champagne"]
    assert titles(three) == ["• Copper"]
    assert three.store.value.lab_at(15.0)[0] == 62.0
    assert "File ▸ Close Other Tabs" not in dict(commands(three.window))


def test_quitting_asks_for_every_unsaved_tab_and_one_cancel_keeps_all(three, dialogs, own_session):
    lighten(three, 61)
    three.window.tabs.setCurrentIndex(0)
    lighten(three, 62)
    assert not three.window.close()
    assert dialogs.asked == ["Red"]
    assert len(titles(three)) == 3
    dialogs.answer = Answer.DISCARD
    assert three.window.close()
    assert dialogs.asked == ["Red", "Red", "Champagne"]
    assert list(own_session.rglob("*.recovery.json")) == []


def test_the_other_programs_follow_the_tab_in_front(three, qtbot, monkeypatch):
    sent = []
    monkeypatch.setattr(
        three.session, "_publish", lambda _topic, value: sent.append(paint_from_json(value).name)
    )
    qtbot.wait(20)
    sent.clear()
    for place in (0, 1):
        three.window.tabs.setCurrentIndex(place)
        qtbot.waitUntil(lambda place=place: len(sent) == place + 1)
    # A paint that is not in front does not change, and is not sent.
    three.documents.row[2].store.set(load_shipped_paint("blue"), "Elsewhere")
    qtbot.wait(20)
    assert sent == ["Red", "Copper"]
    assert three.window.editors.editors[0].fields[0].value() == load_shipped_paint("copper").lab_at(15.0)[0]


def test_a_double_click_on_a_number_goes_back_to_what_its_own_tab_had(three):
    lighten(three, 61)
    three.window.tabs.setCurrentIndex(0)
    three.window.tabs.setCurrentIndex(2)
    field = three.window.editors.editors[0].fields[0]
    assert field.value() == 61.0
    field.reset()
    assert three.store.value == load_shipped_paint("champagne")


def test_saving_names_the_tab_after_its_file(three, dialogs, tmp_path):
    dialogs.path = tmp_path / "mine"
    choose(three, "File ▸ Save")
    assert titles(three) == ["Red", "Copper", "mine.brdfpaint"]
    assert load_paint(tmp_path / "mine.brdfpaint") == load_shipped_paint("champagne")
    bar = three.window.tabs
    assert bar.tabToolTip(2) == str(tmp_path / "mine.brdfpaint")
    assert bar.accessibleTabName(2) == "mine.brdfpaint"


def test_a_gesture_ends_with_the_tab_that_it_was_made_in(three):
    three.session.begin_gesture()
    three.session.set_paint(load_shipped_paint("blue"), "Drag")
    three.window.tabs.setCurrentIndex(0)
    assert not three.session.in_gesture
    three.session.set_paint(load_shipped_paint("blue"), "Drag")
    three.window.tabs.setCurrentIndex(2)
    three.session.set_paint(load_shipped_paint("silver_metallic"), "Drag")
    assert three.store.stack.count() == 2


def offer_of(paint) -> dict:
    return {"to": "designer", "time": time.time(), "paint": paint_to_json(paint)}


def test_a_paint_that_arrives_in_the_midst_of_a_drag_waits_for_its_end(designer, qtbot):
    before = designer.documents.front
    band = designer.window.strip.band
    start = band.grip_centres()[0].toPoint()
    QTest.mousePress(band, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(band, start - QPoint(0, 8))
    designer.link.received.emit(OFFER, offer_of(load_shipped_paint("red")))
    assert designer.documents.row == (before,)
    QTest.mouseMove(band, start - QPoint(0, 16))
    QTest.mouseRelease(band, Qt.MouseButton.LeftButton, pos=start)
    qtbot.waitUntil(lambda: designer.store.value == load_shipped_paint("red"))
    assert before.store.stack.count() == 1
    assert designer.store.stack.count() == 0


def test_a_hand_that_a_switch_leaves_behind_moves_nothing_of_the_new_front(three):
    band = three.window.strip.band
    start = band.grip_centres()[0].toPoint()
    QTest.mousePress(band, Qt.MouseButton.LeftButton, pos=start)
    three.window.tabs.setCurrentIndex(0)
    for up in (8, 16):
        QTest.mouseMove(band, start - QPoint(0, up))
    QTest.mouseRelease(band, Qt.MouseButton.LeftButton, pos=start)
    assert three.store.value == load_shipped_paint("red")
    assert three.store.stack.count() == 0
    slider = three.window.editors.editors[0].sliders[0]
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=slider.rect().center())
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=slider.rect().center())
    assert three.store.stack.count() == 1, "the next hand is taken again"


def leave(designer, own_session, folder) -> None:
    """Leave what a kill of this moment would leave: autosaves and the record of the tabs, without their locks."""
    for document in designer.documents.row:
        document.recovery.write()
    designer.documents.record.write()
    for kind in ("*.recovery.json", "*.history.json", "*.tabs.json"):
        for file in own_session.rglob(kind):
            shutil.copy(file, folder / f"left_{file.name}")


def come_back(designer, own_session, folder) -> None:
    """Close all without a question, put what a kill left in its place, and start anew."""
    documents = designer.documents
    (autosaves,) = {document.recovery.folder for document in documents.row}
    designer.dialogs.answer = Answer.DISCARD
    first = documents.add(load_shipped_paint("blue"))
    for document in documents.row:
        if document is not first:
            documents.close(document)
    first.pristine = True
    for file in folder.glob("left_*"):
        # The record names the autosaves as they were called.
        file.replace(autosaves / file.name.removeprefix("left_").replace(".", "x.", 1))
    for file in autosaves.glob("*x.tabs.json"):
        file.write_text(file.read_text().replace(".recovery.json", "x.recovery.json"))
    designer.offer_recovery()


@pytest.fixture
def killed(three, dialogs, own_session, tmp_path):
    """Red edited twice and undone once, copper saved to a file, champagne edited and in front; then a kill."""
    three.dialogs = dialogs
    folder = tmp_path / "left"
    folder.mkdir()
    dialogs.path = tmp_path / "mine"
    three.window.tabs.setCurrentIndex(1)
    choose(three, "File ▸ Save")
    three.window.tabs.setCurrentIndex(0)
    lighten(three, 61)
    lighten(three, 62)
    three.window.undo_action.trigger()
    three.window.tabs.setCurrentIndex(2)
    lighten(three, 63)
    three.window.tabs.setCurrentIndex(0)
    leave(three, own_session, folder)
    come_back(three, own_session, folder)
    return three


def answer_message(designer, qtbot, text: str) -> None:
    button = designer.window.messages.findChild(object, f"message_action_{text}")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_a_kill_leaves_all_tabs_in_their_order_with_their_histories(killed, qtbot, own_session):
    answer_message(killed, qtbot, "Recover All")
    wait_until_read(killed, qtbot)
    assert titles(killed) == ["• Red", "mine.brdfpaint", "• Champagne"]
    assert killed.window.tabs.currentIndex() == 0
    assert killed.store.value.lab_at(15.0)[0] == 61.0
    killed.window.redo_action.trigger()
    assert killed.store.value.lab_at(15.0)[0] == 62.0
    killed.window.undo_action.trigger()
    killed.window.undo_action.trigger()
    assert killed.store.value == load_shipped_paint("red")
    assert not killed.window.undo_action.isEnabled()
    assert len(killed.store.states()) == 3
    killed.window.tabs.setCurrentIndex(1)
    assert killed.store.value == load_shipped_paint("copper")
    assert killed.store.is_clean
    left = [file for file in own_session.rglob("*.tabs.json") if file != killed.documents.record.file]
    assert left == []


def test_one_by_one_the_other_tabs_come_after_the_last_answer(killed, qtbot):
    for answer in ("One by One", "Recover", "Discard"):
        assert "mine.brdfpaint" not in titles(killed)
        dict(killed.window.messages.shown()["recovery"].actions)[answer]()
    wait_until_read(killed, qtbot)
    assert len(titles(killed)) == 2
    assert "mine.brdfpaint" in titles(killed)


def test_saved_tabs_alone_are_offered_too(three, dialogs, own_session, tmp_path, qtbot):
    three.dialogs = dialogs
    folder = tmp_path / "left"
    folder.mkdir()
    for place, name in ((0, "first"), (2, "second")):
        three.window.tabs.setCurrentIndex(place)
        dialogs.path = tmp_path / name
        choose(three, "File ▸ Save")
    leave(three, own_session, folder)
    come_back(three, own_session, folder)
    message = three.window.messages.shown()["recovery"]
    assert "“first.brdfpaint”, “Copper”, “second.brdfpaint”" in message.what
    answer_message(three, qtbot, "Reopen")
    wait_until_read(three, qtbot)
    assert titles(three) == ["first.brdfpaint", "Copper", "second.brdfpaint"]
    assert three.documents.front.title == "second.brdfpaint"


@pytest.mark.parametrize("folder", [False, True])
def test_a_project_opens_its_paints_beside_its_standard(designer, tmp_path, folder, qtbot):
    paints = tuple(load_shipped_paint(name) for name in ("red", "copper"))
    path = tmp_path / "spring.brdfproject"
    save_project(Project("Spring", paints, load_shipped_paint("champagne")), path, folder=folder)
    open_and_wait(designer, qtbot, path)
    assert titles(designer)[-2:] == ["Red", "Copper"]
    assert designer.store.value == paints[0]
    assert designer.store.path is None
    assert designer.feature(StandardControl).standard.name == "Champagne"


def test_a_saved_project_has_tabs_standard_and_all_that_designer_does_not_edit(
    designer, dialogs, tmp_path, qtbot
):
    paints = tuple(load_shipped_paint(name) for name in ("red", "copper"))
    path = tmp_path / "spring.brdfproject"
    view = NamedView("Day", View(exposure_ev=0.5))
    measured = CookTorrancePaint("Measured", (0.1, 0.1, 0.1), (CookTorranceLobe((0.3, 0.3, 0.3), 0.2, 0.3),))
    project = Project("Spring", (*paints, measured), load_shipped_paint("champagne"), (view,), notes="Kept")
    save_project(project, path)
    open_and_wait(designer, qtbot, path)
    lighten(designer, 61)
    designer.documents.close(designer.documents.row[-1])  # a closed tab stays in the project
    designer.window.shipped_requested.emit("pearl")
    assert not designer.documents.row[0].store.is_clean
    dialogs.path = path
    with qtbot.waitSignal(designer.projects.saved):
        designer.window.command("save_project").trigger()
    found = load_project(path)
    assert [one.name for one in found.paints] == ["Red", "Copper", "Measured", "Pearl"]
    assert found.paints[0].lab_at(15.0)[0] == 61.0
    assert found.paints[1:3] == (paints[1], measured)
    assert (found.standard, found.views, found.notes) == (project.standard, (view,), "Kept")
    assert all(one.store.is_clean for one in designer.documents.row)


def test_a_saved_tab_comes_back_with_its_history_and_one_without_a_file_too(
    three, dialogs, own_session, tmp_path, qtbot
):
    three.dialogs = dialogs
    folder = tmp_path / "left"
    folder.mkdir()
    three.window.tabs.setCurrentIndex(0)
    lighten(three, 61)
    lighten(three, 62)
    dialogs.path = tmp_path / "mine"
    choose(three, "File ▸ Save")
    leave(three, own_session, folder)
    come_back(three, own_session, folder)
    answer_message(three, qtbot, "Reopen")
    wait_until_read(three, qtbot)
    assert titles(three) == ["mine.brdfpaint", "Copper", "Champagne"]
    three.window.tabs.setCurrentIndex(0)
    assert three.store.is_clean
    three.window.undo_action.trigger()
    assert three.store.value.lab_at(15.0)[0] == 61.0
    assert not three.store.is_clean
    three.window.undo_action.trigger()
    assert three.store.value == load_shipped_paint("red")
    three.window.redo_action.trigger()
    three.window.redo_action.trigger()
    assert three.store.is_clean


def test_a_history_that_does_not_end_in_the_file_is_left(three, dialogs, own_session, tmp_path, qtbot):
    three.dialogs = dialogs
    folder = tmp_path / "left"
    folder.mkdir()
    three.window.tabs.setCurrentIndex(0)
    lighten(three, 61)
    dialogs.path = tmp_path / "mine"
    choose(three, "File ▸ Save")
    leave(three, own_session, folder)
    save_paint(load_shipped_paint("pearl"), tmp_path / "mine.brdfpaint")
    come_back(three, own_session, folder)
    answer_message(three, qtbot, "Reopen")
    wait_until_read(three, qtbot)
    three.window.tabs.setCurrentIndex(0)
    assert three.store.value == load_shipped_paint("pearl")
    assert not three.window.undo_action.isEnabled()
    assert not list(own_session.rglob("*x.history.json"))


class CountingTabs(DocumentTabs):
    """Counts how often the whole row is laid out."""

    layouts = 0

    def tabLayoutChange(self) -> None:  # noqa: N802 - the name is Qt's
        self.layouts += 1
        super().tabLayoutChange()


@pytest.mark.parametrize("count", [10, 80])
def test_a_change_of_one_tab_lays_the_row_out_a_few_times(qtbot, count: int) -> None:
    bar = CountingTabs()
    qtbot.addWidget(bar)
    bar.show()
    tabs = [TabState(key, f"Paint {key}", None, True) for key in range(count)]
    bar.show_tabs(tabs, 0)
    chosen: list[int] = []
    bar.chosen.connect(chosen.append)

    def change(new: list[TabState], front: int) -> int:
        before = bar.layouts
        bar.show_tabs(new, front)
        assert [bar.tabText(place) for place in range(bar.count())] == [
            tab.title if tab.clean else f"• {tab.title}" for tab in new
        ]
        assert bar.currentIndex() == front
        return bar.layouts - before

    most = 6
    assert change(tabs[:4] + tabs[5:], 4) <= most  # closed
    assert change(tabs, 4) <= most  # reopened
    assert change([*tabs[:2], replace(tabs[2], clean=False), *tabs[3:]], 2) <= most
    assert change([*tabs[1:], tabs[0]], 0) <= most * count  # every one of them has another place
    assert not chosen


def test_closed_documents_that_cannot_be_reopened_are_given_up(designer) -> None:
    documents = designer.documents
    for number in range(MOST_CLOSED + 5):
        documents.add(replace(load_shipped_paint("red"), name=f"Red {number}"))
    open_before = len(documents.row)
    for _ in range(open_before - 1):
        documents.close(documents.front)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    stores = documents.findChildren(DocumentStore, options=Qt.FindChildOption.FindDirectChildrenOnly)
    assert len(stores) == len(documents.row) + MOST_CLOSED


def test_a_document_that_was_not_changed_takes_no_lock(designer, tmp_path, qtbot) -> None:
    path = tmp_path / "red.brdfpaint"
    save_paint(load_shipped_paint("red"), path)
    open_and_wait(designer, qtbot, path)
    document = designer.documents.front
    lock = document.recovery.file.with_suffix(".lock")
    assert not lock.exists()
    lighten(designer, 61.0)
    assert document.recovery.write()
    assert lock.exists()
    assert document.recovery.file.exists()

"""New, open, save, save as, recent files and the question about unsaved changes, on real files."""

from __future__ import annotations

import json
import os
from datetime import datetime
from pathlib import Path

import pytest
from brdf_qt.documents.files import DocumentFiles, DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recent_files import MOST_RECENT
from brdf_qt.documents.recovery import Recovered, Recovery
from brdf_qt.documents.stamp import is_changed, stamp_of
from brdf_qt.window.dialogs import Answer, Overwrite, QtDialogs
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget

from brdf_suite.errors import DocumentError, FileError


def load(path: Path) -> str:
    try:
        return json.loads(path.read_text())["text"]
    except FileNotFoundError as error:
        raise FileError(path, "there is no such file") from error
    except (ValueError, KeyError) as error:
        raise DocumentError(path, "this is no note", "line 1") from error


def save(value: str, path: Path) -> None:
    try:
        path.write_text(json.dumps({"text": value}))
    except OSError as error:
        raise FileError(path, f"it cannot be written ({error.strerror})") from error


NOTE = DocumentFormat(
    kind="note",
    ending=".note",
    new=lambda: "",
    load=load,
    save=save,
    to_json=lambda value: {"text": value},
    from_json=lambda value, _path: value["text"],
    name_of=lambda value: value or "Untitled",
)


class ScriptedDialogs:
    """Answers as scripted, and notes what was asked."""

    def __init__(self) -> None:
        self.answer = Answer.CANCEL
        self.overwrite = Overwrite.CANCEL
        self.path: Path | None = None
        self.asked: list[str] = []

    def unsaved(self, name: str) -> Answer:
        self.asked.append(name)
        return self.answer

    def changed_file(self, path: Path) -> Overwrite:
        self.asked.append(f"changed {path.name}")
        return self.overwrite

    def open_path(self, folder: Path, filters: str) -> Path | None:
        return self.path

    def save_path(self, suggested: Path, filters: str) -> Path | None:
        self.asked.append(suggested.name)
        return self.path


@pytest.fixture
def dialogs() -> ScriptedDialogs:
    return ScriptedDialogs()


@pytest.fixture
def files(qapp, dialogs) -> DocumentFiles[str]:
    return DocumentFiles(DocumentStore("first"), NOTE, dialogs)


def test_save_as_adds_the_ending_and_open_reads_the_same_back(files, dialogs, tmp_path):
    dialogs.path = tmp_path / "a"
    files.store.set("edited", "Edit")
    assert files.save()
    assert files.store.is_clean
    assert files.store.path == tmp_path / "a.note"
    files.store.set("more", "Edit")
    assert files.save()
    assert load(tmp_path / "a.note") == "more"
    assert files.new()
    assert files.store.path is None
    assert files.open(tmp_path / "a.note")
    assert files.store.value == "more"


@pytest.mark.parametrize("answer", list(Answer))
def test_the_answer_about_unsaved_changes_is_obeyed(files, dialogs, tmp_path, answer):
    files.store.mark_clean(tmp_path / "a.note")
    files.store.set("edited", "Edit")
    dialogs.answer = answer
    done = files.new()
    assert dialogs.asked == ["a.note"]
    assert done == (answer is not Answer.CANCEL)
    assert files.store.value == ("edited" if answer is Answer.CANCEL else "")
    assert (tmp_path / "a.note").exists() == (answer is Answer.SAVE)


def test_giving_up_the_save_dialog_keeps_the_document(files, dialogs):
    files.store.set("edited", "Edit")
    dialogs.answer, dialogs.path = Answer.SAVE, None
    assert not files.new()
    assert files.store.value == "edited"


def test_nothing_is_asked_about_a_saved_document(files, dialogs):
    assert files.new()
    assert dialogs.asked == []


def test_a_bad_file_is_reported_with_its_place_and_changes_nothing(files, tmp_path):
    heard: list[Message] = []
    files.failed.connect(heard.append)
    bad = tmp_path / "bad.note"
    bad.write_text("{")
    assert not files.open(bad)
    assert files.store.value == "first"
    assert heard[0].what.startswith("bad.note: ")
    assert heard[0].where == f"Line 1, in {tmp_path}"
    assert "unchanged" in heard[0].todo


def test_a_save_that_fails_leaves_the_document_unsaved(files, tmp_path):
    heard: list[Message] = []
    files.failed.connect(heard.append)
    files.store.mark_clean(tmp_path / "missing" / "a.note")
    files.store.set("edited", "Edit")
    assert not files.save()
    assert not files.store.is_clean
    assert heard[0].severity == "error"


def test_recent_files_are_remembered_newest_first(files, dialogs, tmp_path):
    for number in range(MOST_RECENT + 2):
        dialogs.path = tmp_path / f"{number}.note"
        assert files.save_as()
    assert files.open(tmp_path / "5.note")
    again = DocumentFiles(DocumentStore(""), NOTE, dialogs)
    names = [path.stem for path in again.recent()]
    assert names[:2] == ["5", "11"]
    assert len(names) == len(set(names)) == MOST_RECENT
    (tmp_path / "11.note").unlink()
    assert not files.open(tmp_path / "11.note")
    assert "11" not in [path.stem for path in files.recent()]
    files.clear_recent()
    assert files.recent() == []


def test_the_suggested_name_is_a_safe_file_name(files, dialogs, tmp_path):
    dialogs.path = None
    files.store.set("a/b: c*", "Edit")
    files.save_as()
    assert dialogs.asked == ["a_b_ c_.note"]


def opened(files, path: Path) -> Path:
    """Open a real file and edit it."""
    save("on disk", path)
    assert files.open(path)
    files.store.set("edited", "Edit")
    return path


@pytest.mark.parametrize("answer", list(Overwrite))
def test_a_file_that_another_program_changed_is_written_over_only_when_reported(
    files, dialogs, tmp_path, answer
):
    path = opened(files, tmp_path / "a.note")
    save("by another program", path)
    dialogs.overwrite, dialogs.path = answer, tmp_path / "b.note"
    assert files.save() == (answer is not Overwrite.CANCEL)
    assert dialogs.asked[0] == "changed a.note"
    assert load(path) == ("edited" if answer is Overwrite.OVERWRITE else "by another program")
    assert (tmp_path / "b.note").exists() == (answer is Overwrite.SAVE_AS)
    assert files.store.is_clean == (answer is not Overwrite.CANCEL)


def test_a_change_of_the_same_size_and_time_is_noticed(files, dialogs, tmp_path):
    path = opened(files, tmp_path / "a.note")
    before = path.stat()
    save("on dusk", path)
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert path.stat().st_size == before.st_size
    assert not files.save()
    assert load(path) == "on dusk"


def test_a_file_that_is_touched_or_was_saved_here_or_is_gone_is_not_asked_about(files, dialogs, tmp_path):
    path = opened(files, tmp_path / "a.note")
    os.utime(path, ns=(1, 1))
    assert files.save()
    files.store.set("more", "Edit")
    assert files.save()
    path.unlink()
    files.store.set("again", "Edit")
    assert files.save()
    assert load(path) == "again"
    assert dialogs.asked == []


def test_after_the_answer_the_next_save_asks_no_more(files, dialogs, tmp_path):
    path = opened(files, tmp_path / "a.note")
    save("by another program", path)
    dialogs.overwrite = Overwrite.OVERWRITE
    assert files.save()
    files.store.set("more", "Edit")
    assert files.save()
    assert dialogs.asked == ["changed a.note"]


@pytest.mark.parametrize("other", [False, True])
def test_recovered_work_knows_what_its_file_held(files, dialogs, tmp_path, other):
    path = opened(files, tmp_path / "a.note")
    ended = Recovery(files.store, NOTE, fail)
    ended.close(keep=True)
    if other:
        save("by another program", path)
    again = DocumentFiles(DocumentStore(""), NOTE, dialogs)
    recovery = Recovery(again.store, NOTE, fail)
    recovery.take(recovery.found()[0])
    assert again.save() is not other
    assert dialogs.asked == (["changed a.note"] if other else [])
    assert load(path) == ("by another program" if other else "edited")
    recovery.close(keep=False)


@pytest.mark.parametrize(
    ("button", "answer"),
    [("Overwrite", Overwrite.OVERWRITE), ("Save As…", Overwrite.SAVE_AS), ("", Overwrite.CANCEL)],
)
def test_the_question_about_a_changed_file(qtbot, tmp_path, button, answer):
    window = QWidget()
    qtbot.addWidget(window)
    shown = []

    def press() -> None:
        box = QApplication.activeModalWidget()
        shown.append(box.text() + box.informativeText())
        sign = box.iconPixmap().toImage()
        pixels = [sign.pixelColor(x, y) for x in range(sign.width()) for y in range(sign.height())]
        assert pixels
        assert all(p.red() == p.green() == p.blue() for p in pixels if p.alpha() > 0)
        found = [b for b in box.buttons() if b.text().replace("&", "") == button]
        qtbot.mouseClick(found[0], Qt.MouseButton.LeftButton) if found else box.reject()

    QTimer.singleShot(0, press)
    assert QtDialogs(window).changed_file(tmp_path / "a.note") is answer
    assert "“a.note” was changed by another program" in shown[0]
    assert str(tmp_path) in shown[0]


def test_the_save_dialog_adds_the_ending_itself_so_that_it_asks_about_the_right_file(qtbot, tmp_path):
    window = QWidget()
    qtbot.addWidget(window)

    def type_name() -> None:
        dialog = QApplication.activeModalWidget()
        line = dialog.findChild(QLineEdit)
        line.setText("mine")
        dialog.accept()

    QTimer.singleShot(0, type_name)
    found = QtDialogs(window).save_path(tmp_path / "first.note", NOTE.filters)
    assert found == tmp_path / "mine.note"


def test_an_autosave_that_works_again_is_reported(files, qtbot):
    heard = []
    recovery = Recovery(files.store, NOTE, heard.append)
    files.store.set("edited", "Edit")
    recovery.file.mkdir()  # as on a full disk: the file cannot be written
    assert not recovery.write()
    assert len(heard) == 1
    recovery.file.rmdir()
    with qtbot.waitSignal(recovery.written_again):
        assert recovery.write()
    with qtbot.assertNotEmitted(recovery.written_again):
        recovery.write()
    recovery.close(keep=False)


def fail(error: BaseException) -> None:
    raise AssertionError(error)


def test_unsaved_work_is_written_within_a_second_and_goes_when_saved(files, qtbot, own_settings, tmp_path):
    recovery = Recovery(files.store, NOTE, fail)
    files.store.set("edited", "Edit")
    folder = own_settings

    def written() -> list[Path]:
        return list(folder.rglob("*.recovery.json"))

    qtbot.waitUntil(lambda: bool(written()))
    assert json.loads(written()[0].read_text())["document"] == {"text": "edited"}
    files.store.mark_clean(tmp_path / "a.note")
    qtbot.waitUntil(lambda: not written())
    recovery.close(keep=False)


def test_work_of_a_run_that_lives_is_not_offered(files):
    alive = Recovery(files.store, NOTE, fail)
    files.store.set("edited", "Edit")
    alive.write()
    other = Recovery(DocumentStore(""), NOTE, fail)
    assert other.found() == []
    alive.close(keep=True)
    found = other.found()
    assert [item.value for item in found] == ["edited"]
    other.take(found[0])
    assert not found[0].file.exists()
    other.close(keep=False)


def test_damaged_recovery_is_reported_and_put_aside(files, own_settings):
    heard = []
    recovery = Recovery(files.store, NOTE, heard.append)
    bad = recovery.folder / "x.recovery.json"
    bad.write_text("{")
    assert recovery.found() == []
    assert "cannot be read" in str(heard[0])
    assert not bad.exists()
    recovery.close(keep=False)


def test_recovered_work_stays_on_disk_where_it_cannot_be_written_anew(files, own_settings):
    store = DocumentStore("first")
    ended = Recovery(store, NOTE, fail)
    store.set("edited", "Edit")
    ended.close(keep=True)
    heard = []
    recovery = Recovery(files.store, NOTE, heard.append)
    (item,) = recovery.found()
    # Its own file cannot be made, as on a full disk: a folder stands in its place.
    recovery.file.mkdir()
    recovery.take(item)
    assert files.store.value == "edited"
    assert "cannot be written" in str(heard[0])
    assert json.loads(item.file.read_text())["document"] == {"text": "edited"}
    recovery.file.rmdir()
    recovery.close(keep=False)


def test_recovered_work_that_cannot_be_removed_is_reported(files):
    heard = []
    recovery = Recovery(files.store, NOTE, heard.append)
    stuck = recovery.folder / "stuck.recovery.json"
    stuck.mkdir()
    recovery.drop(Recovered("text", None, datetime.now(), stuck))
    assert "cannot be removed" in str(heard[0])
    recovery.close(keep=False)


def test_the_content_of_a_large_file_is_not_read_to_see_a_change(tmp_path: Path) -> None:
    small, large = tmp_path / "small.note", tmp_path / "large.note"
    small.write_bytes(b"a")
    with large.open("wb") as stream:
        stream.truncate(2**40)  # a hole: no disk is filled, and reading it would take an hour
    for path, same in ((small, True), (large, False)):
        before = stamp_of(path)
        assert not is_changed(path, before)
        os.utime(path, (1.0, 1.0))
        assert is_changed(path, before) is not same

"""New, open, save, save as, recent files and the question about unsaved changes, on real files."""

from __future__ import annotations

import json
from datetime import datetime
from pathlib import Path

import pytest
from brdf_qt.dialogs import Answer
from brdf_qt.document_files import MOST_RECENT, DocumentFiles, DocumentFormat
from brdf_qt.document_store import DocumentStore
from brdf_qt.message_bar import Message
from brdf_qt.recovery import Recovered, Recovery

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
    """Answers as told, and notes what was asked."""

    def __init__(self) -> None:
        self.answer = Answer.CANCEL
        self.path: Path | None = None
        self.asked: list[str] = []

    def unsaved(self, name: str) -> Answer:
        self.asked.append(name)
        return self.answer

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


def test_a_bad_file_is_told_with_its_place_and_changes_nothing(files, tmp_path):
    heard: list[Message] = []
    files.failed.connect(heard.append)
    bad = tmp_path / "bad.note"
    bad.write_text("{")
    assert not files.open(bad)
    assert files.store.value == "first"
    assert "bad.note, at line 1" in heard[0].where
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


def fail(error: BaseException) -> None:
    raise AssertionError(error)


def test_unsaved_work_is_written_within_a_second_and_goes_when_saved(files, qtbot, own_settings, tmp_path):
    recovery = Recovery(files.store, NOTE, fail)
    files.store.set("edited", "Edit")
    folder = own_settings

    def written() -> list[Path]:
        return list(folder.rglob("*.recovery.json"))

    qtbot.waitUntil(lambda: bool(written()), timeout=2000)
    assert json.loads(written()[0].read_text())["document"] == {"text": "edited"}
    files.store.mark_clean(tmp_path / "a.note")
    qtbot.waitUntil(lambda: not written(), timeout=2000)
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


def test_damaged_recovery_is_told_and_put_aside(files, own_settings):
    heard = []
    recovery = Recovery(files.store, NOTE, heard.append)
    bad = recovery._folder / "x.recovery.json"
    bad.write_text("{")
    assert recovery.found() == []
    assert "cannot be read" in str(heard[0])
    assert not bad.exists()
    recovery.close(keep=False)


def test_recovered_work_stays_on_disk_where_it_cannot_be_written_anew(files, own_settings):
    ended = Recovery(DocumentStore("first"), NOTE, fail)
    ended._store.set("edited", "Edit")
    ended.close(keep=True)
    heard = []
    recovery = Recovery(files.store, NOTE, heard.append)
    (item,) = recovery.found()
    # Its own file cannot be made, as on a full disk: a folder stands in its place.
    recovery._file.mkdir()
    recovery.take(item)
    assert files.store.value == "edited"
    assert "cannot be written" in str(heard[0])
    assert json.loads(item.file.read_text())["document"] == {"text": "edited"}
    recovery._file.rmdir()
    recovery.close(keep=False)


def test_recovered_work_that_cannot_be_removed_is_told(files):
    heard = []
    recovery = Recovery(files.store, NOTE, heard.append)
    stuck = recovery._folder / "stuck.recovery.json"
    stuck.mkdir()
    recovery.drop(Recovered("text", None, datetime.now(), stuck))
    assert "cannot be removed" in str(heard[0])
    recovery.close(keep=False)

"""The autosave of a large palette is encoded beside the window, and is what a small one's is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from threading import Event

import pytest
from brdf_color_swatch.assembly import palette_format
from brdf_color_swatch.library import autosave
from brdf_color_swatch.library.autosave import PaletteRecovery
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.work.tasks import TaskRunner

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette

GREY = solid_paint("Grey", (50.0, 0.0, 0.0))


@pytest.fixture
def kept(qapp, monkeypatch):
    """A store whose palette counts as large, its autosave, and the runner of its thread."""
    monkeypatch.setattr(autosave, "_MANY", 2)
    tasks = TaskRunner()
    store = DocumentStore(Palette("Large", (Entry(GREY, id="a"), Entry(GREY, id="b"))))
    failed: list[BaseException] = []
    recovery = PaletteRecovery(store, palette_format(), failed.append, tasks)
    yield store, recovery, tasks, failed
    recovery.close(keep=False)
    tasks.stop()


def test_unsaved_work_is_written_by_a_thread_and_found_again(kept, qtbot) -> None:
    store, recovery, _tasks, failed = kept
    store.set(replace(store.value, name="Changed\u4e00"), "rename")
    qtbot.waitUntil(lambda: recovery.file.exists())
    found = recovery.saved()
    assert found.value == store.value
    assert found.path is None
    assert not failed


def test_edits_that_never_cease_do_not_starve_it(kept, qtbot, monkeypatch) -> None:
    store, recovery, tasks, failed = kept
    gates, begun = [Event(), Event()], []
    real = autosave.encode_autosave

    def held(request, progress) -> Iterator[str]:
        begun.append(request[1].name)
        assert gates[len(begun) - 1].wait(120)
        return real(request, progress)

    def edit(name: str) -> None:
        store.set(replace(store.value, name=name), "rename")
        recovery.write_in_background()

    monkeypatch.setattr(autosave, "encode_autosave", held)
    for name in ("first", "second", "third"):
        edit(name)
    gates[0].set()
    qtbot.waitUntil(lambda: recovery.file.exists())
    assert recovery.saved().value.name == "first"
    qtbot.waitUntil(lambda: len(begun) == 2)
    gates[1].set()
    qtbot.waitUntil(lambda: not tasks.busy)
    assert begun == ["first", "third"]
    assert recovery.saved().value == store.value
    assert not failed


def test_what_is_older_than_the_saved_file_is_not_written(kept, qtbot, tmp_path, monkeypatch) -> None:
    store, recovery, tasks, _failed = kept
    gate, real = Event(), autosave.encode_autosave

    def held(request, progress) -> Iterator[str]:
        assert gate.wait(120)
        return real(request, progress)

    monkeypatch.setattr(autosave, "encode_autosave", held)
    written: list[Path] = []
    put = recovery.take_draft
    monkeypatch.setattr(
        recovery, "take_draft", lambda draft, **how: (written.append(draft), put(draft, **how))
    )
    store.set(replace(store.value, name="Old"), "rename")
    recovery.write_in_background()
    store.mark_clean(tmp_path / "saved.brdfpalette")
    store.set(replace(store.value, name="New"), "rename")
    recovery.write_in_background()
    gate.set()
    qtbot.waitUntil(lambda: not tasks.busy)
    assert len(written) == 1
    assert recovery.saved().value.name == "New"
    assert not list(recovery.folder.glob("*.tmp"))


def test_what_was_saved_meanwhile_leaves_no_autosave(kept, qtbot, tmp_path) -> None:
    store, recovery, tasks, _failed = kept
    store.set(replace(store.value, name="Changed"), "rename")
    recovery.write_in_background()
    assert tasks.busy
    store.mark_clean(tmp_path / "saved.brdfpalette")
    qtbot.waitUntil(lambda: not tasks.busy)
    assert not recovery.file.exists()


def test_a_write_failure_and_its_end_are_reported(kept, qtbot) -> None:
    store, recovery, _tasks, failed = kept
    blocked = recovery.file
    blocked.mkdir()
    store.set(replace(store.value, name="Changed"), "rename")
    qtbot.waitUntil(lambda: bool(failed))
    assert "cannot be written" in str(failed[0])
    blocked.rmdir()
    with qtbot.waitSignal(recovery.written_again):
        store.set(replace(store.value, name="Again"), "rename")
    assert recovery.file.exists()

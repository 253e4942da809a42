"""What a kill -9 leaves of Color Swatch: every palette with its undo history, also steps that changed two of them."""

from __future__ import annotations

import signal
import subprocess
import sys
from dataclasses import replace

import pytest
from brdf_color_swatch.assembly import ColorSwatch
from brdf_color_swatch.export.dialog import QtExportDialogs
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.history import History
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.window.dialogs import Answer
from brdf_qt.work.pictures import Pictures
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtWidgets import QWidget
from shiboken6 import delete

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import load_palette, save_palette

pytestmark = pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system has no kill -9")

RUN = """
import os, signal, sys
from dataclasses import replace
from pathlib import Path
from brdf_color_swatch.assembly import ColorSwatch
from brdf_qt.documents.stamp import stamp_of
from brdf_qt.program.application import create_application
from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.palette_store import load_palette
from PySide6.QtTest import QTest

app = create_application("Color Swatch")
swatch = ColorSwatch()
swatch.window.show()
library = swatch.library
paths = map(Path, sys.argv[1:])
one, two, plain = (library.add_palette(load_palette(p), p, stamp=stamp_of(p)) for p in paths)
value = library.palette
library.edit("Rename", (one, replace(value(one), name="Renamed")))
moved = edits.add_entries(value(two), [value(one).entry("a0")])
library.edit("Move", (one, edits.remove_entries(value(one), ["a0"])), (two, moved))
assert library.save(two)
library.edit("Notes", (one, replace(value(one), notes="later")))
library.history.undo()
files = [library.item(key).palette.recovery for key in (one, two)]
while not (files[0].file.exists() and files[1]._saved_file.exists()):
    QTest.qWait(20)
QTest.qWait(1500)
os.kill(os.getpid(), signal.SIGKILL)
"""


class Discards(QtExportDialogs):
    """Gives unsaved work up at the end of a test."""

    def unsaved(self, name: str) -> Answer:
        return Answer.DISCARD


@pytest.fixture
def killed(tmp_path, monkeypatch):
    """Return the files of two palettes, one left unsaved and one saved, of a program that was killed."""
    monkeypatch.setattr("brdf_qt.program.settings.QCoreApplication.applicationName", lambda: "Color Swatch")
    paths = [tmp_path / f"{name}.brdfpalette" for name in "abc"]
    for path in paths:
        name = path.stem
        entries = tuple(Entry(solid_paint(f"{name}{n}", (50.0, 0.0, 0.0)), id=f"{name}{n}") for n in range(3))
        save_palette(Palette(name.upper(), entries), path)
    done = subprocess.run(
        [sys.executable, "-c", RUN, *map(str, paths)],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == -signal.SIGKILL, done.stderr
    return paths


@pytest.fixture
def again(killed, qtbot, monkeypatch):
    """The program that is started after the kill."""
    monkeypatch.setattr(Pictures, "request", lambda *_: None)
    program = ColorSwatch(dialogs=Discards)
    program.window.show()
    qtbot.waitUntil(lambda: "recovery" in program.window.messages.shown())
    yield program
    program.close()
    program.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def key_of(program: ColorSwatch, path) -> str:
    return next(item.key for item in program.library.items if item.path == path)


def test_the_histories_of_all_palettes_come_back(again, killed, qtbot) -> None:
    library, (one, two, plain) = again.library, killed
    button = again.window.messages.findChild(QWidget, "message_action_Recover")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    key, other = key_of(again, one), key_of(again, two)
    assert library.palette(key).name == "Renamed"
    # The step that both have can be taken back only where the other is read too.
    assert library.history.redo_name == "Notes"
    assert not library.history.can_undo
    again.session.show_scope(Scope(other))
    qtbot.waitUntil(lambda: library.palette(other) is not None)
    assert library.history.undo_name == "Move"
    assert library.item(other).is_clean
    assert not library.item(key).is_clean
    library.history.undo()
    assert [entry.id for entry in library.palette(key)] == ["a0", "a1", "a2"]
    assert library.palette(other) == Palette("B", library.palette(other).entries)
    assert [entry.id for entry in library.palette(other)] == ["b0", "b1", "b2"]
    assert not library.item(other).is_clean
    library.history.undo()
    assert library.palette(key) == load_palette(one)
    assert library.item(key).is_clean
    assert not library.history.can_undo
    for name in ("Rename", "Move", "Notes"):
        assert library.history.redo_name == name
        library.history.redo()
    assert library.palette(key).notes == "later"
    assert plain in [item.path for item in library.items]


def test_a_file_that_was_changed_since_gets_no_history(again, killed, qtbot) -> None:
    _, two, _ = killed
    save_palette(replace(load_palette(two), notes="by another program"), two)
    key = key_of(again, two)
    again.session.show_scope(Scope(key))
    qtbot.waitUntil(lambda: again.library.palette(key) is not None)
    assert again.library.palette(key).notes == "by another program"
    assert not again.library.history.can_undo


@given(
    steps=st.lists(st.sets(st.integers(0, 2), min_size=1, max_size=3), max_size=12),
    back=st.integers(0, 12),
    order=st.permutations(range(3)),
)
def test_the_order_of_the_steps_comes_back_in_whatever_order_the_palettes_do(
    qapp, steps, back, order
) -> None:
    owner = QObject()
    stores = [DocumentStore(Palette(f"p{number}"), owner) for number in range(3)]
    history = History(owner)
    for number, changed in enumerate(steps):
        history.apply(
            f"{number}", [(stores[i], replace(stores[i].value, notes=f"{number}")) for i in changed]
        )
    for _ in range(back):
        history.undo()
    again, other = [DocumentStore(Palette("x"), owner) for _ in stores], History(owner)
    for number in order:
        store, marks = stores[number], history.marks(stores[number])
        again[number].restore(store.states(), store.stack.index(), None)
        other.adopt(again[number], (*marks.done, *marks.undone), store.stack.index())
    assert (other.undo_name, other.redo_name) == (history.undo_name, history.redo_name)
    for one in (history, other):
        while one.can_undo:
            one.undo()
    assert [store.value for store in again] == [store.value for store in stores]
    while other.can_redo:
        assert other.redo_name == history.redo_name
        other.redo()
        history.redo()
        assert [store.value for store in again] == [store.value for store in stores]
    assert not history.can_redo
    delete(owner)


def test_half_of_a_move_is_never_taken_back(qapp) -> None:
    stores = [DocumentStore(Palette("a")), DocumentStore(Palette("b"))]
    history = History()
    history.apply("first", [(stores[0], replace(stores[0].value, notes="1"))])
    history.apply("both", [(store, replace(store.value, notes="2")) for store in stores])
    history.apply("last", [(stores[0], replace(stores[0].value, notes="3"))])
    marks, store = history.marks(stores[0]), DocumentStore(Palette("x"))
    store.restore(stores[0].states(), 3, None)
    other = History()
    other.adopt(store, marks.done, 3)
    other.undo()
    assert store.value.notes == "2"
    assert not other.can_undo

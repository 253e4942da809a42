"""A file that another program writes while it is open: noticed, and taken only where the user says so."""

from __future__ import annotations

from dataclasses import replace

import pytest
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.loading import read_palette_file
from brdf_qt.window.dialogs import Overwrite
from PySide6.QtWidgets import QPushButton

from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.palette_store import load_palette, save_palette


@pytest.fixture
def shared(swatch, tmp_path, qtbot):
    """The sample in a file, open, and that file written by another program."""
    path = tmp_path / "shared.brdfpalette"
    save_palette(swatch.session.palette, path)
    key = swatch.library.add_path(path)
    swatch.session.show_scope(Scope(key))
    qtbot.waitUntil(lambda: swatch.library.item(key).state == "open")

    def write(change) -> None:
        save_palette(change(load_palette(path)), path)
        # The watch receives the notification of the system; a test of its own checks that.
        swatch.library.item(key).palette.watch.changed.emit(str(path))

    return key, path, write


def press(program, key: str, text: str) -> None:
    message = program.window.messages.findChild(object, f"message_{key}")
    next(one for one in message.findChildren(QPushButton) if one.text() == text).click()


def test_reload_takes_what_the_file_holds_and_undo_brings_mine_back(swatch, shared, names, qtbot) -> None:
    key, path, write = shared
    mine = swatch.session.palette
    write(lambda palette: edits.rename_entry(palette, "red", "Crimson"))
    assert "Crimson" not in names(swatch)
    press(swatch, f"outside {key}", "Reload")
    qtbot.waitUntil(lambda: "Crimson" in names(swatch))
    assert swatch.library.item(key).is_clean
    swatch.library.history.undo()
    assert swatch.session.palette == mine
    assert not swatch.library.item(key).is_clean
    assert load_palette(path).entry("red").name == "Crimson"


def test_merge_keeps_both_and_saving_then_asks_nothing(swatch, shared, names, dialogs, qtbot) -> None:
    key, path, write = shared
    swatch.session.edit("Rename", lambda palette: edits.rename_entry(palette, "blue", "Azure"))
    mine = swatch.session.palette
    write(lambda palette: edits.remove_entries(edits.rename_entry(palette, "red", "Crimson"), ["ice"]))
    press(swatch, f"outside {key}", "Merge")
    qtbot.waitUntil(lambda: "Crimson" in names(swatch))
    assert {"Azure", "Crimson"} <= set(names(swatch))
    assert "Ice" not in names(swatch)
    assert f"outside {key}" not in swatch.window.messages.shown()
    assert swatch.library.save(key)
    assert not dialogs.asked
    assert load_palette(path).entry("blue").name == "Azure"
    swatch.library.history.undo()
    assert swatch.session.palette == mine


def test_mine_is_kept_and_the_file_is_not_overwritten_unasked(swatch, shared, dialogs) -> None:
    key, path, write = shared
    swatch.session.edit("Note", lambda palette: replace(palette, notes="mine"))
    write(lambda palette: replace(palette, notes="theirs"))
    press(swatch, f"outside {key}", "Keep Mine")
    dialogs.overwrite = Overwrite.CANCEL
    assert not swatch.library.save(key)
    assert dialogs.asked == ["changed shared.brdfpalette"]
    assert load_palette(path).notes == "theirs"
    dialogs.overwrite = Overwrite.OVERWRITE
    assert swatch.library.save(key)
    assert load_palette(path).notes == "mine"


@pytest.mark.parametrize("text", ["Reload", "Merge"])
def test_a_palette_that_is_closed_meanwhile_is_asked_about_no_more(swatch, shared, text: str) -> None:
    key, _path, write = shared
    library, named = swatch.library, f"outside {key}"
    swatch.session.edit("Rename", lambda palette: edits.rename_entry(palette, "blue", "Azure"))
    write(lambda palette: edits.rename_entry(palette, "red", "Crimson"))
    actions = dict(swatch.window.messages.shown()[named].actions)
    read = read_palette_file(library.item(key).path, lambda _share, _what: None)
    actions[text]()
    assert library.tasks.busy
    assert library.close(key)
    assert not library.tasks.busy
    assert named not in swatch.window.messages.shown()
    # Pressed, or answered, just as it went.
    actions[text]()
    assert not library.tasks.busy
    swatch.session.loader.adopt_file(key, read.palette, read, text)
    assert library.item(key) is None


def test_the_watch_hears_a_file_that_is_replaced(swatch, tmp_path, qtbot) -> None:
    path = tmp_path / "heard.brdfpalette"
    save_palette(swatch.session.palette, path)
    key = swatch.library.add_path(path)
    swatch.session.show_scope(Scope(key))
    qtbot.waitUntil(lambda: swatch.library.item(key).state == "open")
    save_palette(replace(swatch.session.palette, notes="new"), path)
    qtbot.waitUntil(lambda: f"outside {key}" in swatch.window.messages.shown())
    assert swatch.session.palette.notes == ""

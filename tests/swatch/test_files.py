"""Files through the window: lazily read, saved, exported with what is lost, damaged, and unsaved work recovered."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.loading import UnsavedWork, read_palette_file
from brdf_qt.documents.recovery import Recovered
from brdf_qt.window.dialogs import Answer
from PySide6.QtWidgets import QPushButton

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import load_palette, save_palette
from brdf_suite.documents.project import Project, save_project
from brdf_suite.files.palettes import read_palette


def message_text(program, key: str) -> str:
    """Return what a message says; empty where there is none."""
    message = program.window.messages.shown().get(key)
    return "" if message is None else message.what


def press(program, key: str, text: str) -> None:
    """Press a button of a message."""
    message = program.window.messages.findChild(object, f"message_{key}")
    button = next(one for one in message.findChildren(QPushButton) if one.text() == text)
    button.click()


def test_a_file_is_read_when_it_is_wanted_saved_and_read_again(
    swatch, dialogs, tmp_path, names, qtbot, command
) -> None:
    path = tmp_path / "one.brdfpalette"
    save_palette(replace(swatch.session.palette, name="On disk"), path)
    key = swatch.library.add_path(path)
    item = swatch.library.item(key)
    assert (item.state, item.title) == ("closed", "one")
    swatch.session.show_scope(Scope(key))
    assert "Reading" in swatch.window.panes[0].note
    qtbot.waitUntil(lambda: item.state == "open")
    assert item.title == "On disk"
    assert len(names(swatch)) == 6
    swatch.session.edit("Rename", lambda palette: replace(palette, name="Changed"))
    assert swatch.window.isWindowModified()
    command(swatch, "save")
    assert not swatch.window.isWindowModified()
    assert load_palette(path).name == "Changed"
    swatch.library.history.undo()
    assert swatch.window.isWindowModified()
    dialogs.answer = Answer.CANCEL
    command(swatch, "close")
    assert swatch.library.item(key) is not None
    dialogs.answer = Answer.DISCARD
    command(swatch, "close")
    assert swatch.library.item(key) is None
    assert load_palette(path).name == "Changed"


def test_what_a_format_cannot_hold_is_listed_before_it_is_written(
    swatch, dialogs, tmp_path, qtbot, command
) -> None:
    dialogs.path = tmp_path / "out.gpl"
    command(swatch, "export")
    qtbot.waitUntil(lambda: "export" in swatch.window.messages.shown())
    message = swatch.window.messages.shown()["export"]
    assert "45°" in message.todo
    assert not dialogs.path.exists()
    press(swatch, "export", "Export Anyway")
    qtbot.waitUntil(lambda: dialogs.path.exists() and "Saved" in message_text(swatch, "export"))
    assert [entry.name for entry in read_palette(dialogs.path).palette] == [
        e.name for e in swatch.session.palette
    ]
    dialogs.path = tmp_path / "out.xyz"
    command(swatch, "export")
    qtbot.waitUntil(lambda: "names no palette format" in message_text(swatch, "export"))


def test_what_is_selected_is_exported_alone(swatch, dialogs, tmp_path, qtbot, command, select) -> None:
    dialogs.path = tmp_path / "some.brdfpalette"
    select(swatch, "Red", "Ice")
    command(swatch, "export_selected")
    qtbot.waitUntil(lambda: dialogs.path.exists() and "export" in swatch.window.messages.shown())
    assert [entry.name for entry in load_palette(dialogs.path)] == ["Red", "Ice"]


def test_a_palette_of_another_program_is_imported_and_its_file_left_alone(
    swatch, dialogs, tmp_path, qtbot
) -> None:
    path = tmp_path / "web.gpl"
    path.write_text("GIMP Palette\nName: Web\n#\n255 0 0\tRed\n0 0 255\tBlue\n")
    content = path.read_bytes()
    dialogs.path = path
    swatch.window.command("open").trigger()
    qtbot.waitUntil(lambda: swatch.session.palette is not None and swatch.session.palette.name == "Web")
    assert swatch.session.item.path is None
    assert swatch.session.item.is_clean
    assert "*.gpl" in dialogs.asked[-1]
    swatch.session.edit("Rename", lambda palette: replace(palette, name="Mine"))
    dialogs.path = tmp_path / "mine"
    assert swatch.library.save(swatch.session.state.scope.palette)
    assert load_palette(tmp_path / "mine.brdfpalette").name == "Mine"
    assert path.read_bytes() == content
    # What is open has a file of its own now: the other's is read again where it is asked for.
    mine = swatch.session.state.scope.palette
    swatch.window.open_requested.emit(path)
    qtbot.waitUntil(lambda: swatch.session.palette is not None and swatch.session.palette.name == "Web")
    assert swatch.session.state.scope.palette != mine
    assert swatch.library.palette(mine).name == "Mine"


def test_a_damaged_file_is_reported_and_reloads_once_repaired(swatch, tmp_path, qtbot, names) -> None:
    path = tmp_path / "bad.brdfpalette"
    path.write_text('{"format": "brdfpalette", "version": 2, "entries": [{]}')
    swatch.window.open_requested.emit(path)
    pane = swatch.window.panes[0]
    qtbot.waitUntil(lambda: "Repair the file" in pane.note)
    key = swatch.session.state.scope.palette
    assert swatch.library.item(key).state == "wrong"
    assert f"open {key}" in swatch.window.messages.shown()
    save_palette(Palette("Repaired"), path)
    pane.action_requested.emit("again")
    qtbot.waitUntil(lambda: swatch.library.item(key).state == "open")
    assert "empty" in pane.note
    assert f"open {key}" not in swatch.window.messages.shown()


def test_readings_of_an_unmeasured_paint_are_computed_in_the_background(swatch, qtbot, names) -> None:
    lobes = Entry(CookTorrancePaint("Lobes", (0.2, 0.1, 0.05)), id="lobes")
    swatch.session.edit("Add", lambda palette: replace(palette, entries=(*palette.entries, lobes)))
    place = swatch.session.palette.by_id["lobes"]
    qtbot.waitUntil(lambda: not swatch.session.shown[0].rows.columns.waiting.any())
    assert 0.0 < swatch.session.shown[0].rows.lab[place, 1, 0] < 100.0
    row = names(swatch).index("Lobes")
    assert swatch.window.panes[0].model.index(row, 3).data()


def test_unsaved_work_of_a_run_that_was_ended_is_offered_back(swatch, tmp_path, names) -> None:
    path = tmp_path / "kept.brdfpalette"
    save_palette(Palette("Kept"), path)
    key = swatch.library.add_palette(load_palette(path), path)
    swatch.session.show_scope(Scope(key))
    swatch.session.edit("Rename", lambda palette: replace(palette, name="Half done"))
    opened = swatch.library.item(key).palette
    # As a kill leaves it: written, and its lock free.
    opened.recovery.close(keep=True)
    swatch.library.remove_item(key)
    swatch.unsaved.close()
    swatch.unsaved = UnsavedWork(swatch.library)
    swatch.offer_recovery()
    assert "kept.brdfpalette" in swatch.window.messages.shown()["recovery"].what
    press(swatch, "recovery", "Recover")
    assert swatch.session.palette.name == "Half done"
    assert swatch.session.item.path == path
    assert not swatch.session.item.is_clean
    assert load_palette(path).name == "Kept"


def test_recovered_work_stays_where_its_file_is_still_being_read(swatch, tmp_path, qtbot) -> None:
    path = tmp_path / "kept.brdfpalette"
    save_palette(Palette("Kept"), path)
    key = swatch.library.add_path(path)
    gone_on: list[str] = []
    swatch.session.loader.load(key, lambda: gone_on.append(swatch.library.palette(key).name))
    assert swatch.library.item(key).state == "reading"
    work = Recovered(Palette("Half done"), path, datetime.now(), tmp_path / "gone.recovery.json")
    assert swatch.unsaved.recover(work) == key
    assert not swatch.library.tasks.busy
    assert gone_on == ["Half done"]
    opened = swatch.library.item(key).palette
    # An answer that was under way all the same.
    swatch.session.loader.accept(key, read_palette_file(path, lambda _share, _what: None))
    assert swatch.library.item(key).palette is opened
    assert swatch.library.palette(key).name == "Half done"
    assert not swatch.library.item(key).is_clean


def test_an_instruments_export_opens_as_a_palette(swatch, tmp_path: Path, qtbot) -> None:
    path = tmp_path / "export.xml"
    readings = "".join(
        f'<Reading Geometry="45as{angle}"><L>{60 - angle / 4}</L><a>1</a><b>-2</b></Reading>'
        for angle in (15, 25, 45, 75, 110)
    )
    path.write_text(f'<Export><Sample Name="Silver">{readings}</Sample></Export>', "utf-8")
    key = swatch.session.loader.ask_open(path)
    qtbot.waitUntil(lambda: swatch.library.item(key).palette is not None)
    (entry,) = swatch.library.palette(key).entries
    assert entry.name == "Silver"
    assert entry.content.lab_at(110.0) == (32.5, 1.0, -2.0)


@pytest.mark.parametrize("key", ["new", "shipped", "again"])
def test_an_empty_window_offers_what_to_do(swatch, qtbot, key: str) -> None:
    swatch.window.command("close").trigger()
    pane = swatch.window.panes[0]
    assert "Choose a palette" in pane.note
    if key == "again":
        return
    button = pane.findChild(QPushButton, f"note_{key}")
    button.click()
    assert swatch.session.palette.name in ("Untitled", "Sample Paints")
    assert ("empty" in pane.note) is (key == "new")


def test_the_library_remembers_its_files(swatch, tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / "one.brdfpalette"
    save_palette(Palette("One"), path)
    swatch.library.add_path(path)
    swatch.library.close(swatch.session.state.scope.palette)
    for item in swatch.library.items:
        swatch.library.remove_item(item.key)
    swatch.library.restore()
    assert [(item.path, item.state) for item in swatch.library.items] == [(path, "closed")]


def test_every_kind_of_material_is_added_or_opened(swatch, materials, qtbot) -> None:
    for kind, asked in materials.items():
        if kind == "palette of one":
            continue
        before = len(swatch.session.palette)
        swatch.open(asked)
        qtbot.waitUntil(lambda before=before: len(swatch.session.palette) > before)
    palettes = len(swatch.library.items)
    swatch.open(materials["palette of one"])
    qtbot.waitUntil(lambda: len(swatch.library.items) > palettes)


def test_the_paints_of_a_project_come_as_a_palette(swatch, names, tmp_path, qtbot) -> None:
    path = tmp_path / "spring.brdfproject"
    reds = tuple(solid_paint(name, (50.0, 40.0, 20.0)) for name in ("Red A", "Red B"))
    save_project(Project("Spring", reds), path)
    swatch.window.open_requested.emit(path)
    qtbot.waitUntil(lambda: swatch.session.palette is not None and swatch.session.palette.name == "Spring")
    assert names(swatch) == ["Red A", "Red B"]
    path.write_bytes(b"PK")
    swatch.window.open_requested.emit(path)
    qtbot.waitUntil(lambda: "project" in swatch.window.messages.shown())
    assert "damaged" in swatch.window.messages.shown()["project"].what

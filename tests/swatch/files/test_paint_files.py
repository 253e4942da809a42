"""Files of paints that are dropped or pasted: read off the window's thread, in order, one step, and cancelled."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from brdf_color_swatch.editing import paint_files
from brdf_color_swatch.grid.view_state import Scope
from PySide6.QtCore import QMimeData, QPoint, Qt, QUrl
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import load_any_paint, save_paint

NAMES = ("Zinc", "Alum", "Moss")


@pytest.fixture
def files(tmp_path) -> list[Path]:
    paths = [tmp_path / f"{name}.brdfpaint" for name in NAMES]
    for number, path in enumerate(paths):
        save_paint(solid_paint(path.stem, (40.0 + number, 0.0, 0.0)), path)
    return paths


@pytest.fixture(autouse=True)
def empty_clipboard() -> Iterator[None]:
    """The clipboard of the offscreen platform outlives the interpreter, and must hold nothing that Python made."""
    yield
    QGuiApplication.clipboard().clear()


def mime(paths: list[Path]) -> QMimeData:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    return data


@pytest.fixture
def slow(monkeypatch):
    """Hold up the reading of files of that name until ``go`` is set, as a disk does that hangs."""
    go = threading.Event()
    threads: list[int] = []

    def read(path):
        threads.append(threading.get_ident())
        if path.stem == "Alum":
            assert go.wait(60.0)
        return load_any_paint(path)

    monkeypatch.setattr(paint_files, "load_any_paint", read)
    yield go, threads
    go.set()


def wait_idle(swatch, qtbot) -> None:
    qtbot.waitUntil(lambda: swatch.session.reading.is_idle)


def test_pasted_files_come_in_their_order_as_one_step(swatch, files, names, command, slow, qtbot) -> None:
    go, threads = slow
    before, count = swatch.session.palette, len(names(swatch))
    go.set()
    QGuiApplication.clipboard().setMimeData(mime(files))
    command(swatch, "paste")
    wait_idle(swatch, qtbot)
    palette = swatch.session.palette
    assert [entry.name for entry in palette.entries[count:]] == list(NAMES)
    assert threading.get_ident() not in threads
    assert swatch.session.selected == tuple(entry.id for entry in palette.entries[count:])
    command(swatch, "undo")
    assert swatch.session.palette == before


def test_dropped_files_stand_where_they_fell(swatch, files, names, drop, qtbot) -> None:
    grid = swatch.window.panes[0].grid
    before = names(swatch)
    target = grid.visualRect(grid.model().index(1, 0))
    drop(grid.viewport(), QPoint(target.left() + 3, target.center().y()), mime(files))
    assert names(swatch) == before
    wait_idle(swatch, qtbot)
    assert names(swatch) == [before[0], *NAMES, *before[1:]]
    swatch.library.history.undo()
    assert names(swatch) == before


def test_the_palette_of_the_request_gets_them(swatch, files, names, command, slow, qtbot) -> None:
    go, _ = slow
    key, count = swatch.session.state.scope.palette, len(names(swatch))
    QGuiApplication.clipboard().setMimeData(mime(files))
    command(swatch, "paste")
    other = swatch.library.add_palette(Palette("Other"))
    swatch.session.show_scope(Scope(other))
    go.set()
    wait_idle(swatch, qtbot)
    assert names(swatch) == []
    assert [entry.name for entry in swatch.library.palette(key).entries[count:]] == list(NAMES)


def test_a_file_that_hangs_is_cancelled_and_the_others_open(
    swatch, files, names, command, slow, qtbot, tmp_path
) -> None:
    before = swatch.session.palette
    save_palette(
        Palette("More", (Entry(solid_paint("Sky", (60.0, 0.0, -20.0))),)), tmp_path / "more.brdfpalette"
    )
    QGuiApplication.clipboard().setMimeData(mime([*files, tmp_path / "more.brdfpalette"]))
    command(swatch, "paste")
    strip = swatch.window.progress
    qtbot.waitUntil(lambda: bool(strip.jobs))
    cancel = next(one for one in strip.findChildren(QPushButton) if one.isVisible())
    QTest.mouseClick(cancel, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: names(swatch) == ["Sky"])
    assert before in [item.palette.store.value for item in swatch.library.items if item.palette is not None]


def test_one_that_cannot_be_read_is_named_and_nothing_changes(swatch, files, command, qtbot) -> None:
    before = swatch.session.palette
    files[1].write_text("{}")
    QGuiApplication.clipboard().setMimeData(mime(files))
    command(swatch, "paste")
    wait_idle(swatch, qtbot)
    message = swatch.window.messages.shown()["edit"]
    assert "Alum.brdfpaint" in message.what + message.where
    assert swatch.session.palette == before


def test_the_nearest_to_a_paint_file_is_found(swatch, names, command, qtbot, tmp_path) -> None:
    path = tmp_path / "Navy.brdfpaint"
    save_paint(solid_paint("Navy", (30.0, 5.0, -40.0)), path)
    QGuiApplication.clipboard().setMimeData(mime([path]))
    command(swatch, "nearest_clipboard")
    wait_idle(swatch, qtbot)
    assert swatch.session.state.near.name == "Navy"
    assert names(swatch)[0] == "Blue"

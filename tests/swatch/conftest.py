"""A real Color Swatch with settings and a live link of its own, on Qt's offscreen platform."""

from __future__ import annotations

import os
import uuid
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from brdf_color_swatch.assembly import ColorSwatch
from brdf_color_swatch.export.dialog import Choice
from brdf_color_swatch.grid.view_state import Look, PaneState, Scope
from brdf_color_swatch.paint_exchange import PaintExchange
from brdf_qt.window.dialogs import Answer, Overwrite
from brdf_qt.work.pictures import Pictures
from PySide6.QtCore import QCoreApplication, QDeadlineTimer, QEvent, QMimeData, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest

from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.documents.palette import Entry, Palette

_HUB_MS = 120_000
"""It takes a moment; a machine where it takes this long has none."""

COLOURS = {
    "Red": ((60.0, 50.0, 30.0), "Warm", ("hot", "car")),
    "Orange": ((70.0, 30.0, 50.0), "Warm", ("hot",)),
    "Blue": ((30.0, 5.0, -40.0), "Cold", ("car",)),
    "Ice": ((80.0, -5.0, -10.0), "Cold", ()),
    "Silver": ((65.0, 0.0, 0.0), "", ("car",)),
    "Black": ((5.0, 0.0, 0.0), "", ()),
}


class ScriptedDialogs:
    """Gives scripted answers and records the questions."""

    def __init__(self) -> None:
        self.answer = Answer.DISCARD
        self.overwrite = Overwrite.CANCEL
        self.path: Path | None = None
        self.format = ""
        self.asked: list[str] = []

    def unsaved(self, name: str) -> Answer:
        self.asked.append(name)
        return self.answer

    def changed_file(self, path: Path) -> Overwrite:
        self.asked.append(f"changed {path.name}")
        return self.overwrite

    def open_path(self, folder: Path, filters: str) -> Path | None:
        self.asked.append(filters)
        return self.path

    def save_path(self, suggested: Path, filters: str) -> Path | None:
        self.asked.append(filters)
        return self.path

    def folder_path(self, title: str, folder: Path) -> Path | None:
        self.asked.append(title)
        return self.path

    def over(self, window: object) -> ScriptedDialogs:
        return self

    def export_path(
        self, suggested: Path, choices: Sequence[Choice], chosen: Choice
    ) -> tuple[Path, Choice] | None:
        self.asked.append(f"export {suggested.name}")
        if self.path is None:
            return None
        named = next(
            (one for one in choices if one.form is not None and one.form.name == self.format), chosen
        )
        return self.path, named


def paint(name: str, lab: tuple[float, float, float], flop: float = 10.0, gloss: float = 90.0) -> Paint:
    """Return a paint that is lighter by ``flop`` at the face, and darker by as much at the flop."""
    lightness, a, b = lab
    readings = ((15.0, lightness + flop), (45.0, lightness), (110.0, max(0.0, lightness - flop)))
    return Paint(
        name, tuple(Measurement(45.0, angle, (light, a, b)) for angle, light in readings), Gloss(gloss)
    )


def sample() -> Palette:
    """Return six paints in two groups and in none."""
    entries = tuple(
        Entry(
            paint(name, lab), id=name.lower(), group=(group,) if group else (), tags=tags, code=f"C{number}"
        )
        for number, (name, (lab, group, tags)) in enumerate(COLOURS.items())
    )
    return Palette("Sample", entries)


@pytest.fixture(autouse=True)
def own_session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No test touches a user's settings, or speaks with a program that is open."""
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")


@pytest.fixture(scope="module")
def lasting(qapp, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[ColorSwatch, ScriptedDialogs]]:
    """One program for a module, which :func:`swatch` clears for each test: a window takes a while to be made.

    Stand-ins are shown for pictures, which need a process.
    """
    dialogs = ScriptedDialogs()
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("BRDF_SUITE_SETTINGS", str(tmp_path_factory.mktemp("settings")))
        patched.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
        patched.setattr(Pictures, "request", lambda *_: None)
        program = ColorSwatch(dialogs=lambda _window: dialogs)
        program.window.resize(1200, 800)
        program.window.show()
        link = program.feature(PaintExchange).link
        deadline = QDeadlineTimer(_HUB_MS)
        while not link.is_hub:
            if deadline.hasExpired():
                program.close()
                pytest.fail(f"No live link was there {_HUB_MS // 1000} s after the program's start.")
            QTest.qWait(5)
        yield program, dialogs
        program.close()
        program.window.deleteLater()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def dialogs(lasting) -> ScriptedDialogs:
    """The scripted dialogs of the program."""
    return lasting[1]


@pytest.fixture
def swatch(lasting, own_session) -> ColorSwatch:
    """The program of the module as it is at a start, with the sample in front."""
    program, dialogs = lasting
    vars(dialogs).update(vars(ScriptedDialogs()))
    for item in program.library.items:
        program.library.close(item.key)
    program.controller.show_second(False)
    for pane in (1, 0):
        program.session.set_state(PaneState(), pane)
    program.session.set_look(**Look(size=64).to_json())
    for key in program.window.messages.shown():
        program.window.dismiss_message(key)
    dialogs.asked.clear()
    program.session.show_scope(Scope(program.library.add_palette(sample())))
    return program


@pytest.fixture
def names():
    """What a pane shows, by names."""

    def of(program: ColorSwatch, pane: int = 0) -> list[str]:
        model = program.window.panes[pane].model
        return [model.entry_at(row).name for row in range(model.rowCount())]

    return of


@pytest.fixture
def select():
    """Select swatches of a pane by their names."""

    def them(program: ColorSwatch, *wanted: str, pane: int = 0) -> None:
        shown = program.window.panes[pane]
        program.session.set_front(pane)
        rows = [row for row in range(shown.model.rowCount()) if shown.model.entry_at(row).name in wanted]
        shown.grid.select_rows(rows)

    return them


@pytest.fixture
def drop():
    """Drop data on a viewport at a point, as Qt delivers it."""

    def it(target, point, data: QMimeData, keys=Qt.KeyboardModifier.NoModifier) -> QDropEvent:
        actions, button = Qt.DropAction.MoveAction | Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton
        # Qt delivers a drop only to the widget that it has entered.
        QCoreApplication.sendEvent(target, QDragEnterEvent(point, actions, data, button, keys))
        event = QDropEvent(QPointF(point), actions, data, button, keys)
        QCoreApplication.sendEvent(target, event)
        return event

    return it


@pytest.fixture
def command():
    """Do a command by its key; it must be possible."""

    def it(program: ColorSwatch, key: str) -> None:
        action = program.window.command(key)
        assert action is not None
        assert action.isEnabled()
        action.trigger()

    return it

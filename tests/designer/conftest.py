"""A real Designer with settings and a live link of its own, on Qt's offscreen platform unless the caller sets one."""

from __future__ import annotations

import os
import uuid
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from brdf_designer.assembly import FIRST_PAINT, Designer
from brdf_qt.window.dialogs import Answer, Overwrite
from brdf_qt.work import pictures
from PySide6.QtCore import QCoreApplication, QEvent

from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint


class ScriptedDialogs:
    """Gives the answers that a test sets, and notes what was asked."""

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

    def folder_path(self, title: str, folder: Path) -> Path | None:
        self.asked.append(title)
        return self.path

    def over(self, window: object) -> ScriptedDialogs:
        return self

    def save_path(self, suggested: Path, filters: str) -> Path | None:
        return self.path


def open_drawers(designer: Designer) -> None:
    """Show curves, lobes, history and the numbers, which a first start has beyond the picture's edges or folded."""
    designer.window.editors.numbers.set_open(True)
    for drawer in designer.window.stage.drawers.values():
        drawer.set_open(True)


@pytest.fixture(autouse=True)
def own_session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """No test touches a user's settings, or speaks with a program that is open."""
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
    return tmp_path / "settings"


@pytest.fixture(autouse=True)
def exact_fits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fits are exact at once, however busy the machine is; the tests of the time limit set one of their own."""
    monkeypatch.setitem(PaintFitter.__init__.__kwdefaults__, "time_limit_s", 60.0)


@pytest.fixture
def dialogs() -> ScriptedDialogs:
    return ScriptedDialogs()


@pytest.fixture
def own_designer(qtbot, dialogs, monkeypatch) -> Designer:
    """Designer, shown, with its plot there; placeholders stand for the small pictures, which need a process."""
    monkeypatch.setattr(pictures, "child_command", lambda _module: [])
    designer = Designer(dialogs=lambda _window: dialogs)
    qtbot.addWidget(designer.window)
    designer.window.show()
    open_drawers(designer)
    qtbot.waitUntil(lambda: designer.window.plot.is_built)
    yield designer
    designer.close()


@pytest.fixture
def designer(own_designer) -> Designer:
    """The same; a module whose tests need no Designer of their own puts :func:`program` in its place."""
    return own_designer


@pytest.fixture(scope="module")
def lasting(qapp, tmp_path_factory):
    """One Designer for a whole module, which :func:`fresh` clears for each test: a window takes a while to be made."""
    dialogs = ScriptedDialogs()
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("BRDF_SUITE_SETTINGS", str(tmp_path_factory.mktemp("settings")))
        patched.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
        patched.setitem(PaintFitter.__init__.__kwdefaults__, "time_limit_s", 60.0)
        patched.setattr(pictures, "child_command", lambda _module: [])
        designer = Designer(dialogs=lambda _window: dialogs)
        designer.window.show()
        open_drawers(designer)
        while not designer.window.plot.is_built:
            QCoreApplication.processEvents()
    yield designer, dialogs
    designer.close()
    designer.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def fresh(lasting, own_session):
    """The Designer of the module as it is at a start: its first paint alone, no message, nothing that was asked."""
    designer, dialogs = lasting
    documents = designer.documents
    vars(dialogs).update(vars(ScriptedDialogs()), answer=Answer.DISCARD)
    first = documents.add(load_shipped_paint(FIRST_PAINT))
    for document in documents.row:
        if document is not first:
            documents.close(document)
    vars(dialogs).update(vars(ScriptedDialogs()))
    first.pristine = True
    designer.window.panel.show_page("paint")
    for key in designer.window.messages.shown():
        designer.window.dismiss_message(key)
    return designer, dialogs


@pytest.fixture
def program(fresh, qtbot) -> Designer:
    """The Designer of the module at its first paint, with strip and curves there."""
    designer, _ = fresh
    qtbot.waitUntil(lambda: designer.controller.is_idle)
    return designer


@pytest.fixture(scope="session")
def simulated(tmp_path_factory) -> Path:
    """A folder with photographs of a painted sphere, 96 pixels, 8 positions of the lamp × 5; not to be changed."""
    from brdf_suite.acquisition.simulator import SimulatorSettings, simulate
    from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
    from brdf_suite.reflectance.designed.build import build_reflectance

    paint = CookTorrancePaint("Test", (0.2, 0.15, 0.1), (CookTorranceLobe((0.3, 0.3, 0.3), 0.2, 0.3),))
    angles = (20.0, 37.0, 54.0, 71.0, 88.0, 105.0, 122.0, 140.0)
    rig = SimulatorSettings(
        size=(96, 96), angles_deg=angles, exposures=5, shortest_s=0.002, board=False, white=False
    )
    folder = tmp_path_factory.mktemp("session") / "photographs"
    simulate(build_reflectance(paint), folder, rig, "Test")
    return folder


@pytest.fixture
def asked(fresh) -> ScriptedDialogs:
    """What its questions for files are answered with."""
    return fresh[1]

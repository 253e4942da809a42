"""A real Lobe Visualizer with settings and a live link of its own, on Qt's offscreen platform by default.

Views in three dimensions need OpenGL and are tested elsewhere; here the window is made without them.
"""

from __future__ import annotations

import contextlib
import os
import uuid
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from brdf_lobe_visualizer.assembly import LobeVisualizer
from brdf_lobe_visualizer.cuts.panel import CURVES, POLAR, Slices
from brdf_lobe_visualizer.factor_maps.part import Factors
from brdf_lobe_visualizer.lobe_basis.part import Basis
from brdf_lobe_visualizer.subjects.fits import Fits
from PySide6.QtCore import QCoreApplication, QEvent


@pytest.fixture(autouse=True)
def own_session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """No test touches a user's settings, or speaks with a program that is open."""
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
    return tmp_path / "settings"


class Asked:
    """Answers the questions for files as set."""

    def __init__(self) -> None:
        self.files: list[str] = []
        self.path: Path | None = None


@pytest.fixture(scope="module")
def lasting(qapp, tmp_path_factory):
    """One window for a whole module, without views; :func:`program` empties it for each test."""
    asked = Asked()
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("BRDF_SUITE_SETTINGS", str(tmp_path_factory.mktemp("settings")))
        patched.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
        program = LobeVisualizer(
            (), ask_files=lambda *_of: asked.files, ask_path=lambda _suggested: asked.path
        )
        program.window.resize(1000, 700)
        program.window.show()
    yield program, asked
    program.close()
    program.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def asked(lasting) -> Asked:
    """What the next question for a file is answered with."""
    vars(lasting[1]).update(vars(Asked()))
    return lasting[1]


@pytest.fixture
def program(lasting, asked) -> LobeVisualizer:
    """The program with nothing in its session, all options at their defaults and no message."""
    program, _ = lasting
    program.session.set_subjects(())
    program.session.show_all()
    program.session.reset_options()
    program.session.reset_incidence()
    program.numbers.dock.hide()
    program.window.plots.set_shown("albedo", False, remember=False)
    for key in list(program.window.messages.shown()):
        program.window.dismiss_message(key)
    return program


@pytest.fixture
def opened(program, qtbot):
    """Open names or files one after another, and wait for them and all that follows."""

    def open_and_wait(*names: str | Path) -> LobeVisualizer:
        for name in names:
            with qtbot.waitSignal(program.sources.idle, timeout=60_000):
                program.sources.open(name)
        qtbot.waitUntil(lambda: program.is_idle, timeout=60_000)
        return program

    return open_and_wait


@contextlib.contextmanager
def window_with(part, size, tmp_path_factory):
    """One window with one part alone, of a module's settings and link."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("BRDF_SUITE_SETTINGS", str(tmp_path_factory.mktemp("settings")))
        patched.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
        # Fits come as the tests give them.
        patched.setattr(Fits, "_look", lambda _self: None)
        program = LobeVisualizer((part,))
        program.window.resize(*size)
        program.window.show()
        yield program
        program.close()
        program.window.deleteLater()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture(scope="module")
def window_with_slices(qapp, tmp_path_factory):
    """One window for a whole module with the slices alone; ``slices`` empties it for each test."""
    with window_with(Slices, (1300, 800), tmp_path_factory) as program:
        yield program


@pytest.fixture(scope="module")
def window_with_basis(qapp, tmp_path_factory):
    """The same with the basis alone."""
    with window_with(Basis, (1100, 700), tmp_path_factory) as program:
        yield program


@pytest.fixture(scope="module")
def window_with_factors(qapp, tmp_path_factory):
    """The same with the maps of factors alone."""
    with window_with(Factors, (1100, 700), tmp_path_factory) as program:
        yield program


@pytest.fixture
def slices(window_with_slices, qtbot) -> Slices:
    """The part that shows slices, with its polar plot and its curves, all options at their defaults."""
    program = window_with_slices
    part = program.feature(Slices)
    qtbot.waitUntil(lambda: part.polar.plot is not None)
    program.session.set_subjects(())
    program.session.show_all()
    program.session.reset_options()
    program.session.reset_incidence()
    part.state.reset()
    for key in program.window.plots.plots:
        program.window.plots.set_shown(key, key in (POLAR, CURVES))
    return part

"""Lobes in three dimensions in a real window, with OpenGL on an X server of its own; one window a module."""

from __future__ import annotations

import importlib.util
import uuid
from pathlib import Path

import pytest
from brdf_lobe_visualizer.assembly import LobeVisualizer
from brdf_lobe_visualizer.view3d.panel import Space
from PySide6.QtCore import QCoreApplication, QEvent

_FILE = Path(__file__).parent.parent / "qt_gl" / "xvfb.py"
_spec = importlib.util.spec_from_file_location("xvfb", _FILE)
xvfb = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(xvfb)


@pytest.fixture(scope="session", autouse=True)
def screen() -> None:
    """The display on which this session's widgets are shown."""
    xvfb.use_screen()


@pytest.fixture(autouse=True)
def own_session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No test touches a user's settings, or speaks with a program that is open."""
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")


@pytest.fixture(scope="module")
def lasting(screen, qapp, tmp_path_factory):
    """One window for a whole module, with the view in three dimensions and nothing else."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("BRDF_SUITE_SETTINGS", str(tmp_path_factory.mktemp("settings")))
        patched.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
        program = LobeVisualizer((Space,))
        program.window.resize(900, 640)
        program.window.show()
    yield program
    program.close()
    program.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def program(lasting, qtbot):
    """The program with nothing in its session and all options at their defaults, its view there."""
    program, space = lasting, lasting.feature(Space)
    qtbot.waitUntil(lambda: space.view is not None and space.view.isValid())
    program.session.set_subjects(())
    program.session.show_all()
    program.session.reset_options()
    program.session.reset_incidence()
    space.state.reset()
    space.sweep.set_running(False)
    space.frame()
    space.go_to("plane")
    qtbot.waitUntil(
        lambda: not program.session.tasks.busy
    )  # figures of a subject that has gone may still be reported
    for key in list(program.window.messages.shown()):
        program.window.dismiss_message(key)
    QCoreApplication.processEvents()  # messages took room from the view
    return program


@pytest.fixture
def space(program):
    """The part that shows lobes."""
    return program.feature(Space)

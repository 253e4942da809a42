"""What a kill -9 leaves of the Viewer: its view with the undo history, its paint, and a studio with its own history."""

from __future__ import annotations

import signal
import subprocess
import sys

import pytest
from brdf_qt.program.settings import state_folder
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QWidget

pytestmark = pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system has no kill -9")

RUN = """
import dataclasses, os, signal, sys
from pathlib import Path
from brdf_qt.program.application import create_application
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle
from brdf_viewer.controller import ViewerController
from PySide6.QtCore import QCoreApplication
from PySide6.QtTest import QTest

name, light, studio = sys.argv[1:]
app = create_application("Viewer")
QCoreApplication.setApplicationName(name)
view = View(environment=light, surface="sphere", sparkle=Sparkle(mode="off"))
viewer = ViewerController(view, "blue", follow=False)
viewer.window.picture.setMaximumSize(200, 160)
viewer.window.show()
while not viewer.state.is_complete:
    QTest.qWait(10)
viewer.paint.open("red")
viewer.state.step_view(exposure_ev=1.5)
viewer.state.step_view(camera=Camera(azimuth_deg=200.0))
viewer.state.step_view(exposure_ev=-1.0)
viewer.undo()
if studio == "studio":
    store = viewer.studio.store
    assert viewer.studio.new("empty")
    for number in (1, 2):
        store.set(dataclasses.replace(store.value, name=f"Name {number}"), "Rename")
    store.undo()
    while not viewer.studio.recovery.file.exists():
        QTest.qWait(20)
while not viewer.recovered.recovery.file.exists():
    QTest.qWait(20)
QTest.qWait(1500)
os.kill(os.getpid(), signal.SIGKILL)
"""


def kill(light, *, studio: bool) -> None:
    words = [QCoreApplication.applicationName(), str(light), "studio" if studio else "none"]
    done = subprocess.run(
        [sys.executable, "-c", RUN, *words], capture_output=True, text=True, check=False, timeout=300
    )
    assert done.returncode == -signal.SIGKILL, done.stderr


def recover(viewer, qtbot) -> None:
    button = viewer.window.findChild(QWidget, "message_action_Recover")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_view_history_and_paint_come_back(start, lights, qtbot) -> None:
    kill(lights["bright"], studio=False)
    viewer = start(follow=False)
    first = viewer.view
    assert "view, paint and history" in viewer.messages()["recovery"]
    assert viewer.state.history.steps == 0
    recover(viewer, qtbot)
    qtbot.waitUntil(lambda: viewer.state.environment.key == str(lights["bright"]))
    assert viewer.view.environment == str(lights["bright"]) != first.environment
    assert (viewer.view.exposure_ev, viewer.view.camera.azimuth_deg) == (1.5, 200.0)
    assert viewer.state.paint_key == "red"
    assert viewer.state.history.redo_text == "Change Exposure"
    viewer.controller.undo()
    viewer.controller.undo()
    assert (viewer.view.exposure_ev, viewer.view.camera) == (0.0, first.camera)
    assert not viewer.state.history.stack.canUndo()
    for _ in range(3):
        viewer.state.history.redo()
    assert viewer.view.exposure_ev == -1.0
    viewer.close()
    # The user has closed the window: nothing is offered to the next one.
    assert not list(state_folder("autosave_views").glob("*.json"))


def test_a_studio_comes_back_with_its_history_over_the_view(start, lights, tmp_path, qtbot) -> None:
    kill(lights["bright"], studio=True)
    viewer = start(follow=False)
    assert "Name 1" in viewer.messages()["recovery"]
    recover(viewer, qtbot)
    control = viewer.controller.studio
    qtbot.waitUntil(lambda: viewer.window.studio_dock.isVisible() and control.is_lit())
    assert viewer.view.environment == str(lights["bright"])
    assert viewer.view.exposure_ev == 1.5
    store = control.store
    assert (store.value.name, store.stack.undoText(), store.stack.redoText()) == (
        "Name 1",
        "Rename",
        "Rename",
    )
    store.undo()
    assert store.value.name == "My studio"
    store.redo()
    store.redo()
    assert store.value.name == "Name 2"
    assert control.files.save_to(tmp_path / "name.brdfstudio")  # so that the window closes without a question


def test_discarded_work_is_not_offered_again(start, lights, qtbot) -> None:
    kill(lights["bright"], studio=False)
    viewer = start(follow=False)
    button = viewer.window.findChild(QWidget, "message_action_Discard")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert "recovery" not in viewer.messages()
    assert viewer.state.history.steps == 0
    viewer.close()
    assert start(follow=False).messages() == {}

"""What a kill -9 leaves of Lobe Visualizer: the reflectances that were open, in their order, and the one in front."""

from __future__ import annotations

import signal
import subprocess
import sys

import pytest
from brdf_lobe_visualizer.assembly import LobeVisualizer
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.pipeline.material import default_paint_name

pytestmark = pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system has no kill -9")

RUN = """
import os, signal, sys
from brdf_lobe_visualizer.assembly import LobeVisualizer
from brdf_qt.program.application import create_application
from PySide6.QtTest import QTest

app = create_application("Lobe Visualizer")
program = LobeVisualizer(())
program.start_when_painted()
program.window.show()
asked = sys.argv[1:]
while not program.session.subjects:
    QTest.qWait(20)
for number, one in enumerate(asked, 2):
    program.sources.open(one)
    while len(program.session.subjects) < number:
        QTest.qWait(20)
if len(asked) > 1:
    program.session.remove(program.session.subjects[0].key)
    program.session.set_front(program.session.subjects[0].key)
QTest.qWait(1000)
assert program.reopening.record.file.exists()
os.kill(os.getpid(), signal.SIGKILL)
"""


def kill(*asked: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", RUN, *asked], capture_output=True, text=True, check=False, timeout=240
    )
    assert done.returncode == -signal.SIGKILL, done.stderr


@pytest.fixture
def start(monkeypatch):
    """Start the program after a kill; it has no views."""
    monkeypatch.setattr(
        "brdf_qt.program.settings.QCoreApplication.applicationName", lambda: "Lobe Visualizer"
    )
    started = []

    def one() -> LobeVisualizer:
        program = LobeVisualizer(())
        program.start_when_painted()
        program.window.show()
        started.append(program)
        return program

    yield one
    for program in started:
        program.window.close()
        program.close()
        program.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def origins(program: LobeVisualizer) -> list[str]:
    return [subject.material.origin for subject in program.session.subjects]


def test_the_reflectances_come_back_in_their_order(start, tmp_path, qtbot) -> None:
    path = tmp_path / "two.brdfpalette"
    save_palette(Palette("Two", (Entry(solid_paint("Swatch", (50.0, 20.0, 0.0)), id="s"),)), path)
    entry = f"{path}#s"
    kill("red", entry, "lambertian")
    program = start()
    qtbot.waitUntil(lambda: "recovery" in program.window.messages.shown())
    assert "“Red”, “two.brdfpalette”, “Lambertian”" in program.window.messages.shown()["recovery"].what
    button = program.window.messages.findChild(QWidget, "message_action_Reopen")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: origins(program) == ["red", entry, "lambertian"])
    qtbot.waitUntil(lambda: program.session.front is not None and program.session.front.title == "Red")
    # An ordinary end leaves nothing to be offered.
    qtbot.waitUntil(lambda: program.is_idle)
    program.window.close()
    assert not list(tmp_path.rglob("*.tabs.json"))


def test_an_empty_start_is_no_work(start, qtbot) -> None:
    kill()
    program = start()
    qtbot.waitUntil(lambda: origins(program) == [default_paint_name()])
    assert "recovery" not in program.window.messages.shown()

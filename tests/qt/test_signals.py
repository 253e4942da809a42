"""Start and end of programs: signals before and after the event loop, threads, a scale that no window can have."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

_PROGRAM = """
import os, signal, sys
from brdf_qt.program.application import create_application
from PySide6.QtWidgets import QWidget
app = create_application("Signals", ["signals"], theme_name="dark")
os.kill(os.getpid(), signal.SIGTERM)
window = QWidget()
window.show()
sys.exit(app.exec())
"""


_SCALED = """
import sys
from brdf_qt.program.application import create_application
from PySide6.QtWidgets import QMainWindow
app = create_application("Scale", ["scale"], theme_name="dark")
window = QMainWindow()
window.show()
print(window.devicePixelRatioF())
"""


@pytest.mark.parametrize("scale", ["-3", "0", "nan", "1e9", "nonsense"])
def test_a_scale_that_no_window_can_have_is_ignored(scale: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", _SCALED],
        env={**os.environ, "QT_SCALE_FACTOR": scale},
        capture_output=True,
        text=True,
        timeout=240,
        check=True,
    )
    assert done.stdout == "1.0\n"
    assert f"QT_SCALE_FACTOR is '{scale}', which is no scale" in done.stderr


def test_a_signal_before_the_event_loop_is_not_lost():
    done = subprocess.run([sys.executable, "-c", _PROGRAM], timeout=240, check=False)
    assert done.returncode == 0


_AFTER = """
import atexit, os, signal, sys
def interrupt():
    for number in (signal.SIGINT, signal.SIGTERM):
        os.kill(os.getpid(), number)
    print("ended")
atexit.register(interrupt)  # before PySide is imported: the application object is destroyed before it
from brdf_qt.program.application import create_application
from PySide6.QtCore import QTimer
app = create_application("Signals", ["signals"], theme_name="dark")
QTimer.singleShot(0, app.quit)
sys.exit(app.exec())
"""


def test_signals_that_come_when_the_application_has_gone_are_ignored():
    done = subprocess.run(
        [sys.executable, "-c", _AFTER], capture_output=True, text=True, timeout=240, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "ended\n", "")


_WORKING = """
import atexit, sys, threading
from PySide6.QtCore import QTimer
from brdf_qt.program.application import create_application
from brdf_qt.work.tasks import TaskRunner

begun, ended = threading.Event(), threading.Event()
atexit.register(lambda: print("ended" if ended.is_set() else "runs"))  # after what the application registers

def work(request, progress):
    begun.set()
    try:
        while True:
            progress(0.0, "")
    finally:
        ended.set()

app = create_application("Work", ["work"], theme_name="dark")
runner = TaskRunner()
runner.submit("key", work, None, print, print)
begun.wait()
QTimer.singleShot(0, app.quit)
sys.exit(app.exec())
"""


def test_work_ends_before_the_application_is_destroyed():
    """A thread that reports its progress meanwhile can hold the process up for ever."""
    done = subprocess.run(
        [sys.executable, "-c", _WORKING], capture_output=True, text=True, timeout=240, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "ended\n", "")

"""Start and end of programs: signals before and after the event loop, threads, a scale that no window can have."""

from __future__ import annotations

import os
import signal
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
import os, signal, sys
from PySide6.QtCore import QTimer
from brdf_qt.program.application import create_application, end_application
app = create_application("Signals", ["signals"], theme_name="dark")
QTimer.singleShot(0, app.quit)
status = end_application(app.exec())
print(status, flush=True)
os.kill(os.getpid(), getattr(signal, sys.argv[1]))
"""


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_a_signal_after_the_event_loop_ends_the_process_in_silence(name: str):
    """A handler would use an application object that may be destroyed by then."""
    done = subprocess.run(
        [sys.executable, "-c", _AFTER, name], capture_output=True, text=True, timeout=240, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (-getattr(signal, name), "0\n", "")


_WORKING = """
import sys, threading, time
from PySide6.QtCore import QTimer
from brdf_qt.program import application
from brdf_qt.work.tasks import TaskRunner

begun, ended = threading.Event(), threading.Event()

def work(request, progress):
    begun.set()
    try:
        while True:
            progress(0.0, "")
    finally:
        ended.set()

def hang(request, progress):
    begun.set()
    while True:
        time.sleep(1.0)

app = application.create_application("Work", ["work"], theme_name="dark")
runner = TaskRunner()
runner.submit("key", work if sys.argv[1] == "work" else hang, None, print, print)
begun.wait()
QTimer.singleShot(0, lambda: app.exit(3))
status = application.end_application(app.exec(), int(sys.argv[2]))
print(ended.is_set())
sys.exit(status)
"""


@pytest.mark.parametrize(("work", "patience", "printed"), [("work", "200000", "True\n"), ("hang", "300", "")])
def test_work_ends_before_the_application_is_destroyed_or_with_the_process(
    work: str, patience: str, printed: str
):
    """A thread that reports its progress meanwhile can hold the process up for ever."""
    done = subprocess.run(
        [sys.executable, "-c", _WORKING, work, patience],
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (3, printed, "")


def test_a_program_without_standard_output_ends_too():
    command = ["sh", "-c", 'exec "$@" >&-', "sh", sys.executable, "-c", _WORKING, "hang", "300"]
    assert subprocess.run(command, timeout=240, check=False).returncode == 3

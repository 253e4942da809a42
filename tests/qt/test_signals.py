"""Starts of programs: signals that come before the event loop runs, and a scale that no window can have."""

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

"""Signals that come before the event loop runs."""

from __future__ import annotations

import subprocess
import sys

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


def test_a_signal_before_the_event_loop_is_not_lost():
    done = subprocess.run([sys.executable, "-c", _PROGRAM], timeout=240, check=False)
    assert done.returncode == 0

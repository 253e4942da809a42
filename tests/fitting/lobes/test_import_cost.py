"""The room is on a program's start-up path: what is heavy is imported when a fitter is made."""

from __future__ import annotations

import subprocess
import sys


def test_importing_the_room_loads_no_solver() -> None:
    code = (
        "import sys, brdf_suite.fitting; heavy = "
        "('highspy', 'concurrent.futures', 'scipy.optimize', 'moderngl', 'PySide6'); "
        "print([m for m in heavy if m in sys.modules])"
    )
    answer = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=240
    )
    assert answer.stdout.strip() == "[]"

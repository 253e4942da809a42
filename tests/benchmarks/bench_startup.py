"""From the start of a program's process to its first painted, usable window.

Designer runs on Qt's offscreen platform, so that the figure is the program's own and no X server's.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from statistics import median

NAME = "startup"
BOUNDS = {"designer_ready_s": ("<=", 2.0, "s", "Designer: process start to a usable window, median of 5")}
RUNS = 5


def run(progress=None):
    from brdf_suite.progress import report

    times = []
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, "-m", "brdf_designer", "--report-startup", "--quit-after", "0"]
    for index in range(RUNS + 1):
        report(progress, index / (RUNS + 1), "starting Designer")
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, check=True, timeout=60
        )
        times.append(json.loads(done.stdout.splitlines()[-1])["ready_s"])
    return {"designer_ready_s": median(times[1:])}  # the first fills the system's file cache

"""Time from process start to the first painted, usable window.

Qt's offscreen platform excludes the X server from the figure.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from statistics import median

NAME = "startup"
BOUNDS = {
    "designer_ready_s": ("<=", 2.0, "s", "Designer: process start to a usable window, median of 5"),
    "lobes_ready_s": ("<=", 2.0, "s", "Lobe Visualizer: the same"),
}
PROGRAMS = {"designer_ready_s": "brdf_designer", "lobes_ready_s": "brdf_lobe_visualizer"}
RUNS = 5


def run(progress=None):
    from brdf_suite.progress import report

    found = {}
    for place, (figure, package) in enumerate(PROGRAMS.items()):
        report(progress, place / len(PROGRAMS), f"starting {package}")
        found[figure] = _ready_s(package)
    return found


def _ready_s(package):
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, "-m", package, "--report-startup", "--quit-after", "0"]
    times = []
    for _ in range(RUNS + 1):
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, check=True, timeout=60
        )
        times.append(json.loads(done.stdout.splitlines()[-1])["ready_s"])
    return median(times[1:])  # the first fills the system's file cache

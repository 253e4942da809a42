"""Time from process start to the start page and to the first painted, usable window; and from a paint to its picture.

Qt's offscreen platform excludes the X server from the figures of starts. The picture is drawn on a virtual screen.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from statistics import median

from brdf_suite.cli.tools.bench import load_module

NAME = "startup"
BOUNDS = {
    "start_page_ms": ("<=", 1000.0, "ms", "Designer: process start to the painted start page, median of 5"),
    "gallery_picture_ms": (
        "<=",
        1500.0,
        "ms",
        "click on a paint of the start page to its first picture, 1280 x 720, after the start, median of 3",
    ),
    "viewer_strip_picture_ms": (
        "<=",
        1500.0,
        "ms",
        "Viewer: click on a paint of the paint strip to its first picture, 1280 x 720, after the start, median of 3",
    ),
    "designer_strip_picture_ms": ("<=", 1500.0, "ms", "Designer: the same"),
    "designer_ready_s": ("<=", 2.0, "s", "Designer: process start to a usable window, median of 5"),
    "lobes_ready_s": ("<=", 2.0, "s", "Lobe Visualizer: the same"),
}
PROGRAMS = {"designer_ready_s": "brdf_designer", "lobes_ready_s": "brdf_lobe_visualizer"}
RUNS = 5


def run(progress=None):
    from brdf_suite.progress import report

    report(progress, 0.0, "starting with the start page")
    found = {"start_page_ms": 1e3 * _seconds("brdf_designer", "start_page_s", "--start-page")}
    report(progress, 0.2, "opening paints of the start page")
    found["gallery_picture_ms"] = _picture_ms("gallery_click.py")
    report(progress, 0.3, "choosing paints of the paint strip")
    found["viewer_strip_picture_ms"] = _picture_ms("strip_click.py", "viewer")
    found["designer_strip_picture_ms"] = _picture_ms("strip_click.py", "designer")
    for place, (figure, package) in enumerate(PROGRAMS.items()):
        report(progress, 0.4 + 0.6 * place / len(PROGRAMS), f"starting {package}")
        found[figure] = _seconds(package, "ready_s")
    return found


def _picture_ms(script, *arguments):
    screenshots = load_module(Path(__file__).parents[2] / "packaging" / "screenshots" / "screenshots.py")
    path = Path(__file__).parent / "parts" / "start" / script
    with screenshots.virtual_screen() as display:
        environment = {**os.environ, "DISPLAY": display, "QT_QPA_PLATFORM": "xcb"}
        done = subprocess.run(
            [sys.executable, str(path), *arguments],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
            timeout=600,
        )
    return median(json.loads(done.stdout.splitlines()[-1]))


def _seconds(package, name, *options):
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, "-m", package, "--report-startup", "--quit-after", "0", *options]
    times = []
    for _ in range(RUNS + 1):
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, check=True, timeout=60
        )
        times.append(json.loads(done.stdout.splitlines()[-1])[name])
    return median(times[1:])  # the first fills the system's file cache

"""From the wish to open a MERL table of 35 MB to its picture in the real program: a part of ``bench lobes``."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

RUNS = 5

BOUNDS = {
    "table_open_s": (
        "<=",
        1.0,
        "s",
        "35 MB table, from the request to all views painted, whole program, median of 5",
    ),
    "table_read_s": ("", None, "s", "the part until the table is loaded"),
    "table_open_cpu_s": ("", None, "s", "processor time of all threads until that picture"),
    "table_all_s": (
        "",
        None,
        "s",
        "the same until every view is idle, with lobes fitted to the table",
    ),
    "paint_open_s": ("", None, "s", "a shipped paint, likewise, in the same run"),
    "table_open_offscreen": (
        "",
        None,
        "",
        "1 without a screen, when the 3-D view is omitted",
    ),
}


def run(progress=None):
    from brdf_suite.files.measured import write_measured
    from brdf_suite.progress import report
    from brdf_suite.reflectance.registry import MODELS

    report(progress, 0.0, "writing a table of 35 MB")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "polaris.binary"
        write_measured(MODELS["cook_torrance"].default, path)
        report(progress, 0.3, "opening it in the program")
        done = subprocess.run(
            [sys.executable, str(Path(__file__).parent / "lobes_open_program.py"), str(path), str(RUNS)],
            env=_environment(),
            capture_output=True,
            text=True,
            check=True,
            timeout=600,
        )
    found = json.loads(done.stdout.splitlines()[-1])
    # The first of a kind pays for imports that the user pays once as well; the median is of all.
    return {
        "table_open_s": median(found["shown_s"]),
        "table_read_s": median(found["read_s"]),
        "table_open_cpu_s": median(found["cpu_s"]),
        "table_all_s": median(found["all_s"]),
        "paint_open_s": median(found["paint_s"]),
        "table_open_offscreen": int(found["platform"] == "offscreen"),
    }


def _environment():
    screen = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    platform = {} if screen or sys.platform in ("darwin", "win32") else {"QT_QPA_PLATFORM": "offscreen"}
    return {**os.environ, **platform}

"""Time from a slider's mouse event to painted numbers and target colours in Designer, and to what the fit gives.

A drag of 600 steps in the real window with all parts, in a separate process on Qt's offscreen platform. The first 30
steps, which fill caches, are excluded. Slow work runs at idle; its longest pieces are listed.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from statistics import median

import numpy as np

NAME = "designer"
BOUNDS = {
    "picture_share": (
        ">=",
        0.55,
        "",
        "share of the window's area that the picture has at 1920 x 1080 as it starts, drawers that are open taken off",
    ),
    "update_median_ms": (
        "<=",
        5.0,
        "ms",
        "slider event to painted numbers and target colours, median of a drag",
    ),
    "update_p99_ms": ("<=", 12.0, "ms", "the same, 99th percentile"),
    "update_cpu_median_ms": ("", None, "ms", "its processor time on the window's thread, median"),
    "update_cpu_p99_ms": ("", None, "ms", "the same, 99th percentile"),
    "followed_median_ms": (
        "",
        None,
        "ms",
        "slider event until strip, curves and what the fit gives in patches and status bar are also painted, median",
    ),
    "followed_p99_ms": ("", None, "ms", "the same, 99th percentile"),
    "followed_cpu_median_ms": ("", None, "ms", "its processor time on the window's thread, median"),
    "values_median_ms": ("", None, "ms", "the part until all values are set, before painting"),
    "idle_median_ms": ("", None, "ms", "one piece of the idle work"),
    "idle_max_ms": ("", None, "ms", "the longest piece: the delay of an event at that moment"),
}
NOTES = {
    "update_median_ms": "the fit, strip and curves follow in the next turn of the event loop: followed_median_ms",
    "update_p99_ms": "without drawing the picture, which this platform cannot; a slow frame waits for a rest",
}
_WARM_UP = 30


def run(progress=None):
    from brdf_suite.progress import report

    report(progress, 0.1, "dragging a slider of Designer")
    script = Path(__file__).parent / "parts" / "designer_drag.py"
    done = subprocess.run(
        [sys.executable, str(script)], capture_output=True, text=True, check=True, timeout=300
    )
    times = json.loads(done.stdout.splitlines()[-1])
    names = ("update", "cpu", "values", "followed", "followed_cpu")
    update, cpu, values, followed, followed_cpu = (times[name][_WARM_UP:] for name in names)
    return {
        "picture_share": times["picture_share"],
        "update_median_ms": median(update),
        "update_p99_ms": float(np.percentile(update, 99)),
        "update_cpu_median_ms": median(cpu),
        "update_cpu_p99_ms": float(np.percentile(cpu, 99)),
        "followed_median_ms": median(followed),
        "followed_p99_ms": float(np.percentile(followed, 99)),
        "followed_cpu_median_ms": median(followed_cpu),
        "values_median_ms": median(values),
        "idle_median_ms": median(times["idle"]),
        "idle_max_ms": max(times["idle"]),
    }

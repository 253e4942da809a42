"""Color Swatch with ten thousand paints: opening, scrolling, searching, memory, and picture rate.

The real window runs in a separate process on Qt's offscreen platform without cached pictures; they arrive while it is
scrolled. The picture rate is that of the painter alone: key, fit, shading, read-back.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

NAME = "palette"
BOUNDS = {
    "open_10k_s": ("<=", 1.0, "s", "a file of 10,000 paints: request to first swatches painted"),
    "scroll_median_ms": (
        "<=",
        16.0,
        "ms",
        "a notch of the wheel to the grid painted, pictures arriving, median",
    ),
    "scroll_p99_ms": ("<=", 33.0, "ms", "the same, 99th percentile"),
    "nearest_ms": (
        "<=",
        30.0,
        "ms",
        "the nearest 20 of 10,000 by ΔE00 at 15, 45 and 110°, median of 40 paints",
    ),
    "memory_mb": (
        "<=",
        500.0,
        "MB",
        "window with 10,000 paints and drawing process, after scrolling; shared pages counted once",
    ),
    "thumbnails_per_s": (">=", 60.0, "1/s", "spheres of 96×96, 4 samples, with each paint's fit"),
    "thumbnail_cpu_ms": (
        "",
        None,
        "ms",
        "processor time of one picture, independent of machine load",
    ),
    "panels_per_s": ("", None, "1/s", "the same on the curved panel"),
    "strips_per_s": ("", None, "1/s", "flop strips of 96×96"),
    "scroll_cpu_median_ms": (
        "",
        None,
        "ms",
        "processor time of a notch on the window's thread, median",
    ),
    "scroll_cpu_p99_ms": ("", None, "ms", "the same, 99th percentile"),
    "first_picture_s": (
        "",
        None,
        "s",
        "request to the first picture drawn, empty cache, including process start",
    ),
    "first_page_s": ("", None, "s", "request to the last picture of the first page drawn, empty cache"),
    "arrived": ("", None, "", "pictures that arrived during scrolling"),
    "window_mb": ("", None, "MB", "window process alone, resident, peak"),
    "drawing_mb": ("", None, "MB", "drawing process alone, resident, peak"),
    "kept_ms": ("", None, "ms", "a picture of 96×96 read from disk"),
    "columns_ms": ("", None, "ms", "numeric columns of 10,000 paints"),
    "duplicates_s": ("", None, "s", "duplicates among 10,000 paints within ΔE00 of 1"),
    "hue_path_s": ("", None, "s", "10,000 paints along the hue path"),
}
NOTES: dict[str, str] = {}
PAINTS = 10_000
DRAWN = 192


def run(progress=None):
    from brdf_suite.cli.tools.bench import load_module
    from brdf_suite.documents.palette_store import save_palette
    from brdf_suite.progress import report

    made = load_module(Path(__file__).parent / "parts" / "palette" / "paints.py")
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        report(progress, 0.0, "making ten thousand paints")
        file = Path(folder) / "ten thousand.brdfpalette"
        large = made.palette(PAINTS)
        save_palette(large, file)
        report(progress, 0.05, "drawing pictures")
        found |= rates()
        report(progress, 0.3, "searching")
        found |= searching(large)
        report(progress, 0.4, "opening and scrolling in Color Swatch")
        found |= window(file)
    report(progress, 1.0, "measured")
    return {key: found.get(key) for key in BOUNDS}


def run_part(name, argument, **environment):
    """Return what a process of this benchmark prints as its last line, a JSON object."""
    done = subprocess.run(
        [sys.executable, str(Path(__file__).parent / "parts" / "palette" / name), argument],
        capture_output=True,
        text=True,
        check=True,
        timeout=600,
        env={**os.environ, **environment},
    )
    return json.loads(done.stdout.splitlines()[-1])


def rates():
    """Pictures a second and the processor's time, in a process with the surroundings of the one that draws."""
    reported = run_part("rates.py", str(DRAWN), OPENBLAS_NUM_THREADS="1")
    NOTES.update(reported["notes"])
    return reported["figures"]


def searching(large):
    """Nearest, columns, duplicates, order; the nearest are checked against a comparison with every paint."""
    from brdf_suite.appearance.difference.formulas import delta_e_2000
    from brdf_suite.palettes.columns import Columns
    from brdf_suite.palettes.duplicates import duplicates
    from brdf_suite.palettes.order import ordered
    from brdf_suite.palettes.search import nearest

    began = perf_counter()
    columns = Columns.of(large.entries)
    found = {"columns_ms": 1e3 * (perf_counter() - began)}
    rng = np.random.default_rng(3)
    times = []
    for _ in range(40):
        wanted = columns.main[rng.integers(PAINTS)] + rng.normal(0.0, 4.0, (3, 3))
        began = perf_counter()
        result = nearest(columns, wanted, 20)
        times.append(1e3 * (perf_counter() - began))
        each = delta_e_2000(wanted, columns.lab).mean(axis=1)
        assert result.indices.tolist() == np.argsort(each, kind="stable")[:20].tolist()
    found["nearest_ms"] = median(times)
    began = perf_counter()
    duplicates(columns, 1.0)
    found["duplicates_s"] = perf_counter() - began
    began = perf_counter()
    ordered(columns, "hue path")
    found["hue_path_s"] = perf_counter() - began
    return found


def window(file):
    from brdf_suite.files.cache.disk_cache import default_root

    # The light and the form are there already, as they are after any start but the first; no picture is.
    cache = file.parent / "own cache"
    cache.mkdir()
    for kept in ("lobe_maps", "occlusion"):
        if (default_root() / kept).is_dir():
            (cache / kept).symlink_to(default_root() / kept)
    reported = run_part("window.py", str(file), BRDF_SUITE_CACHE=str(cache))
    assert reported["swatches"] >= PAINTS
    return {
        "open_10k_s": reported["open_s"],
        "scroll_median_ms": median(reported["scroll_ms"]),
        "scroll_p99_ms": float(np.percentile(reported["scroll_ms"], 99)),
        "scroll_cpu_median_ms": median(reported["scroll_cpu_ms"]),
        "scroll_cpu_p99_ms": float(np.percentile(reported["scroll_cpu_ms"], 99)),
        "first_picture_s": reported["first_picture_s"],
        "first_page_s": reported["first_page_s"],
        "arrived": reported["arrived"],
        "window_mb": reported["window_mb"],
        "drawing_mb": reported["drawing_mb"],
        "memory_mb": reported["memory_mb"],
    }

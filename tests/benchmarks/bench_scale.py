"""Cost against size: swatches, triangles, nodes of a scene, environments, lamps, tabs and readings.

Windows run on Qt's offscreen platform, each size in a process of its own. An exponent is the slope between the two
largest sizes, both axes logarithmic, of the processor's time, which other programs of the machine lengthen less than
the time that passes. With `--large` sizes that take minutes are measured too.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

NAME = "scale"
LARGE = False
"""Whether sizes that take minutes are measured too; set by ``--large``."""

BOUNDS = {
    "swatches_turn_ms": (
        "<=",
        100.0,
        "ms",
        "longest turn of Color Swatch's event loop with 100,000 swatches: open, scroll, search, sort, select all, edit",
    ),
    "swatches_turn_cpu_ms": ("", None, "ms", "processor time of the window's thread in the longest turn"),
    "swatches_memory_mb": ("<=", 500.0, "MB", "its memory after these, resident"),
    "swatches_peak_mb": ("", None, "MB", "its largest memory meanwhile"),
    "swatches_open_s": ("", None, "s", "100,000 swatches: request to the first swatches shown"),
    "swatches_exponent": ("", None, "", "of opening"),
    "triangles_first_frame_s": (
        "<=",
        2.5,
        "s",
        "glTF file of 10⁶ triangles with normals and texture coordinates: reading to Viewer's first frame, 1280x720; "
        "coarse where whole ones are slow",
    ),
    "triangles_whole_s": ("", None, "s", "reading to the first whole frame"),
    "triangles_cpu_s": ("", None, "s", "its processor time, all threads"),
    "triangles_read_s": ("", None, "s", "the part of it that reads the file, off the window's thread"),
    "triangles_bare_s": ("", None, "s", "PLY file of 10⁶ triangles without normals, to the first frame"),
    "triangles_exponent": ("", None, "", "of the glTF file"),
    "nodes_10k_ms": ("", None, "ms", "glTF file of a chain of 10⁴ nodes that show one triangle each"),
    "nodes_exponent": ("", None, "", "of it"),
    "environment_4k_s": (
        "",
        None,
        "s",
        "environment of 4096x2048 read and filtered, nothing cached",
    ),
    "environment_exponent": ("", None, "", "of it, against the number of pixels"),
    "lamps_64_s": ("", None, "s", "studio of 64 lamps drawn at 1024x512"),
    "lamps_exponent": ("", None, "", "of it"),
    "tabs_open_s": ("", None, "s", "opening 200 tabs in Designer, each with a turn of the event loop"),
    "tabs_close_s": ("<=", 2.0, "s", "Close All Tabs with 200 open in Designer, until the window is idle"),
    "tabs_close_one_ms": ("", None, "ms", "closing one of 200 and showing the next, mean of 20"),
    "tabs_close_cpu_s": ("", None, "s", "its processor time, all threads"),
    "tabs_exponent": ("", None, "", "of closing"),
    "samples_1m_s": ("", None, "s", "goniometer file of 10⁶ readings"),
    "samples_exponent": ("", None, "", "of it"),
}
NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}

SIZES: dict[str, tuple[tuple[int, ...], tuple[int, ...]]] = {
    "swatches": ((1_000, 10_000, 100_000), ()),
    "triangles": ((100_000, 1_000_000), (10_000_000,)),
    "nodes": ((100, 1_000, 10_000), (100_000,)),
    "environment": ((1024, 2048, 4096), (8192, 16384)),
    "lamps": ((1, 4, 16, 64), ()),
    "tabs": ((10, 50, 200), (1_000,)),
    "samples": ((1_000, 10_000, 100_000, 1_000_000), ()),
}
"""By what is counted: the sizes that are always measured, and those of ``--large``."""
_PART = Path(__file__).parent / "parts" / "scale"
_WEIGHT = {"swatches": 6, "triangles": 4, "environment": 6, "tabs": 2}
_TIMEOUT_S = 1800

EXPLAINED = """\
### Sizes and exponents

| cost of | by size | exponent | why |
|---|---|---|---|
{rows}

Limits: a palette has at most 100,000 entries, a file of readings 10⁶ of them, a studio 64 lamps; larger ones are
refused with a message. An environment image of more than 8,192 columns is averaged to that as it is read.
"""
WHY = {
    "swatches": "each entry is read once; only what is seen is painted",
    "triangles": "sorts of edges and of places, n log n; the rest is linear",
    "nodes": "the graph is walked once",
    "environment": "a pixel is added to each map once",
    "lamps": "each lamp is looked at for each pixel, beside what does not depend on lamps",
    "tabs": "between 1 and 2: Qt lays the whole row of tabs out whenever one of them changes",
    "samples": "a line is read once",
}


def run(progress=None):
    from brdf_suite.progress import report

    found: dict[str, float | None] = dict.fromkeys(BOUNDS)
    TABLES.clear()
    whole, done = sum(_WEIGHT.get(name, 1) for name in SIZES), 0
    for name, (usual, large) in SIZES.items():
        report(progress, done / whole, f"measuring {name}")
        sizes = (*usual, *(large if LARGE else ()))
        measured = {size: _measure(name, size) for size in sizes}
        TABLES[name] = {str(size): values for size, values in measured.items()}
        found |= FIGURES[name](measured[usual[-1]])
        found[f"{name}_exponent"] = exponent(name, measured)
        done += _WEIGHT.get(name, 1)
    if "triangles" in SIZES:
        largest = SIZES["triangles"][0][-1]
        bare = _run("triangles.py", "ply", largest)
        TABLES["triangles without normals"] = {str(largest): bare}
        found["triangles_bare_s"] = bare["first_frame_s"]
    report(progress, 1.0, "measured")
    return found


def _measure(name, size):
    if name == "swatches":
        return _run("swatches.py", size)
    if name == "triangles":
        return _run("triangles.py", "glb", size)
    if name == "tabs":
        return _run("tabs.py", size)
    return _run("costs.py", name, size)


def _run(script, *arguments):
    """Return what a process of this benchmark prints as its last line, a JSON object."""
    with tempfile.TemporaryDirectory() as cache:
        own = {"BRDF_SUITE_CACHE": cache} if "environment" in arguments else {}
        done = subprocess.run(
            [sys.executable, str(_PART / script), *map(str, arguments)],
            capture_output=True,
            text=True,
            check=True,
            timeout=_TIMEOUT_S,
            env={**os.environ, **own},
        )
    return json.loads(done.stdout.splitlines()[-1])


_COST = {
    "swatches": "open_cpu_s",
    "triangles": "cpu_s",
    "tabs": "close_cpu_s",
}


def cost(name, values):
    """Return the processor's seconds of one size."""
    return values[_COST.get(name, "cpu_s")]


def exponent(name, measured):
    """Return the slope between the two largest sizes, both axes logarithmic; of environments against pixels."""
    (small, first), (large, second) = sorted(measured.items())[-2:]
    power = 2.0 if name == "environment" else 1.0
    return math.log(cost(name, second) / cost(name, first)) / math.log(large / small) / power


def _swatches(values):
    longest = max(values["turns_s"], key=lambda key: values["turns_s"][key])
    NOTES["swatches_turn_ms"] = f"in: {longest}"
    return {
        "swatches_turn_ms": 1e3 * values["turns_s"][longest],
        "swatches_turn_cpu_ms": 1e3 * max(values["turns_cpu_s"].values()),
        "swatches_memory_mb": values["memory_mb"],
        "swatches_peak_mb": values["memory_peak_mb"],
        "swatches_open_s": values["open_s"],
    }


def _triangles(values):
    return {
        "triangles_first_frame_s": values["first_frame_s"],
        "triangles_whole_s": values["whole_frame_s"],
        "triangles_cpu_s": values["cpu_s"],
        "triangles_read_s": values["read_s"],
    }


def _tabs(values):
    return {
        "tabs_open_s": values["open_s"],
        "tabs_close_s": values["close_s"],
        "tabs_close_one_ms": 1e3 * values["close_one_s"],
        "tabs_close_cpu_s": values["close_cpu_s"],
    }


FIGURES = {
    "swatches": _swatches,
    "triangles": _triangles,
    "nodes": lambda values: {"nodes_10k_ms": 1e3 * values["s"]},
    "environment": lambda values: {"environment_4k_s": values["s"]},
    "lamps": lambda values: {"lamps_64_s": values["s"]},
    "tabs": _tabs,
    "samples": lambda values: {"samples_1m_s": values["s"]},
}
"""By what is counted: the figures of the largest size that is always measured."""


def appendix():
    """Return the table of sizes, with the exponents and their causes."""
    if not TABLES:
        return ""
    rows = []
    for name in SIZES:
        measured = {int(size): values for size, values in TABLES[name].items()}
        costs = ", ".join(f"{size:,}: {cost(name, values):.3g} s" for size, values in measured.items())
        rows.append(f"| {name} | {costs} | {exponent(name, measured):.2f} | {WHY[name]} |")
    return EXPLAINED.format(rows="\n".join(rows))

"""Lobe Visualizer: 3-D surfaces, slice plots during a drag, opening a table; each in a separate process."""

from __future__ import annotations

from pathlib import Path

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.progress import subrange

_HERE = Path(__file__).parent
_surface = load_module(_HERE / "parts" / "lobes" / "lobes_surface.py")
_slices = load_module(_HERE / "parts" / "lobes" / "lobes_slices.py")
_open = load_module(_HERE / "parts" / "lobes" / "lobes_open.py")

NAME = "lobes"
BOUNDS = (
    _surface.BOUNDS
    | {
        "slices_median_ms": (
            "<=",
            16.0,
            "ms",
            "six reflectances in polar plot and curves, incidence change to painted, median of a drag",
        ),
        "slices_p99_ms": ("", None, "ms", "the same, 99th percentile"),
        "slices_cpu_ms": ("", None, "ms", "its processor time, median"),
        "slices_both_median_ms": ("", None, "ms", "with each fit as a second line, median"),
        "slices_both_p99_ms": ("", None, "ms", "the same, 99th percentile"),
        "slices_both_cpu_ms": ("", None, "ms", "its processor time, median"),
    }
    | _open.BOUNDS
)
NOTES = _surface.NOTES


def run(progress=None):
    """Return the figures of :data:`BOUNDS`."""
    found = _surface.run(subrange(progress, 0.0, 0.4))
    found |= _slices.measure()
    return found | _open.run(subrange(progress, 0.7, 1.0))

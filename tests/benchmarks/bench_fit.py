"""Time and accuracy of a fit: from target samples to weights, three channels, base and coat.

The fitter runs with its default limit, as in the programs. Fit time excludes sampling the reflectance.
"""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.progress import Progress, report, subrange

NAME = "fit"


def _parts() -> list[ModuleType]:
    """Load the parts beside this file: ``fit_*.py``, each with ``TITLE``, ``BOUNDS`` and ``run`` as a benchmark has."""
    return [
        load_module(path) for path in sorted((Path(__file__).resolve().parent / "parts").glob("fit_*.py"))
    ]


PARTS = _parts()

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    key: row for module in PARTS for key, row in module.BOUNDS.items()
}
#: key: what is to be known of the figure; filled by ``run``.
NOTES: dict[str, str] = {}


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Return the figures of :data:`BOUNDS`."""
    figures: dict[str, float | None] = {}
    for number, module in enumerate(PARTS):
        report(progress, number / len(PARTS), module.TITLE)
        figures |= module.run(subrange(progress, number / len(PARTS), (number + 1) / len(PARTS)))
        NOTES.update(getattr(module, "NOTES", {}))
    return figures

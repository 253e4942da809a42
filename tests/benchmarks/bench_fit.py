"""How long a fit takes and how true it is: from target samples in hand to weights, three channels, base and coat.

The fitter runs with its own limit, as the programs use it. The times leave out sampling the reflectance, as
the suite defines fit time; docs/fit.md tells what it costs.
"""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report

NAME = "fit"


def _parts() -> list[ModuleType]:
    """Load the parts beside this file: ``fit_*.py``, each with ``BOUNDS`` and ``run`` as a benchmark has."""
    modules = []
    for path in sorted(Path(__file__).resolve().parent.glob("fit_*.py")):
        spec = importlib.util.spec_from_file_location(f"brdf_suite_bench_{path.stem}", path)
        if spec is None or spec.loader is None:
            raise SuiteError(f"{path} cannot be imported.")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        modules.append(module)
    return modules


PARTS = _parts()

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    key: row for part in PARTS for key, row in part.BOUNDS.items()
}
#: key: what is to be known of the figure; filled by ``run``.
NOTES: dict[str, str] = {}


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Return the figures of :data:`BOUNDS`."""
    figures: dict[str, float | None] = {}
    for number, part in enumerate(PARTS):
        report(progress, number / len(PARTS), part.__name__)
        figures |= part.run(None)
        NOTES.update(getattr(part, "NOTES", {}))
    return figures

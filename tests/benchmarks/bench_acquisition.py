"""Acquisition from photographs of a sphere: a simulated rig reconstructed, its steps, the fit and its intervals."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType

from brdf_suite.progress import Progress, subrange

NAME = "acquisition"
PARTS = (
    "acquisition_table",
    "acquisition_response",
    "acquisition_misalignment",
    "acquisition_fit",
    "acquisition_intervals",
)


def _loaded(names: Iterable[str]) -> dict[str, ModuleType]:
    """Return the modules beside this one, each with ``BOUNDS``, ``NOTES`` and ``figures(progress)``."""
    found = {}
    for name in names:
        spec = importlib.util.spec_from_file_location(
            name, Path(__file__).parent / "parts" / "acquisition" / f"{name}.py"
        )
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        spec.loader.exec_module(module)
        found[name] = module
    return found


_PARTS = _loaded(PARTS)

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    key: row for module in _PARTS.values() for key, row in module.BOUNDS.items()
}
NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure everything: two hours, all but some minutes for the intervals."""
    figures: dict[str, float | None] = {}
    for n, module in enumerate(_PARTS.values()):
        figures |= module.figures(subrange(progress, n / len(_PARTS), (n + 1) / len(_PARTS)))
        NOTES.update(module.NOTES)
        TABLES.update(getattr(module, "TABLES", {}))
    return figures

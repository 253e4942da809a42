"""``brdf-suite bench NAME``: the measured figures, from the benchmarks beside the tests.

A benchmark is a module ``bench_NAME.py`` in ``tests/benchmarks`` or below, with ``NAME``, ``BOUNDS`` (key ->
comparison, bound, unit, meaning) and ``run(progress) -> {key: number or None}``; it may add as it runs ``NOTES``
(key -> text) and ``TABLES`` (key -> values by name), which only ``--json`` prints, and ``appendix() -> str``: Markdown,
its headings of the third level, that ``--write`` puts below the module's table. One with ``LARGE`` (False) has larger
sizes, which ``--large`` asks for by making it True.
"""

from __future__ import annotations

import argparse
import ast
import importlib.util
import math
import subprocess
from pathlib import Path
from types import ModuleType

from brdf_suite.cli.arguments import add_json
from brdf_suite.cli.output import print_json, progress_bar
from brdf_suite.cli.tools.measurements import (
    Bound,
    ReportSection,
    Result,
    describe_machine,
    machine_summary,
    renew_section,
    today,
)
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.progress import Progress

_CHECKOUT = Path(__file__).resolve().parents[3]
_FOLDER = _CHECKOUT / "tests" / "benchmarks"
_DOCS = _CHECKOUT / "docs" / "method"
_INSERT_FIGURES = _CHECKOUT / "packaging" / "documents" / "insert_figures.py"


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.examples = ("brdf-suite bench fit", "brdf-suite bench --list")
    command.description = "Measure. Without --json a table with the bound beside each figure."
    command.add_argument("name", nargs="?", metavar="NAME", help="which benchmark; see --list")
    command.add_argument("--list", action="store_true", help="name the benchmarks")
    command.add_argument("--all", action="store_true", help="run them all")
    command.add_argument(
        "--large", action="store_true", help="also the sizes that take minutes, where a benchmark has some"
    )
    add_json(command)
    command.add_argument(
        "--write",
        action="store_true",
        help="write the figures into docs/method/measurements.json and .md, and into the documents",
    )
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Run what was asked for; 1 where a bound is missed."""
    found = _find()
    if options.list:
        for name, path in found.items():
            about = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
            print(f"{name:12} {about.partition(chr(10))[0]}")
        return 0
    if options.all == (options.name is not None):
        raise SuiteError("Name one benchmark, or --all; `brdf-suite bench --list` names them.")
    if options.name is not None and options.name not in found:
        raise SuiteError(f"There is no benchmark {options.name!r}; there are {', '.join(found)}.")
    kept = True
    for name in found if options.all else [options.name]:
        module = load_module(found[name])  # not before: another may need an extra that is not there
        if options.large and not hasattr(module, "LARGE") and not options.all:
            raise SuiteError(f"Benchmark {name} has no larger sizes.")
        module.LARGE = options.large  # type: ignore[attr-defined]  # a benchmark with larger sizes reads it
        with progress_bar(name, quiet=options.json) as progress:
            result = measure(module, progress)
        kept &= all(result.bounds[key].holds(value) is not False for key, value in result.figures.items())
        if options.json:
            print_json(result.to_json(describe_machine()))
        else:
            _print_table(result)
        if options.write:
            about = (module.__doc__ or "").strip()
            renew_section(_DOCS, ReportSection(about, machine_summary(), today(), result, appendix(module)))
    if options.write:
        load_module(_INSERT_FIGURES).insert_into_documents(_CHECKOUT)
    return 0 if kept else 1


def measure(module: ModuleType, progress: Progress | None) -> Result:
    """Run one benchmark module; its keys must be those that it declares, its values finite."""
    bounds = {key: Bound(*row) for key, row in module.BOUNDS.items()}
    try:
        measured = module.run(progress)
    except Cancelled:
        raise
    except (SuiteError, OSError, subprocess.SubprocessError) as error:
        return Result(
            module.NAME, dict.fromkeys(bounds), bounds, dict.fromkeys(bounds, f"not measured: {error}")
        )
    figures = {key: None if value is None else float(value) for key, value in measured.items()}
    if set(figures) != set(bounds):
        raise SuiteError(f"Benchmark {module.NAME} declares {sorted(bounds)} but measured {sorted(figures)}.")
    for key, value in figures.items():
        if value is not None and not math.isfinite(value):
            raise SuiteError(f"Benchmark {module.NAME}: {key} is {value}.")
    return Result(
        module.NAME,
        {key: figures[key] for key in bounds},
        bounds,
        dict(getattr(module, "NOTES", {})),
        dict(getattr(module, "TABLES", {})),
    )


def appendix(module: ModuleType) -> str:
    """Return what the module adds below its table: Markdown, or nothing."""
    own = getattr(module, "appendix", None)
    return "" if own is None else str(own())


def _find() -> dict[str, Path]:
    """Return the benchmarks' modules by name."""
    if not _FOLDER.is_dir():
        raise SuiteError(
            "The benchmarks are part of the source checkout; this is an installed copy without them."
        )
    return dict(sorted((path.stem.removeprefix("bench_"), path) for path in _FOLDER.rglob("bench_*.py")))


def load_module(path: Path) -> ModuleType:
    """Load a benchmark, or a part of one; they are no package. Raise :class:`SuiteError` where it cannot be."""
    spec = importlib.util.spec_from_file_location(f"brdf_suite_{path.stem}", path)
    if spec is None or spec.loader is None:
        raise SuiteError(f"{path} cannot be imported.")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _print_table(result: Result) -> None:
    rows = list(result.rows())
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    print(f"{result.name} on {describe_machine()['processor']}")
    for key, value, bound, kept, meaning in rows:
        mark = "✓" if kept == "yes" else kept
        print(f"  {key:{widths[0]}}  {value:>{widths[1]}}  {bound:>{widths[2]}}  {mark:2}  {meaning}")

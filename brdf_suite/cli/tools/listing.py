"""``brdf-suite list``: what is shipped and what is known by name."""

from __future__ import annotations

import argparse
import json
import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.cli.arguments import USUAL, add_json
from brdf_suite.cli.output import print_csv, print_json, print_notes
from brdf_suite.command_parser import CommandParser
from brdf_suite.files import exports, measured, palettes
from brdf_suite.pipeline.material import paint_titles
from brdf_suite.pipeline.scene import environment_names, surface_names
from brdf_suite.plugins import Registry
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.registry import ENTRIES, MODELS
from brdf_suite.reports import handover
from brdf_suite.resources import SCHEMA_ENDING, resource, schema_names
from brdf_suite.variables import VARIABLES

Row = Mapping[str, object]


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "List names: of what is shipped (paints, environments, surfaces), of file formats and their endings, of "
        "reflectance models, of the geometries of instruments, of installed plug-ins and why one is skipped, of JSON "
        "Schemas of the suite's own formats with the files that they are in, and of environment variables with what "
        "they are set to. Without KIND all of them."
    )
    command.examples = (
        "brdf-suite list paints",
        "brdf-suite list formats --csv",
        "brdf-suite list environments --json",
    )
    command.add_argument("kind", metavar="KIND", nargs="?", choices=tuple(_KINDS), help=", ".join(_KINDS))
    add_json(command, csv=True)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print the names, with what each means."""
    kinds = tuple(_KINDS) if options.kind is None else (options.kind,)
    found = {kind: list(_KINDS[kind]()) for kind in kinds}
    if options.json:
        print_json(found)
        return 0
    if options.csv:
        columns = dict.fromkeys(key for rows in found.values() for row in rows for key in row)
        print_csv(
            {"kind": kind, **{key: row.get(key, "") for key in columns}}
            for kind, rows in found.items()
            for row in rows
        )
        return 0
    for kind, rows in found.items():
        if len(found) > 1:
            print(f"{kind}:")
        elif not rows:
            print_notes([f"there are no {kind}"])
        width = max((len(str(row["name"])) for row in rows), default=0)
        for row in rows:
            print(
                f"{row['name']:{width}}  {'  '.join(str(row[key]) for key in row if key != 'name')}".rstrip()
            )
    return 0


def _paints() -> Iterable[Row]:
    shipped = [{"name": name, "title": title} for name, title in paint_titles().items()]
    return [*shipped, *({"name": name, "title": paint.name} for name, paint in TABLE_1.items())]


def _formats() -> Iterable[Row]:
    """Every format, by what goes into it; one that is read and written twice stands there twice."""
    for known in handover.formats():
        uses = "read, written" if known.read is not None else "written"
        yield _format(known.name, known.title, "paints", (known.ending,), uses)
    for kind, formats in (("palettes", palettes.FORMATS), ("measured", measured.FORMATS)):
        for one in formats:
            uses = "read" if one.write is None else "read, written"
            yield _format(one.name, one.title, kind, one.endings, uses)


def _format(name: str, title: str, holds: str, endings: tuple[str, ...], uses: str) -> Row:
    names = dict.fromkeys((*USUAL.get(name, ()), *(ending.lstrip(".") for ending in endings)))
    also = [other for other in names if other != name]
    return {
        "name": name,
        "holds": holds,
        "endings": " ".join(endings),
        "uses": uses,
        "title": title,
        "also": " ".join(also),
    }


def _schemas() -> Iterable[Row]:
    for name in schema_names():
        file = resource("schemas", f"{name}{SCHEMA_ENDING}")
        title = str(json.loads(file.read_text(encoding="utf-8"))["title"]).removeprefix("BRDF Suite: ")
        yield {"name": name, "file": str(file), "title": title}


def _plugins() -> Iterable[Row]:
    """Every plug-in that is installed, by its group, with why it is skipped where it is."""
    tables: tuple[Registry[Any], ...] = (ENTRIES, measured.FORMATS, palettes.FORMATS, exports.FORMATS)
    for table in tables:
        len(table)  # which loads them
        for plugin, reason in table.states.items():
            state = f"skipped: {reason}" if reason else "loaded"
            yield {"name": plugin.name, "group": plugin.group, "package": plugin.package, "state": state}


_KINDS: Mapping[str, Callable[[], Iterable[Row]]] = {
    "paints": _paints,
    "environments": lambda: [{"name": name} for name in environment_names()],
    "surfaces": lambda: [{"name": name} for name in surface_names()],
    "formats": _formats,
    "models": lambda: [{"name": name, "title": model.title} for name, model in MODELS.items()],
    "geometries": lambda: [{"name": name, "title": one.title} for name, one in GEOMETRY_SETS.items()],
    "plugins": _plugins,
    "schemas": _schemas,
    "variables": lambda: [
        {"name": name, "value": os.environ.get(name, ""), "title": what} for name, what in VARIABLES.items()
    ],
}

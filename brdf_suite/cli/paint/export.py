"""``brdf-suite export PAINT|PALETTE… -o FILE``: export paints to other programs, or make a report of one."""

from __future__ import annotations

import argparse
from itertools import chain

from brdf_suite.appearance.difference.tolerance import Tolerances
from brdf_suite.cli.arguments import PAINTS, add_arguments, add_export, add_format, add_output
from brdf_suite.cli.output import export_progress, print_done, print_json, print_notes
from brdf_suite.cli.paint.tolerances import add_tolerances, parse_tolerances
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.store import load_view
from brdf_suite.errors import UnreachableError
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.pipeline.material import paints_of
from brdf_suite.reports.handover import export, export_losses, format_named, format_of, formats, item_of
from brdf_suite.reports.paint_report.document import ReportOptions

_ENDINGS = {known.name: (known.ending,) for known in formats()}


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Write paints for other programs: CxF3 with one specification per angle, CSV, JSON; LuxCore car "
        "paint, MaterialX OpenPBR, glTF clearcoat, USD Preview Surface and RGL .bsdf for renderers; a one-page report "
        "as HTML or PDF. What a format cannot hold is reported. L*a*b* are of D65 and the 10° observer."
    )
    command.examples = (
        "brdf-suite export blue -o blue.cxf",
        "brdf-suite export summer.brdfpalette -o - --format csv > summer.csv",
        "brdf-suite export blue --list-losses --format mtlx",
    )
    several = "several go into one CSV, CxF3, JSON, .scn, .mtlx or .usda"
    add_arguments(command, {"sources PAINT|PALETTE...": f"{PAINTS}; {several}"})
    add_output(command, "the file to write", stream=_ending, required=False)
    command.wanted.add("output")
    add_format(command, _ENDINGS)
    add_arguments(
        command,
        {
            "--list-losses": "list what each format (or the one of --format) cannot hold of the paints, and write "
            "nothing",
        },
    )
    add_arguments(
        command.add_argument_group("reports"),
        {
            "--standard PAINT": "the paint that this one is compared with",
            "--view FILE": "the .brdfview of the picture",
            "--no-pictures": "leave the pictures out",
        },
    )
    add_tolerances(command)
    add_export(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the export or list its losses, as lines or as a JSON object."""
    names = [*chain.from_iterable(map(paints_of, options.sources))]
    items = [item_of(paint) for paint in names]
    read = [m.aspecular_deg for item in items for m in item.paint.measurements]
    report = ReportOptions(
        standard=None if options.standard is None else load_standards(options.standard)[0],
        tolerances=parse_tolerances(options, read) or Tolerances({}, None, options.difference),
        view=None if options.view is None else load_view(options.view),
        pictures=not options.no_pictures,
    )
    if options.list_losses:
        wanted = formats(report) if options.format is None else (format_named(options.format, report),)
        return _list_losses(options, names, items, wanted)
    if options.output is None:
        options.parser.error("-o FILE is missing; --list-losses writes nothing")
    known = (
        format_of(options.output, report) if options.format is None else format_named(options.format, report)
    )
    with export_progress("export", options) as progress:
        done = export(known, items, options.output, progress=progress)
    size = done.path.stat().st_size
    if options.json:
        print_json(
            {
                "output": str(done.path),
                "format": done.format,
                "paints": [item.name for item in items],
                "bytes": size,
                "losses": list(done.losses),
                "notes": list(done.notes),
            }
        )
        return 0
    print_notes(done.losses, "lost")
    print_notes(done.notes)
    what = items[0].name if len(items) == 1 else f"{len(items)} paints"
    print_done(f"{done.path}: {what}, {known.title}, {size:,} bytes")
    return 0


def _ending(options: argparse.Namespace) -> str:
    if options.format is None:
        options.parser.error("with -o - give --format too")
    return _ENDINGS[options.format][0]


def _list_losses(
    options: argparse.Namespace,
    names: list[str],
    items: list[ExportItem],
    wanted: tuple[ExportFormat, ...],
) -> int:
    table: dict[str, dict[str, list[str]]] = {}
    for name, item in zip(names, items, strict=True):
        rows = table[name] = {}
        for known in wanted:
            try:
                rows[known.name] = list(export_losses(known, item))
            except UnreachableError as error:
                rows[known.name] = [f"Cannot be written: {error}"]
    if options.json:
        print_json({"losses": table})
        return 0
    for name, rows in table.items():
        for known in wanted:
            print(f"{name}, {known.title} ({known.name}, {known.ending}): {known.holds}")
            for loss in rows[known.name] or ["Nothing is lost."]:
                print(f"  {loss}")
    return 0

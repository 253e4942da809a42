"""``brdf-suite export PAINT… -o FILE``: export paints to other programs, or make a report of one."""

from __future__ import annotations

import argparse

from brdf_suite.appearance.difference.tolerance import Tolerances
from brdf_suite.cli.output import add_arguments, add_export, export_progress, print_json, print_notes
from brdf_suite.cli.paint.tolerances import add_tolerances, parse_tolerances
from brdf_suite.documents.store import load_view
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.reports.handover import export, export_losses, format_named, format_of, formats, item_of
from brdf_suite.reports.paint_report.document import ReportOptions

_NAMES = ("cxf", "csv", "json", "luxcore", "openpbr", "gltf", "rgl", "html", "pdf")


def add(command: argparse.ArgumentParser) -> None:
    """Declare the command."""
    command.description = (
        "Write paints for other programs: CxF3 with one specification per angle, CSV, JSON; LuxCore car "
        "paint, MaterialX OpenPBR, glTF clearcoat and RGL .bsdf for renderers; a one-page report as HTML or PDF. What "
        "a format cannot hold is reported. L*a*b* are of D65 and the 10° observer."
    )
    add_arguments(
        command,
        {
            "paints PAINT...": "a .brdfpaint or measured file, or a paint's name; several go into one CSV, CxF3, "
            "JSON, .scn or .mtlx",
            "-o/--output/--out FILE": "the file to write",
            "--format": "the format (default: what the ending of FILE names)",
            "--list-losses": "list what each format (or the one of --format) cannot hold of the paints, and write "
            "nothing",
            "--standard PAINT": "in reports: the paint that this one is compared with",
            "--view FILE": "in reports: the .brdfview of the picture",
            "--no-pictures": "in reports: leave the pictures out",
        },
        format=_NAMES,
    )
    add_tolerances(command)
    add_export(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the export or list its losses, as lines or as a JSON object."""
    items = [item_of(paint) for paint in options.paints]
    read = [m.aspecular_deg for item in items for m in item.paint.measurements]
    report = ReportOptions(
        standard=None if options.standard is None else load_standards(options.standard)[0],
        tolerances=parse_tolerances(options, read) or Tolerances({}, None, options.difference),
        view=None if options.view is None else load_view(options.view),
        pictures=not options.no_pictures,
    )
    if options.list_losses:
        wanted = formats(report) if options.format is None else (format_named(options.format, report),)
        return _list_losses(options, items, wanted)
    if options.output is None:
        raise SuiteError("No output file: give -o FILE, or --list-losses to see what the format would lose.")
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
    names = items[0].name if len(items) == 1 else f"{len(items)} paints"
    print(f"{done.path}: {names}, {known.title}, {size:,} bytes")
    return 0


def _list_losses(
    options: argparse.Namespace, items: list[ExportItem], wanted: tuple[ExportFormat, ...]
) -> int:
    table: dict[str, dict[str, list[str]]] = {}
    for name, item in zip(options.paints, items, strict=True):
        rows = table[str(name)] = {}
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

"""``brdf-suite judge STANDARD-PAINT PAINT|PALETTE…``: batches against a standard, by their readings."""

from __future__ import annotations

import argparse
from dataclasses import replace

from brdf_suite.appearance.difference.tolerance import Tolerances, difference_title
from brdf_suite.appearance.geometries import Geometry
from brdf_suite.cli.arguments import PAINT, add_arguments, add_json
from brdf_suite.cli.output import print_csv, print_json, print_notes
from brdf_suite.cli.paint.tolerances import add_tolerances, parse_tolerances, verdict_text
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError, did_you_mean
from brdf_suite.paint_design.standard import AngleRow, BatchReport, Standard, judge_all, paint_like
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.pipeline.material import default_paint
from brdf_suite.reflectance.instruments.spectrophotometer import support_notice

_FILES = "also CSV and JSON of an export"


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Judge each batch's readings against the standard's. What a standard was not read at is measured "
        "of it where it is more than readings. With tolerances the exit status is 1 where a batch fails."
    )
    command.examples = (
        "brdf-suite judge standard.cxf batch.cxf --tolerance 15=1.2 --tolerance 0.8",
        "brdf-suite judge blue summer.brdfpalette --tolerance 2 --csv > verdicts.csv",
    )
    add_arguments(
        command,
        {
            "standard STANDARD-PAINT": f"{PAINT}; {_FILES}",
            "batch PAINT|PALETTE...": f"likewise; {_FILES}",
            "--name NAME": "which standard of a file that holds several (default: the first)",
        },
    )
    add_tolerances(command)
    add_json(command, csv=True)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Judge and print; 1 where a batch fails."""
    standard = _chosen(load_standards(options.standard), options.name, options.standard)
    # What is no designed paint is read at the standard's angles, or at the usual ones where it has none of its own.
    like = standard.paint
    if like is None and len(standard.readings) >= 3:
        like = replace(default_paint(), measurements=standard.readings)
    batches = [
        paint_like(one, like or default_paint()) for path in options.batch for one in load_standards(path)
    ]
    angles = [m.aspecular_deg for paint in batches for m in paint.measurements]
    tolerances = parse_tolerances(options, angles) or Tolerances({}, None, options.difference)
    reports = judge_all(standard, batches, tolerances)
    failed = any(report.passes is False for report in reports)
    if options.json:
        print_json(
            {
                "standard": standard.name,
                "origin": standard.origin,
                "notices": list(standard.notices),
                "batches": [report.to_json() for report in reports],
            }
        )
        return 1 if failed else 0
    if options.csv:
        print_csv(_row(report, row) for report in reports for row in report.rows)
        return 1 if failed else 0
    title = difference_title(tolerances.difference)
    for report in reports:
        _print(report, standard, title)
    print_notes(f"{standard.name}: {notice}" for notice in standard.notices)
    if not options.tolerance:
        print_notes(["nothing is judged: no --tolerance is given"])
    return 1 if failed else 0


def _row(report: BatchReport, row: AngleRow) -> dict[str, object]:
    verdict = row.verdict
    numbers = (
        ("", "", "", "", "")
        if verdict is None
        else (verdict.difference, verdict.lightness, verdict.chroma, verdict.hue, verdict.passes)
    )
    names = ("difference", "delta_l", "delta_c", "delta_h", "passes")
    return {"batch": report.name, "angle": row.angle, **dict(zip(names, numbers, strict=True))}


def _chosen(standards: tuple[Standard, ...], name: str | None, path: str) -> Standard:
    if name is None:
        return standards[0]
    found = [standard for standard in standards if standard.name == name]
    if not found:
        names = [standard.name for standard in standards]
        near = did_you_mean(name, names) or f"; there are {', '.join(names[:20])}."
        raise SuiteError(f"{path}: holds no standard called {name!r}{near}")
    return found[0]


def _print(report: BatchReport, standard: Standard, title: str) -> None:
    word = {True: "pass", False: "FAIL", None: "not judged"}[report.passes]
    print(f"{report.name} against {standard.name}: {word}")
    print(f"{'angle':>16} {title:>9} {'ΔL*':>8} {'ΔC*':>8} {'ΔH*':>8}")
    for row in report.rows:
        print(f"{row.angle + row.marks:>16} {_numbers(row)}")
    print(f"  in words: {report.sentence()}")
    if report.flop is not None:
        print(f"  flop index: {report.flop[0]:.1f} and {report.flop[1]:.1f}")
    for angle, change in report.gloss.items():
        print(f"  gloss at {angle}°: {change:+.1f} GU")
    if any(row.computed for row in report.rows):
        print(
            "  * the standard was not read there: the virtual spectrophotometer's reading of its reflectance"
        )
    far = support_notice(
        (Geometry(row.illumination_deg, row.aspecular_deg), row.sample_deg) for row in report.rows
    )
    for notice in far:
        print(f"  † {notice}")


def _numbers(row: AngleRow) -> str:
    if row.verdict is None:
        return "        –  the standard has no reading"
    verdict = row.verdict
    suffix = "" if verdict.passes is None else f"  {verdict_text(verdict)}"
    return f"{verdict.difference:9.3f} {verdict.lightness:+8.2f} {verdict.chroma:+8.2f} {verdict.hue:+8.2f}{suffix}"

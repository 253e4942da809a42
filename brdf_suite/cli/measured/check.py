"""``brdf-suite check``: reciprocity, non-negativity and energy conservation of any reflectance."""

from __future__ import annotations

import argparse

from brdf_suite.cli.arguments import PAINT, add_json
from brdf_suite.cli.output import print_csv, print_json
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance import registry
from brdf_suite.reflectance.checks import check_model, check_reflectance


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Measure whether a reflectance is reciprocal, never negative, and reflects no more light than "
        "arrives: its directional albedo (light at an angle) and the white furnace (view at an angle). What a model "
        "claims and does not keep is a fault; what it does not claim is listed with its size."
    )
    command.epilog = "exit status: 0 every claim held, 1 one did not"
    command.examples = ("brdf-suite check blue", "brdf-suite check --models --csv > models.csv")
    command.add_argument(
        "what", metavar="PAINT|MODEL", nargs="?", help=f"{PAINT}; or a model (`brdf-suite list models`)"
    )
    command.add_argument("--models", action="store_true", help="check every registered model")
    add_json(command, csv=True)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Check and print."""
    if options.models == (options.what is not None):
        raise SuiteError("Name one paint, file or model to check, or give --models for every model.")
    if options.models or options.what in registry.MODELS:
        models = registry.MODELS.values() if options.models else [registry.MODELS[options.what]]
        reports = [check_model(entry) for entry in models]
    else:
        item = load_material(options.what)
        reports = [check_reflectance(item.reflectance, item.name)]
    if options.json:
        print_json({"reports": [r.to_json() for r in reports]} if options.models else reports[0].to_json())
    elif options.csv:
        print_csv(
            {
                "name": report.name,
                "check": finding.check,
                "violation": finding.size,
                "outcome": finding.outcome,
                "unit": finding.unit,
                "where": finding.where,
            }
            for report in reports
            for finding in report.findings
        )
    else:
        for report in reports:
            print(f"{report.name}: {'held' if report.passed else 'NOT held'}")
            print(f"{'check':>20}  {'violation':>10}  outcome")
            for finding in report.findings:
                where = f", {finding.where}" if finding.size > 0.0 else ""
                if finding.typical:
                    where += f"; median {finding.typical:.2g}"
                print(f"{finding.check:>20}  {finding.size:10.3g}  {finding.outcome} ({finding.unit}{where})")
            print(f"{'polar angle °':>20}  {'directional albedo r, g, b':^32}  {'white furnace r, g, b':^32}")
            for angle, light, view in zip(report.incidence_deg, report.albedo, report.furnace, strict=True):
                albedo, furnace = ("".join(f"{value:10.4f}" for value in row) for row in (light, view))
                print(f"{angle:20.0f}  {albedo:^32}  {furnace:^32}")
    return 0 if all(report.passed for report in reports) else 1

"""``brdf-suite represent PAINT``: one reflectance as cosine lobes, Cook-Torrance lobes and factors."""

from __future__ import annotations

import argparse

from brdf_suite.cli.arguments import PAINT, add_arguments, add_json
from brdf_suite.cli.output import print_csv, print_json, print_notes, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.inspection.representations import Comparison, compare_representations
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.scene import find_environment
from brdf_suite.progress import report, subrange


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Fit cosine lobes, Cook-Torrance lobes and homomorphic factors to the same part of a reflectance, and compare "
        "them at pairs of directions that none of them saw, in a picture of a sphere, in size and in time."
    )
    add_arguments(
        command,
        {
            "reflectance PAINT": PAINT,
            "--environment NAME|FILE": "the light on the sphere (default: booth)",
            "--open": "then open the reflectance and the three fits in the Lobe Visualizer, which fits them again",
        },
    )
    add_json(command, csv=True)
    command.examples = (
        "brdf-suite represent blue",
        "brdf-suite represent paint.brdf --environment sunny --csv",
    )
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Compare and print; open the window where that was asked for."""
    _, path = find_environment(options.environment or "booth")
    with progress_bar("representing", quiet=options.json) as progress:
        report(progress, 0.0, "reading")
        material = load_material(options.reflectance)
        environment = read_environment(path)
        found, _ = compare_representations(material, environment, progress=subrange(progress, 0.05, 1.0))
    if options.json:
        print_json(found.to_json())
    elif options.csv:
        print_csv(
            {
                "kind": row.kind,
                "relative_rms": row.errors.relative_rms,
                "median_relative": row.errors.median_relative,
                "delta_e_mean": row.delta_e_mean,
                "delta_e_p99": row.delta_e_p99,
                "bytes": row.size_bytes,
                "ns_per_pair": row.nanoseconds,
                "fit_s": row.fit_seconds,
            }
            for row in found.rows
        )
    else:
        _print_table(found)
    if not options.open:
        return 0
    from brdf_suite.cli.default_action import open_one

    return open_one("lobes", [options.reflectance, "--representations"])


def _print_table(found: Comparison) -> None:
    print(f"{found.name}: {found.pairs:,} pairs of directions held out ({found.where})")
    print(f"ΔE00 over a sphere in {found.environment}; time of an evaluation on one processor core")
    print(f"{'':>18}  relative RMS  median error  ΔE00 mean    p99      bytes  ns/pair   fit s")
    for row in found.rows:
        print(
            f"{row.kind:>18}  {100.0 * row.errors.relative_rms:10.1f} %  {100.0 * row.errors.median_relative:10.2f} %"
            f"  {row.delta_e_mean:9.2f} {row.delta_e_p99:6.2f}  {row.size_bytes:9,}  {row.nanoseconds:7,.0f} "
            f"{row.fit_seconds:7.1f}"
        )
    for row in found.rows:
        print_notes(row.notices, row.kind)

"""``brdf-suite prefilter ENV``: make the prefiltered maps of an environment, or load them from the cache."""

from __future__ import annotations

import argparse
from time import perf_counter

from brdf_suite.cli.arguments import add_json
from brdf_suite.cli.fit_options import add_basis, parse_basis
from brdf_suite.cli.output import print_json, print_notes, progress_bar
from brdf_suite.cli.picture.scene_options import add_environment
from brdf_suite.command_parser import CommandParser
from brdf_suite.pipeline.scene import load_environment


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Prefilter an environment map with every cosine lobe of the basis. The maps go to the cache, from "
        "which the Viewer and `render` take them."
    )
    add_environment(command)
    add_basis(command)
    add_json(command)
    command.examples = ("brdf-suite prefilter studio.exr",)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Prefilter and print what there is now."""
    basis = parse_basis(options)
    start = perf_counter()
    with progress_bar("prefiltering", quiet=options.json) as progress:
        prepared = load_environment(options.environment, progress, layout=options.layout, basis=basis)
    seconds = perf_counter() - start
    facts = prepared.to_json() | {"seconds": seconds}
    if options.json:
        print_json(facts)
        return 0
    print_notes(prepared.environment.notes)
    rows, columns = prepared.environment.radiance.shape[:2]
    sizes = ", ".join(
        f"{exponent:,.0f}: {lobe.faces.shape[1]}"
        for exponent, lobe in zip(prepared.maps.exponents, prepared.maps.lobes, strict=True)
    )
    source = " from the cache" if prepared.from_cache else ""
    print(f"{prepared.name}: {columns}×{rows}, {seconds:.2f} s{source}; face size per exponent: {sizes}")
    return 0

"""``brdf-suite shading-table``: generation of the lobe look-up table of the shader."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from brdf_suite.cli.output import progress_bar
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.lighting.filter.shading_table import shading_table

_OUTPUT = Path("look_ups.json")


def add(command: argparse.ArgumentParser) -> None:
    """Declare the command."""
    command.description = (
        "Find direction, exponent and amplitude by which a cosine lobe times the cosine of incidence is "
        "looked up in prefiltered maps, by least squares over the sphere. The suite's own is "
        "resources/shading/look_ups.json; the same command gives the same file."
    )
    command.add_argument(
        "-o", "--output", metavar="FILE", type=Path, default=_OUTPUT, help=f"default: {_OUTPUT}"
    )
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Make the table and write it."""
    with progress_bar("fitting look-ups", quiet=False) as progress:
        table = shading_table(progress)
    text = json.dumps(table)
    for opening in ('{"toward_normal"', '"targets"', '"coated"', '"gloss"', '"diffuse"', '"cosines"'):
        text = text.replace(opening, "\n" + opening)  # one lobe on a line
    write_atomically(options.output, f"{text}\n".encode())
    print(f"{options.output}: {len(table['targets'])} targets, {len(table['exponents'])} exponents")
    return 0

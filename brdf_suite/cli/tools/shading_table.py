"""``brdf-suite shading-table``: generation of the shader's lobe look-ups and of the facets' directional albedo."""

from __future__ import annotations

import argparse
import io
import json
from pathlib import Path

import numpy as np

from brdf_suite.cli.arguments import add_json, add_output
from brdf_suite.cli.output import print_done, print_json, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.lighting.filter.shading_table import shading_table
from brdf_suite.reflectance.facet_table import facet_table

_OUTPUT, _FACETS = Path("look_ups.json"), Path("facet_albedo.npy")


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Find direction, exponent and amplitude by which a cosine lobe times the cosine of incidence is "
        "looked up in prefiltered maps, by least squares over the sphere. The suite's own is "
        "resources/shading/look_ups.json; the same command gives the same file. With --facets: the light that rough "
        "facets reflect, by roughness, angle and Fresnel reflectance, from which multiple scattering follows; the "
        "suite's own is resources/shading/facet_albedo.npy."
    )
    command.examples = ("brdf-suite shading-table -o look_ups.json",)
    add_output(
        command,
        f"the file to write (default: {_OUTPUT}, or {_FACETS} with --facets)",
        stream=_OUTPUT.suffix,
        required=False,
    )
    command.add_argument("--facets", action="store_true", help="make the table of rough facets instead")
    add_json(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Make the table and write it."""
    if options.facets:
        return _write_facets(options.output or _FACETS, as_json=options.json)
    with progress_bar("fitting look-ups", quiet=options.json) as progress:
        table = shading_table(progress)
    text = json.dumps(table)
    for opening in ('{"toward_normal"', '"targets"', '"coated"', '"gloss"', '"diffuse"', '"cosines"'):
        text = text.replace(opening, "\n" + opening)  # one lobe on a line
    output = options.output or _OUTPUT
    write_atomically(output, f"{text}\n".encode())
    counts = {"targets": len(table["targets"]), "exponents": len(table["exponents"])}
    if options.json:
        print_json({"output": str(output), **counts})
    else:
        print_done(f"{output}: {counts['targets']} targets, {counts['exponents']} exponents")
    return 0


def _write_facets(output: Path, *, as_json: bool) -> int:
    with progress_bar("integrating facets", quiet=as_json) as progress:
        table = facet_table(progress)
    data = io.BytesIO()
    np.save(data, table)
    write_atomically(output, data.getvalue())
    if as_json:
        print_json({"output": str(output), "shape": list(table.shape)})
    else:
        print_done(f"{output}: {' × '.join(map(str, table.shape))} numbers")
    return 0

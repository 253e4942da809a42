"""``brdf-suite convert PAINT -o FILE``: conversion between formats of measured reflectance."""

from __future__ import annotations

import argparse
from collections.abc import Mapping

from brdf_suite.cli.arguments import PAINT, add_arguments, add_format, add_json, add_output
from brdf_suite.cli.output import print_done, print_json, print_notes
from brdf_suite.command_parser import CommandParser
from brdf_suite.files.measured import FORMATS
from brdf_suite.inspection.measuring import convert

_WRITTEN = {known.name: known.endings for known in FORMATS if known.write is not None}


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Read a measured file by its content, or take a paint, and write it in the format of --format, or that the "
        "ending of FILE names. What a format cannot hold is refused, and FILE is left as it was."
    )
    command.examples = (
        "brdf-suite convert paint.brdf -o paint.brdftable",
        "brdf-suite convert copper -o copper.merl",
        "brdf-suite convert copper -o - --format rgl > copper.bsdf",
    )
    command.add_argument("sources", metavar="PAINT", nargs="+", help=PAINT)
    add_output(command, "the file to write; also the last word without -o", stream=_ending, or_last=True)
    add_arguments(
        command,
        {
            "--observer {2,10}=10": "the observer through which spectra become colour, where the file holds no spectra "
            "(default: 10)",
            "--scale-factors {yes,no}": "whether a MERL table carries its scale factors (default: found by its "
            "energy, and said)",
            "--average-reciprocal": "average a pair and its swap, where a MERL table holds both (φd over 360°)",
        },
        observer=int,
    )
    add_format(command, _WRITTEN)
    add_json(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Convert and print a line or a JSON object."""
    if len(options.sources) > 1:
        options.parser.error("one file holds one material; name one PAINT")
    done = convert(
        options.sources[0],
        options.output,
        format_name=options.format,
        observer_deg=options.observer,
        scale_factors=None if options.scale_factors is None else options.scale_factors == "yes",
        average_reciprocal=options.average_reciprocal,
    )
    size = done.target.stat().st_size
    if options.json:
        print_json(
            {
                "input": str(done.source),
                "output": str(done.target),
                "format": done.format,
                "bytes": size,
                "facts": {key: str(value) for key, value in done.facts.items() if key != "notes"},
                "notes": [*_read_notes(done.facts), *done.notes],
            }
        )
        return 0
    print_notes((*_read_notes(done.facts), *done.notes))
    print_done(f"{done.target}: {done.format}, {size:,} bytes, from {done.source}")
    return 0


def _ending(options: argparse.Namespace) -> str:
    if options.format is None:
        options.parser.error("with -o - give --format too")
    return _WRITTEN[options.format][0]


def _read_notes(facts: Mapping[str, object]) -> tuple[str, ...]:
    """Return the reader's assumptions and repairs."""
    notes = facts.get("notes", ())
    return tuple(str(note) for note in notes) if isinstance(notes, (tuple, list)) else (str(notes),)

"""``brdf-suite convert IN OUT``: conversion between formats of measured reflectance."""

from __future__ import annotations

import argparse
from collections.abc import Mapping

from brdf_suite.cli.output import add_arguments, print_json
from brdf_suite.inspection.measuring import convert


def add(command: argparse.ArgumentParser) -> None:
    """Declare the command."""
    command.description = (
        "Read a measured file by its content and write it in the format that the ending of OUT names. "
        "What a format cannot hold is refused, and OUT is left as it was."
    )
    add_arguments(
        command,
        {
            "source IN": "a measured file, a .brdfpaint, or a paint's name",
            "target OUT": "the file to write",
            "--observer {2,10}=10": "the observer through which spectra become colour, where OUT holds no spectra "
            "(default: 10)",
            "--scale-factors {yes,no}": "whether a MERL table carries its scale factors (default: found by its "
            "energy, and said)",
            "--average-reciprocal": "average a pair and its swap, where a MERL table holds both (φd over 360°)",
            "--json": "print what was done as one JSON object",
        },
        observer=int,
    )
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Convert and print a line or a JSON object."""
    done = convert(
        options.source,
        options.target,
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
    print(f"{done.target}: {done.format}, {size:,} bytes, from {done.source}")
    for note in (*_read_notes(done.facts), *done.notes):
        print(f"  {note}")
    return 0


def _read_notes(facts: Mapping[str, object]) -> tuple[str, ...]:
    """Return the reader's assumptions and repairs."""
    notes = facts.get("notes", ())
    return tuple(str(note) for note in notes) if isinstance(notes, (tuple, list)) else (str(notes),)

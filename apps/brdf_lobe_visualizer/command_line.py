"""Lobe Visualizer: any reflectance in three dimensions. ``brdf-lobes --help`` lists its options."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from brdf_qt.program.run import program_parser, run_program

from brdf_lobe_visualizer.assembly import LobeVisualizer
from brdf_lobe_visualizer.script import add_fit, add_options, apply_subjects, apply_view, parse_fit


def main(argv: Sequence[str] | None = None) -> int:
    """Run Lobe Visualizer; return the exit status."""
    return run_program("Lobe Visualizer", parser(), _make, argv)


def parser() -> argparse.ArgumentParser:
    """Return the parser of the command line."""
    parser = program_parser(
        "brdf-lobes",
        "Look at any reflectance in three dimensions, in slices and in numbers, beside its fitted lobes. "
        "Follows the paint that is edited in Designer.",
        'to all being there, fits and figures too; "shown_s" to the reflectances being shown',
        epilog="Ctrl+K finds any command by name.",
    )
    parser.add_argument(
        "reflectances",
        nargs="*",
        metavar="REFLECTANCE",
        help="a .brdfpaint, .brdfpalette or measured file, the name of a shipped paint or of one of Table 1, or of a "
        "model; any number",
    )
    add_options(parser)
    add_fit(parser)
    return parser


def _make(options: argparse.Namespace) -> LobeVisualizer:
    program = LobeVisualizer(asked=options.reflectances, fit=parse_fit(options))
    apply_view(program, options)
    program.reached.connect(
        lambda milestone: apply_subjects(program, options) if milestone == "shown" else None
    )
    return program

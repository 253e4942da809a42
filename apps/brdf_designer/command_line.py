"""Designer: the program that designs paints. ``brdf-designer --help`` lists its options."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from brdf_qt.program.run import add_actions, program_parser, run_program

if TYPE_CHECKING:
    from brdf_designer.assembly import Designer


def main(argv: Sequence[str] | None = None) -> int:
    """Run Designer; return the exit status."""
    parser = program_parser(
        "brdf-designer",
        "Edit a metallic car paint: L*a*b* (D65, 10°) at its aspecular angles in degrees, gloss in "
        "gloss units (GU), flakes. Programs of the suite that are open follow every change.",
        'to its plot being there; with --screenshot "finished_s" too, to all pictures being drawn',
    )
    parser.add_argument("paint", nargs="?", help="a .brdfpaint file, or the name of a shipped paint")
    add_actions(parser)
    return run_program(
        "Designer",
        parser,
        _make,
        argv,
        actions=lambda options: options.do,
        loads="brdf_designer.assembly",
        is_asked=lambda options: options.paint is not None,
    )


def _make(options: argparse.Namespace) -> Designer:
    # Deferred: the start page is on the screen before all of Designer is loaded.
    from brdf_designer.assembly import Designer

    designer = Designer()
    if options.paint is not None:
        designer.open(options.paint)
    return designer

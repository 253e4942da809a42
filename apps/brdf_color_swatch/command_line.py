"""Color Swatch: the program that manages palettes of paints. ``brdf-swatch --help`` lists its options."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from brdf_qt.program.run import add_actions, program_parser, run_program

from brdf_color_swatch.assembly import ColorSwatch
from brdf_color_swatch.grid.tile import FORMS


def main(argv: Sequence[str] | None = None) -> int:
    """Run Color Swatch; return the exit status."""
    return run_program("Color Swatch", _parser(), _make, argv, actions=lambda options: options.do)


def _make(options: argparse.Namespace) -> ColorSwatch:
    program = ColorSwatch()
    look = {"form": options.form, "size": options.swatch_size, "as_list": options.list or None}
    program.session.set_look(**{key: value for key, value in look.items() if value is not None})
    for name in options.palettes:
        program.open(name)
    return program


def _parser() -> argparse.ArgumentParser:
    parser = program_parser(
        "brdf-swatch",
        "Organize metallic car paints as palettes: groups, tags, search by text and colour (ΔE00 at "
        "each angle, D65, 10°), flop. Programs of the suite that are open exchange paints with it.",
        'to its library being there; with --screenshot "finished_s" too, to all pictures being drawn',
    )
    parser.add_argument(
        "palettes",
        nargs="*",
        metavar="FILE",
        help="palettes of any format, or `shipped` for the sample paints",
    )
    parser.add_argument("--form", choices=FORMS, help="form of the swatches")
    parser.add_argument("--swatch-size", type=int, metavar="PX", help="size of the swatches in pixels")
    parser.add_argument("--list", action="store_true", help="show a list instead of the grid")
    add_actions(parser, "search=TEXT, select=N,N…, group=PATH, sort=KEY")
    return parser

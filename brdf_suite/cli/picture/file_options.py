"""Command-line options for picture files."""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from brdf_suite.output.picture_file import PictureSettings

_COLOUR_SPACES = ("srgb", "display-p3", "rec2020")


def add_picture(command: argparse.ArgumentParser, *, radiance: bool = True, sheet: bool = False) -> None:
    """Declare the options read by :func:`parse_settings`; ``radiance``: EXR beside PNG; ``sheet``: with text."""
    spaces = _COLOUR_SPACES if radiance else _COLOUR_SPACES[:2]
    exr = "; 16 or 32 of an EXR (default: 32)" if radiance else ""
    command.set_defaults(bits=None, transparent=False)
    if not sheet:
        command.add_argument(
            "--bits",
            type=int,
            choices=(8, 16, 32) if radiance else (8, 16),
            help=f"bits a channel: 8 or 16 of a PNG (default: 8){exr}",
        )
        command.add_argument(
            "--transparent",
            action="store_true",
            help="the object alone, with its share of each pixel as alpha",
        )
    rest = ", linear; rec2020 for EXR" if radiance else ""
    command.add_argument(
        "--colour-space",
        choices=spaces,
        default=None,
        help=f"colours of the file, its ICC profile within (default: srgb{rest})",
    )
    command.add_argument(
        "--samples",
        type=int,
        default=None,
        metavar="N",
        help="real time: samples per pixel, where the GPU has them (default: 4)",
    )


def parse_settings(options: argparse.Namespace) -> PictureSettings:
    """Return the settings that the options ask for."""
    from brdf_suite.output.picture_file import PictureSettings

    picture = PictureSettings(options.bits, options.colour_space, transparent=options.transparent)
    return picture if options.samples is None else replace(picture, samples=options.samples)

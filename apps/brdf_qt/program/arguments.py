"""Arguments that every program's command line has."""

from __future__ import annotations

import argparse

from brdf_qt.program.translation import languages

_LARGEST = 20_000


def add_language(parser: argparse.ArgumentParser) -> None:
    """Add the option that sets the language for one run."""
    parser.add_argument(
        "--language", choices=languages(), help="language of this run (default: the one chosen last)"
    )


def window_size(text: str) -> tuple[int, int]:
    """Parse ``WIDTHxHEIGHT`` in pixels (an argparse type)."""
    width, _, height = text.partition("x")
    if not (width.isdecimal() and height.isdecimal()) or not all(
        0 < int(n) < _LARGEST for n in (width, height)
    ):
        raise argparse.ArgumentTypeError(f"{text!r} is no size; give WIDTHxHEIGHT in pixels, as in 1280x800")
    return int(width), int(height)

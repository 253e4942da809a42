"""The option that says how an environment's image is laid out, the same for every command that reads one."""

from __future__ import annotations

import argparse

# Those of lighting.layouts, which --help does not wait for; a test holds the two together.
LAYOUTS = (
    "latlong",
    "horizontal_cross",
    "vertical_cross",
    "horizontal_strip",
    "vertical_strip",
    "exr_cube",
    "angular",
    "mirror_ball",
    "dome",
)


def add_layout(command: argparse.ArgumentParser) -> None:
    """Declare ``--layout``."""
    command.add_argument(
        "--layout",
        choices=("auto", *LAYOUTS),
        default="auto",
        metavar="LAYOUT",
        help="how the image is laid out, where its shape misleads: "
        + ", ".join(LAYOUTS)
        + " (default: auto)",
    )

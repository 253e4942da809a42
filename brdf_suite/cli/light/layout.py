"""Command-line option for the layout of an environment's image, shared by all commands that read one."""

from __future__ import annotations

import argparse

from brdf_suite.documents.view import ENVIRONMENT_LAYOUTS


def add_layout(command: argparse.ArgumentParser) -> None:
    """Declare ``--layout``."""
    command.add_argument(
        "--layout",
        choices=ENVIRONMENT_LAYOUTS,
        default="auto",
        metavar="LAYOUT",
        help="how the image is laid out, where its shape misleads: "
        + ", ".join(ENVIRONMENT_LAYOUTS[1:])
        + " (default: auto)",
    )

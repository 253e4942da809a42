"""``brdf-suite environment …``: facts about environment maps, and maps and lights made from them.

Each action is a module of its own, with ``add(actions)`` and ``run(arguments) -> int``.
"""

from __future__ import annotations

import argparse

from brdf_suite.cli.light import info as environment_info
from brdf_suite.cli.light import lights as environment_lights
from brdf_suite.cli.light import studio_and_sky as environment_light


def add(command: argparse.ArgumentParser) -> None:
    """Declare the command and its actions."""
    command.description = (
        "Look into an environment: an .exr, .hdr or .brdfstudio file, or a shipped one (booth, sunny, "
        "overcast); or make one."
    )
    actions = command.add_subparsers(dest="action", metavar="ACTION", required=True)
    for module in (environment_info, environment_lights, environment_light):
        module.add(actions)

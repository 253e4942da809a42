"""The ``brdf-suite`` command: its arguments, its exit statuses, and nothing else.

Each command is a module with ``add(subparsers)`` and ``run(arguments) -> int``, imported here so that
``--help`` knows it; what a command needs beyond the standard library, it imports when it runs.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from importlib.metadata import version

from brdf_suite.cli import bench, check, compare, convert, fit, measure, prefilter, programs, render
from brdf_suite.errors import Cancelled, SuiteError

DONE, FAILED, USAGE, CANCELLED = 0, 1, 2, 130

_EPILOG = """\
units:
  L*a*b*        CIE 1976, illuminant D65, 10° observer; aspecular angles in degrees from the mirror
                direction, light at 45°
  gloss         gloss units (GU) at 20° and 60°, ASTM D523
  exposure      EV: +1 doubles the light; rotation in degrees, counter-clockwise seen from above
  size          pixels, as WIDTHxHEIGHT; meshes in metres, texture coordinates in millimetres

exit status:
  0 done    1 failed, with one line that says why    2 wrong arguments    130 cancelled

Without a command the Designer and the Viewer open, linked. Where there is no screen, the default scene
is rendered to brdf-suite.png in the working folder instead.
"""


def parser() -> argparse.ArgumentParser:
    """Return the parser of the whole command."""
    top = argparse.ArgumentParser(
        prog="brdf-suite",
        description="Design the appearance of automotive paint, fit it, and render it.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    top.add_argument("--version", action="version", version=f"brdf-suite {version('brdf-suite')}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND")
    for module in (programs, render, measure, compare, convert, check, fit, prefilter, bench):
        module.add(commands)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command with ``arguments`` (default: the process's) and return its exit status."""
    options = parser().parse_args(arguments)
    run = getattr(options, "run", programs.open_both)
    try:
        return int(run(options))
    except (Cancelled, KeyboardInterrupt):
        print("brdf-suite: cancelled", file=sys.stderr)
        return CANCELLED
    except SuiteError as error:
        print(f"brdf-suite: {error}", file=sys.stderr)
        return FAILED


if __name__ == "__main__":
    sys.exit(main())

"""Entry point of the ``brdf-suite`` command: arguments and exit statuses.

Each command is a module with ``add(parser)``, which declares its arguments. Only the module of the command that is
named is imported: ``--help`` needs none of them.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Container, Sequence
from importlib import import_module

from brdf_suite.cli import default_action
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.processes import MODULE_OPTION, is_own_module, run_module

DONE, FAILED, USAGE, CANCELLED = 0, 1, 2, 130

COMMANDS = {
    "render": ("picture.render", "render a paint or a measured file to a PNG or EXR"),
    "turntable": ("picture.turntable", "render one turn of the object to a video or a folder of PNG"),
    "sheet": (
        "picture.sheet",
        "render the paints of a palette or a folder to one PNG or PDF, with their figures",
    ),
    "measure": (
        "measured.measure",
        "measure paints and measured files: colour per angle, gloss, haze, flop, travel",
    ),
    "compare": (
        "measured.compare",
        "compare two paints or measured files: colour differences per angle, RMS and log error",
    ),
    "judge": (
        "paint.judge",
        "judge batches against a standard: differences per angle, pass or fail, in words",
    ),
    "design": ("paint.design", "make a paint: from a measurement, a step away, or between two"),
    "convert": (
        "measured.convert",
        "convert a measured file, or a paint, to a format of measured reflectance",
    ),
    "export": ("paint.export", "hand paints over to other programs, or make a one-page report"),
    "project": ("paint.project", "pack paints, views, lights and what they name; list and collect"),
    "palette": ("palette.palette", "convert a palette, describe one, or find paints in it"),
    "check": ("measured.check", "check a paint, a measured file or a model: reciprocity, sign, energy"),
    "acquire": ("measured.acquire", "make a reflectance table from photographs of a painted sphere"),
    "fit": ("measured.fit", "fit the cosine lobes to a paint or a measured file"),
    "fit-cook-torrance": (
        "measured.fit_cook_torrance",
        "fit Cook-Torrance lobes to a measured file and write them as a paint",
    ),
    "represent": (
        "measured.represent",
        "compare cosine lobes, Cook-Torrance lobes and factors of one reflectance",
    ),
    "factorize": ("measured.factorize", "write anything that reflects as a product of textures"),
    "basis": ("tools.basis", "search the lobe exponents that fit a database of paints best"),
    "prefilter": ("light.prefilter", "prefilter an environment, its maps kept in the cache"),
    "environment": (
        "light.environment",
        "what an environment map holds; studios and skies from a description",
    ),
    "cache": (
        "tools.cache",
        "show, check or empty the cache of prefiltered maps, baked occlusion and pictures of paints",
    ),
    "shading-table": ("tools.shading_table", "make the table by which the shading looks lobes up"),
    "agreement": ("tools.agreement", "compare the real-time picture with the path-traced one"),
    "bench": ("tools.bench", "measure the suite's figures (in a source checkout)"),
}
"""The commands but those that open a program: the module of each in this package, and what it does."""

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


class _Rows(argparse.RawDescriptionHelpFormatter):
    """Help formatter with a column wide enough for command names."""

    def add_argument(self, action: argparse.Action) -> None:
        """Count the indent of a command, which the base class ignores: otherwise its help starts on the next line."""
        super().add_argument(action)
        for command in self._iter_indented_subactions(action):
            width = (
                len(self._format_action_invocation(command)) + self._current_indent + self._indent_increment
            )
            self._action_max_length = max(self._action_max_length, width)


class _Version(argparse.Action):
    """Prints the version; what reads it takes as long to import as all else that ``--help`` needs."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        """Print it and end."""
        from importlib.metadata import version

        print(f"brdf-suite {version('brdf-suite')}")
        parser.exit()


def parser(wanted: Container[str] = ()) -> argparse.ArgumentParser:
    """Return the parser of the whole command, with the arguments of those commands that are ``wanted``."""
    top = argparse.ArgumentParser(
        prog="brdf-suite",
        description="Design the appearance of automotive paint, fit it, and render it.",
        epilog=_EPILOG,
        formatter_class=_Rows,
    )
    top.add_argument("--version", action=_Version, nargs=0, help="show program's version number and exit")
    commands = top.add_subparsers(dest="command", metavar="COMMAND")
    default_action.add(commands)
    for name, (module, summary) in COMMANDS.items():
        command = commands.add_parser(name, help=summary)
        if name in wanted:
            import_module(f"brdf_suite.cli.{module}").add(command)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command with ``arguments`` (default: the process's) and return its exit status."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    if given[:1] == [MODULE_OPTION]:
        return _run_module(given[1:])
    try:
        if given and given[0] in default_action.PROGRAMS:
            # argparse would take the program's options for its own.
            return default_action.open_one(given[0], given[1:])
        try:
            options = parser(given[:1]).parse_args(given)
            status = int(getattr(options, "run", default_action.open_both)(options))
        finally:
            if sys.stdout is not None:  # None where the caller closed it
                sys.stdout.flush()  # here and not at exit, where a failure can no longer be reported
        return status
    except BrokenPipeError:  # the reader of our output wants no more, as `head` does
        _drop_output()
        return FAILED
    except OSError as error:
        if error.filename is not None or error.errno is None:
            raise  # about a file: the code that opened it should have reported it
        _drop_output()
        print(f"brdf-suite: the output cannot be written: {error.strerror}.", file=sys.stderr)
        return FAILED
    except (Cancelled, KeyboardInterrupt):
        print("brdf-suite: cancelled", file=sys.stderr)
        return CANCELLED
    except SuiteError as error:
        # One line, also where a name that was typed has line breaks.
        print("brdf-suite: " + " ".join(str(error).splitlines()), file=sys.stderr)
        return FAILED


def _run_module(words: Sequence[str]) -> int:
    """Run the module that ``--module`` names, which is how a frozen build starts its child processes."""
    if not words or not is_own_module(words[0]):
        print(f"brdf-suite: {MODULE_OPTION} takes the name of a module of the suite.", file=sys.stderr)
        return USAGE
    run_module(words[0], words[1:])
    return DONE


def _drop_output() -> None:
    """Discard buffered output, which would fail again at exit."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


if __name__ == "__main__":
    sys.exit(main())

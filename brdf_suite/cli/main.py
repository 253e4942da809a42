"""Entry point of the ``brdf-suite`` command: arguments and exit statuses.

Each command is a module with ``add(parser)``, which declares its arguments. Only the module of the command that is
named is imported: ``--help`` needs none of them.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Container, Sequence
from importlib import import_module
from pathlib import Path
from time import perf_counter

from brdf_suite.cli import default_action
from brdf_suite.cli.output import print_error
from brdf_suite.cli.streams import closed_output, streams, visible_streams
from brdf_suite.command_parser import LOG, CommandParser, set_loudness
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.interrupts import interrupts_between_imports
from brdf_suite.processes import prepare_streams, run_named_module
from brdf_suite.variables import VARIABLES

DONE, FAILED, CANCELLED = 0, 1, 130

COMMANDS = {
    "render": ("picture.render", "render a paint or a measured file to a PNG or EXR"),
    "turntable": ("picture.turntable", "render one turn of the object to a video or a folder of PNG"),
    "sheet": (
        "picture.sheet",
        "render the paints of a palette or a folder to one PNG or PDF, with their figures",
    ),
    "thumbnail": ("picture.thumbnail", "draw the small picture of a document, for file managers"),
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
    "list": (
        "tools.listing",
        "list paints, environments, surfaces, formats, models, geometries, plugins, schemas, variables",
    ),
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
    "batch": ("tools.batch", "do one step with thousands of paints, on all cores or on a cluster"),
    "agreement": ("tools.agreement", "compare the real-time picture with the path-traced one"),
    "completion": ("tools.completion", "print the completion of a shell, or the pages of the manual"),
    "bench": ("tools.bench", "measure the suite's figures (in a source checkout)"),
}
"""The commands but those that open a program: the module of each in this package, and what it does."""

if not (Path(__file__).resolve().parents[2] / "tests" / "benchmarks").is_dir():
    del COMMANDS["bench"]  # in an installed copy there is nothing to run

_SYNONYMS = {
    **{
        kind: f"list {kind}"
        for kind in (
            *(
                "paints",
                "environments",
                "surfaces",
                "formats",
                "models",
                "geometries",
                "plugins",
                "schemas",
                "variables",
            ),
        )
    },
    "ls": "list",
    "show": "viewer",
    "view": "viewer",
    "edit": "designer",
    "info": "palette info",
    "video": "turntable",
    "diff": "compare",
    "import": "design start",
}
"""What to propose for words that people try."""

_EPILOG = """\
words:
  PAINT         a shipped paint by name (`brdf-suite list paints`), or a file: .brdfpaint, .cxf, a
                measured file, an entry of a palette as FILE#ID
  PALETTE       a palette of any format, or a folder: all of its paints
  -             for a file that is read, standard input; after -o, standard output

units:
  L*a*b*        CIE 1976, illuminant D65, 10° observer; aspecular angles in degrees from the mirror
                direction, light at 45°
  gloss         gloss units (GU) at 20° and 60°, ASTM D523
  exposure      EV: +1 doubles the light; rotation in degrees, counter-clockwise seen from above
  size          pixels, as WIDTHxHEIGHT; meshes in metres, texture coordinates in millimetres

environment variables:
{}

exit status:
  0 done    1 failed, with one line that says why    2 wrong arguments    130 cancelled

Without a command the Designer and the Viewer open, linked. Where there is no screen, the default scene
is rendered to brdf-suite.png in the working folder instead.
""".format("\n".join(f"  {name:<27} {what}" for name, what in VARIABLES.items()))


def parser(wanted: Container[str] = ()) -> CommandParser:
    """Return the parser of the whole command, with the arguments of those commands that are ``wanted``."""
    top = CommandParser(
        prog="brdf-suite",
        description="Design the appearance of automotive paint, fit it, and render it.",
        epilog=_EPILOG,
    )
    top.synonyms = _SYNONYMS
    top.examples = (
        "brdf-suite                                  # Designer and Viewer, linked",
        "brdf-suite render blue -o blue.png",
        "brdf-suite list paints",
        "brdf-suite help render",
    )
    commands = top.add_subparsers(dest="command", metavar="COMMAND", title="commands")
    default_action.add(commands)
    for name, (module, summary) in COMMANDS.items():
        command = commands.add_parser(name, help=summary)
        if name in wanted:
            import_module(f"brdf_suite.cli.{module}").add(command)
    commands.add_parser("help", help="show the help of a command: help render")
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command with ``arguments`` (default: the process's) and return its exit status."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    prepare_streams()
    status = run_named_module(given)
    if status is not None:
        return status
    try:
        try:
            with closed_output(), visible_streams(), interrupts_between_imports():
                status = _run(given)
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
        print(f"brdf-suite: the output cannot be written: {error.strerror or error}.", file=sys.stderr)
        return FAILED
    except (Cancelled, KeyboardInterrupt):
        print("brdf-suite: cancelled", file=sys.stderr)
        return CANCELLED
    except SuiteError as error:
        print_error(error)
        return FAILED


def _run(given: list[str]) -> int:
    place = next((i for i, word in enumerate(given) if not word.startswith("-")), len(given))
    first = "".join(given[place : place + 1])
    if first == "help":
        given = [*given[place + 1 :], "--help"]
        first = given[0]
    if first in default_action.PROGRAMS:
        # argparse would take the program's options for its own.
        return default_action.open_one(first, [*given[:place], *given[place + 1 :]])
    options = parser((first,)).parse_args(given)
    set_loudness(options)
    with streams(options):
        started = perf_counter()
        try:
            return int(getattr(options, "run", default_action.open_both)(options))
        except SuiteError as error:
            # Here, where standard input still has its name.
            if isinstance(error, Cancelled):
                raise
            LOG.debug("where it failed", exc_info=error)
            print_error(error)
            return FAILED
        finally:
            LOG.info("%s: %.2f s", options.parser.prog, perf_counter() - started)


def _drop_output() -> None:
    """Discard buffered output, which would fail again at exit."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


if __name__ == "__main__":
    sys.exit(main())

"""``brdf-suite basis``: search for the exponents that best fit a paint database (Westlund and Meyer, section 3.2)."""

from __future__ import annotations

import argparse
import shlex
import sys
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from brdf_suite.cli.arguments import add_arguments, add_export, add_output, whole_number
from brdf_suite.cli.output import export_progress, print_json
from brdf_suite.cli.tools.measurements import describe_machine
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.fitting.basis_search import document
from brdf_suite.fitting.basis_search.database import load_database
from brdf_suite.fitting.basis_search.search import CountResult, search, usable_cores
from brdf_suite.release import __version__
from brdf_suite.resources import resource_root

_OUTPUT = Path("basis.json")
_MOST_STARTS, _MOST_WORKERS = 64, 64
_LIBRARIES = ("numpy", "scipy", "highspy")


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Search the exponents of the fixed cosine lobes: one lobe is added at a time, and each count is "
        "optimized from several starts by Levenberg-Marquardt and a polish of maximum plus mean error. The same "
        "command on the same machine gives the same file. What is found is kept in FILE.part after each count; the "
        "same command resumes from there."
    )
    add_arguments(
        command,
        {
            "--database FOLDER": "a folder of .brdfpaint files; default: the shipped paints",
            "--lobes N=11": "the largest count, 1 to 12; default: 11",
            "--starts N=4": "starts per count; default: 4",
            "--workers N": "processes; default: one per core",
            "--default N": "the count to be the default; left out, the rule of docs/method/basis.md chooses",
            "--fresh": "forget what an interrupted search found",
        },
        lobes=whole_number(1, 12),
        starts=whole_number(2, _MOST_STARTS),
        workers=whole_number(1, _MOST_WORKERS),
        default=whole_number(1, 12),
    )
    command.examples = ("brdf-suite basis --database paints -o basis.json --lobes 8",)
    add_output(command, f"the file to write (default: {_OUTPUT})", required=False)
    command.set_defaults(output=_OUTPUT)
    add_export(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Search, write the file and print the table."""
    if options.default is not None and options.default > options.lobes:
        raise SuiteError(f"--default {options.default} is more than the {options.lobes} lobes of the search.")
    database = load_database(options.database or resource_root() / "paints")
    settings = document.settings_of(database, options.starts)
    state = options.output.with_name(options.output.name + ".part")
    done = [] if options.fresh else document.load_state(state, settings)
    workers = options.workers or usable_cores()
    results = list(done)

    def found(result: CountResult) -> None:
        results.append(result)
        document.save_state(state, settings, results)

    document.save_state(state, settings, results)  # a folder that cannot be written is reported now
    try:
        with export_progress("basis", options) as progress:
            search(
                database,
                options.lobes,
                starts=options.starts,
                workers=workers,
                done=done,
                progress=progress,
                found=found,
            )
    except (Cancelled, KeyboardInterrupt):
        print(
            f"brdf-suite: {len(results)} of {options.lobes} counts are kept in {state}; "
            "the same command resumes from there.",
            file=sys.stderr,
        )
        raise
    except SuiteError:
        if not results:  # refused before anything was found: nothing to resume from
            state.unlink(missing_ok=True)
        raise
    results = results[: options.lobes]
    answer = document.save_basis(
        options.output,
        database.names,
        results,
        options.default or document.choose_default(results),
        _provenance(options, database.sha256, workers, len(done), results),
    )
    state.unlink(missing_ok=True)
    if options.json:
        print_json(answer)
    else:
        _print(options.output, answer["default_count"], results)
    return 0


def command_line(options: argparse.Namespace, workers: int) -> str:
    """Return the command that makes this answer again; what was left out and has one default stays out."""
    output = None if options.output == _OUTPUT else options.output
    given = {"--lobes": options.lobes, "--starts": options.starts, "--workers": workers}
    given |= {"--database": options.database, "-o": output, "--default": options.default}
    words = [str(word) for pair in given.items() if pair[1] is not None for word in pair]
    return shlex.join(["brdf-suite", "basis", *words])


def _provenance(
    options: argparse.Namespace, sha256: str, workers: int, resumed: int, results: list[CountResult]
) -> dict[str, object]:
    """Return how, where and when the answer was made."""
    machine = describe_machine()
    return {
        "command": command_line(options, workers),
        "database_sha256": sha256,
        "starts": options.starts,
        "workers": workers,
        "counts_of_an_interrupted_run": resumed,
        "seconds": sum(result.seconds for result in results),
        "evaluations": sum(result.evaluations for result in results),
        "date": datetime.now(UTC).date().isoformat(),
        "versions": {
            "brdf-suite": __version__,
            **{name: version(name) for name in _LIBRARIES},
            "python": str(machine["python"]),
        },
        "processor": machine["processor"],
        "cores": machine["cores"],
        "system": machine["system"],
    }


def _print(path: Path, default: object, results: list[CountResult]) -> None:
    print(f"{'lobes':>5} {'maximum':>8} {'mean':>8} {'seconds':>8}  exponents")
    for result in results:
        mean = sum(result.errors) / len(result.errors)
        exponents = ", ".join(f"{exponent:,.4g}" for exponent in result.exponents)
        mark = "*" if result.count == default else " "
        print(
            f"{result.count:4}{mark} {max(result.errors):8.3f} {mean:8.3f} {result.seconds:8.1f}  {exponents}"
        )
    print(f"{path}: {len(results)} counts, {sum(result.seconds for result in results):.0f} s; * the default")

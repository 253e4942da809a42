"""Pages of the manual, one for each command, made from its parser."""

from __future__ import annotations

import argparse
import subprocess
from collections.abc import Iterator
from pathlib import Path

from brdf_suite.cli.default_action import PROGRAMS
from brdf_suite.cli.output import print_done
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.atomic import make_folder, write_atomically
from brdf_suite.errors import SuiteError, did_you_mean
from brdf_suite.processes import child_command
from brdf_suite.regular_files import is_folder

_ENDING = ".1"
_NO_COMMANDS = {"help"}


def print_manual(top: CommandParser, output: Path | None) -> int:
    """Print the page of ``top``, or write the one that ``output`` is called after, or all into the folder."""
    if output is None:
        print(manual_page(top, top.prog), end="")
    elif output.suffix == _ENDING and not is_folder(output):
        name = top.prog if output.stem == "standard output" else output.stem
        write_atomically(output, manual_page(top, name).encode())
    else:
        make_folder(output)
        names = manual_names(top)
        for name in names:
            write_atomically(output / f"{name}{_ENDING}", manual_page(top, name).encode())
        print_done(f"{output}: {len(names)} pages")
    return 0


def parsers(of: CommandParser) -> Iterator[tuple[tuple[str, ...], CommandParser]]:
    """Yield the words and the parser of a command and of all commands below it."""
    yield tuple(of.prog.split(" ")), of
    for action in of._actions:
        if isinstance(action, argparse._SubParsersAction):
            for below in action.choices.values():
                yield from parsers(below)


def manual_names(top: CommandParser) -> list[str]:
    """Return the names of all pages."""
    return list(_paths(top))


def manual_page(top: CommandParser, name: str) -> str:
    """Return a page by its name, ``brdf-suite-render``; those of the programs are made by these.

    Raises
    ------
    SuiteError
        There is no such page, or a program cannot be started.
    """
    paths = _paths(top)
    if name not in paths:
        raise SuiteError(f"There is no page {name}{did_you_mean(name, list(paths))}.")
    path = paths[name]
    if path[-1] in PROGRAMS:
        command = child_command(PROGRAMS[path[-1]][0], "--manual")
        done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)  # noqa: S603 - a module of ours
        if done.returncode:
            raise SuiteError(f"The page {name} cannot be made: {done.stderr.strip()[-300:]}")
        return done.stdout
    near = [other for other, its in paths.items() if its[:-1] == path or its == path[:-1]]
    of = dict(parsers(top))
    return of[path].format_manual(_summaries(top).get(path, ""), near)


def _paths(top: CommandParser) -> dict[str, tuple[str, ...]]:
    return {"-".join(path): path for path, _ in parsers(top) if path[-1] not in _NO_COMMANDS}


def _summaries(top: CommandParser) -> dict[tuple[str, ...], str]:
    """Return what the commands do, as the list of commands says."""
    return {
        (*path, row.dest): row.help or ""
        for path, command in parsers(top)
        for action in command._actions
        if isinstance(action, argparse._SubParsersAction)
        for row in action._get_subactions()
    }

"""Write docs/command/reference.md: every command with its arguments, as the parser of ``brdf-suite`` has them.

Run ``.venv/bin/python packaging/documents/command_page.py [FILE]`` after a change of a command.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from brdf_suite.cli.main import COMMANDS, parser
from brdf_suite.cli.tools.completion import parsers
from brdf_suite.command_parser import CommandParser

PAGE = Path(__file__).resolve().parents[2] / "docs" / "command" / "reference.md"
_HEAD = """\
# All commands

Made from the parser by `packaging/documents/command_page.py`. Every command also has the general options below.
[Using the command](scripting.md) explains words, output and exit status.
"""
_PROGRAMS = {"designer", "viewer", "lobes", "swatch", "help"}
"""Their options are those of the programs; ``brdf-designer --help`` and so on list them."""


def command_page() -> str:
    """Return the page."""
    top = parser(COMMANDS)
    general = next(group for group in top._action_groups if group.title == "general")
    parts = [_HEAD, *_table("General options", general, top)]
    for path, command in parsers(top):
        if len(path) > 1 and path[1] not in _PROGRAMS:
            parts += _section(path, command)
    return "\n".join(parts)


def _section(path: tuple[str, ...], command: CommandParser) -> list[str]:
    usage = command.format_usage().removeprefix("usage: ").strip()
    parts = [f"## {' '.join(path[1:])}\n"]
    if command.description:
        parts.append(f"{_text(command.description)}\n")
    parts.append(f"    {usage}\n")
    for group in command._action_groups:
        if group.title not in ("general", "commands"):
            title = str(group.title).removeprefix("positional ").capitalize()
            parts += _table(title, group, command)
    if command.examples:
        parts.append("```\n" + "\n".join(command.examples) + "\n```\n")
    return parts


def _table(title: str, group: argparse._ArgumentGroup, command: CommandParser) -> list[str]:
    rows = [
        f"| {_names(action)} | {_text(command._get_formatter()._expand_help(action)) if action.help else ''} |"
        for action in group._group_actions
        if action.help != argparse.SUPPRESS and not isinstance(action, argparse._SubParsersAction)
    ]
    return [f"| {title} | |\n|---|---|\n" + "\n".join(rows) + "\n"] if rows else []


def _names(action: argparse.Action) -> str:
    if not action.option_strings:
        return f"`{action.metavar or action.dest}`"
    value = "" if action.nargs == 0 else f" {_value(action)}"
    return ", ".join(f"`{name}{value}`" for name in action.option_strings)


def _value(action: argparse.Action) -> str:
    if isinstance(action.metavar, tuple):
        return " ".join(action.metavar)
    if action.metavar is not None:
        return str(action.metavar).replace("|", " or ")  # in the code of a table readers differ about pipes
    return "{" + ",".join(map(str, action.choices)) + "}" if action.choices else action.dest.upper()


def _text(text: str) -> str:
    """Return help as Markdown shows it in a table: one line, signs as they are."""
    for sign in "\\*_<[|":
        text = text.replace(sign, f"\\{sign}")
    return " ".join(text.split())


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else PAGE
    target.write_text(command_page(), encoding="utf-8")

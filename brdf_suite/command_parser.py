"""Parser of the suite's command lines: one-line usage, errors that name what was meant, options that all have."""

from __future__ import annotations

import argparse
import logging
import sys
from collections.abc import Mapping, Sequence
from itertools import takewhile
from pathlib import Path
from typing import Any, NoReturn, cast

from brdf_suite.errors import did_you_mean
from brdf_suite.foreign_text import make_visible
from brdf_suite.release import __version__

USAGE = 2
"""Exit status of wrong arguments."""


LOG = logging.getLogger("brdf_suite")
"""The log of the suite; its level is that of ``--quiet`` and ``--verbose``."""
_HANDLER = "command line"


def set_loudness(options: argparse.Namespace) -> None:
    """Print from now on as much of the log on standard error as ``--quiet`` and ``--verbose`` ask for."""
    for before in [one for one in LOG.handlers if one.name == _HANDLER]:
        LOG.removeHandler(before)
    LOG.setLevel(
        logging.DEBUG if "verbose" in options else logging.ERROR if "quiet" in options else logging.NOTSET
    )
    if "verbose" in options:
        shown = logging.StreamHandler(sys.stderr)
        shown.name = _HANDLER
        shown.setFormatter(_VisibleLines("%(name)s: %(message)s"))
        LOG.addHandler(shown)


class _VisibleLines(logging.Formatter):
    """Log lines in which characters that are not seen are shown: they may hold names from files."""

    def format(self, record: logging.LogRecord) -> str:
        """Return the line of a record."""
        return make_visible(super().format(record))


class _Rows(argparse.HelpFormatter):
    """Help formatter with a column wide enough for command names; it wraps only paragraphs of one line."""

    def add_argument(self, action: argparse.Action) -> None:
        """Count the indent of a command, which the base class ignores: otherwise its help starts on the next line."""
        super().add_argument(action)
        for command in self._iter_indented_subactions(action):
            width = (
                len(self._format_action_invocation(command)) + self._current_indent + self._indent_increment
            )
            self._action_max_length = max(self._action_max_length, width)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        wrap = super()._fill_text
        return "\n\n".join(part if "\n" in part else wrap(part, width, indent) for part in text.split("\n\n"))


class _Version(argparse.Action):
    """Prints the version."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        """Print it and end."""
        print(f"brdf-suite {__version__}")
        parser.exit()


class _Manual(argparse.Action):
    """Prints the page of the manual, as the command that collects all of them asks for it."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        """Print it and end."""
        print(cast(CommandParser, parser).format_manual(), end="")
        parser.exit()


class CommandParser(argparse.ArgumentParser):
    """Parser with ``--help``, ``--version``, ``--quiet`` and ``--verbose``, as have the parsers of its commands.

    A wrong argument is answered by two lines: what is wrong, with the nearest that there is, and the usage of the
    command that was given it. The namespace has the parser of the innermost command as ``parser``.

    Attributes
    ----------
    examples
        Command lines, shown below the help.
    synonyms
        What to propose for words that are no command.
    wanted
        Options that the usage shows as if they were required, by their names in the namespace.
    """

    def __init__(self, **given: Any) -> None:
        given.setdefault("formatter_class", _Rows)
        super().__init__(**{**given, "add_help": False})
        self.examples: Sequence[str] = ()
        self.synonyms: Mapping[str, str] = {}
        self.wanted: set[str] = set()
        self.set_defaults(parser=self)
        general = self.add_argument_group("general")
        # Without defaults: what is given before a command counts for it.
        missing = argparse.SUPPRESS
        general.add_argument("-h", "--help", action="help", help="show this help and end")
        general.add_argument("--version", action=_Version, nargs=0, help="show the version and end")
        general.add_argument("--manual", action=_Manual, nargs=0, help=argparse.SUPPRESS)
        loudness = general.add_mutually_exclusive_group()
        loudness.add_argument(
            "-q", "--quiet", action="store_true", default=missing, help="results and errors only"
        )
        loudness.add_argument(
            "-v", "--verbose", action="store_true", default=missing, help="show the log, on standard error"
        )

    @property
    def has_commands(self) -> bool:
        """Whether the first word is a command with a parser of its own."""
        return any(isinstance(action, argparse._SubParsersAction) for action in self._actions)

    def format_usage(self) -> str:
        """Return the usage in one line: what is given by place or required, and that there are options."""
        words = [self.prog]
        for action in self._actions:
            if action.help == argparse.SUPPRESS:
                continue
            name = str(action.metavar or action.dest)
            if not action.option_strings:
                form = {"?": "[{}]", "+": "{}...", "*": "[{}...]", argparse.PARSER: "{} ..."}
                words.append(form.get(str(action.nargs), "{}").format(name))
            elif action.required or action.dest in self.wanted:
                words += [action.option_strings[0], name]
        return f"usage: {' '.join(words)} [OPTION...]\n"

    def format_help(self) -> str:
        """Return the help, with the general options after all others and the examples last."""
        groups = self._action_groups
        groups.append(groups.pop([group.title for group in groups].index("general")))
        self.usage = self.format_usage().removeprefix("usage: ").strip().replace("%", "%%")
        text = super().format_help()
        if not self.examples:
            return text
        return f"{text}\nexamples:\n" + "".join(f"  {line}\n" for line in self.examples)

    def format_manual(self, summary: str = "", see_also: Sequence[str] = ()) -> str:
        """Return the command's page of the manual, in the macros of man(7).

        Parameters
        ----------
        summary
            What it does in a few words; left out, the first sentence of the description.
        see_also
            Names of other pages.
        """
        name = self.prog.replace(" ", "-")
        summary = summary or (self.description or self.prog).partition(".")[0]
        page = [
            f'.TH "{_roff(name.upper())}" 1 "" "BRDF Suite {__version__}" "User commands"',
            ".SH NAME",
            f"{_roff(name)} \\- {_roff(summary)}",
            ".SH SYNOPSIS",
            _roff(self.format_usage().removeprefix("usage: ").strip()),
        ]
        if self.description:
            page += [".SH DESCRIPTION", _roff(self.description)]
        formatter = self._get_formatter()
        for group in sorted(self._action_groups, key=lambda group: group.title == "general"):
            rows = [row for action in group._group_actions for row in _manual_rows(action, formatter)]
            if rows:
                title = "arguments" if group.title == "positional arguments" else group.title or ""
                page += [f'.SH "{_roff(title.upper())}"', *rows]
        for part in (self.epilog or "").split("\n\n"):
            title, _, rest = part.partition("\n")
            if rest and title.endswith(":"):
                page += [
                    f'.SH "{_roff(title.rstrip(":").upper())}"',
                    ".nf",
                    *map(_roff, rest.splitlines()),
                    ".fi",
                ]
            elif part:
                page += [".PP", _roff(" ".join(part.split()))]
        if self.examples:
            page += [".SH EXAMPLES", ".nf", *map(_roff, self.examples), ".fi"]
        if see_also:
            page += [".SH SEE ALSO", ", ".join(f"{_roff(other)}(1)" for other in see_also)]
        return "\n".join(page) + "\n"

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        """Parse as the base class does; what is not known is an error of this command and not of the outermost."""
        words = [*(sys.argv[1:] if args is None else args)]
        if not self.has_commands:  # before what is missing, which may be what was misspelt
            for word in takewhile(lambda one: one != "--", words):
                if word.startswith("--"):
                    self._check_option(word.partition("=")[0])
        found, left = super().parse_known_args(words, namespace)
        if left:
            self._check_option(left[0])
            self.error(f"{left[0]!r} is one argument too many")
        return found, left

    def error(self, message: str) -> NoReturn:
        """End with the message and the usage of this command."""
        self.exit(USAGE, f"{self.prog}: {message}\n{self.format_usage()}")

    def _check_option(self, name: str) -> None:
        known = [*self._option_string_actions]
        if name.startswith("-") and not any(one.startswith(name) for one in known):
            near = did_you_mean(name, [one for one in known if one.startswith("--")])
            self.error(f"there is no option {name}" + near)

    def _get_value(self, action: argparse.Action, arg_string: str) -> Any:
        # An unset variable of a shell; as a path it would be the working folder.
        if action.type is Path and not arg_string:
            raise argparse.ArgumentError(action, "a file or a folder has no empty name")
        return super()._get_value(action, arg_string)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is None or value in action.choices:
            return
        names = [str(choice) for choice in action.choices]
        if isinstance(action, argparse._SubParsersAction):
            meant = self.synonyms.get(value)
            near = did_you_mean(value, names) if meant is None else f"; did you mean {meant}?"
            self.error(f"there is no command {value!r}" + (near or f"; there are {', '.join(names)}"))
        raise argparse.ArgumentError(
            action, f"{value!r} is none of {', '.join(names)}{did_you_mean(str(value), names)}"
        )


def _manual_rows(action: argparse.Action, formatter: argparse.HelpFormatter) -> list[str]:
    """Return an argument for the manual, or each of a parser's commands."""
    if isinstance(action, argparse._SubParsersAction):
        commands = [(one.dest, one.help or "") for one in action._get_subactions()]
        return [row for name, does in commands for row in (".TP", f".B {_roff(name)}", _roff(does))]
    if action.help == argparse.SUPPRESS:
        return []
    written = formatter._format_action_invocation(action)
    return [".TP", f".B {_roff(written)}", _roff(formatter._expand_help(action) if action.help else "")]


def _roff(text: str) -> str:
    """Return a text as the macros of man(7) take it: no line of it a request, no dash a hyphen."""
    plain = text.replace("\\", "\\e").replace("-", "\\-").replace('"', "\\(dq")
    plain = "".join(one if one.isascii() else f"\\[u{ord(one):04X}]" for one in plain)
    return f"\\&{plain}" if plain.startswith((".", "'")) else plain

"""``brdf-suite completion``: completion scripts of shells, and the pages of the manual, made from the parser."""

from __future__ import annotations

import argparse
import shlex

from brdf_suite.cli.arguments import add_output
from brdf_suite.cli.tools.manual import parsers, print_manual
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.release import __version__

_PAINTS = "$(brdf-suite list paints --csv 2>/dev/null | cut -d, -f2 | tail -n +2)"


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Print what a shell needs to complete commands, options, their words and the names of paints; or pages of the "
        "manual: that of brdf-suite, the one that FILE is called after, as brdf-suite-render.1, or all of them where "
        "FILE is a folder. Both are made from the parser, so that they have every option."
    )
    command.examples = (
        "brdf-suite completion bash > ~/.local/share/bash-completion/completions/brdf-suite",
        "brdf-suite completion zsh >> ~/.zshrc",
        "brdf-suite completion fish > ~/.config/fish/completions/brdf-suite.fish",
        "brdf-suite completion man -o ~/.local/share/man/man1",
    )
    kinds = (*_KINDS, "man")
    command.add_argument("kind", metavar="KIND", choices=kinds, help=", ".join(kinds))
    written = "the file to write, of the manual also a folder (default: standard output)"
    add_output(command, written, stream=".1", required=False)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print or write the script or page."""
    from brdf_suite.cli.main import COMMANDS, parser

    top = parser(COMMANDS)
    if options.kind == "man":
        return print_manual(top, options.output)
    text = _KINDS[options.kind](top)
    if options.output is None:
        print(text, end="")
    else:
        write_atomically(options.output, text.encode())
    return 0


def _bash(top: CommandParser) -> str:
    words, after = [], []
    for path, command in parsers(top):
        given: dict[str, None] = {}
        for action in command._actions:
            if action.help == argparse.SUPPRESS:
                continue
            given |= dict.fromkeys(action.option_strings)
            choices = " ".join(map(str, action.choices or ()))
            if action.option_strings and choices:
                flags = "|".join(f'"{" ".join(path[1:])}:{flag}"' for flag in action.option_strings)
                after.append(
                    f'    {flags}) COMPREPLY=($(compgen -W {shlex.quote(choices)} -- "$word")); return ;;'
                )
            elif choices:
                given |= dict.fromkeys(choices.split())
        named = any(
            "PAINT" in str(action.metavar) for action in command._actions if not action.option_strings
        )
        paints = f" {_PAINTS}" if named else ""
        words.append(f'    "{" ".join(path[1:])}") words="{" ".join(given)}{paints}" ;;')
    path_words = "|".join(sorted({word for path, _ in parsers(top) for word in path[1:]}))
    return f"""\
# Completion of brdf-suite {__version__} for bash.
_brdf_suite() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" path="" each words=""
  for each in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$each" in {path_words}) path="${{path:+$path }}$each" ;; *) [ -n "$path" ] && break ;; esac
  done
  case "$path:$before" in
{chr(10).join(after)}
  esac
  case "$path" in
{chr(10).join(words)}
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _brdf_suite brdf-suite
"""


def _zsh(top: CommandParser) -> str:
    return f"autoload -U +X bashcompinit && bashcompinit\n{_bash(top)}"


def _fish(top: CommandParser) -> str:
    lines = [f"# Completion of brdf-suite {__version__} for fish."]
    for path, command in parsers(top):
        seen = " ".join(f"__fish_seen_subcommand_from {word};" for word in path[1:]).replace("; _", "; and _")
        when = shlex.quote(seen.rstrip(";") or "__fish_use_subcommand")
        for action in command._actions:
            if isinstance(action, argparse._SubParsersAction):
                for row in action._get_subactions():
                    lines.append(
                        f"complete -c brdf-suite -n {when} -f -a {row.dest} -d {shlex.quote(row.help or '')}"
                    )
            elif action.option_strings and action.help != argparse.SUPPRESS:
                flags = [
                    f"-l {flag[2:]}" if flag.startswith("--") else f"-s {flag[1:]}"
                    for flag in action.option_strings
                ]
                choices = shlex.quote(" ".join(map(str, action.choices or ())))
                value = "" if action.nargs == 0 else f" -x -a {choices}" if action.choices else " -r"
                text = shlex.quote((action.help or "").replace("%%", "%"))
                lines.append(f"complete -c brdf-suite -n {when} {' '.join(flags)}{value} -d {text}")
            elif "PAINT" in str(action.metavar):
                lines.append(f"complete -c brdf-suite -n {when} -a '({_PAINTS[2:-1]})'")
    return "\n".join(lines) + "\n"


_KINDS = {"bash": _bash, "zsh": _zsh, "fish": _fish}

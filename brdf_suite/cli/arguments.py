"""Declaration of arguments: how each is written, what it is read as, and the options that several commands have."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import did_you_mean

PAINT = (
    "a name (`brdf-suite list paints`), or a file: .brdfpaint, .cxf, measured, or an entry of a palette, FILE#ID; - is "
    "standard input"
)
PAINTS = f"{PAINT}; a palette or a folder stands for all of its paints"

_SIZE = re.compile(r"([1-9]\d{0,4})[x×X]([1-9]\d{0,4})")
_LARGEST = 65_536


def size(text: str) -> tuple[int, int]:
    """Parse ``WIDTHxHEIGHT`` in pixels, each 1 to 65,536 (an argparse type)."""
    match = _SIZE.fullmatch(text)
    if match is None:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a size; write WIDTHxHEIGHT in pixels, as in 1280x720"
        )
    width, height = int(match[1]), int(match[2])
    if max(width, height) > _LARGEST:
        raise argparse.ArgumentTypeError(f"{text} is too large; each side is at most {_LARGEST} pixels")
    return width, height


def whole_number(low: int, high: int) -> Callable[[str], int]:
    """Return what parses a whole number from ``low`` to ``high`` (an argparse type)."""

    def parse(text: str) -> int:
        if not (text.isascii() and text.isdigit() and len(text) < 10 and low <= int(text) <= high):
            raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from {low:,} to {high:,}")
        return int(text)

    return parse


_KINDS: Mapping[str, Callable[[str], object]] = {
    **dict.fromkeys(("K", "N"), int),
    **dict.fromkeys(("A", "DEG", "E", "EV", "L", "M", "S", "T", "UNITS", "X"), float),
    **dict.fromkeys(("FILE", "FOLDER"), Path),
    "WxH": size,
}
"""What an argument is read as, by the word that stands for it; a text where its word is none of these."""


def add_arguments(
    command: argparse._ActionsContainer,
    texts: Mapping[str, str],
    **kinds: Callable[[str], object] | Sequence[str],
) -> None:
    """Declare arguments: how each is written, and its help text.

    ``"paint PAINT"`` is given by place, ``"paint [PAINT]"`` may be left out, of ``"paint PAINT..."`` there are one or
    more. ``"-n/--count N=16"`` is an option with a value, 16 where it is not given; ``"--at X Y"`` takes two,
    ``"--form {png,pdf}"`` one of these words; ``"--fresh"`` takes none, ``"--[no-]fresh"`` can be denied.
    ``kinds`` has, by the arguments' names, what reads a value, or the words that are allowed.
    """
    for written, text in texts.items():
        left, _, default = written.removesuffix(" (required)").partition("=")
        names, *words = left.split(" ")
        flags = names.replace("[no-]", "").split("/")
        name = next((flag for flag in flags if flag.startswith("--")), flags[0]).lstrip("-").replace("-", "_")
        kind, word = kinds.get(name), words[0] if words else ""
        more: dict[str, Any] = {"help": text}
        if kind is None and not words:
            more["action"] = argparse.BooleanOptionalAction if "[no-]" in names else "store_true"
        else:
            reader = kind if callable(kind) else _KINDS.get(word.strip("[.]"), str)
            more |= {"type": reader, "default": default or None}
            if word.startswith("{"):
                more["choices"] = [reader(choice) for choice in word[1:-1].split(",")]
            else:
                more["metavar"] = tuple(words) if len(words) > 1 else word.strip("[.]") or None
        if kind is not None and not callable(kind):
            more["choices"] = kind
        if len(words) > 1:
            more["nargs"] = len(words)
        elif word.endswith("...") or word.startswith("["):
            more["nargs"] = "+" if word.endswith("...") else "?"
        if written.endswith(" (required)"):
            more["required"] = True
        command.add_argument(*flags, **more)


def add_output(
    command: CommandParser,
    text: str,
    *,
    stream: str | Callable[[argparse.Namespace], str] | None = None,
    required: bool = True,
    or_last: bool = False,
) -> None:
    """Declare ``-o FILE``.

    Parameters
    ----------
    text
        What is written.
    stream
        The ending of what ``-o -`` writes to standard output, or what finds it of the options; None where a file needs
        a name.
    or_last
        Left out, the last of the ``sources`` is the output, as ``cp`` has it.
    """
    if stream is not None:
        text += "; - is standard output"
    command.add_argument(
        "-o", "--output", metavar="FILE", type=Path, required=required and not or_last, help=text
    )
    if or_last:
        command.wanted.add("output")
    command.set_defaults(stream=stream, or_last=or_last)


def add_cmyk_profile(command: argparse._ActionsContainer) -> None:
    """Declare ``--cmyk-profile``."""
    command.add_argument(
        "--cmyk-profile",
        metavar="ICC",
        type=Path,
        help="the profile of a press, through which colours in CMYK are seen that bring none of their own",
    )


def add_json(command: CommandParser, *, csv: bool = False) -> None:
    """Declare ``--json``, and for a table ``--csv``."""
    form = command.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="print one JSON object")
    if csv:
        form.add_argument("--csv", action="store_true", help="print the table as comma-separated values")


def add_export(command: CommandParser) -> None:
    """Declare ``--json`` and ``--follow``."""
    add_json(command)
    command.add_argument(
        "--follow",
        action="store_true",
        help="print each step as a line of JSON, and stop when standard input ends: for programs",
    )


USUAL = {
    "cxf": ("cxf3", "cxf-3"),
    "openpbr": ("mtlx", "materialx"),
    "luxcore": ("scn", "lux"),
    "rgl": ("bsdf",),
    "gltf": ("glb",),
    "usd": ("usda",),
    "brdfpalette": ("palette",),
    "merl": ("binary",),
}
"""What formats are called beside their names."""


def add_format(command: CommandParser, endings: Mapping[str, Sequence[str]]) -> None:
    """Declare ``--format`` with the names of formats; each is also called as its ``endings`` are."""
    command.add_argument(
        "--format",
        type=named({name: (*USUAL.get(name, ()), *ends) for name, ends in endings.items()}),
        metavar="NAME",
        help=f"the format (default: what the ending of FILE names): {', '.join(endings)}; endings and usual names do "
        "too, as cxf3, mtlx, bsdf",
    )


def named(names: Mapping[str, Sequence[str]]) -> Callable[[str], str]:
    """Return what reads a format's name (an argparse type): by itself, by an ending, or by another usual name.

    ``names`` has what else a format is called, by its name.

    >>> named({"openpbr": (".mtlx", "materialx")})("mtlx")
    'openpbr'
    """
    usual = {other.lstrip("."): name for name, others in names.items() for other in reversed(others)}

    def parse(text: str) -> str:
        asked = text.lower().lstrip(".")
        known = asked if asked in names else usual.get(asked)
        if known is None:
            near = did_you_mean(asked, [*names, *usual])
            raise argparse.ArgumentTypeError(f"{text!r} is none of {', '.join(names)}{near}")
        return known

    return parse

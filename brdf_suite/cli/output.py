"""Output helpers shared by the commands: progress, JSON, sizes."""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import re
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

from brdf_suite.errors import Cancelled
from brdf_suite.progress import Progress

_SIZE = re.compile(r"([1-9]\d{0,4})[x×X]([1-9]\d{0,4})")
_LARGEST = 65_536
STAGE_END = " ..."
"""Ends the line of a stage on standard error, which sets it apart from notes and errors."""
_NUMBER = re.compile(r"\d[\d,.]*")


@contextmanager
def progress_bar(what: str, *, quiet: bool = False) -> Iterator[Progress]:
    """Show on standard error how far the body is: a bar on a terminal, else a line for each stage.

    A stage is what stands before a colon (:func:`brdf_suite.progress.stage`); numbers make no new one. ``quiet``
    shows nothing.
    """
    if quiet:
        yield lambda *_: None
        return
    if sys.stderr is None or not sys.stderr.isatty():
        yield _stage_lines()
        return
    from tqdm import tqdm

    form = "{desc:<28} {percentage:3.0f}% |{bar:30}| {elapsed}"
    with tqdm(total=1.0, desc=what, leave=False, bar_format=form) as bar:

        def show(fraction: float, doing: str) -> None:
            bar.set_description_str(doing.rpartition(": ")[2][:28], refresh=False)
            bar.update(fraction - bar.n)

        yield show


def _stage_lines() -> Progress:
    """Return a callback that prints the name of each stage and an ellipsis once, when it begins."""
    seen: set[str] = set()

    def show(fraction: float, doing: str) -> None:
        stage = doing.partition(": ")[0]
        key = _NUMBER.sub("0", stage)
        if key not in seen and fraction < 1.0:  # at 1 nothing begins any more
            seen.add(key)
            with contextlib.suppress(OSError, ValueError, AttributeError):  # standard error may be closed
                print(f"{stage}{STAGE_END}", file=sys.stderr, flush=True)

    return show


def print_json(value: Mapping[str, object]) -> None:
    """Print one JSON object. Numbers that are not finite are a fault, never printed as such."""
    print(json.dumps(value, indent=2, allow_nan=False, ensure_ascii=False))


def print_notes(notes: Iterable[str], word: str = "note") -> None:
    """Print notices, each on a line that begins with ``word``."""
    for note in notes:
        print(f"{word}: {note}")


def print_written(made: Any, line: str, *, as_json: bool, **changed: object) -> None:
    """Print what was written: its fields, with ``changed`` ones, as JSON; or its notices and then a line."""
    if as_json:
        facts = asdict(made) | changed
        facts["output"] = str(facts.pop("path"))
        print_json(facts)
        return
    print_notes(made.notices)
    print(line)


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
    **dict.fromkeys(("DIR", "FILE", "FOLDER", "IN", "OUT", "OUT.exr", "OUT.png", "PATH"), Path),
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


def add_export(command: argparse.ArgumentParser) -> None:
    """Declare ``--json`` and ``--follow``."""
    command.add_argument("--json", action="store_true", help="print what was done as one JSON object")
    command.add_argument(
        "--follow",
        action="store_true",
        help="print each step as a line of JSON, and stop when standard input ends: for programs",
    )


@contextmanager
def export_progress(what: str, options: argparse.Namespace) -> Iterator[Progress]:
    """Yield the callback that reports the progress of the body as the options ask for it."""
    if not options.follow:
        with progress_bar(what, quiet=options.json) as progress:
            yield progress
        return
    ended = threading.Event()

    def wait_for_the_end() -> None:
        # By the system's own call: a thread that waits in a buffered read would hold its lock at our exit.
        while os.read(sys.stdin.fileno(), 4096):
            pass
        ended.set()

    threading.Thread(target=wait_for_the_end, daemon=True).start()

    def report(fraction: float, doing: str) -> None:
        if ended.is_set():
            raise Cancelled
        try:
            print(json.dumps({"fraction": round(fraction, 4), "what": doing}), flush=True)
        except BrokenPipeError as error:  # the reader is gone
            raise Cancelled from error

    yield report

"""Output helpers shared by the commands: progress, JSON, sizes."""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import re
import sys
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict
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


def print_written(made: Any, line: str, *, as_json: bool, **changed: object) -> None:
    """Print what was written: its fields, with ``changed`` ones, as JSON; or its notices and then a line."""
    if as_json:
        facts = asdict(made) | changed
        facts["output"] = str(facts.pop("path"))
        print_json(facts)
        return
    for notice in made.notices:
        print(f"note: {notice}")
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

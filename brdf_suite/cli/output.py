"""What the commands print: results on standard output; progress, notes and losses on standard error."""

from __future__ import annotations

import argparse
import contextlib
import csv
import json
import logging
import os
import re
import sys
import threading
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict
from typing import Any

from brdf_suite.command_parser import LOG
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.foreign_text import guard_cells, make_visible
from brdf_suite.progress import Progress

STAGE_END = " ..."
"""Ends the line of a stage on standard error, which sets it apart from notes and errors."""
_NUMBER = re.compile(r"\d[\d,.]*")


def is_quiet() -> bool:
    """Return whether only results and errors are printed."""
    return not LOG.isEnabledFor(logging.WARNING)


@contextmanager
def progress_bar(what: str, *, quiet: bool = False) -> Iterator[Progress]:
    """Show on standard error how far the body is: a bar on a terminal, else a line for each stage.

    A stage is what stands before a colon (:func:`brdf_suite.progress.stage`); numbers make no new one. ``quiet``
    shows nothing.
    """
    if quiet or is_quiet():
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


def print_csv(rows: Iterable[Mapping[str, object]]) -> None:
    """Print a table of comma-separated values, the names of the columns first; nothing of no rows."""
    table = list(rows)
    if not table:
        return
    writer = csv.DictWriter(sys.stdout, list(table[0]), lineterminator="\n")
    writer.writeheader()
    for row in table:
        cells = {key: f"{v:.6g}" if isinstance(v, float) else v for key, v in row.items()}
        writer.writerow(guard_cells(cells))


def print_done(*lines: str) -> None:
    """Print what was done, such as the name of a written file; nothing where only results are wanted."""
    if not is_quiet():
        for line in lines:
            print(line)


def print_notes(notes: Iterable[str], word: str = "note") -> None:
    """Print notices on standard error, each on a line that begins with ``word``."""
    if not is_quiet():
        _print_lines(word, notes)


def print_problems(problems: Iterable[str]) -> None:
    """Print on standard error what failed while the rest was done, also where only results and errors are wanted."""
    _print_lines("problem", problems)


def _print_lines(word: str, lines: Iterable[str]) -> None:
    if sys.stderr is None:  # the caller closed it
        return
    for line in lines:
        print(f"{word}: {line}", file=sys.stderr)


def print_error(error: SuiteError) -> None:
    """Print what went wrong, in one line also where a name that was typed has line breaks."""
    print("brdf-suite: " + make_visible(" ".join(str(error).splitlines())), file=sys.stderr)


def print_written(made: Any, line: str, *, as_json: bool, **changed: object) -> None:
    """Print what was written: its fields, with ``changed`` ones, as JSON; or its notices and then a line."""
    if as_json:
        facts = asdict(made) | changed
        facts["output"] = str(facts.pop("path"))
        print_json(facts)
        return
    print_notes(made.notices)
    print_done(line)


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

"""Progress of an export: a bar for a person, or lines for the program that has started it.

With ``--follow`` each step is a line of JSON on standard output, ``{"fraction": 0.5, "what": "drawing"}``, and the
export is cancelled when standard input ends: so it ends with the program that started it, too, and takes its unfinished
files along.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from brdf_suite.cli.output import progress_bar
from brdf_suite.errors import Cancelled
from brdf_suite.progress import Progress


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

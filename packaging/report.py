"""Messages of the set-up: one line each, marked as ours among the lines of the tools that it runs."""

from __future__ import annotations

import sys


class NotPrepared(SystemExit):
    """Ends the program with a message and exit status 1."""


def report(text: str) -> None:
    """Print one line."""
    line = f"[brdf-suite] {text}"
    encoding = sys.stdout.encoding or "utf-8"  # a redirected output of Windows knows few letters
    print(line.encode(encoding, "backslashreplace").decode(encoding), flush=True)

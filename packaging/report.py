"""Messages of the set-up: one line each, marked as ours among the lines of the tools that it runs."""

from __future__ import annotations


class NotPrepared(SystemExit):
    """Ends the program with a message and exit status 1."""


def report(text: str) -> None:
    """Print one line."""
    print(f"[brdf-suite] {text}", flush=True)

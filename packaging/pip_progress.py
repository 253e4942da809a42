"""Run pip without its talk: one progress line of ours, its whole output in a log.

On some machines pip prints a warning for every package that it looks for, and what matters drowns in them.
Standard library only.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

_TAIL = 12
_SPARSE = 10


class PipError(Exception):
    """Pip did not do what it was asked; the text holds the last lines that it printed."""


def say(text: str) -> None:
    """Print one line of ours."""
    print(f"[brdf-suite] {text}", flush=True)


def run_pip(python: str | Path, arguments: list[str], log: Path, cwd: Path) -> None:
    """Run ``python -m pip`` with ``arguments`` in ``cwd``; append what it prints to ``log``.

    Raises
    ------
    PipError
        It ended with an error.
    """
    command = [str(python), "-m", "pip", "--disable-pip-version-check", "--no-color", *arguments]
    progress = _Progress()
    last: list[str] = []
    with (
        log.open("a", encoding="utf-8") as file,
        subprocess.Popen(
            command,
            cwd=cwd,
            env={**os.environ, "PYTHONUNBUFFERED": "1", "PIP_PROGRESS_BAR": "off", "PIP_NO_INPUT": "1"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
            errors="replace",
        ) as process,
    ):
        assert process.stdout is not None
        try:
            for line in process.stdout:
                file.write(line)
                progress.see(line)
                if line.strip() and not line.startswith("WARNING"):
                    last = [*last[1 - _TAIL :], line.rstrip()]
        except BaseException:
            process.terminate()
            raise
        finally:
            progress.end()
    if process.returncode != 0:
        raise PipError("\n".join(last) or f"pip ended with status {process.returncode} and said nothing")


class _Progress:
    """What pip is at: a single changing line on a terminal, else a line now and then."""

    def __init__(self) -> None:
        self._terminal = sys.stdout.isatty()
        self._collected = 0
        self._shown = False

    def see(self, line: str) -> None:
        """Look at one line of pip."""
        words = line.split()
        if line.startswith("Collecting ") and len(words) > 1:
            self._collected += 1
            text = f"fetching package {self._collected}, {words[1]}"
            if self._terminal:
                self._change(text)
            elif self._collected % _SPARSE == 1:
                say(text)
        elif line.startswith("Installing collected packages:"):
            text = f"installing {len(words) - 3} packages"
            if self._terminal:
                self._change(text)
            else:
                say(text)

    def end(self) -> None:
        """Take the changing line away."""
        if self._shown:
            self._change("")
            print("\r", end="", flush=True)
            self._shown = False

    def _change(self, text: str) -> None:
        width = shutil.get_terminal_size().columns - 1
        line = f"[brdf-suite] {text}" if text else ""
        print(f"\r{line[:width]:{width}}", end="", flush=True)
        self._shown = True

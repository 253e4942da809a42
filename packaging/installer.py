"""Install Python packages with uv, or with pip where uv cannot be installed: one progress line, a full log.

uv downloads in parallel and installs in seconds; it is installed by pip into the environment that it then fills.
Standard library only, since it runs before anything is installed.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from report import report

_LAST_LINES = 12
_PIP_LINES_A_REPORT = 10


class InstallError(Exception):
    """The packages could not be installed; the text holds the last lines of the installer's output."""


class Installer:
    """Installs packages into the environment of ``python``, within the versions of a constraints file.

    ``log`` receives everything that the tools print. Relative paths in arguments are relative to ``folder``.
    """

    def __init__(self, python: Path, constraints: Path, log: Path, folder: Path) -> None:
        self._python = python
        self._constraints = constraints
        self._log = log
        self._folder = folder
        self._uv: bool | None = None

    def install(self, *arguments: str) -> None:
        """Install with the arguments of ``pip install`` (``uv pip install`` knows the same ones).

        Raises
        ------
        InstallError
            Neither uv nor pip could install the packages.
        """
        words = ["install", "--constraint", str(self._constraints), *arguments]
        if self._has_uv():
            try:
                self._run([str(self._uv_program()), "pip", *words, "--python", str(self._python)])
                return
            except InstallError as failure:
                # A mirror or a proxy may be set up for pip alone.
                report(f"uv failed ({str(failure).splitlines()[0][:100]}); trying pip")
        self._run_pip(words)

    def _has_uv(self) -> bool:
        """Whether uv is in the environment, after an attempt to install it."""
        if self._uv is None and self._uv_program().exists():
            self._uv = True
        if self._uv is None:
            try:
                self._run_pip(
                    ["install", "--only-binary", ":all:", "--constraint", str(self._constraints), "uv"]
                )
                self._uv = self._uv_program().exists()
            except InstallError:
                report("uv cannot be installed here; using pip")
                self._uv = False
        return self._uv

    def _uv_program(self) -> Path:
        return self._python.with_name("uv.exe" if os.name == "nt" else "uv")

    def _run_pip(self, words: list[str]) -> None:
        self._run([str(self._python), "-m", "pip", "--disable-pip-version-check", "--no-color", *words])

    def _run(self, command: list[str]) -> None:
        progress = _Progress()
        last: list[str] = []
        quiet = {
            "PYTHONUNBUFFERED": "1",
            "PIP_PROGRESS_BAR": "off",
            "PIP_NO_INPUT": "1",
            "UV_NO_PROGRESS": "1",
            "UV_COMPILE_BYTECODE": "1",  # as pip does: the first start of a program need not wait for it
            "NO_COLOR": "1",
        }
        process = subprocess.Popen(
            command,
            cwd=self._folder,
            env={**os.environ, **quiet},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
            errors="replace",
            start_new_session=True,  # so that its own children can be stopped with it
        )
        with process, self._log.open("a", encoding="utf-8") as log:
            log.write(f"$ {' '.join(command)}\n")
            assert process.stdout is not None
            try:
                for line in process.stdout:
                    log.write(line)
                    progress.show(line)
                    if line.strip() and not line.lower().startswith("warning"):
                        last = [*last[1 - _LAST_LINES :], line.rstrip()]
            except BaseException:
                _stop(process)
                raise
            finally:
                progress.clear()
        if process.returncode != 0:
            raise InstallError(
                "\n".join(last) or f"{command[0]} ended with status {process.returncode} and printed nothing"
            )


def _stop(process: subprocess.Popen[str]) -> None:
    """End an installer and the processes that it started, which would go on writing into the environment."""
    process.terminate()
    try:
        process.wait(5)
    except subprocess.TimeoutExpired:
        process.kill()
    if os.name != "nt":
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


class _Progress:
    """Progress of an installer: one changing line on a terminal, otherwise a line now and then."""

    def __init__(self) -> None:
        self._width = shutil.get_terminal_size().columns - 1 if sys.stdout.isatty() else 0
        self._collected = 0

    def show(self, line: str) -> None:
        """Show what one line of the installer's output says about progress, if anything."""
        text, is_rare = self._describe(line)
        if text and self._width:
            print(f"\r{f'[brdf-suite] {text}'[: self._width]:{self._width}}", end="", flush=True)
        elif text and is_rare:
            report(text)

    def clear(self) -> None:
        """Remove the changing line."""
        if self._width:
            print(f"\r{'':{self._width}}\r", end="", flush=True)

    def _describe(self, line: str) -> tuple[str, bool]:
        """Return the text for a line, and whether such lines are rare enough to print each."""
        words = line.split()
        if line.startswith("Collecting ") and len(words) > 1:  # pip
            self._collected += 1
            return (
                f"fetching package {self._collected}, {words[1]}",
                self._collected % _PIP_LINES_A_REPORT == 1,
            )
        if line.startswith("Installing collected packages:"):  # pip
            return f"installing {len(words) - 3} packages", True
        if re.match(r"\s*(Downloading|Building) \S+ ?", line):  # uv names large packages alone
            return line.strip()[:1].lower() + line.strip()[1:], True
        if found := re.match(r"(Resolved|Prepared|Installed) \d+ packages?", line):  # uv
            return found[0].lower(), True
        return "", False

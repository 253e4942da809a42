"""Ctrl-C at any import: a start ends in silence, a command in one line; no error that blames a library."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

_SIGNALLED = """
import os, signal, sys
from brdf_suite.cli.main import main

wanted = sys.argv[1]

def look(event, arguments):
    global wanted
    if event == "import" and arguments[0] == wanted:
        wanted = ""
        os.kill(os.getpid(), signal.SIGINT)

sys.addaudithook(look)
sys.exit(main(["fit", "copper"]))
"""

_STARTED = """
import os, runpy, signal, sys

module, *wanted = sys.argv[1:]

def look(event, arguments):
    if event == "import" and arguments[0] in wanted:
        os.kill(os.getpid(), signal.SIGINT)

sys.addaudithook(look)
sys.argv[1:] = ["--help"]
runpy.run_module(module, run_name="__main__", alter_sys=True)
"""
_POSIX = pytest.mark.skipif(sys.platform == "win32", reason="signals are of POSIX")


@_POSIX
@pytest.mark.parametrize(
    ("module", "imported"),
    [
        ("brdf_suite", "brdf_suite.cli.main"),
        ("brdf_suite", "brdf_suite.cli.default_action"),
        ("brdf_suite", "brdf_suite.processes"),
        *[
            (program, imported)
            for program in ("brdf_designer", "brdf_viewer", "brdf_lobe_visualizer", "brdf_color_swatch")
            for imported in (f"{program}.command_line", "PySide6.QtCore", "brdf_qt.program.run")
        ],
    ],
)
def test_an_interrupt_in_the_start_ends_the_process_in_silence(module: str, imported: str) -> None:
    """Libraries in C take ``KeyboardInterrupt`` for a missing module, or end the process with a long message."""
    done = subprocess.run(
        [sys.executable, "-c", _STARTED, module, imported],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (-signal.SIGINT, "", "")


@_POSIX
@pytest.mark.parametrize("module", ["brdf_suite", "brdf_viewer"])
def test_an_interrupt_that_is_ignored_stays_ignored(module: str) -> None:
    """As ``nohup`` and job systems leave it."""
    code = f"import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)\n{_STARTED}"
    done = subprocess.run(
        [sys.executable, "-c", code, module, "brdf_suite.processes"],
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("usage: ")


@_POSIX
@pytest.mark.parametrize("module", ["numpy", "datetime", "highspy._core"])
def test_an_interrupt_in_an_import_ends_the_command_in_one_line(module: str) -> None:
    """Two of them are imported by libraries in C, which would take it for a missing module."""
    done = subprocess.run(
        [sys.executable, "-c", _SIGNALLED, module], capture_output=True, text=True, check=False
    )
    said = done.stderr.removeprefix("fitting ...").strip()
    assert (done.returncode, said) == (130, "brdf-suite: cancelled")


def test_the_handler_of_the_caller_is_left(capsys: pytest.CaptureFixture[str]) -> None:
    from brdf_suite.cli.main import main

    before = signal.getsignal(signal.SIGINT)
    assert main(["list", "surfaces"]) == 0
    assert signal.getsignal(signal.SIGINT) is before
    assert capsys.readouterr().out

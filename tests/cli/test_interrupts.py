"""Ctrl-C at any import of a command: one line and status 130, and no error that blames a library."""

from __future__ import annotations

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


@pytest.mark.skipif(sys.platform == "win32", reason="signals are of POSIX")
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

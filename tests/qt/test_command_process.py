"""Work in child processes: what they print, how they end, and how they are cancelled."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from brdf_qt.work.command_process import CommandProcess, run_command

from brdf_suite.errors import Cancelled, SuiteError


@pytest.fixture
def child(tmp_path: Path, monkeypatch):
    """Make the command that is started next run this code."""

    def replace(code: str) -> None:
        program = tmp_path / "program"
        program.write_text(f"#!{PYTHON}\nimport sys\n{code}\n")
        program.chmod(0o755)
        monkeypatch.setattr(sys, "executable", str(program))

    return replace


PYTHON = sys.executable
STEP = 'print(\'{"fraction": 0.5, "what": "half"}\', flush=True)\n'


@pytest.mark.parametrize(
    ("code", "signal", "found"),
    [
        (STEP + "print('a note')", "done", [["a note"]]),
        ("print('one is missing'); sys.exit(1)", "done", [["one is missing"]]),
        ("print('brdf-suite: no such file', file=sys.stderr); sys.exit(2)", "failed", ["no such file"]),
        ("sys.exit(130)", "cancelled", []),
        ("import os; os.kill(os.getpid(), 9)", "failed", ["The work ended without a message."]),
    ],
)
def test_an_end_is_reported_once(child, qtbot, code, signal, found) -> None:
    child(code)
    process = CommandProcess()
    moved: list[tuple[float, str]] = []
    process.moved.connect(lambda *step: moved.append(step))
    with qtbot.waitSignal(getattr(process, signal)) as ended:
        process.run_command("export")
    assert ended.args == found
    assert moved == ([(0.5, "half")] if STEP in code else [])


def test_a_program_that_is_not_there_is_reported(qtbot, monkeypatch, tmp_path) -> None:
    monkeypatch.setattr(sys, "executable", str(tmp_path / "none"))
    process = CommandProcess()
    with qtbot.waitSignal(process.failed) as failed:
        process.run_command("export")
    assert "could not be started" in failed.args[0]


def test_a_closed_input_cancels(child, qtbot) -> None:
    child(STEP + "sys.stdin.read(); sys.exit(130)")
    process = CommandProcess()
    with qtbot.waitSignal(process.moved):
        process.run_command("export")
    with qtbot.waitSignal(process.cancelled):
        process.cancel()


def test_a_thread_gets_the_lines_or_the_error(child) -> None:
    steps: list[tuple[float, str]] = []
    child(STEP + "print('a note')")
    assert run_command(["export"], lambda *step: steps.append(step)).strip() == "a note"
    assert (0.5, "half") in steps
    child("print('brdf-suite: no such file', file=sys.stderr); sys.exit(2)")
    with pytest.raises(SuiteError, match=r"^no such file$"):
        run_command(["export"], lambda *_: None)


def test_a_thread_that_cancels_waits_for_the_end(child, tmp_path) -> None:
    child(f"sys.stdin.read(); open({str(tmp_path / 'cleaned')!r}, 'w'); sys.exit(130)")

    def stop(_fraction: float, _what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        run_command(["export"], stop)
    assert (tmp_path / "cleaned").exists()

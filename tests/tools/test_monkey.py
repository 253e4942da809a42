"""A slice of the random events in the real programs, and what goes wrong under them is seen."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

pytest.importorskip("resource", reason="memory limits are set through the Unix module resource")

from tools.attack import report
from tools.attack.monkeys.run import PROGRAMS, Monkeys, run_program

EVENTS = 30


@pytest.fixture(autouse=True)
def offscreen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")


def faults_of(found: Monkeys) -> list[str]:
    return [*found.tracebacks.values(), *found.deaths.values(), *found.hangs.values()]


@pytest.mark.parametrize("program", PROGRAMS)
def test_random_events_do_no_harm(program: str) -> None:
    found = run_program(program, 1, EVENTS, print)
    assert faults_of(found) == []
    assert found.messages == {}
    assert found.events >= EVENTS
    assert found.memory_mb > 50.0


def test_the_same_number_sends_the_same_events(tmp_path: Path) -> None:
    traces = []
    for turn in ("first", "second"):
        run_program("swatch", 2, 12, print, keep=tmp_path / turn)
        (trace,) = (tmp_path / turn).glob("*.trace")
        # What they meet may be another widget, where the machine is slow.
        traces.append([line.split()[1] for line in trace.read_text().splitlines()[:12]])
    assert traces[0] == traces[1]
    assert len(set(traces[0])) > 2


@pytest.mark.parametrize(
    ("kind", "does"),
    [
        ("tracebacks", "raise KeyError('of the test')"),
        ("deaths", "os.kill(os.getpid(), signal.SIGSEGV)"),
        ("hangs", "while time.thread_time() - began < 5.5:\n        pass"),
    ],
)
def test_what_goes_wrong_is_seen(
    kind: str, does: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The first thing that an interpreter imports: the program gets a key that does harm.
    (tmp_path / "sitecustomize.py").write_text(
        "import os, signal, time\n"
        "from PySide6.QtTest import QTest\n"
        "def press(*_):\n"
        "    began = time.thread_time()\n"
        f"    {does}\n"
        "QTest.keyPress = staticmethod(press)\n"
    )
    path = os.pathsep.join(filter(None, (str(tmp_path), os.environ.get("PYTHONPATH"))))
    monkeypatch.setenv("PYTHONPATH", path)
    said: list[str] = []
    found = run_program("swatch", 1, 8, said.append)
    assert getattr(found, kind), vars(found)
    assert said
    assert "key" in "".join([*getattr(found, kind), *getattr(found, kind).values()])
    rows = report.rows({"monkey": {"swatch": vars(found)}})
    assert [title for title, *_, good in rows if not good and title.endswith(kind)]


def test_a_program_that_is_closed_is_started_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "sitecustomize.py").write_text(
        "from PySide6.QtTest import QTest\n"
        "from PySide6.QtWidgets import QApplication\n"
        "QTest.keyPress = staticmethod(lambda *_: QApplication.exit(0))\n"
    )
    path = os.pathsep.join(filter(None, (str(tmp_path), os.environ.get("PYTHONPATH"))))
    monkeypatch.setenv("PYTHONPATH", path)
    found = run_program("swatch", 1, 12, print)
    assert (found.starts > 1, faults_of(found)) == (True, [])
    assert found.events >= 12

"""The plug-in that delays threads puts its waits around all work in the background, and none on the main thread."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
TESTS = """
import threading, time
import pytest
from brdf_qt.link import parsing
from brdf_qt.work.tasks import TaskRunner
from brdf_suite.fitting.lobes.background import BackgroundSolver
from brdf_suite.pipeline.seen_queue import SeenWeights

@pytest.fixture
def waits(monkeypatch):
    found = []
    monkeypatch.setattr(time, "sleep", lambda seconds: found.append((threading.current_thread(), seconds)))
    return found

def test_tasks(qtbot, waits):
    runner, answers = TaskRunner(), []
    for number in range(60):
        runner.submit(str(number), lambda request, _progress: request, number, answers.append, answers.append)
    qtbot.waitUntil(lambda: len(answers) == 60, timeout=120_000)
    assert sorted(answers) == list(range(60))
    assert waits
    assert all(0.0 <= seconds <= 1.0 for _, seconds in waits)
    assert threading.main_thread() not in {thread for thread, _ in waits}

@pytest.mark.parametrize("call", [parsing.decode, BackgroundSolver.advance, SeenWeights.find])
def test_calls(call, waits):
    def fail():
        with pytest.raises(Exception):
            call()
    fail()
    assert not waits
    for _ in range(60):  # each waits with a probability of two thirds
        thread = threading.Thread(target=fail)
        thread.start()
        thread.join()
    assert waits
"""


def test_work_in_the_background_waits(tmp_path: Path) -> None:
    file = tmp_path / "test_waits.py"
    file.write_text(TESTS)
    command = [sys.executable, "-m", "pytest", "-p", "tools.late_threads", "-q", f"--rootdir={tmp_path}"]
    done = subprocess.run([*command, str(file)], cwd=CHECKOUT, capture_output=True, text=True, check=False)
    assert "4 passed" in done.stdout, done.stdout + done.stderr

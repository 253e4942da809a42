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
from tools import late_threads

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

def test_a_piece_of_work_waits_before_and_after(waits, monkeypatch):
    monkeypatch.setattr(late_threads.random, "random", lambda: 0.0)
    order = []
    monkeypatch.setattr(time, "sleep", lambda seconds: order.append("wait"))
    run(late_threads.late(lambda: order.append("work")))
    assert order == ["wait", "work", "wait"]
    seldom = late_threads.late(lambda: order.append("work"), 60.0)
    order.clear()
    run(lambda: (seldom(), seldom()))
    assert order == ["wait", "work", "work"]

def test_threads_of_the_suite_begin_late(waits, monkeypatch):
    monkeypatch.setattr(late_threads.random, "random", lambda: 0.0)
    run(lambda: None)
    assert not waits
    def of_the_suite(): pass
    of_the_suite.__module__ = "brdf_suite.any"
    run(of_the_suite)
    assert len(waits) == 1

def run(target):
    thread = threading.Thread(target=target)
    thread.start()
    thread.join()

@pytest.mark.parametrize("call", [parsing.decode, BackgroundSolver.advance, SeenWeights.find])
def test_calls(call, waits):
    def fail():
        with pytest.raises(Exception):
            call()
    fail()
    assert not waits
    for _ in range(60):  # each waits with a probability of two thirds
        run(fail)
    assert waits
"""


def test_work_in_the_background_waits(tmp_path: Path) -> None:
    file = tmp_path / "test_waits.py"
    file.write_text(TESTS)
    command = [sys.executable, "-m", "pytest", "-p", "tools.late_threads", "-q", f"--rootdir={tmp_path}"]
    done = subprocess.run([*command, str(file)], cwd=CHECKOUT, capture_output=True, text=True, check=False)
    assert "6 passed" in done.stdout, done.stdout + done.stderr

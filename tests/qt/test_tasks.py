"""Background work: newest wins, stale results are dropped, callbacks come on the main thread."""

from __future__ import annotations

import threading

import pytest
import shiboken6
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_suite.errors import FileError


@pytest.fixture
def runner(qapp):
    runner = TaskRunner()
    yield runner
    assert runner.stop()


def fail(error: Exception) -> None:
    raise AssertionError(error)


def test_the_answer_comes_on_the_main_thread(runner, qtbot):
    seen = []
    runner.submit("k", lambda request, _p: (request, threading.get_ident()), 7, seen.append, fail)
    assert runner.busy
    qtbot.waitUntil(lambda: bool(seen))
    request, worker = seen[0]
    assert request == 7
    assert worker != threading.get_ident()
    assert not runner.busy


def test_a_newer_request_drops_the_older_answer(runner, qtbot):
    gate = threading.Event()
    seen = []

    def work(request, _progress):
        if request == "old":
            assert gate.wait(120)
        return request

    runner.submit("k", work, "old", seen.append, fail)
    runner.submit("k", work, "new", seen.append, fail)
    gate.set()
    qtbot.waitUntil(lambda: bool(seen))
    assert runner.stop()
    qtbot.wait(30)
    assert seen == ["new"]


def test_a_task_of_another_key_is_left_alone(runner, qtbot):
    seen = []
    for key in ("a", "b"):
        runner.submit(key, lambda request, _p: request, key, seen.append, fail)
    qtbot.waitUntil(lambda: len(seen) == 2)
    assert sorted(seen) == ["a", "b"]


def test_cancel_stops_the_work_at_its_next_report(runner, qtbot):
    started, ended = threading.Event(), threading.Event()

    def work(_request, progress):
        started.set()
        try:
            while True:
                progress(0.5, "working")
                threading.Event().wait(0.005)
        finally:
            ended.set()

    runner.submit("k", work, None, fail, fail)
    assert started.wait(120)
    runner.cancel("k")
    assert not runner.busy
    assert ended.wait(120)


def test_progress_and_errors_arrive(runner, qtbot):
    moved, failed = [], []

    def work(_request, progress):
        progress(0.25, "reading")
        raise FileError("x.exr", "it is cut off")

    runner.submit("k", work, None, fail, failed.append, lambda f, what: moved.append((f, what)))
    qtbot.waitUntil(lambda: bool(failed))
    assert moved == [(0.25, "reading")]
    assert isinstance(failed[0], FileError)


@pytest.mark.parametrize("stopped", [True, False])
def test_a_thread_that_outlives_its_runner_ends_in_silence(qapp, capfd, stopped):
    began, gate = threading.Event(), threading.Event()

    def work(_request, _progress):
        began.set()
        gate.wait(10.0)

    owner = QObject()
    runner = TaskRunner(owner)
    runner.submit("k", work, 0, fail, fail)
    assert began.wait(10.0)
    if stopped:
        assert not runner.stop(10)
    threading.Timer(0.2, gate.set).start()
    shiboken6.delete(owner)
    assert gate.is_set(), "its threads were waited for"
    assert capfd.readouterr().err == ""

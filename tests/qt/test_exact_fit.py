"""The optimum after the time limit, with a real fitter and its thread."""

from __future__ import annotations

import threading
from concurrent.futures import Future
from dataclasses import replace

import pytest
from brdf_qt.work.exact_fit import ExactFit
from brdf_qt.work.fit_error import FINAL_TIP, LIMITED_TIP, fit_tips, large_error_tip
from PySide6.QtCore import QThread

from brdf_suite.errors import FittingError
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint


@pytest.fixture
def hurried(qapp):
    fitter = PaintFitter(time_limit_s=1e-6)
    yield fitter
    fitter.close()


@pytest.fixture
def exact(qapp):
    return ExactFit()


def test_the_optimum_of_the_paint_on_show_arrives_on_the_main_thread(hurried, exact, qtbot):
    paint = load_shipped_paint("copper")
    fit = hurried.fit(paint)
    assert fit.time_limited
    threads = []
    exact.arrived.connect(lambda _: threads.append(QThread.currentThread()))
    with qtbot.waitSignal(exact.arrived) as found:
        exact.watch(fit)
    (better,) = found.args
    patient = PaintFitter(time_limit_s=60.0).fit(paint)
    assert threads == [exact.thread()]
    assert not better.time_limited
    assert better.paint is paint
    assert better.worst_delta_e == pytest.approx(patient.worst_delta_e, abs=1e-6)
    assert better.worst_delta_e < fit.worst_delta_e


def test_of_an_earlier_paint_nothing_is_reported(hurried, exact, qtbot):
    first = hurried.fit(load_shipped_paint("copper"))
    first.exact.result(timeout=120)
    second = hurried.fit(load_shipped_paint("blue"))
    reported = []
    exact.arrived.connect(reported.append)
    exact.watch(first)
    exact.watch(second)
    qtbot.waitUntil(lambda: bool(reported))
    qtbot.wait(50)
    assert [fit.paint.name for fit in reported] == ["Blue"]
    third = hurried.fit(load_shipped_paint("copper"))
    exact.watch(third)
    exact.forget()
    third.exact.result(timeout=120)
    qtbot.wait(50)
    assert len(reported) == 1


def test_a_fit_that_is_exact_already_is_not_waited_for(exact, qtbot):
    reported = []
    exact.arrived.connect(reported.append)
    exact.watch(PaintFitter(time_limit_s=60.0).fit(load_shipped_paint("blue")))
    qtbot.wait(50)
    assert not reported


@pytest.mark.parametrize("watched_first", [True, False])
def test_a_closed_fitter_tells_nothing(hurried, exact, qtbot, watched_first):
    reported = []
    exact.arrived.connect(reported.append)
    exact.failed.connect(lambda *what: reported.append(what))
    with (
        hurried.lobe_fitter.solver.background.lock
    ):  # its thread cannot come to the optimum before it is closed
        fit = hurried.fit(load_shipped_paint("blue"))
        assert fit.exact_follows
        if watched_first:
            exact.watch(fit)
        closing = threading.Thread(target=hurried.close)
        closing.start()
        qtbot.waitUntil(fit.exact.cancelled)
    closing.join()
    if not watched_first:
        exact.watch(fit)
    qtbot.wait(50)
    assert not reported
    assert not fit.exact_follows


def test_a_solver_that_gives_up_is_reported(hurried, exact, qtbot):
    future: Future[object] = Future()
    fit = hurried.fit(load_shipped_paint("blue"))
    fit = replace(fit, exact=future)
    assert fit.exact_follows
    with qtbot.waitSignal(exact.failed) as reported:
        exact.watch(fit)
        future.set_exception(FittingError("no optimum"))
    assert reported.args[0] is fit
    assert str(reported.args[1]) == "no optimum"
    assert not fit.exact_follows


def test_a_limited_fit_says_whether_the_exact_one_follows():
    for worst in (0.2, None):
        assert fit_tips(worst, False, False) == ""
        assert fit_tips(worst, True, True) == LIMITED_TIP
        assert fit_tips(worst, True, False) == FINAL_TIP
    for follows in (True, False):
        assert fit_tips(2.0, True, follows) == large_error_tip(True, follows)
    assert "follows automatically" in LIMITED_TIP
    assert "follows automatically" in large_error_tip(True, True)
    assert "no exact one" in FINAL_TIP
    assert "no exact result" in large_error_tip(True, False)

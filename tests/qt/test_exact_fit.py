"""The optimum after the time limit, with a real fitter and its thread."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import replace

import pytest
from brdf_qt.exact_fit import ExactFit
from brdf_qt.fit_error import LIMITED_TIP, fit_tips, large_error_tip
from PySide6.QtCore import QThread

from brdf_suite.errors import FittingError
from brdf_suite.pipeline.paint import PATIENT_TIME_LIMIT_S, PaintFitter
from brdf_suite.pipeline.scene import load_shipped_paint


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
    with qtbot.waitSignal(exact.arrived, timeout=20_000) as found:
        exact.watch(fit)
    (better,) = found.args
    patient = PaintFitter(time_limit_s=PATIENT_TIME_LIMIT_S).fit(paint)
    assert threads == [exact.thread()]
    assert not better.time_limited
    assert better.paint is paint
    assert better.worst_delta_e == pytest.approx(patient.worst_delta_e, abs=1e-6)
    assert better.worst_delta_e < fit.worst_delta_e


def test_of_an_earlier_paint_nothing_is_told(hurried, exact, qtbot):
    first = hurried.fit(load_shipped_paint("copper"))
    first.fit.exact.result(timeout=20)
    second = hurried.fit(load_shipped_paint("blue"))
    told = []
    exact.arrived.connect(told.append)
    exact.watch(first)
    exact.watch(second)
    qtbot.waitUntil(lambda: bool(told), timeout=20_000)
    qtbot.wait(50)
    assert [fit.paint.name for fit in told] == ["Blue"]
    third = hurried.fit(load_shipped_paint("copper"))
    exact.watch(third)
    exact.forget()
    third.fit.exact.result(timeout=20)
    qtbot.wait(50)
    assert len(told) == 1


def test_a_fit_that_is_exact_already_is_not_waited_for(exact, qtbot):
    told = []
    exact.arrived.connect(told.append)
    exact.watch(PaintFitter(time_limit_s=PATIENT_TIME_LIMIT_S).fit(load_shipped_paint("blue")))
    qtbot.wait(50)
    assert not told


def test_a_closed_fitter_tells_nothing(hurried, exact, qtbot):
    told = []
    exact.arrived.connect(told.append)
    fit = hurried.fit(load_shipped_paint("blue"))
    hurried.close()
    exact.watch(fit)
    qtbot.wait(50)
    assert not told or fit.fit.exact.result().time_limited is False


def test_a_solver_that_gives_up_is_told(hurried, exact, qtbot):
    future: Future[object] = Future()
    fit = hurried.fit(load_shipped_paint("blue"))
    fit = replace(fit, fit=replace(fit.fit, exact=future))
    with qtbot.waitSignal(exact.failed, timeout=5_000) as told:
        exact.watch(fit)
        future.set_exception(FittingError("no optimum"))
    assert str(told.args[0]) == "no optimum"


def test_a_limited_fit_says_that_the_exact_one_follows():
    assert fit_tips(0.2, False) == ""
    assert fit_tips(0.2, True) == LIMITED_TIP
    assert fit_tips(2.0, True) == large_error_tip(True)
    assert "follows" in LIMITED_TIP
    assert "follows" in large_error_tip(True)

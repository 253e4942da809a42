"""What a fit leaves to the background: the optimum and nothing less, cancelled by the next fit, dropped by close."""

from __future__ import annotations

import pickle
import threading
from collections.abc import Iterator
from concurrent.futures import CancelledError, Future, wait
from typing import Any

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles import AngleFitter
from brdf_suite.fitting.lobes.angles import fitter as fitter_module
from brdf_suite.fitting.lobes.background import chain_futures
from brdf_suite.pipeline.material import load_document, load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint, build_reflectance
from brdf_suite.reflectance.designed.layers import split_layers
from brdf_suite.reflectance.protocol import Layered

SECONDS = 120.0


@pytest.fixture
def hurried() -> Iterator[AngleFitter]:
    """A fitter of a limit that nothing can meet: coat and base are left to the background."""
    fitter = AngleFitter(time_limit_s=1e-5)
    yield fitter
    fitter.close()


def paint(name: str) -> Layered:
    layers = split_layers(build_reflectance(load_document(name)))
    assert layers is not None
    return layers


def held_back(fitter: AngleFitter, monkeypatch: pytest.MonkeyPatch) -> threading.Event:
    """Keep the thread of the grey coat from working until the event is set."""
    event = threading.Event()
    background = fitter.grey_coat.background
    advance = background.advance

    def later(work: Any) -> Any:
        assert event.wait(SECONDS)
        return advance(work)

    monkeypatch.setattr(background, "advance", later)
    return event


def test_the_exact_answer_is_an_optimum_however_long_its_base_takes(
    hurried: AngleFitter, monkeypatch: pytest.MonkeyPatch
) -> None:
    # No limit of its own may end it.
    monkeypatch.setattr(fitter_module, "WARM_UP_S", 1e-6)
    fit = hurried.fit(paint("copper"))
    assert fit.time_limited
    assert fit.exact is not None
    exact = fit.exact.result(timeout=SECONDS)
    assert not exact.time_limited
    assert exact.exact is None
    assert {*exact.base_error.method, *exact.coat_error.method} == {"optimum"}


def test_the_next_fit_cancels_it_at_once_whichever_solver_it_needs(
    hurried: AngleFitter, monkeypatch: pytest.MonkeyPatch
) -> None:
    released = held_back(hurried, monkeypatch)
    grey = hurried.fit(paint("blue"))
    coloured = hurried.fit(paint("table1_polaris_silver"))
    assert grey.exact is not None
    assert grey.exact.cancelled()
    released.set()
    assert not wait([grey.exact], timeout=SECONDS).not_done, "the waiting caller is notified"
    assert coloured.exact is not None
    assert not coloured.exact.result(timeout=SECONDS).time_limited


def test_a_fit_that_begins_meanwhile_finds_the_late_base_begun(
    hurried: AngleFitter, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between the look whether it is still wanted and its begin no other fit comes in."""
    inside, go_on, superseded = threading.Event(), threading.Event(), threading.Event()
    base = Future[Any]()

    def slowly(*_given: Any, **_named: Any) -> Future[Any]:
        inside.set()
        assert go_on.wait(SECONDS)
        return base

    monkeypatch.setattr(hurried.base_solver, "begin", slowly)
    released = held_back(hurried, monkeypatch)
    fit = hurried.fit(paint("blue"))
    released.set()
    assert inside.wait(SECONDS)
    other = threading.Thread(target=lambda: (hurried.supersede(), superseded.set()))
    other.start()
    assert not superseded.wait(0.1)
    go_on.set()
    other.join(SECONDS)
    assert superseded.is_set()
    assert fit.exact is not None
    assert fit.exact.cancelled()
    hurried.close()  # the coat's thread has come to its end
    assert base.cancelled()


def test_a_late_base_without_requests_is_not_begun(
    hurried: AngleFitter, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun: list[object] = []
    begin = hurried.base_solver.begin
    monkeypatch.setattr(hurried.base_solver, "begin", lambda *a, **k: (begun.append(1), begin(*a, **k))[1])
    make = hurried.base_target
    arrived, go_on = threading.Event(), threading.Event()

    def slowly(*given: Any) -> Any:
        if threading.current_thread() is not threading.main_thread():
            arrived.set()
            assert go_on.wait(SECONDS)
        return make(*given)

    monkeypatch.setattr(hurried, "base_target", slowly)
    released = held_back(hurried, monkeypatch)
    fit = hurried.fit(paint("blue"))
    released.set()
    assert arrived.wait(SECONDS)
    hurried.supersede()
    go_on.set()
    hurried.close()
    assert fit.exact is not None
    assert fit.exact.cancelled()
    assert begun == []


def test_close_ends_what_is_in_work_and_notifies_waiting_callers(
    hurried: AngleFitter, monkeypatch: pytest.MonkeyPatch
) -> None:
    released = held_back(hurried, monkeypatch)
    fit = hurried.fit(paint("copper"))
    assert fit.exact is not None
    assert not fit.exact.done()
    released.set()
    hurried.close()
    assert not wait([fit.exact], timeout=SECONDS).not_done
    assert fit.exact.cancelled()


def test_a_coat_without_an_optimum_is_reported(hurried: AngleFitter, monkeypatch: pytest.MonkeyPatch) -> None:
    def lost(*_: object) -> None:
        raise FittingError("no optimum")

    monkeypatch.setattr(hurried.grey_coat.background, "advance", lost)
    fit = hurried.fit(paint("blue"))
    assert fit.exact is not None
    with pytest.raises(FittingError, match="no optimum"):
        fit.exact.result(timeout=SECONDS)


def test_a_fit_whose_optimum_is_to_come_can_be_pickled(hurried: AngleFitter) -> None:
    fit = hurried.fit(build_paint(load_shipped_paint("blue")))
    assert fit.exact is not None
    copy = pickle.loads(pickle.dumps(fit))
    assert copy.exact is None
    assert copy.time_limited
    np.testing.assert_array_equal(copy.weights.kdd, fit.weights.kdd)


def test_one_after_another_carries_values_errors_and_cancelling() -> None:
    first, second = Future[int](), Future[str]()
    whole = chain_futures(first, lambda value, _: second if value == 3 else None)
    first.set_result(3)
    assert not whole.done()
    second.set_result("three")
    assert whole.result() == "three"

    def fails(_value: int, _whole: Future[str]) -> Future[str]:
        raise FittingError("not to be begun")

    first = Future[int]()
    whole = chain_futures(first, fails)
    first.set_result(1)
    with pytest.raises(FittingError, match="not to be begun"):
        whole.result(timeout=0.0)

    for ended in ("first", "second", "whole"):
        first, second = Future[int](), Future[str]()
        whole = chain_futures(first, lambda _value, _whole, second=second: second)
        if ended != "first":
            first.set_result(1)
        {"first": first, "second": second, "whole": whole}[ended].cancel()
        assert whole.cancelled()
        assert second.cancelled() == (ended != "first")
        assert not wait([whole], timeout=SECONDS).not_done
        with pytest.raises(CancelledError):
            whole.result(timeout=0.0)

    first = Future[int]()
    whole = chain_futures(first, lambda _value, _whole: Future[str]())
    whole.cancel()
    assert first.cancelled(), "what is not begun yet is not needed"

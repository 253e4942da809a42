"""The assistant from photographs to a paint: every step on the real road, stopped and resumed on the way."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path
from threading import Event

import numpy as np
import pytest
from brdf_designer.acquire.assistant import Assistant
from brdf_designer.acquire.control import AcquireControl
from brdf_designer.acquire.fit.page import with_error
from brdf_designer.acquire.reconstruction.session import WORK_FILE
from PySide6.QtWidgets import QPushButton

from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.documents.store import load_any_paint
from brdf_suite.files.measured.brdftable import read_brdftable


@pytest.fixture
def folder(simulated, tmp_path) -> Path:
    return Path(shutil.copytree(simulated, tmp_path / "photographs"))


@pytest.fixture
def assistant(fresh, folder, qtbot) -> Assistant:
    """The assistant of the module's Designer with a session of its own open."""
    designer, _ = fresh
    control = designer.feature(AcquireControl)
    found = control.open()
    for key in found.window.messages.shown():
        found.window.messages.dismiss(key)
    open_folder(found, folder, qtbot)
    return found


def open_folder(assistant, folder, qtbot):
    with qtbot.waitSignal(assistant.bench.opened):
        assistant.sessions.open(folder)
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)


def positions_done(assistant) -> int:
    """As the page of the reconstruction shows it: n of m."""
    return int(assistant.window.reconstruction.facts.texts["Positions"].split()[0])


def finished(assistant, qtbot, key):
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    assert assistant.window.messages.shown() == {}
    return assistant.bench.results[key]


def test_from_photographs_to_a_paint(assistant, folder, asked, tmp_path, fresh, qtbot):
    window, bench = assistant.window, assistant.bench
    window.response.start.click()
    response = finished(assistant, qtbot, "response")
    assert response.found.bit_depth == 12
    assert window.response.plot.curves
    assert "Times" in window.response.facts.texts

    window.geometry_page.start.click()
    geometry = finished(assistant, qtbot, "geometry")
    page = window.geometry_page
    assert {mark.name for mark in page.picture.marks} >= {"fitted outline", "highlight, found"}
    assert "px" in page.facts.texts["Outline"]
    # The outline lies where the sphere does: in the middle of the picture, 0.85 of it wide.
    around = geometry.state.outline
    assert around.mean(axis=0) == pytest.approx([47.5, 47.5], abs=1.5)
    assert np.ptp(around[:, 0]) == pytest.approx(0.85 * 96, abs=2.5)

    # Stopped as soon as the first position is in the file, then resumed: what was done is taken up.
    window.reconstruction.start.click()
    qtbot.waitUntil(lambda: positions_done(assistant) >= 1 or "table" in bench.results)
    # One progress, with one button to stop: that of the window.
    assert window.progress.jobs == ("table",)
    (stop,) = window.progress.findChildren(QPushButton)
    stop.click()
    assert (folder / WORK_FILE).exists()
    assert window.reconstruction.start.isEnabled()
    assert "table" not in bench.results
    window.reconstruction.start.click()
    table = finished(assistant, qtbot, "table")
    assert table.acquired.resumed >= 1
    assert len(table.acquired.positions_done) == 8
    assert window.coverage.map.map is not None
    assert window.coverage.save.isEnabled()

    asked.path = tmp_path / "test.brdftable"
    window.coverage.save.click()
    finished(assistant, qtbot, "table")
    assert np.array_equal(read_brdftable(asked.path).values, table.acquired.table.values)
    assert str(asked.path) in window.coverage.kept.text()

    window.fit.lobes.setValue(1)
    window.fit.start.click()
    fit = finished(assistant, qtbot, "fit")
    # The paint that was photographed has a slope of 0.2; so few pixels determine its colours poorly.
    assert fit.paint.lobes[0].m == pytest.approx(0.2, rel=0.2)
    assert all(0.02 < value < 0.6 for value in fit.paint.kd)
    assert [curve.name for curve in window.fit.plot.curves][:2] == ["measured", "fitted"]
    assert float(window.fit.table.item(1, 4).text().split()[0]) == pytest.approx(
        fit.paint.lobes[0].m, rel=0.1
    )

    asked.path = tmp_path / "test.brdfpaint"
    window.fit.save.click()
    finished(assistant, qtbot, "fit")
    assert load_any_paint(asked.path) == fit.paint

    designer, _ = fresh
    before = len(designer.documents.row)
    window.fit.open.click()
    finished(assistant, qtbot, "fit")
    assert designer.documents.front.title == "Test"
    assert len(designer.documents.row) <= before + 1
    assert not designer.documents.front.store.is_clean
    lightest = designer.session.paint.measurements[0].lab
    assert lightest[0] > designer.session.paint.measurements[-1].lab[0]

    # Another mask takes the table and the fit with it, and nothing else.
    window.show_page("mask")
    qtbot.waitUntil(lambda: window.mask_page.picture.history is not None)
    used = np.ones((96, 96), bool)
    used[:, :10] = False
    window.mask_page.picture.put(used)
    assert set(bench.results) == {"response", "geometry"}
    assert not window.coverage.save.isEnabled()
    assert not window.fit.open.isEnabled()
    assistant.write_pending()
    # What was begun with the other mask is not mixed with it: that is said, with the way on.
    window.reconstruction.start.click()
    qtbot.waitUntil(lambda: "table" in window.messages.shown())
    assert [text for text, _ in window.messages.shown()["table"].actions] == ["Start Over"]


def test_work_of_an_earlier_run_is_taken_up(assistant, folder, qtbot):
    """What was done is there when the folder is opened again, with its calibration."""
    assistant.reconstruction.find_table()
    qtbot.waitUntil(lambda: positions_done(assistant) >= 2 or "table" in assistant.bench.results)
    assistant.bench.cancel("table")
    open_folder(assistant, folder, qtbot)
    assert set(assistant.bench.results) == {"response", "geometry"}
    assert positions_done(assistant) >= 1
    assert assistant.window.reconstruction.start.text() in ("Resume", "Start")


def test_closing_stops_nothing_and_progress_is_shown_where_it_can_be_seen(assistant, fresh, qtbot):
    go_on = Event()

    def work(_request, progress):
        progress(0.5, "half of it")
        go_on.wait()
        return "done"

    answers = []
    host, window = fresh[0].window, assistant.window
    assistant.bench.run("test", work, None, answers.append)
    qtbot.waitUntil(lambda: "test" in window.progress.jobs)
    window.close()
    assert window.progress.jobs == ()
    assert host.progress.jobs == ("test",)
    window.bring()
    assert "test" in assistant.window.progress.jobs
    assert host.progress.jobs == ()
    go_on.set()
    qtbot.waitUntil(lambda: answers == ["done"])
    assert window.progress.jobs == ()


def test_an_error_of_a_step_is_reported_and_the_others_stay(assistant, folder, qtbot):
    session = read_session(folder)
    write_session(replace(session, sphere=replace(session.sphere, radius_m=0.5)), folder)
    assistant.window.response.start.click()
    finished(assistant, qtbot, "response")
    assistant.window.geometry_page.start.click()
    qtbot.waitUntil(lambda: "geometry" in assistant.window.messages.shown())
    assert "geometry" not in assistant.bench.results
    assert "response" in assistant.bench.results


def test_other_choices_forget_what_hangs_on_them(assistant, qtbot):
    assistant.window.response.start.click()
    finished(assistant, qtbot, "response")
    assistant.window.geometry_page.refined.click()
    assert assistant.bench.options.refine is False
    assert "response" in assistant.bench.results
    assistant.window.geometry_page.refined.click()
    kind = assistant.window.response.kind
    kind.setCurrentIndex(kind.findData("linear"))
    kind.activated.emit(kind.currentIndex())
    assert assistant.bench.results == {}
    assert assistant.bench.options.response == "linear"


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (0.31234, 0.0123, "0.31 ± 0.01"),
        (12.3, 2.0, "12 ± 2"),
        (0.5, float("nan"), "0.5 ± ?"),
        (0.25, 0.0, "0.25"),
    ],
)
def test_an_uncertainty_has_one_digit_and_its_value_no_more(value, error, text):
    assert with_error(value, error) == text

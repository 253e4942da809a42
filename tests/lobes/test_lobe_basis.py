"""The basis in the real window: the stored search, the selected paint's errors, searches as processes and in files."""

from __future__ import annotations

import shutil
import threading
from pathlib import Path

import numpy as np
import pytest
from brdf_lobe_visualizer.lobe_basis.part import BASIS, Basis, BasisRun
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial

from brdf_suite.fitting.basis_search.document import load_search, save_state
from brdf_suite.fitting.lobes.basis import STORED_NAME
from brdf_suite.pipeline.material import Material, load_document
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.resources import resource, resource_root

STORED = Path(str(resource("basis", STORED_NAME)))


@pytest.fixture
def basis(window_with_basis, qtbot) -> Basis:
    program = window_with_basis
    part = program.feature(Basis)
    program.session.set_subjects(())
    program.window.plots.set_shown(BASIS, True)
    part.show_shipped()
    qtbot.waitUntil(lambda: part.is_idle)
    return part


@pytest.fixture
def session(window_with_basis):
    return window_with_basis.session


def test_the_stored_search_is_drawn(basis) -> None:
    search = load_search(STORED)
    points = basis.view.plots.dots.getData()
    assert len(points[0]) == sum(result.count for result in search.results)
    last = search.results[-1]
    assert np.sort(points[1][points[0] == last.count]) == pytest.approx(np.log10(last.exponents))
    words = basis.view.note.text()
    assert "Sample paints" in words
    assert f"default: {search.default_count} lobes" in words
    assert "changed" not in words
    basis.view.plots.read_exponents(float(search.default_count))
    assert f"{search.default_count} lobes" in basis.view.plots.readouts[0].text()
    basis.view.plots.read_errors(1.2)
    assert "worst" in basis.view.plots.readouts[1].text()


def test_the_selected_paint_has_its_errors_live(basis, session, qtbot) -> None:
    search = load_search(STORED)
    for name in ("blue_metallic", "satin_blue"):
        session.add(PlottedMaterial(name, name, Material(name, build_reflectance(load_document(name)))))
    for name in ("blue_metallic", "satin_blue"):
        session.set_front(name)
        qtbot.waitUntil(
            lambda name=name: basis.view.plots.own is not None and basis.view.plots.own[0].key == name
        )
        errors = basis.view.plots.own[1]
        place = search.paints.index(name)
        assert errors.errors == pytest.approx([result.errors[place] for result in search.results], rel=1e-6)
    session.add(PlottedMaterial("satin_blue", "matt", Material("matt", Lambertian(0.5))))
    qtbot.waitUntil(lambda: not basis.view.plots.own[1].whole)
    assert "matt: colour error only" in basis.view.note.text()
    session.set_subjects(())
    qtbot.waitUntil(lambda: basis.view.plots.own is None)


def test_a_running_search_is_followed(basis, qtbot, tmp_path: Path) -> None:
    search = load_search(STORED)
    state = tmp_path / "basis.json.part"
    settings = {"database_sha256": "x", "paints": list(search.paints), "starts": 4}
    save_state(state, settings, search.results[:2])
    before = basis.search
    basis.show_file(state)
    assert basis.search is before, "it is read on the thread of the window"
    qtbot.waitUntil(lambda: len(basis.search.results) == 2)
    assert "2 lobe counts so far" in basis.view.note.text()
    save_state(state, settings, search.results[:5])
    qtbot.waitUntil(lambda: len(basis.search.results) >= 5)
    assert len(basis.search.results) == 5
    assert len(basis.view.plots.dots.getData()[0]) == 1 + 2 + 3 + 4 + 5
    state.write_text("{")
    qtbot.waitUntil(lambda: BASIS in basis.window.messages.shown())
    assert len(basis.search.results) == 5  # what was read stays


def test_the_name_is_that_of_the_search_that_is_shown(basis, qtbot, tmp_path: Path, monkeypatch) -> None:
    import brdf_suite.fitting.basis_search.document as document

    before, begun, go = basis.view.note.text(), threading.Event(), threading.Event()
    other = tmp_path / "other.json"
    other.write_bytes(STORED.read_bytes())
    load = document.load_search

    def hold(path: Path):
        begun.set()
        go.wait(60.0)
        return load(path)

    monkeypatch.setattr(document, "load_search", hold)
    basis.show_file(other)
    qtbot.waitUntil(begun.is_set)
    basis.show_note()
    assert basis.view.note.text() == before
    go.set()
    qtbot.waitUntil(lambda: basis.is_idle)
    assert basis.view.note.text().startswith("other.json")


def test_a_folder_is_searched_in_a_process_and_can_be_stopped(basis, qtbot, tmp_path: Path) -> None:
    paints = tmp_path / "paints"
    paints.mkdir()
    shutil.copy(resource_root() / "paints" / "solid_red.brdfpaint", paints)
    basis.show_folder(paints)
    assert "no search yet" in basis.view.note.text()
    basis.view.search.click()
    assert not basis.view.search.isEnabled()
    assert basis.view.progress.jobs == (BASIS,)
    qtbot.waitUntil(lambda: basis.view.search.isEnabled() and basis.is_idle)
    assert [result.count for result in basis.search.results] == [1]
    assert basis.search.default_count == 1
    assert basis.view.progress.jobs == ()
    qtbot.waitUntil(lambda: basis.is_idle)
    assert "changed" not in basis.view.note.text()
    shutil.copy(resource_root() / "paints" / "satin_blue.brdfpaint", paints)
    qtbot.waitUntil(lambda: "changed since" in basis.view.note.text())
    # Now one that is stopped: it keeps its place and reports nothing.
    basis.view.search.click()
    qtbot.waitUntil(lambda: basis.run is not None)
    basis.run.cancel()
    qtbot.waitUntil(lambda: basis.run is None)
    assert BASIS not in basis.window.messages.shown()
    basis.view.reset.trigger()
    qtbot.waitUntil(lambda: basis.is_idle)
    assert "Sample paints" in basis.view.note.text()


def test_what_cannot_be_searched_is_reported(basis, qtbot, tmp_path: Path) -> None:
    basis.show_folder(tmp_path)
    basis.start_search()
    qtbot.waitUntil(lambda: BASIS in basis.window.messages.shown())
    assert basis.run is None
    assert basis.view.search.isEnabled()
    run = BasisRun(tmp_path, tmp_path / "basis.json", 3, basis)
    with qtbot.waitSignal(run.failed) as failed:
        run.start()
    assert "no paint" in failed.args[0]


def test_paints_are_read_on_a_thread_and_again_only_where_they_have_changed(
    basis, qtbot, tmp_path: Path, monkeypatch
) -> None:
    from threading import current_thread, main_thread

    from brdf_suite.fitting.basis_search import database

    read, threads = database.database_sha256, []

    def counted(folder: Path) -> str:
        threads.append(current_thread())
        return read(folder)

    monkeypatch.setattr(database, "database_sha256", counted)
    below = tmp_path / "below"
    below.mkdir()
    shutil.copy(resource_root() / "paints" / "solid_red.brdfpaint", below)
    basis.show_folder(tmp_path)
    qtbot.waitUntil(lambda: basis.is_idle)
    known = basis.paints.known
    assert (known.count, known.sha256) == (1, read(tmp_path))
    basis.show_shipped()
    qtbot.waitUntil(lambda: basis.is_idle)
    threads.clear()
    basis.show_folder(tmp_path)
    basis.show_note()
    qtbot.waitUntil(lambda: basis.is_idle)
    assert not threads  # nothing has changed
    shutil.copy(resource_root() / "paints" / "satin_blue.brdfpaint", below)
    basis.paints.look()
    qtbot.waitUntil(lambda: basis.paints.known.count == 2)
    assert len(threads) == 1
    assert main_thread() not in threads
    basis.show_folder(tmp_path / "gone")
    qtbot.waitUntil(lambda: basis.is_idle)
    assert basis.paints.known.count == 0

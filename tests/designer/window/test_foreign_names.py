"""Names from files are plain text all over Designer, and a wheel that passes over its fields changes nothing."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from brdf_designer.acquire.control import AcquireControl
from brdf_designer.export.control import HandoverControl
from brdf_designer.from_measurement.control import MeasuredControl
from brdf_designer.history.control import HistoryControl
from brdf_designer.standard_comparison.control import StandardControl
from brdf_designer.variations.control import VariationsControl
from brdf_designer.variations.interpolation_control import InterpolationControl
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recovery import Recovery

from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.pipeline.material import load_document, load_shipped_paint


def part(designer, kind):
    return designer.feature(kind)


@pytest.fixture
def hostile(walks, tmp_path: Path) -> Path:
    """A paint whose name and whose file's name Qt takes for HTML."""
    path = tmp_path / f"{walks.HOSTILE_FILE}.brdfpaint"
    save_paint(replace(load_shipped_paint("copper"), name=walks.HOSTILE), path)
    return path


def test_names_are_plain_text_in_the_whole_window(designer, hostile, walks, qtbot, tmp_path: Path) -> None:
    window = designer.window
    designer.open(str(hostile))
    qtbot.waitUntil(lambda: designer.reading.is_idle)
    designer.open("blue")
    standard, between = part(designer, StandardControl), part(designer, InterpolationControl)
    for kind in (VariationsControl, InterpolationControl, StandardControl):
        designer.window.panel.bring_in_sight(part(designer, kind).host)
    palette = tmp_path / f"{walks.HOSTILE_FILE}.brdfpalette"
    paints = [replace(load_shipped_paint(name), name=walks.HOSTILE) for name in ("red", "copper")]
    save_palette(Palette(walks.HOSTILE, tuple(Entry(paint) for paint in paints)), palette)
    standard.load(palette)
    qtbot.waitUntil(lambda: standard.standard is not None)
    standard.add_batches(palette)
    qtbot.waitUntil(lambda: len(standard.batches()) >= 2)
    between.load(hostile)
    qtbot.waitUntil(lambda: between.share is not None)
    between.take(0.5)
    part(designer, HandoverControl).open()
    lobes = tmp_path / f"{walks.HOSTILE_FILE} lobes.brdfpaint"
    save_paint(replace(load_document("table1_blue"), name=walks.HOSTILE), lobes)
    measured = part(designer, MeasuredControl)
    measured.open(lobes)
    qtbot.waitUntil(lambda: measured.start_of_front() is not None)
    designer.open(str(tmp_path / f"{walks.HOSTILE_FILE} none.brdfpaint"))  # a message names it
    qtbot.waitUntil(lambda: bool(window.messages.shown()))
    window.show_recent(designer.files.recent())
    history = part(designer, HistoryControl).strip.states
    for front in (designer.documents.front, designer.documents.row[0]):
        designer.documents.show(front)
        # Lists and the history are filled when the program is idle.
        qtbot.waitUntil(lambda: designer.controller.is_idle and designer.session.is_quiet)
        qtbot.waitUntil(lambda: history.rowCount() > 0)
        wrong, seen = walks.drawn_as_html()
        assert wrong == []
        assert seen > 20


def test_unsaved_work_is_offered_in_plain_text(designer, hostile, walks) -> None:
    form = designer.documents.front.files.format
    paint = form.load(hostile)
    for _ in range(2):
        store = DocumentStore(form.new())
        recovery = Recovery(store, form, lambda error: None)
        store.set(paint, "Open")
        recovery.write()
        recovery.close(keep=True)
    designer.offer_recovery()
    assert walks.HOSTILE in designer.window.messages.shown()["recovery"].what
    wrong, seen = walks.drawn_as_html()
    assert wrong == []
    assert seen


def test_the_assistant_shows_names_as_plain_text(fresh, simulated, walks, qtbot, tmp_path: Path) -> None:
    designer, _ = fresh
    folder = tmp_path / walks.HOSTILE_FILE
    shutil.copytree(simulated, folder)
    session = read_session(folder)
    write_session(replace(session, name=walks.HOSTILE), folder)
    assistant = part(designer, AcquireControl).open()
    with qtbot.waitSignal(assistant.bench.opened):
        assistant.sessions.open(folder)
    qtbot.waitUntil(lambda: assistant.bench.is_quiet)
    wrong, _seen = walks.drawn_as_html()
    assert wrong == []
    changed, count = walks.changed_by_wheel(assistant.window)
    assert changed == []
    assert count > 10
    assistant.bench.open(None, None)
    assistant.window.hide()


def test_a_wheel_changes_nothing_in_the_window(designer, walks, qtbot) -> None:
    for kind in (VariationsControl, InterpolationControl, StandardControl):
        designer.window.panel.bring_in_sight(part(designer, kind).host)
    part(designer, HandoverControl).open()
    part(designer, StandardControl).take_present()
    qtbot.waitUntil(lambda: designer.controller.is_idle)
    paint = designer.session.paint
    changed, count = walks.changed_by_wheel(designer.window)
    assert changed == []
    assert count > 30
    assert designer.session.paint is paint

"""The Viewer that several tests use is brought back to its start exactly, or replaced: see ``lasting.py``."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from brdf_suite.documents.view import Camera
from brdf_suite.documents.view_settings import Compare, LightColour


@pytest.fixture(scope="session")
def lasting() -> ModuleType:
    spec = importlib.util.spec_from_file_location("lasting", Path(__file__).with_name("lasting.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def in_new_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Go on with other settings, as the next test has."""
    return lambda name: monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / name))


def test_after_a_wild_session_a_viewer_is_as_a_new_one(
    start, lasting, lights, tmp_path, qtbot, in_new_settings
) -> None:
    used = start()
    kept = lasting.LastingViewer(used)
    controller, window, state = used.controller, used.window, used.state
    mesh = tmp_path / "tetra.obj"
    mesh.write_text("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    controller.open_file(str(mesh))
    controller.open_file(str(lights["bright"]))
    controller.open_file(str(tmp_path / "letter.docx"))
    controller.paint.open("copper")
    controller.open_file(str(tmp_path / "missing.brdfpaint"))
    controller.compare.choose("solid_white")
    qtbot.waitUntil(lambda: state.second is not None)
    state.change_view(compare=Compare("swipe", "solid_white"))
    used.wait_idle()
    QTest.mousePress(used.canvas, Qt.MouseButton.LeftButton, pos=QPoint(20, 20))
    QTest.mouseRelease(used.canvas, Qt.MouseButton.LeftButton, pos=QPoint(60, 30))
    window.commands.turntable.trigger()
    state.change_view(
        camera=Camera(azimuth_deg=10.0, distance=3.0),
        tone_curve="linear",
        background="grey",
        exposure_ev=1.5,
        light_colour=LightColour("A", adapted=False),
        fresnel="off",
    )
    controller.undo()
    window.commands.copy.trigger()
    window.messages.show_message(Message("note", "A note."))
    window.status.showMessage("something")
    window.environment.exposure.setFocus()
    used.pixels()
    assert {"dropped", "paint", "note"} <= set(used.messages())
    in_new_settings("next")
    assert kept.bring_back(used) == []
    assert used.messages() == {}
    assert (state.history.steps, state.history.undo_text, state.history.redo_text) == (0, "", "")
    assert (state.paint_key, state.fit.paint.name) == ("blue", "Blue")
    assert controller.paint.following

    in_new_settings("new")
    new = start()
    qtbot.waitUntil(lambda: new.state.light_figures is not None)
    assert used.view == new.view
    assert state.surface.value is new.state.surface.value
    assert state.environment.value is new.state.environment.value
    seen, expected = lasting.seen_of(controller), lasting.seen_of(new.controller)
    fits = {name for name in seen if "status_fit" in name}  # with the time that the fit took
    assert set(lasting.differences(seen, expected)) <= fits
    assert np.array_equal(used.pixels(), new.pixels())


def draw_nothing(viewer) -> None:
    viewer.controller.drawer.scene_renderer.draw = lambda *_: None


def refuse_lights(viewer) -> None:
    viewer.controller.drawer.uploads["environment"] = print


def listen(viewer) -> None:
    viewer.state.contents_changed.connect(print)


def begin_a_studio(viewer) -> None:
    viewer.controller.studio.new("three")


def widen(viewer) -> None:
    viewer.window.resize(900, 600)


def test_what_is_not_brought_back_is_noticed(start, lasting, in_new_settings) -> None:
    viewer = start()
    kept = lasting.LastingViewer(viewer)
    known: set[str] = set()
    for do in (draw_nothing, refuse_lights, listen, begin_a_studio, widen):
        do(viewer)
        in_new_settings(do.__name__)
        found = set(kept.bring_back(viewer))
        assert found > known, do
        known = found


def test_a_viewer_that_cannot_be_brought_back_is_replaced(start, lasting, in_new_settings) -> None:
    closed = []
    viewers = lasting.lasting_viewers(closed.append)
    take = next(viewers)
    first = take(start, None)
    assert take(start, lambda controller: first) is first
    widen(first)
    in_new_settings("next")
    second = take(start, lambda controller: first)
    assert second is not first
    assert closed == [first.controller]
    assert next(viewers, None) is None
    assert closed == [first.controller, second.controller]

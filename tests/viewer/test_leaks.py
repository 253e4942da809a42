"""A day's work: a thousand paints and fifty environments leave memory and OpenGL objects as they were."""

from __future__ import annotations

import gc
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.program.application import surface_format
from brdf_viewer.scene.drawing import SceneDrawer
from brdf_viewer.scene.viewer_state import ViewerState
from PySide6.QtGui import QOffscreenSurface, QOpenGLContext
from PySide6.QtWidgets import QApplication

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Compare
from brdf_suite.pipeline.lobe_fit import LobeFit, PaintFitter
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.realtime.gl.context import adopt_context
from brdf_suite.surface.mesh import Mesh, PartGeometry

SIZE = (48, 32)
MEGABYTE = 1 << 20


def resident() -> int:
    """Return the bytes of this process that are in memory."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096


def sheet() -> Mesh:
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32) * 0.1
    normals = np.tile(np.array([0, 0, 1], np.float32), (4, 1))
    triangles = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
    uvs = np.zeros((4, 2), np.float32)
    return Mesh("sheet", (PartGeometry("sheet", "paint", corners, normals, uvs, triangles),))


class Desk:
    """A state and what draws it, off screen and small."""

    def __init__(self, lights) -> None:
        # Qt's own, like the window's: a second kind of context in one process disturbs the windows of later tests.
        self.surface = QOffscreenSurface()
        self.surface.setFormat(surface_format(0))
        self.surface.create()
        self.qt_context = QOpenGLContext()
        self.qt_context.setFormat(surface_format(0))
        assert self.qt_context.create()
        assert self.qt_context.makeCurrent(self.surface)
        self.context = adopt_context(lambda name: int(self.qt_context.getProcAddress(name.encode()) or 0))
        self.environments = {name: load_environment(path) for name, path in lights.items()}
        self.view = View(Camera(azimuth_deg=0.0, elevation_deg=5.0))
        self.state = ViewerState(self.view)
        self.drawer = SceneDrawer(self.context, self.state, lambda: (0.1, 0.1, 0.1), self.refused)
        self.fitter = PaintFitter()
        self.target = self.context.simple_framebuffer(SIZE, 4)
        self.state.set_environment("dim", self.environments["dim"])
        self.state.set_surface("sheet", sheet())

    def refused(self, kind: str, error: Exception) -> None:
        raise AssertionError(f"{kind}: {error}")

    def show(self, number: int) -> None:
        lab = (30.0 + number % 60, 20.0 * np.sin(number), 20.0 * np.cos(number))
        self.state.set_fit(self.fitter.fit(solid_paint(f"paint {number}", lab)))
        self.draw()

    def draw(self) -> None:
        self.drawer.draw(self.target, SIZE, self.view)

    def pixels(self) -> np.ndarray:
        return np.frombuffer(self.target.read(components=3), np.uint8)

    def close(self) -> None:
        self.fitter.close()
        self.drawer.release()
        self.context.detect_framebuffer(0).use()
        self.target.release()
        self.qt_context.doneCurrent()


@pytest.fixture
def desk(qapp, lights):
    desk = Desk(lights)
    yield desk
    desk.close()


needs_proc = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")


def fits_alive() -> int:
    """How many fits of paints there are in this process."""
    return sum(isinstance(known, LobeFit) for known in gc.get_objects())


@needs_proc
def test_a_thousand_paints(desk) -> None:
    for number in range(100):
        desk.show(number)
    gc.collect()
    counters, memory, fits = desk.drawer.scene_renderer.renderer.counters, resident(), fits_alive()
    made, live, uploads = counters.total_created, counters.live, counters.texture_uploads
    first = desk.pixels().copy()
    for number in range(100, 1000):
        desk.show(number)
    gc.collect()
    assert not (desk.pixels() == first).all()
    assert (counters.total_created, counters.live) == (made, live)
    # What a paint uploads is a ramp at most, and a view of one mode none: see the counts of an edit elsewhere.
    assert counters.texture_uploads - uploads <= 900
    assert resident() - memory < 24 * MEGABYTE
    # Other tests of this process may have left some; of nine hundred more, none but the newest stay.
    assert fits_alive() <= fits + 4


@needs_proc
def test_fifty_environments(desk) -> None:
    desk.show(1)

    def change(number: int) -> None:
        name = ("bright", "dim")[number % 2]
        desk.state.set_environment(name, replace(desk.environments[name]))
        desk.draw()

    for number in range(10):
        change(number)
    gc.collect()
    counters, memory = desk.drawer.scene_renderer.renderer.counters, resident()
    live = counters.live
    first = desk.pixels().copy()
    for number in range(10, 60):
        change(number)
    gc.collect()
    assert (desk.pixels() == first).all()
    assert counters.live == live
    assert resident() - memory < 24 * MEGABYTE


@needs_proc
def test_modes_of_comparison_that_come_and_go(desk) -> None:
    desk.show(1)
    desk.state.set_second("b", desk.fitter.fit(solid_paint("b", (50.0, 40.0, 20.0))))
    modes = ("off", "side", "swipe", "blink", "difference")

    def round_of_modes() -> None:
        for mode in modes:
            desk.view = replace(desk.view, compare=Compare(mode, "b"))
            desk.draw()

    round_of_modes()
    round_of_modes()
    counters, memory = desk.drawer.scene_renderer.renderer.counters, resident()
    live = counters.live
    for _ in range(50):
        round_of_modes()
    gc.collect()
    assert counters.live == live
    assert resident() - memory < 24 * MEGABYTE


def test_the_window_makes_no_more_widgets(viewer, qtbot) -> None:
    def work(number: int) -> None:
        viewer.controller.paint.open(("solid_red", "blue")[number % 2])
        viewer.window.commands.figures.trigger()
        viewer.window.commands.compare.picked.emit(("swipe", "off")[number % 2])
        viewer.state.change_view(exposure_ev=float(number % 3))

    viewer.window.panel.bring_in_sight(viewer.window.tone)  # what is not seen is not counted
    viewer.controller.compare.choose("solid_white")
    qtbot.waitUntil(lambda: viewer.state.second is not None)
    for number in range(4):
        work(number)
    viewer.pixels()
    # What the first count of the pixels makes comes once, when the picture rests for the first time.
    qtbot.waitUntil(lambda: viewer.controller.tone.counted is not None)
    QApplication.sendPostedEvents(None, 0)
    widgets, live = (
        len(QApplication.allWidgets()),
        viewer.controller.drawer.scene_renderer.renderer.counters.live,
    )
    for number in range(30):
        work(number)
    viewer.pixels()
    qtbot.waitUntil(lambda: len(QApplication.allWidgets()) <= widgets)
    assert viewer.controller.drawer.scene_renderer.renderer.counters.live <= live

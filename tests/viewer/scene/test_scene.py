"""Environments and surfaces: chosen, dropped, refused, cancelled."""

from __future__ import annotations

import gc
import itertools
import os
import threading
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.work import scene_loading as loading
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QProgressBar, QPushButton, QWidget

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import save_paint
from brdf_suite.documents.view import Camera
from brdf_suite.errors import GraphicsError
from brdf_suite.pipeline.material import load_document
from brdf_suite.pipeline.picture import SceneRenderer
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.progress import report
from brdf_suite.realtime.pictures import moving


def drop(viewer, *paths: Path) -> bool:
    """Drop files on the middle of the picture, as a file manager does; False where the window refuses."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    place = QPointF(viewer.window.rect().center())
    button, keys = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(place.toPoint(), Qt.DropAction.CopyAction, data, button, keys)
    QApplication.sendEvent(viewer.window, enter)
    if not enter.isAccepted():
        return False
    QApplication.sendEvent(viewer.window, QDropEvent(place, Qt.DropAction.CopyAction, data, button, keys))
    return True


def choose(chooser, key: str) -> None:
    index = chooser.list.findData(key)
    assert index >= 0
    chooser.list.setCurrentIndex(index)
    chooser.list.activated.emit(index)


def test_a_dropped_environment_lights_the_surface(viewer, lights) -> None:
    first = viewer.pixels()
    assert drop(viewer, lights["bright"])
    assert viewer.view.environment == str(lights["dim"])  # the old one until the new one is there
    viewer.wait_idle()
    assert viewer.view.environment == str(lights["bright"])
    assert viewer.pixels().mean() > first.mean() + 10
    assert viewer.window.status.cell("environment").text() == "bright.exr"
    chooser = viewer.window.environment.chooser.list
    assert chooser.currentText() == "bright.exr"
    assert "64 × 32 pixels" in viewer.window.environment.facts.text()


def test_the_list_goes_back_to_an_earlier_file(viewer, lights) -> None:
    drop(viewer, lights["bright"])
    viewer.wait_idle()
    bright = viewer.pixels()
    choose(viewer.window.environment.chooser, str(lights["dim"]))
    viewer.wait_idle()
    assert viewer.pixels().mean() < bright.mean() - 10


def test_shipped_environments_and_surfaces_are_in_the_lists(viewer) -> None:
    environments, forms = viewer.window.environment.chooser.list, viewer.window.surface.chooser
    assert {environments.findText(t) for t in ("Light booth", "Sunny sky", "Overcast sky")}.isdisjoint({-1})
    rows = range(forms.sources.rowCount())
    titles = {forms.sources.source_at(row).title for row in rows}
    assert titles >= {"Speed form", "Sphere", "Curved panel", "Car"}
    first = viewer.pixels()
    viewer.window.panel.show_page("form")
    place = forms.view.visualRect(forms.view.sources.index(forms.sources.row_of("panel"), 0)).center()
    QTest.mouseClick(forms.view.viewport(), Qt.MouseButton.LeftButton, pos=place)
    viewer.wait_idle()
    assert forms.sources.present == "panel"
    assert viewer.view.surface == "panel"
    assert np.abs(viewer.pixels().astype(int) - first).max() > 20
    assert "triangles" in viewer.window.surface.facts.text()


def test_a_bad_environment_is_reported_and_the_old_picture_stays(filled, tmp_path) -> None:
    first, view = filled.pixels(), filled.view
    bad = tmp_path / "notes.hdr"
    bad.write_text("this is no picture\n" * 10)
    drop(filled, bad)
    filled.wait_idle()
    text = filled.messages()["environment"]
    assert text.startswith("notes.hdr: ")
    assert str(tmp_path) in text
    assert "The picture shows dim.exr" in text
    assert filled.view == view
    filled.qtbot.waitUntil(lambda: filled.window.environment.chooser.list.currentText() == "dim.exr")
    size = filled.pixels().shape
    filled.window.messages.dismiss("environment")
    filled.qtbot.wait(50)
    assert filled.pixels().shape == size  # the message lay over the picture
    assert np.array_equal(filled.pixels(), first)


def test_a_message_leaves_when_the_next_file_is_good(viewer, tmp_path, lights) -> None:
    drop(viewer, tmp_path / "missing.exr")
    viewer.wait_idle()
    assert "missing.exr" in viewer.messages()["environment"]
    drop(viewer, lights["bright"])
    viewer.wait_idle()
    assert "environment" not in viewer.messages()


def test_a_bad_mesh_is_reported_and_the_old_one_stays(viewer, tmp_path) -> None:
    bad = tmp_path / "empty.obj"
    bad.write_text("# no faces\nv 0 0 0\n")
    first = viewer.pixels()
    drop(viewer, bad)
    viewer.wait_idle()
    assert viewer.messages()["surface"].startswith("empty.obj: ")
    assert viewer.view.surface == "sphere"
    viewer.window.messages.dismiss("surface")
    viewer.qtbot.waitUntil(lambda: viewer.pixels().shape == first.shape)
    assert np.array_equal(viewer.pixels(), first)


def write_tetrahedron(folder: Path) -> Path:
    mesh = folder / "tetra.obj"
    mesh.write_text("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    return mesh


def test_the_first_frame_of_a_large_surface_is_coarse_and_the_next_whole(
    viewer, tmp_path, qtbot, monkeypatch
) -> None:
    drawn = []
    draw = SceneRenderer.draw

    def noted(self, view, framebuffer, size, coarseness=moving.WHOLE) -> None:
        drawn.append((self.renderer.mesh.triangle_count, coarseness))
        draw(self, view, framebuffer, size, coarseness)

    monkeypatch.setattr(SceneRenderer, "draw", noted)
    monkeypatch.setattr(moving, "_MANY_TRIANGLES", 1)
    monkeypatch.setattr(moving, "_QUICK_MS", 0.0)
    before = viewer.window.drawer.renderer.mesh.triangle_count
    drop(viewer, write_tetrahedron(tmp_path))
    qtbot.waitUntil(lambda: len([n for n, _ in drawn if n != before]) >= 2, timeout=60_000)
    assert [c for n, c in drawn if n != before][:2] == [moving.STEPS[-1], moving.WHOLE]


def test_a_dropped_mesh_is_drawn_and_framed(viewer, tmp_path) -> None:
    mesh = write_tetrahedron(tmp_path)
    first = viewer.pixels()
    drop(viewer, mesh)
    viewer.wait_idle()
    assert viewer.view.surface == str(mesh)
    assert viewer.state.surface.value.triangle_count == 4
    assert np.abs(viewer.pixels().astype(int) - first).max() > 20
    assert "4 triangles" in viewer.window.surface.facts.text()


def test_a_file_of_another_kind_is_reported(viewer, tmp_path) -> None:
    drop(viewer, tmp_path / "letter.docx")
    assert ".exr" in viewer.messages()["dropped"]
    assert "letter.docx" in viewer.messages()["dropped"]


def test_text_is_no_drop(viewer) -> None:
    data = QMimeData()
    data.setText("hello")
    button, keys = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    place = viewer.window.rect().center()
    event = QDragEnterEvent(place, Qt.DropAction.CopyAction, data, button, keys)
    event.ignore()
    QApplication.sendEvent(viewer.window, event)
    assert not event.isAccepted()


def test_the_dialog_opens_what_the_user_gives(start, lights) -> None:
    asked = []

    def ask(parent, kind: str) -> str:
        asked.append(kind)
        return str(lights["bright"]) if kind == "environment" else ""

    viewer = start(ask=ask)
    viewer.window.environment.chooser.button.click()
    viewer.wait_idle()
    assert viewer.view.environment == str(lights["bright"])
    view = viewer.view
    viewer.window.surface.chooser.button.click()  # the user presses Cancel
    assert asked == ["environment", "surface"]
    assert viewer.view == view


class SlowLoad:
    """Stands before the real reading, which is too fast to be stopped by hand, and waits in it."""

    def __init__(self) -> None:
        self.go_on = threading.Event()
        self.steps = 0

    def __call__(self, key: str, progress) -> object:
        while not self.go_on.wait(0.01):
            self.steps += 1
            report(progress, min(0.9, self.steps / 100), "prefiltering")
        return self.real(key, progress)


@pytest.fixture
def slow(monkeypatch) -> SlowLoad:
    slow = SlowLoad()
    slow.real = loading.prepare_environment
    monkeypatch.setattr(loading, "prepare_environment", slow)
    yield slow
    slow.go_on.set()


def test_progress_is_shown_and_cancel_keeps_the_old_picture(start, slow, lights, qtbot) -> None:
    slow.go_on.set()
    viewer = start()
    slow.go_on.clear()
    first, view = viewer.pixels(), viewer.view
    viewer.controller.scene.open("environment", str(lights["bright"]))
    strip = viewer.window.progress
    qtbot.waitUntil(strip.isVisible)
    assert viewer.window.status.cell("environment").text() == "(bright.exr)"
    # Another job may have a line as well: what is baked for the surface.
    qtbot.waitUntil(lambda: strip.findChild(QWidget, "job_environment") is not None)
    job = strip.findChild(QWidget, "job_environment")
    qtbot.waitUntil(lambda: job.findChild(QProgressBar).value() > 0)
    assert viewer.pixels().shape[1] == first.shape[1]  # drawn on while the work runs
    section = viewer.window.environment
    assert not section.figures.isEnabled()  # they are of the light that is still on show
    job.findChild(QPushButton).click()
    qtbot.waitUntil(lambda: viewer.controller.scene.is_idle)
    assert section.figures.isEnabled()
    assert "environment" not in strip.jobs
    assert viewer.view == view
    assert viewer.window.environment.chooser.list.currentText() == "dim.exr"
    assert viewer.messages() == {}
    slow.go_on.set()
    qtbot.wait(100)
    assert viewer.view == view  # the late answer is dropped


def test_before_the_first_picture_the_window_is_grey_and_alive(start, slow, qtbot) -> None:
    viewer = start(wait=False)
    qtbot.waitUntil(viewer.window.progress.isVisible)
    pixels = viewer.pixels().reshape(-1, 3)
    assert np.ptp(pixels) <= 1
    assert 0 < pixels[0, 0] < 255
    with qtbot.waitSignal(viewer.controller.picture_complete):
        slow.go_on.set()
    assert np.ptp(viewer.pixels()) > 50


def test_only_the_newest_of_several_requests_is_shown(viewer, lights) -> None:
    for name in ("bright", "dim", "bright", "dim", "bright"):
        viewer.controller.scene.open("environment", str(lights[name]))
    viewer.wait_idle()
    assert viewer.view.environment == str(lights["bright"])
    assert viewer.state.environment.key == str(lights["bright"])


def test_what_the_graphics_card_refuses_is_reported_and_the_old_one_drawn(
    viewer, lights, monkeypatch, qtbot
) -> None:
    first, environment = viewer.pixels(), viewer.state.environment.value
    luminance = viewer.state.light_figures.average_luminance
    upload = viewer.controller.drawer.uploads["environment"]

    def refuse(prepared) -> None:
        if prepared is not environment:
            raise GraphicsError("The graphics driver failed while making a texture: GL_OUT_OF_MEMORY.")
        upload(prepared)

    viewer.controller.drawer.uploads["environment"] = refuse

    def counted() -> bool:
        figures = viewer.state.light_figures
        return figures is not None and figures.average_luminance == luminance

    for as_a_whole in (False, True):
        if as_a_whole:  # refused at last, with nothing on its way any more
            viewer.state.set_environment(str(lights["bright"]), load_environment(str(lights["bright"])))
            viewer.state.light_figures = None
        else:
            drop(viewer, lights["bright"])
        qtbot.waitUntil(lambda: "environment" in viewer.messages())
        assert "OUT_OF_MEMORY" in viewer.messages()["environment"]
        assert viewer.view.environment == str(lights["dim"])
        qtbot.waitUntil(counted)  # those of the light that is drawn, and not of the refused one
        viewer.window.messages.dismiss("environment")
    qtbot.waitUntil(lambda: viewer.pixels().shape == first.shape)
    assert np.array_equal(viewer.pixels(), first)


def test_recent_files_are_in_the_menu_and_in_the_next_viewer(start, lights, qtbot) -> None:
    viewer = start()
    drop(viewer, lights["bright"])
    viewer.wait_idle()
    menu = viewer.window.commands.recent_menus["environment"]
    assert next(a.text() for a in menu.actions()) == str(lights["bright"])
    viewer.close()
    again = start()
    recent = again.window.commands.recent_menus["environment"].actions()
    assert str(lights["bright"]) in [a.text() for a in recent]
    next(a for a in recent if a.text() == str(lights["bright"])).trigger()
    again.wait_idle()
    assert again.view.environment == str(lights["bright"])


def test_a_dropped_paint_is_shown(viewer, tmp_path) -> None:
    file = tmp_path / "ruby.brdfpaint"
    save_paint(solid_paint("Ruby", (35.0, 60.0, 35.0)), file)
    before = viewer.pixels()
    drop(viewer, file)
    viewer.wait_idle()
    assert viewer.state.fit.paint.name == "Ruby"
    assert np.abs(viewer.pixels().astype(int) - before).max() > 30
    assert not viewer.window.paint.follow.isChecked()
    assert viewer.window.windowTitle() == "Ruby, Sphere, dim.exr"
    file.write_text("{}")
    drop(viewer, file)
    viewer.wait_idle()
    assert viewer.messages()["paint"].startswith("ruby.brdfpaint: ")
    assert viewer.state.fit.paint.name == "Ruby"


def test_a_cook_torrance_paint_is_shown(viewer, tmp_path) -> None:
    file = tmp_path / "measured.brdfpaint"
    save_paint(load_document("table1_2k_acrylack"), file)
    before = viewer.pixels()
    drop(viewer, file)
    viewer.wait_idle()
    assert viewer.state.fit.name == "2K Acrylack"
    assert np.abs(viewer.pixels().astype(int) - before).max() > 30
    assert viewer.window.windowTitle() == "2K Acrylack, Sphere, dim.exr"
    assert "ΔE00 0." in viewer.window.status.cell("fit").text()
    drop(viewer, file.with_name("missing.brdfpaint"))
    viewer.wait_idle()
    assert viewer.state.fit.name == "2K Acrylack"
    assert "2K Acrylack" in viewer.messages()["paint"]


def test_many_environments_leave_nothing_behind(start, lights) -> None:
    viewer = start(size=(1, 1))
    viewer.state.change_view(background="grey", camera=Camera(distance=6.0))

    def change(times: int) -> None:
        for index in range(times):
            viewer.controller.scene.open("environment", str(lights[("bright", "dim")[index % 2]]))
            viewer.wait_idle()
            viewer.pixels()
        gc.collect()

    change(6)
    live, growth = [viewer.controller.drawer.scene_renderer.renderer.counters.live], []
    for _ in range(6):  # what leaks grows each time; what is made once when it is first wanted does not
        memory = resident()
        change(4)
        growth.append(resident() - memory)
        live.append(viewer.controller.drawer.scene_renderer.renderer.counters.live)
        if live[-1] <= live[-2] and growth[-1] < 2.4e6:
            break
    assert any(later <= earlier for earlier, later in itertools.pairwise(live)), live
    assert min(growth) < 2.4e6, growth


def resident() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_after_a_failure_a_new_context_draws_the_same_picture(viewer, qtbot) -> None:
    before = viewer.pixels()
    old = viewer.controller.drawer
    viewer.controller.drawer.scene_renderer.draw = lambda *_: (_ for _ in ()).throw(
        GraphicsError("Out of memory.")
    )
    with qtbot.waitSignal(viewer.window.picture.failed):
        viewer.window.picture.redraw()
    assert viewer.window.status.cell("frame").text() == ""
    again = next(one for one in viewer.window.picture.findChildren(QPushButton) if one.text() == "Try again")
    assert again.isVisible()
    again.click()
    qtbot.waitUntil(lambda: viewer.controller.drawer is not old and viewer.controller.drawer.is_complete)
    assert np.array_equal(viewer.pixels(), before)
    azimuth = viewer.view.camera.azimuth_deg
    QTest.mousePress(viewer.canvas, Qt.MouseButton.LeftButton)
    assert viewer.canvas.cursor().shape() == Qt.CursorShape.ClosedHandCursor  # the new canvas is listened to
    assert viewer.view.camera.azimuth_deg == azimuth
    QTest.mouseRelease(viewer.canvas, Qt.MouseButton.LeftButton)


def test_after_a_lost_context_a_new_one_draws_the_same_picture(viewer, qtbot, monkeypatch) -> None:
    """No test can make a driver reset: the surface is made to see what Qt reports after one."""
    before, old, canvas = viewer.pixels(), viewer.controller.drawer, viewer.canvas
    surface = viewer.window.picture
    monkeypatch.setattr(type(surface), "is_lost", property(lambda one: one.canvas is canvas))
    with qtbot.waitSignal(surface.canvas_changed):
        surface.redraw()
    qtbot.waitUntil(lambda: viewer.controller.drawer is not old and viewer.controller.drawer.is_complete)
    assert np.array_equal(viewer.pixels(), before)
    assert surface.failure == ""
    assert not viewer.messages()

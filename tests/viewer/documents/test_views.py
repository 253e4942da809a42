"""Views as files, and what is remembered between runs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from brdf_qt.window.dialogs import Overwrite
from brdf_viewer.documents.remembered import recall, remember
from PySide6.QtCore import QSettings
from PySide6.QtTest import QTest

from brdf_suite.documents.store import load_view, save_view
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Compare, LightColour, Sparkle, SurfaceLook


class Answers:
    """Dialogs that answer with a script; they note what they were asked."""

    def __init__(self) -> None:
        self.path: Path | None = None
        self.overwrite = Overwrite.CANCEL
        self.asked: list[str] = []

    def open_path(self, folder, filters):
        self.asked.append("open")
        return self.path

    def save_path(self, suggested, filters):
        self.asked.append(f"save {suggested.name}")
        return self.path

    def changed_file(self, path):
        self.asked.append(f"changed {path.name}")
        return self.overwrite

    def unsaved(self, name):
        raise AssertionError("a view is never asked about")


def test_a_view_is_saved_opened_and_undone(start, lights, tmp_path) -> None:
    answers = Answers()
    viewer = start(dialogs=answers)
    first = viewer.view
    answers.path = tmp_path / "evening"
    viewer.state.change_view(
        exposure_ev=1.25,
        camera=Camera(azimuth_deg=200.0, distance=1.0, target=(0.0, 0.1, 0.0)),
        light_colour=LightColour("A", adapted=False),
        tone_curve="linear",
    )
    saved = viewer.view
    pixels = viewer.pixels()
    viewer.canvas.setFocus()
    viewer.qtbot.waitUntil(viewer.canvas.hasFocus)
    QTest.keySequence(viewer.canvas, "Ctrl+S")
    file = tmp_path / "evening.brdfview"
    assert answers.asked == ["save view.brdfview"]
    assert load_view(file) == saved
    viewer.state.set_view(first)
    steps = viewer.state.history.steps
    viewer.controller.open_file(str(file))
    viewer.wait_idle()
    assert viewer.view == saved
    assert viewer.state.history.steps == steps + 1
    assert (viewer.pixels() == pixels).all()
    # A double click on a number now goes back to what the file has.
    viewer.window.camera.elevation.setValue(70.0)
    viewer.window.camera.elevation.reset()
    assert viewer.view.camera.elevation_deg == saved.camera.elevation_deg
    viewer.window.commands.undo.trigger()
    viewer.window.commands.undo.trigger()
    viewer.window.commands.undo.trigger()
    assert viewer.view == first


def test_saving_again_asks_nothing_unless_the_file_has_changed(start, tmp_path) -> None:
    answers = Answers()
    viewer = start(dialogs=answers)
    file = answers.path = tmp_path / "a.brdfview"
    viewer.window.commands.save_view.trigger()
    viewer.state.change_view(exposure_ev=2.0)
    viewer.window.commands.save_view.trigger()
    assert answers.asked == ["save view.brdfview"]
    assert load_view(file).exposure_ev == 2.0
    save_view(View(exposure_ev=-3.0), file)
    viewer.window.commands.save_view.trigger()
    assert answers.asked[1:] == ["changed a.brdfview"]
    assert load_view(file).exposure_ev == -3.0
    answers.overwrite = Overwrite.OVERWRITE
    viewer.window.commands.save_view.trigger()
    assert load_view(file).exposure_ev == 2.0
    answers.path = tmp_path / "b.brdfview"
    viewer.window.commands.save_view_as.trigger()
    assert answers.path.exists()


def test_a_framed_camera_is_saved_where_it_stands(start, tmp_path) -> None:
    answers = Answers()
    viewer = start(dialogs=answers)
    answers.path = tmp_path / "a.brdfview"
    assert viewer.view.camera.distance is None
    viewer.window.commands.save_view.trigger()
    saved = load_view(answers.path).camera
    assert saved.distance is not None
    pixels = viewer.pixels()
    viewer.state.change_view(camera=saved)
    assert (viewer.pixels() == pixels).all()


def test_a_view_brings_its_light_and_surface(start, lights, tmp_path) -> None:
    viewer = start()
    file = tmp_path / "other.brdfview"
    camera = Camera(azimuth_deg=80.0, distance=0.9, target=(0.0, 0.0, 0.0))
    save_view(View(camera, str(lights["bright"]), "panel", compare=Compare("side", "solid_red")), file)
    viewer.window.files_dropped.emit([str(file)])
    viewer.wait_idle()
    assert (viewer.state.environment.key, viewer.state.surface.key) == (str(lights["bright"]), "panel")
    assert viewer.view.camera == camera
    viewer.qtbot.waitUntil(lambda: viewer.state.second is not None)


def test_a_view_that_cannot_be_read_is_reported(viewer, tmp_path) -> None:
    bad = tmp_path / "bad.brdfview"
    bad.write_text('{"format": "brdfview", "version": 3, "camera": {}, "exposure_ev": "bright"}')
    before = viewer.view
    viewer.controller.open_file(str(bad))
    viewer.wait_idle()
    assert "exposure_ev" in viewer.messages()["view"]
    assert viewer.view == before


def test_a_view_that_cannot_be_written_is_reported(start, tmp_path) -> None:
    answers = Answers()
    viewer = start(dialogs=answers)
    answers.path = tmp_path / "missing" / "a.brdfview"
    viewer.window.commands.save_view.trigger()
    assert "a.brdfview" in viewer.messages()["view"]
    assert viewer.controller.views.path is None


def test_speed_and_comparison_are_remembered_and_bad_values_left_out(qapp, tmp_path) -> None:
    file = str(tmp_path / "viewer.ini")
    store = QSettings(file, QSettings.Format.IniFormat)
    compare = Compare("swipe", "solid_red", 0.3, 4.0, 2.5, "picture")
    sparkle, look = Sparkle("texture", 3, 2.5), SurfaceLook(occlusion=False, ground=False)
    remember(
        store, replace(View(), turntable_deg_s=-60.0, compare=compare, sparkle=sparkle, surface_look=look)
    )
    store.sync()
    again = recall(QSettings(file, QSettings.Format.IniFormat))
    assert (again.sparkle, again.surface_look) == (sparkle, look)
    assert again.turntable_deg_s == -60.0
    assert again.compare == Compare(rate_hz=4.0, scale_delta_e=2.5, basis="picture")
    store.setValue("view/turntable_deg_s", "fast")
    store.setValue("compare/rate_hz", 1e9)
    store.setValue("sparkle/light_count", "many")
    store.setValue("surface_look/ground", "perhaps")
    assert recall(store).sparkle == replace(sparkle, light_count=Sparkle().light_count)
    assert recall(store).surface_look == replace(look, ground=True)
    assert recall(store).turntable_deg_s == View().turntable_deg_s
    assert recall(store).compare.rate_hz == Compare().rate_hz

"""Exports: the dialog, the process beside the Viewer, its progress, its end, its failures."""

from __future__ import annotations

import json
import os

import numpy as np
import OpenEXR
import pytest
from brdf_viewer.export.control import ExportControl
from brdf_viewer.export.job import FORMATS, ExportJob, ExportProcess, ExportSettings
from PIL import Image
from PySide6.QtGui import QAction

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lens


@pytest.fixture
def exporting(start, tmp_path):
    """A Viewer whose exports go to ``tmp_path/out``, under the name that is suggested."""
    folder = tmp_path / "out"
    folder.mkdir()
    viewer = start()
    control = viewer.controller.export
    control.ask = lambda _parent, name, _title, ending: str(folder / (name + ending))
    viewer.folder, viewer.export = folder, control
    return viewer


def run(viewer, settings: ExportSettings) -> None:
    viewer.export.export(settings)
    viewer.qtbot.waitUntil(lambda: not viewer.export.running)


@pytest.mark.usefixtures("four_samples")
def test_a_picture_as_it_is_on_screen(exporting) -> None:
    """The dialog's own settings, and the exported picture is the one on screen."""
    exporting.window.findChild(QAction, "action_Export Picture").trigger()
    dialog = exporting.export.dialog
    assert dialog.isVisible()
    assert not dialog.isModal()
    wanted = dialog.settings()
    assert wanted.size == exporting.window.picture.device_size
    assert wanted.form.title == "PNG, 8 bits"
    shown = exporting.pixels().astype(int)
    dialog.export_button.click()
    exporting.qtbot.waitUntil(lambda: not exporting.export.running)
    assert "export" not in exporting.messages()
    with Image.open(exporting.folder / "Blue.png") as image:
        assert image.info["icc_profile"]
        assert json.loads(image.info["View"])["surface"] == "sphere"
        difference = np.abs(np.asarray(image.convert("RGB")).astype(int) - shown)
    assert (difference > 1).mean() < 2e-3
    assert [path.name for path in exporting.folder.iterdir()] == ["Blue.png"]


def test_the_dialog_offers_what_each_kind_has(exporting) -> None:
    dialog = exporting.export.dialog
    for kind, forms in FORMATS.items():
        dialog.open_for(kind)
        assert [dialog.format.itemText(i) for i in range(dialog.format.count())] == [
            form.title for form in forms
        ]
        assert dialog.source.isVisible() == (kind == "sheet")
        assert dialog.frames.isVisible() == (kind == "turntable")
    assert not dialog.export_button.isEnabled()  # no palette yet
    dialog.ask_source = lambda _parent: "/somewhere/a.brdfpalette"
    dialog.browse_button.click()
    assert dialog.export_button.isEnabled()
    dialog.open_for("picture")
    dialog.format.setCurrentIndex(2)
    assert dialog.settings().colour_space == "rec2020"
    dialog.preset.setCurrentIndex(3)
    assert dialog.settings().size == (3840, 2160)
    assert dialog.settings().lens == Lens()
    dialog.aperture.setValue(2.8)
    dialog.turn.setValue(3.0)
    assert dialog.settings().lens == Lens(2.8, None, 3.0)
    dialog.width_field.setValue(1234)
    assert dialog.preset.currentText() == "Other"


def test_exr_turntable_and_sheet(exporting, tmp_path) -> None:
    run(exporting, ExportSettings("picture", FORMATS["picture"][2], (32, 24), "rec2020", transparent=True))
    with OpenEXR.File(str(exporting.folder / "Blue.exr")) as file:
        assert file.channels()["RGBA"].pixels.shape == (24, 32, 4)
    lens = Lens(0.5, 0.7, 4.0)
    run(exporting, ExportSettings("picture", FORMATS["picture"][2], (32, 24), "rec2020", lens=lens))
    with OpenEXR.File(str(exporting.folder / "Blue.exr")) as file:
        assert file.channels()["RGB"].pixels.shape == (24, 32, 3)
    assert exporting.state.view.lens == lens  # the view keeps it
    turn = ExportSettings("turntable", FORMATS["turntable"][2], (32, 24), frames=2, shutter_deg=180.0)
    run(exporting, turn)
    assert sorted(path.name for path in (exporting.folder / "Blue").iterdir()) == [
        "frame_0001.png",
        "frame_0002.png",
    ]
    palette = tmp_path / "Two.brdfpalette"
    save_palette(Palette("Two", (Entry(solid_paint("White", (95.0, 0.0, 1.0))),)), palette)
    run(exporting, ExportSettings("sheet", FORMATS["sheet"][0], (40, 30), source=str(palette)))
    with Image.open(exporting.folder / "Two.png") as image:
        assert image.info["Title"] == "Two"
    assert "export" not in exporting.messages()


def test_what_fails_is_reported_in_the_window(exporting) -> None:
    control: ExportControl = exporting.export
    control.ask = lambda *_: str(exporting.folder / "no" / "a.png")
    run(exporting, ExportSettings("picture", FORMATS["picture"][0], (32, 24)))
    assert "folder does not exist" in exporting.messages()["export"]
    control.ask = lambda *_: ""
    control.export(ExportSettings("picture", FORMATS["picture"][0], (32, 24)))
    assert not control.running
    assert list(exporting.folder.iterdir()) == []


def test_cancelled_it_leaves_nothing(exporting) -> None:
    """Cancelled as the user does, at the first step that it reports."""
    reported: list[float] = []

    def stop(kind: str, fraction: float, what: str) -> None:
        if "frame" in what and not reported:
            reported.append(fraction)
            exporting.window.busy_cancelled.emit(kind)

    exporting.window.set_busy = stop
    run(exporting, ExportSettings("turntable", FORMATS["turntable"][2], (64, 48), frames=7200))
    assert reported
    assert list(exporting.folder.iterdir()) == []
    assert "export" not in exporting.messages()


def test_closing_the_window_ends_an_export(exporting) -> None:
    exporting.export.export(ExportSettings("turntable", FORMATS["turntable"][2], (64, 48), frames=7200))
    process = exporting.export.process.process
    exporting.qtbot.waitUntil(lambda: process.processId() != 0)
    number = process.processId()
    exporting.close()
    with pytest.raises(ProcessLookupError):
        os.kill(number, 0)
    assert list(exporting.folder.iterdir()) == []


@pytest.mark.parametrize(("kind", "given"), [("picture", True), ("turntable", True), ("sheet", False)])
def test_an_export_is_fitted_as_the_picture_on_show(tmp_path, kind, given) -> None:
    settings = ExportSettings(kind, FORMATS[kind][0], (64, 48), source=str(tmp_path))
    job = ExportJob(settings, tmp_path / "out", View(), None, "blue", ("--lobe-count=7",))
    assert ("--lobe-count=7" in job.arguments()) == given
    job.tidy()


def test_ended_by_force_its_leftovers_are_taken_away(qtbot, tmp_path) -> None:
    job = ExportJob(
        ExportSettings("turntable", FORMATS["turntable"][2], (64, 48), frames=7200),
        tmp_path / "turn",
        View(surface="sphere"),
        None,
        "blue",
    )
    process = ExportProcess(job)
    with qtbot.waitSignal(process.moved, check_params_cb=lambda _f, what: what.startswith("frame 3")):
        process.start()
    assert job.leftovers()
    with qtbot.waitSignal(process.failed):
        process.process.kill()
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".turn")]
    assert not job.folder.exists()

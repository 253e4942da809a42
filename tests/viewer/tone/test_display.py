"""Exposure, tone curve, Fresnel and background: control to view to pixels."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from brdf_qt.window.command_palette import commands
from PIL import Image
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest

from brdf_suite.output.picture_file import picture_metadata


def run(viewer, command: str) -> None:
    dict(commands(viewer.window))[command].trigger()


def changes(viewer, act) -> float:
    """Return the largest change of a pixel that ``act`` makes."""
    first = viewer.pixels().astype(int)
    act()
    return float(np.abs(viewer.pixels().astype(int) - first).max())


def test_exposure(viewer) -> None:
    first = viewer.pixels().mean()
    viewer.window.environment.exposure.slider.setValue(20)
    assert viewer.view.exposure_ev == pytest.approx(2.0)
    assert viewer.pixels().mean() > first + 20
    assert viewer.window.status.cell("exposure").text() == "+2.0 EV"


def test_rotation(viewer) -> None:
    assert changes(viewer, lambda: viewer.window.environment.rotation.number.setValue(90)) > 20
    assert viewer.view.rotation_deg == 90
    assert viewer.window.environment.rotation.slider.value() == 90


def test_background(viewer) -> None:
    box = viewer.window.environment.background

    assert changes(viewer, lambda: choose(box, "grey")) > 20
    corner = viewer.pixels()[:4, :4].reshape(-1, 3)
    assert np.ptp(corner.mean(axis=0)) < 1.5  # neutral
    button = viewer.window.environment.background_colour
    assert not button.isEnabled()
    choose(box, "colour")
    assert button.isEnabled()
    button.click()
    button.picker.setCurrentColor(QColor(26, 26, 178))
    button.picker.close()
    assert viewer.view.background_colour == pytest.approx((26 / 255, 26 / 255, 178 / 255), abs=1e-4)
    r, g, b = viewer.pixels()[:4, :4].reshape(-1, 3).mean(axis=0)
    assert b > 150
    assert max(r, g) < 60


@pytest.mark.parametrize("index", [1, 2])
def test_tone_curve(viewer, index) -> None:
    curve = viewer.window.tone.curve
    assert changes(viewer, lambda: curve.activated.emit(index)) > 3
    assert viewer.view.tone_curve == curve.itemData(index)
    assert curve.currentIndex() == index


def choose(box, key) -> None:
    box.activated.emit(box.findData(key))


def test_fresnel(viewer) -> None:
    box = viewer.window.fresnel.mode
    assert changes(viewer, lambda: choose(box, "off")) > 3
    assert viewer.view.fresnel == "off"
    viewer.controller.undo()
    assert viewer.view.fresnel == "raised"
    assert box.currentData() == "raised"


def test_several_angles_are_fitted_on_a_thread_and_then_shown(viewer, qtbot) -> None:
    choose(viewer.window.fresnel.mode, "off")
    off = viewer.pixels()
    choose(viewer.window.fresnel.mode, "raised")
    raised = viewer.pixels()
    with qtbot.waitSignal(viewer.controller.drawer.angle_fits.arrived, timeout=60_000):
        choose(viewer.window.fresnel.mode, "multi_angle")
        viewer.pixels()
    several = viewer.pixels()
    assert viewer.window.fresnel.mode.currentData() == "multi_angle"
    away = np.abs(several.astype(int) - off).mean()
    assert 0 < np.abs(several.astype(int) - raised).mean() < 0.5 * away


def test_look_up(viewer) -> None:
    box = viewer.window.fresnel.look_up
    assert changes(viewer, lambda: choose(box, "paper")) > 1
    assert viewer.view.look_up == "paper"
    viewer.controller.undo()
    assert viewer.view.look_up == "shifted"
    assert box.currentData() == "shifted"


def test_the_picture_goes_to_the_clipboard(viewer, qapp) -> None:
    viewer.window.commands.copy.trigger()
    image = qapp.clipboard().image()
    assert (image.width(), image.height()) == viewer.window.picture.device_size


def test_the_picture_is_saved_with_what_it_shows(start, tmp_path) -> None:
    asked = []

    def ask(parent, name: str) -> str:
        asked.append(name)
        return str(tmp_path / "mine")

    viewer = start(ask_picture=ask)
    viewer.state.change_view(exposure_ev=1.0)
    run(viewer, "File ▸ Export As ▸ Save Picture…")
    assert asked == ["Blue"]
    with Image.open(tmp_path / "mine.png") as saved:
        text = dict(saved.text)
        pixels = np.asarray(saved)
    assert np.array_equal(pixels, viewer.pixels())
    assert text == picture_metadata(viewer.state.fit, viewer.view)
    assert "+1 EV" in text["Description"]
    assert viewer.messages() == {}
    assert "mine.png" in viewer.window.status.currentMessage()


def test_a_picture_that_cannot_be_saved_is_reported_until_one_is(start, tmp_path) -> None:
    names = [tmp_path / "missing" / "a.png", tmp_path / "a.jpg", "", tmp_path / "a.png"]
    viewer = start(ask_picture=lambda *_: str(names.pop(0)))
    run(viewer, "File ▸ Export As ▸ Save Picture…")
    assert str(tmp_path / "missing") in viewer.messages()["picture"]
    run(viewer, "File ▸ Export As ▸ Save Picture…")
    assert "ends in .png" in viewer.messages()["picture"]
    run(viewer, "File ▸ Export As ▸ Save Picture…")  # the user gives up
    assert "picture" in viewer.messages()
    run(viewer, "File ▸ Export As ▸ Save Picture…")
    assert viewer.messages() == {}
    assert [file.name for file in tmp_path.glob("a.*")] == ["a.png"]


def test_before_there_is_a_picture_none_is_saved(start) -> None:
    viewer = start(wait=False, ask_picture=lambda *_: pytest.fail("nothing to ask for"))
    viewer.controller.state.environment = None
    run(viewer, "File ▸ Export As ▸ Save Picture…")
    assert "no picture yet" in viewer.messages()["picture"]


@pytest.mark.parametrize(
    ("query", "command"),
    [
        ("overcast", "View ▸ Environment ▸ Overcast sky"),
        ("curved panel", "View ▸ Surface ▸ Curved panel"),
        ("copper", "Paint ▸ Open Shipped Paint ▸ Copper"),
        ("linear", "View ▸ Tone Curve ▸ Linear, clipping marked"),
    ],
)
def test_everything_shipped_is_found_by_name(start, query, command) -> None:
    viewer = start()
    palette = viewer.window.palette_window
    palette.open()
    QTest.keyClicks(palette.query, query)
    assert palette.found.currentItem().text() == command
    before = viewer.view
    QTest.keyClick(palette.query, Qt.Key.Key_Return)
    viewer.wait_idle()
    if query == "copper":
        assert viewer.state.fit.paint.name == "Copper"
        assert viewer.view == before
        return
    changed = {
        "overcast": {"environment": "overcast"},
        "curved panel": {"surface": "panel"},
        "linear": {"tone_curve": "linear", "clipping_marks": True},
    }[query]
    kept = dataclasses.replace(before, **changed, camera=viewer.view.camera)
    assert viewer.view == kept
    assert dict(commands(viewer.window))[command].isChecked()

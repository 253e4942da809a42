"""The lighting section: presets, light colour with and without adaptation, exposure, lamps."""

from __future__ import annotations

import dataclasses
import threading

import numpy as np
import pytest
from brdf_qt.gl.aiming import placed, polar_of
from brdf_viewer.light.control import metered_part
from brdf_viewer.light.section import (
    ILLUMINANT_TITLES,
    PRESETS,
    LampFields,
    colour_note,
    preset_of,
    with_preset,
)
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import ILLUMINANTS, MOST_LAMPS, Lamp, LightColour
from brdf_suite.pipeline import seen_weights
from brdf_suite.pipeline.scene import environment_names


def press(viewer, key: str) -> None:
    button = viewer.window.lighting.preset_buttons[key]
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def choose(box, key: str) -> None:
    box.setCurrentIndex(box.findData(key))
    box.activated.emit(box.currentIndex())


def test_every_preset_can_be_had() -> None:
    assert {preset.environment for preset in PRESETS.values()} <= set(environment_names())
    assert tuple(ILLUMINANT_TITLES) == ILLUMINANTS
    start = View(environment="overcast", exposure_ev=1.0, light_colour=LightColour("A", adapted=False))
    for key in PRESETS:
        view = with_preset(start, key)
        assert preset_of(view) == key
        assert (view.exposure_ev, view.light_colour.adapted) == (1.0, False)
    assert preset_of(View(environment="booth", lamps=(Lamp("directional"),))) == ""


def test_a_preset_is_one_step_that_can_be_undone(viewer) -> None:
    before = viewer.view
    press(viewer, "a")
    viewer.wait_idle()
    assert viewer.state.environment.key == "booth"
    assert viewer.view.light_colour.illuminant == "A"
    assert viewer.window.lighting.preset_buttons["a"].isChecked()
    assert not viewer.window.lighting.preset_buttons["d65"].isChecked()
    viewer.controller.undo()
    viewer.wait_idle()
    assert viewer.view == before
    assert viewer.state.environment.key == before.environment
    assert not any(button.isChecked() for button in viewer.window.lighting.preset_buttons.values())


def test_the_tint_is_seen_until_the_eye_has_adapted(viewer) -> None:
    section = viewer.window.lighting
    plain = viewer.pixels().astype(int)
    assert not section.adapted.isEnabled()
    choose(section.illuminant, "A")
    assert viewer.view.light_colour == LightColour("A", adapted=True)
    assert np.array_equal(viewer.pixels(), plain)
    assert "No metamerism" in section.metamerism.text()
    section.adapted.click()
    tinted = viewer.pixels().astype(int)
    warmth = (tinted[..., 0] - tinted[..., 2]).mean() - (plain[..., 0] - plain[..., 2]).mean()
    assert warmth > 20
    assert "tint" in section.metamerism.text()
    choose(section.illuminant, "environment")
    assert np.array_equal(viewer.pixels(), plain)
    assert section.metamerism.isHidden()


def test_what_is_assumed_of_the_paint_is_said() -> None:
    assert colour_note(LightColour("D65", adapted=False), "unknown") == ""
    for adapted in (True, False):
        assert "No metamerism" in colour_note(LightColour("TL84", adapted), "unknown")
        assert "were computed" in colour_note(LightColour("TL84", adapted), "used")
        assert "are being computed" in colour_note(LightColour("TL84", adapted), "in work")


def test_automatic_exposure_follows_the_light_and_locked_does_not(viewer, lights, qtbot) -> None:
    viewer.state.change_view(background="grey")
    cell, section = viewer.window.status.cell("exposure"), viewer.window.lighting
    choose(section.exposure_mode, "automatic")
    dim = viewer.pixels().astype(int)
    dim_ev = viewer.state.exposed_view.exposure_ev
    qtbot.waitUntil(lambda: "automatic" in cell.text())
    viewer.controller.open_file(str(lights["bright"]))
    viewer.wait_idle()
    qtbot.waitUntil(lambda: viewer.state.exposed_view.exposure_ev < dim_ev - 0.5)
    automatic = viewer.pixels().astype(int)
    rows, columns = (n // 2 for n in automatic.shape[:2])
    middle = np.s_[rows - 15 : rows + 15, columns - 15 : columns + 15]
    assert abs(np.median(automatic[middle]) - np.median(dim[middle])) < 25
    ev = viewer.state.exposed_view.exposure_ev
    choose(section.exposure_mode, "locked")  # the picture stays, and so does the number from now on
    assert viewer.view.exposure_ev == pytest.approx(ev)
    assert np.array_equal(viewer.pixels(), automatic)
    viewer.controller.open_file(str(lights["dim"]))
    viewer.wait_idle()
    assert viewer.view.exposure_ev == pytest.approx(ev)
    assert viewer.pixels().mean() < automatic.mean()


def test_the_meter_waits_until_the_camera_rests(viewer, qtbot) -> None:
    choose(viewer.window.lighting.exposure_mode, "automatic")
    viewer.pixels()
    measured = viewer.state.metered_ev
    viewer.state.change_view(camera=Camera(elevation_deg=80.0))
    viewer.pixels()
    assert viewer.state.metered_ev == measured
    qtbot.waitUntil(lambda: viewer.state.metered_ev != measured)


def test_the_meter_looks_at_light_and_object_alone() -> None:
    view = View()
    for change in ({"exposure_ev": 1.0}, {"tone_curve": "linear"}, {"background": "grey"}):
        assert metered_part(dataclasses.replace(view, **change)) == metered_part(view)
    for change in ({"rotation_deg": 1.0}, {"lamps": (Lamp(),)}, {"environment": "sunny"}):
        assert metered_part(dataclasses.replace(view, **change)) != metered_part(view)


def test_lamps_are_added_edited_and_removed(viewer) -> None:
    fields = viewer.window.lighting.lamps
    fields.add_button.click()
    assert len(viewer.view.lamps) == 1
    fields.azimuth.setValue(90.0)
    fields.elevation.setValue(0.0)
    fields.distance.setValue(2.0)
    fields.strength.setValue(5.0)
    fields.temperature.setValue(3000.0)
    lamp = viewer.view.lamps[0]
    assert lamp.position == pytest.approx((2.0, 0.0, 0.0))
    assert (lamp.strength, lamp.temperature_k) == (5.0, 3000.0)
    choose(fields.kind, "directional")
    assert viewer.view.lamps[0].azimuth_deg == 90.0
    assert fields.distance.isHidden()
    fields.add_button.click()
    assert len(viewer.view.lamps) == 2
    assert viewer.view.lamps[0].kind == "directional"
    fields.remove_button.click()
    fields.remove_button.click()
    assert viewer.view.lamps == ()
    assert not fields.remove_button.isEnabled()


def test_no_more_lamps_than_a_view_may_have(qtbot) -> None:
    fields = LampFields()
    qtbot.addWidget(fields)
    for _ in range(MOST_LAMPS + 3):
        fields.add_button.click()
    assert len(fields.lamps) == MOST_LAMPS
    assert not fields.add_button.isEnabled()


def test_a_moving_lamp_goes_round_and_is_one_step(viewer, qtbot) -> None:
    press(viewer, "point")
    viewer.wait_idle()
    _, elevation, distance = polar_of(viewer.view.lamps[0])
    start, steps = viewer.view.lamps[0].position, viewer.state.history.steps
    viewer.window.lighting.lamps.moving.click()
    qtbot.waitUntil(lambda: viewer.view.lamps[0].position != start)
    viewer.window.lighting.lamps.moving.click()
    assert polar_of(viewer.view.lamps[0])[1:] == pytest.approx((elevation, distance))
    assert viewer.state.history.steps == steps + 1
    viewer.controller.undo()
    assert viewer.view.lamps[0].position == start
    assert preset_of(viewer.view) == "point"


@pytest.mark.parametrize("kind", ["point", "directional"])
def test_a_lamp_is_where_it_was_put(kind: str) -> None:
    for azimuth, elevation in ((-170.0, 30.0), (10.0, -45.0), (135.0, 80.0)):
        lamp = placed(Lamp(kind), azimuth, elevation, 3.0)
        assert polar_of(lamp) == pytest.approx((azimuth, elevation, 3.0))


def test_a_paint_with_spectra_is_computed_in_the_lamp(viewer, shared_data, qtbot) -> None:
    def pixels() -> np.ndarray:
        # Weights at every angle of the view follow; and a bar of progress takes some of the picture's height.
        qtbot.waitUntil(lambda: not (viewer.window.busy or viewer.controller.drawer.awaits_weights))
        QApplication.processEvents()
        return viewer.pixels()

    viewer.controller.open_file(str(shared_data / "brdf" / "krylon_blue.brdf"))
    qtbot.waitUntil(lambda: viewer.state.paint_key.endswith("krylon_blue.brdf"))
    section = viewer.window.lighting
    fit, plain = viewer.state.fit, pixels().astype(int)
    choose(section.illuminant, "A")
    qtbot.waitUntil(lambda: viewer.state.relit is not None)
    assert "were computed from the paint's spectra" in section.metamerism.text()
    assert viewer.state.drawn_fit is not fit
    assert np.abs(pixels() - plain).max() > 5  # though the eye has adapted
    viewer.controller.compare.choose(viewer.state.paint_key)  # B is the same paint, and in the same lamp
    qtbot.waitUntil(lambda: viewer.state.second_relit is not None)
    np.testing.assert_allclose(
        viewer.state.drawn_second.value.weights.kd, viewer.state.drawn_fit.weights.kd, atol=1e-9
    )
    viewer.controller.compare.set_mode("off")
    choose(section.illuminant, "D65")
    assert viewer.state.drawn_second is viewer.state.second
    assert viewer.state.drawn_fit is fit
    assert np.array_equal(pixels(), plain)


def test_a_picture_is_finished_only_with_its_weights_by_view(start, shared_data, qtbot, monkeypatch) -> None:
    go_on = threading.Event()
    find = seen_weights.seen_weights

    def held(*arguments: object) -> object:
        go_on.wait()
        return find(*arguments)

    monkeypatch.setattr(seen_weights, "seen_weights", held)
    viewer = start(paint=str(shared_data / "brdf" / "krylon_blue.brdf"), wait=False)
    finished: list[bool] = []
    viewer.controller.picture_finished.connect(lambda: finished.append(True))
    qtbot.waitUntil(lambda: bool(viewer.window.status.cell("frame").text()))
    qtbot.waitUntil(lambda: viewer.controller.drawer.awaits_weights)
    qtbot.wait(50)
    assert not finished
    go_on.set()
    qtbot.waitUntil(lambda: bool(finished))

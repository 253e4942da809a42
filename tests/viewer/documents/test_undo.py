"""Undo and redo of the view: one step a gesture."""

from __future__ import annotations

from dataclasses import replace

import pytest
from brdf_viewer.documents.view_history import PAUSE_MS, ViewHistory, changed_fields, step_name
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Compare, Relief


def test_changes_of_the_same_field_that_follow_closely_are_one_step(qapp) -> None:
    history = ViewHistory(View())
    heard = []
    history.changed.connect(lambda old, new: heard.append((old.exposure_ev, new.exposure_ev)))
    for value in (0.5, 1.0, 1.5):
        history.set(replace(history.value, exposure_ev=value))
    history.set(replace(history.value, exposure_ev=1.5))
    history.set(replace(history.value, tone_curve="linear"))
    assert (history.undo_text, history.steps) == ("Change Tone Curve", 2)
    history.undo()
    history.undo()
    assert history.value == View()
    assert (history.undo_text, history.redo_text) == ("", "Change Exposure")
    history.redo()
    assert history.value.exposure_ev == 1.5
    assert heard == [(0.0, 0.5), (0.5, 1.0), (1.0, 1.5), (1.5, 1.5), (1.5, 1.5), (1.5, 0.0), (0.0, 1.5)]


def test_after_a_pause_it_is_another_step(qtbot) -> None:
    history = ViewHistory(View())
    history.set(View(exposure_ev=1.0))
    qtbot.wait(PAUSE_MS + 200)
    history.set(View(exposure_ev=2.0))
    history.undo()
    assert history.value.exposure_ev == 1.0


def test_a_gesture_is_one_step_whatever_it_changes(qapp) -> None:
    history = ViewHistory(View())
    history.begin()
    history.set(View(rotation_deg=10.0))
    history.set(View(rotation_deg=20.0, camera=Camera(azimuth_deg=1.0)))
    history.end()
    history.set(View(rotation_deg=30.0, camera=Camera(azimuth_deg=1.0)))
    assert (history.undo_text, history.steps) == ("Turn Light", 2)
    history.undo()
    history.undo()
    assert history.value == View()


def test_what_runs_by_itself_is_one_step_at_its_end(qapp) -> None:
    history = ViewHistory(View())
    history.begin_running("Turntable")
    for angle in range(5):
        history.amend(View(rotation_deg=float(angle)))
    assert (history.undo_text, history.steps) == ("Turntable", 0)
    history.end_running()
    assert (history.undo_text, history.steps) == ("Turntable", 1)
    history.undo()
    assert history.value == View()
    history.redo()
    assert history.value.rotation_deg == 4.0


def test_an_edit_while_it_runs_is_a_step_of_its_own(qapp) -> None:
    history = ViewHistory(View())
    history.begin_running("Turntable")
    history.amend(View(rotation_deg=5.0))
    history.set(View(rotation_deg=5.0, exposure_ev=1.0))
    history.amend(View(rotation_deg=9.0, exposure_ev=1.0))
    history.end_running()
    assert history.undo_text == "Change Exposure"
    history.undo()
    assert history.value == View(rotation_deg=5.0)


@pytest.mark.parametrize(
    ("view", "names", "step"),
    [
        (View(), (), ""),
        (View(camera=Camera(azimuth_deg=3.0)), ("camera",), "Move Camera"),
        (View(compare=Compare(divider=0.3)), ("compare.divider",), "Move Divider"),
        (
            View(compare=Compare("swipe", "red")),
            ("compare.mode", "compare.paint"),
            "Change Compare",
        ),
        (View(relief=Relief(orange_peel=0.3)), ("relief.orange_peel",), "Change Relief"),
    ],
)
def test_names_of_steps(view, names, step) -> None:
    assert changed_fields(View(), view) == names
    assert step_name(names) == step


def move(canvas, dx: int, buttons=Qt.MouseButton.LeftButton) -> None:
    """Drag in five moves, as a hand does."""
    start = QPointF(canvas.rect().center())
    QTest.mousePress(canvas, buttons, Qt.KeyboardModifier.NoModifier, start.toPoint())
    for i in range(1, 6):
        place = start + QPointF(dx * i / 5, 0)
        event = QMouseEvent(
            QEvent.Type.MouseMove,
            place,
            canvas.mapToGlobal(place),
            Qt.MouseButton.NoButton,
            buttons,
            Qt.KeyboardModifier.NoModifier,
        )
        QApplication.sendEvent(canvas, event)
    QTest.mouseRelease(canvas, buttons, Qt.KeyboardModifier.NoModifier, place.toPoint())


def test_keys_undo_a_drag_as_one_step(viewer, qtbot) -> None:
    commands, before = viewer.window.commands, viewer.view
    assert not commands.undo.isEnabled()
    first = viewer.pixels()
    move(viewer.canvas, 100)
    move(viewer.canvas, -30)
    moved = viewer.view
    assert commands.undo.text() == "&Undo Move Camera"
    viewer.canvas.setFocus()
    qtbot.waitUntil(viewer.canvas.hasFocus)
    QTest.keySequence(viewer.canvas, "Ctrl+Z")
    QTest.keySequence(viewer.canvas, "Ctrl+Z")
    assert viewer.view == before
    assert (viewer.pixels() == first).all()
    assert not commands.undo.isEnabled()
    commands.redo.trigger()
    commands.redo.trigger()
    assert viewer.view == moved


def test_a_sliders_drag_and_a_typed_number_are_a_step_each(viewer) -> None:
    exposure = viewer.window.environment.exposure
    for steps in (3, 7, 12):
        exposure.slider.setValue(steps)
    viewer.window.camera.elevation.setValue(40.0)
    assert viewer.state.history.steps == 2
    viewer.window.commands.undo.trigger()
    viewer.window.commands.undo.trigger()
    assert (exposure.value(), viewer.window.camera.elevation.value()) == (0.0, 7.0)


def test_presets_are_a_step_each_however_fast(viewer) -> None:
    commands = viewer.window.commands
    for action in commands.presets:
        action.trigger()
    assert viewer.state.history.steps == len(commands.presets)


def test_the_turntable_is_one_step_and_stops_for_undo(viewer, qtbot) -> None:
    commands, before = viewer.window.commands, viewer.view
    commands.turntable.trigger()
    qtbot.waitUntil(lambda: viewer.view.rotation_deg < before.rotation_deg - 2)
    assert commands.undo.text() == "&Undo Turntable"
    commands.undo.trigger()
    assert not commands.turntable.isChecked()
    assert viewer.view.rotation_deg == before.rotation_deg
    assert viewer.state.history.steps == 0


def test_the_turntables_speed_and_direction(viewer, qtbot) -> None:
    viewer.window.camera.turntable.setValue(-90.0)
    assert viewer.view.turntable_deg_s == -90.0
    before = viewer.view.rotation_deg
    viewer.window.commands.turntable.trigger()
    qtbot.waitUntil(lambda: viewer.view.rotation_deg > before + 5)
    viewer.window.commands.turntable.trigger()
    viewer.window.camera.turntable.setValue(0.0)
    viewer.window.commands.turntable.trigger()
    still = viewer.view
    qtbot.wait(100)
    assert viewer.view == still


def test_an_environment_and_a_surface_are_brought_back(viewer, lights, qtbot) -> None:
    scene = viewer.controller.scene
    camera = viewer.view.camera
    scene.open("environment", str(lights["bright"]))
    viewer.wait_idle()
    scene.open("surface", "panel")
    viewer.wait_idle()
    assert viewer.state.history.steps == 2
    commands = viewer.window.commands
    commands.undo.trigger()
    viewer.wait_idle()
    assert viewer.state.surface.key == "sphere"
    assert viewer.view.camera == camera
    commands.undo.trigger()
    viewer.wait_idle()
    assert viewer.state.environment.key == viewer.view.environment == str(lights["dim"])
    assert viewer.state.history.steps == 0
    commands.redo.trigger()
    commands.redo.trigger()
    viewer.wait_idle()
    assert (viewer.state.environment.key, viewer.state.surface.key) == (str(lights["bright"]), "panel")
    assert viewer.window.surface.chooser.sources.present == "panel"


def test_an_environment_that_is_gone_is_reported_and_the_view_names_what_is_drawn(
    viewer, lights, tmp_path
) -> None:
    copy = tmp_path / "copy.exr"
    copy.write_bytes(lights["bright"].read_bytes())
    viewer.controller.scene.open("environment", str(copy))
    viewer.wait_idle()
    viewer.controller.scene.open("environment", str(lights["dim"]))
    viewer.wait_idle()
    copy.unlink()
    viewer.window.commands.undo.trigger()
    viewer.wait_idle()
    assert "copy.exr" in viewer.messages()["environment"]
    assert viewer.view.environment == viewer.state.environment.key == str(lights["dim"])

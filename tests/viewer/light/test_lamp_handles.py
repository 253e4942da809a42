"""Lamps dragged in the picture, and put where their highlight is clicked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from brdf_suite.documents.view import Camera
from brdf_suite.documents.view_settings import Lamp

LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
FRONT = Camera(azimuth_deg=0.0, elevation_deg=0.0)


def handles(viewer):
    return viewer.controller.lamps.handles.layer.handles


def drag(viewer, start: QPoint, *ways: QPoint) -> None:
    QTest.mousePress(viewer.canvas, LEFT, NONE, start)
    for way in ways:
        QTest.mouseMove(viewer.canvas, start + way)
    QTest.mouseRelease(viewer.canvas, LEFT, NONE, start + ways[-1])


def with_lamps(viewer, *lamps: Lamp) -> None:
    viewer.window.show_tab("light")
    viewer.state.change_view(lamps=lamps, camera=FRONT)
    viewer.state.history.end()


def test_a_handle_lies_in_the_lamps_direction_and_moves_it(viewer) -> None:
    with_lamps(
        viewer, Lamp("directional", azimuth_deg=0.0, elevation_deg=30.0), Lamp(position=(2.0, 0.0, 0.0))
    )
    layer = viewer.controller.lamps.handles.layer
    assert layer.isVisible()
    first, second = handles(viewer)
    assert first.place.x() == pytest.approx(layer.centre.x())
    assert layer.centre.y() - first.place.y() == pytest.approx(layer.reach / 3.0)  # 30 of 90 degrees up
    assert second.place.x() - layer.centre.x() == pytest.approx(layer.reach)
    before, steps = viewer.view, viewer.state.history.steps
    drag(viewer, first.place.toPoint(), QPoint(2, -2), QPoint(0, -round(layer.reach / 3.0)))
    lamp = viewer.view.lamps[0]
    assert lamp.elevation_deg == pytest.approx(60.0, abs=4.0)
    assert lamp.azimuth_deg == pytest.approx(0.0, abs=4.0)
    assert viewer.window.lighting.lamps.elevation.value() == pytest.approx(lamp.elevation_deg, abs=0.1)
    assert viewer.view.camera == before.camera
    assert viewer.window.surface.parts.picked() == []
    assert viewer.state.history.steps == steps + 1
    viewer.controller.undo()
    assert viewer.view == before


def test_a_point_lamp_keeps_its_distance_and_goes_behind(viewer) -> None:
    with_lamps(viewer, Lamp(position=(0.0, 1.5, 1.5)))
    layer = viewer.controller.lamps.handles.layer
    start = handles(viewer)[0].place.toPoint()
    assert not handles(viewer)[0].behind
    drag(viewer, start, QPoint(0, -5), QPoint(0, -round(layer.reach)))
    position = np.array(viewer.view.lamps[0].position)
    assert np.linalg.norm(position) == pytest.approx(np.hypot(1.5, 1.5), abs=1e-6)
    assert position[2] < 0.0 < position[1]
    assert handles(viewer)[0].behind


def test_beside_a_handle_the_camera_turns(viewer) -> None:
    with_lamps(viewer, Lamp("directional", azimuth_deg=0.0, elevation_deg=30.0))
    lamps = viewer.view.lamps
    drag(viewer, handles(viewer)[0].place.toPoint() + QPoint(40, 0), QPoint(20, 0))
    assert viewer.view.camera != FRONT
    assert viewer.view.lamps == lamps


def test_handles_are_put_away_and_hidden_with_the_tab(viewer) -> None:
    with_lamps(viewer, Lamp())
    layer = viewer.controller.lamps.handles.layer
    viewer.window.show_tab("paint")
    assert not layer.isVisible()
    viewer.window.show_tab("light")
    assert layer.isVisible()
    viewer.canvas.setFocus()
    QTest.keyClick(viewer.canvas, Qt.Key.Key_L)
    assert not layer.isVisible()
    QTest.keyClick(viewer.canvas, Qt.Key.Key_L)
    assert layer.isVisible()


@pytest.mark.parametrize("given", [(), (Lamp("point", position=(0.0, 3.0, 0.0), strength=20.0),)])
def test_the_highlight_comes_where_it_is_clicked(viewer, given) -> None:
    with_lamps(viewer, *given)
    viewer.state.change_part("light_colour", brightness=0.0)
    before = viewer.view
    viewer.window.lighting.lamps.highlight.click()
    assert viewer.controller.lamps.asking.isChecked()
    canvas = viewer.canvas
    place = QPoint(canvas.width() // 2 + 22, canvas.height() // 2 - 18)
    QTest.mouseClick(canvas, LEFT, NONE, QPoint(3, 3))  # beside the surface nothing happens
    assert viewer.view == before
    QTest.mouseClick(canvas, LEFT, NONE, place)
    assert len(viewer.view.lamps) == 1
    assert not viewer.window.lighting.lamps.highlight.isChecked()
    assert viewer.window.surface.parts.picked() == []
    viewer.state.change_view(exposure_ev=-3.0)
    light = viewer.pixels().sum(axis=2).astype(float)
    rows, columns = np.nonzero(light >= 0.9 * light.max())
    assert (columns.mean(), rows.mean()) == pytest.approx((place.x(), place.y()), abs=3.0)
    viewer.controller.undo()
    viewer.controller.undo()
    assert viewer.view == before


def test_escape_ends_the_question(viewer) -> None:
    viewer.canvas.setFocus()
    QTest.keyClick(viewer.canvas, Qt.Key.Key_L, Qt.KeyboardModifier.ShiftModifier)
    layer = viewer.controller.lamps.handles.layer
    assert layer.words.startswith("Click on the surface")
    assert viewer.canvas.cursor().shape() == Qt.CursorShape.CrossCursor
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Escape)
    assert layer.words == ""
    before = replace(viewer.view)
    QTest.mouseClick(viewer.canvas, LEFT, NONE, viewer.canvas.rect().center())
    assert viewer.view == before


def test_a_drag_that_turns_the_light_says_so_for_a_moment(viewer, qtbot) -> None:
    layer, canvas = viewer.controller.lamps.handles.layer, viewer.canvas
    middle, alt = canvas.rect().center(), Qt.KeyboardModifier.AltModifier
    QTest.mousePress(canvas, LEFT, alt, middle)
    QTest.mouseMove(canvas, middle + QPoint(40, 0))
    assert viewer.view.rotation_deg == pytest.approx(20.0)
    assert layer.words.startswith("Light turned to 20°")
    QTest.mouseRelease(canvas, LEFT, alt, middle + QPoint(40, 0))
    qtbot.waitUntil(lambda: not layer.words)

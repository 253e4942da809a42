"""Gestures, keys and fields move the camera and the light, and the picture with them."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from brdf_qt.window.view_titles import PRESETS
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.pipeline.picture import SceneRenderer
from brdf_suite.realtime.pictures import moving

LEFT, MIDDLE = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton
NONE = Qt.KeyboardModifier.NoModifier
SHIFT, ALT = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.AltModifier


def drag(widget, dx: int, dy: int, button=LEFT, modifiers=NONE) -> None:
    start = QPointF(widget.rect().center())
    end = start + QPointF(dx, dy)
    QTest.mousePress(widget, button, modifiers, start.toPoint())
    move = QMouseEvent(
        QEvent.Type.MouseMove, end, widget.mapToGlobal(end), Qt.MouseButton.NoButton, button, modifiers
    )
    QApplication.sendEvent(widget, move)
    QTest.mouseRelease(widget, button, modifiers, end.toPoint())


def wheel(widget, notches: float, place: QPointF | None = None) -> None:
    place = place or QPointF(widget.rect().center())
    turn = QPoint(0, round(120 * notches))
    event = QWheelEvent(
        place,
        widget.mapToGlobal(place),
        QPoint(),
        turn,
        Qt.MouseButton.NoButton,
        NONE,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)


def object_centre(pixels: np.ndarray, grey: np.ndarray) -> tuple[float, float]:
    """Return the middle (x, y) of what differs from the grey background."""
    rows, columns = np.nonzero(np.abs(pixels.astype(int) - grey).max(axis=2) > 12)
    return float(columns.mean()), float(rows.mean())


def test_a_left_drag_orbits(viewer) -> None:
    before, first = viewer.view, viewer.pixels()
    drag(viewer.canvas, 60, 20)
    after = viewer.view
    assert after.camera.azimuth_deg == pytest.approx((before.camera.azimuth_deg - 21) % 360)
    assert after.camera.elevation_deg == pytest.approx(before.camera.elevation_deg + 7)
    assert after.rotation_deg == before.rotation_deg
    assert np.abs(viewer.pixels().astype(int) - first).max() > 20
    assert viewer.window.camera.elevation.value() == pytest.approx(after.camera.elevation_deg, abs=0.1)


def test_slow_frames_are_smaller_while_the_hand_moves(viewer, qtbot, monkeypatch) -> None:
    sizes = []
    draw = SceneRenderer.draw

    def noted(self, view, framebuffer, size, coarseness=None) -> None:
        sizes.append(size if coarseness is moving.WHOLE else coarseness)
        draw(self, view, framebuffer, size, coarseness)

    monkeypatch.setattr(SceneRenderer, "draw", noted)
    whole = viewer.window.picture.device_size
    monkeypatch.setattr(moving, "BUDGET_MS", 1e-3)  # nothing is as fast
    viewer.window.picture.redraw()
    qtbot.waitUntil(lambda: len(sizes) > 0, timeout=20_000)
    assert set(sizes) == {whole}
    sizes.clear()
    for _ in range(3):
        drag(viewer.canvas, 20, 5)
        qtbot.waitUntil(lambda: len(sizes) >= 1, timeout=20_000)
    qtbot.waitUntil(lambda: sizes[-1] == whole, timeout=20_000)
    assert moving.STEPS[-1] in sizes
    # What is grabbed is never the smaller one.
    drag(viewer.canvas, 20, 5)
    sizes.clear()
    viewer.pixels()
    assert sizes == [whole]


@pytest.mark.parametrize(("button", "modifiers"), [(MIDDLE, NONE), (LEFT, SHIFT)])
def test_a_pan_takes_the_surface_with_the_cursor(viewer, button, modifiers) -> None:
    viewer.state.change_view(background="grey")
    grey = viewer.pixels()[2, 2]
    x, y = object_centre(viewer.pixels(), grey)
    drag(viewer.canvas, 50, -30, button, modifiers)
    new_x, new_y = object_centre(viewer.pixels(), grey)
    assert (new_x - x, new_y - y) == pytest.approx((50, -30), abs=5)


def test_the_wheel_zooms(viewer) -> None:
    viewer.state.change_view(background="grey")
    grey = viewer.pixels()[2, 2]

    def area() -> int:
        return int((np.abs(viewer.pixels().astype(int) - grey).max(axis=2) > 12).sum())

    framed = area()
    wheel(viewer.canvas, -3)
    farther = area()
    wheel(viewer.canvas, 3)
    back = area()
    assert farther < 0.7 * framed
    assert back == pytest.approx(framed, rel=0.02)


def test_alt_and_drag_turn_the_light_and_not_the_camera(viewer) -> None:
    before, first = viewer.view, viewer.pixels()
    drag(viewer.canvas, 80, 0, LEFT, ALT)
    assert viewer.view.camera == before.camera
    assert viewer.view.rotation_deg == pytest.approx(40)
    assert np.abs(viewer.pixels().astype(int) - first).max() > 20
    assert viewer.window.environment.rotation.value() == pytest.approx(40)


def test_the_light_turns_all_the_way_round(viewer) -> None:
    for _ in range(5):
        drag(viewer.canvas, 100, 0, LEFT, ALT)
    assert viewer.view.rotation_deg == pytest.approx(250 - 360)


def test_keys_pick_presets_and_frame(viewer, qtbot) -> None:
    viewer.canvas.setFocus()
    qtbot.waitUntil(viewer.canvas.hasFocus)
    for index, (_, azimuth, elevation) in enumerate(PRESETS.values()):
        wheel(viewer.canvas, 1)
        QTest.keyClick(viewer.canvas, Qt.Key(Qt.Key.Key_1.value + index))
        camera = viewer.view.camera
        assert (camera.azimuth_deg, camera.elevation_deg, camera.distance) == (azimuth, elevation, None)
    drag(viewer.canvas, 30, 0, MIDDLE)
    assert viewer.view.camera.target is not None
    QTest.keyClick(viewer.canvas, Qt.Key.Key_F)
    assert viewer.view.camera.target is None


def test_space_turns_the_surface_before_a_still_camera_and_light(viewer, qtbot) -> None:
    viewer.canvas.setFocus()
    qtbot.waitUntil(viewer.canvas.hasFocus)
    before = viewer.view
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Space)
    assert viewer.window.commands.turntable.isChecked()
    qtbot.waitUntil(lambda: viewer.view.rotation_deg < before.rotation_deg - 2)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Space)
    assert not viewer.window.commands.turntable.isChecked()
    stopped = viewer.view
    qtbot.wait(80)
    assert viewer.view == stopped
    turned = (before.camera.azimuth_deg - stopped.camera.azimuth_deg) % 360
    assert turned == pytest.approx(before.rotation_deg - stopped.rotation_deg)


def test_the_turntable_leaves_the_background_where_it_is(viewer) -> None:
    """The light stands still before the camera, so behind the object nothing moves."""
    from brdf_suite.output.turning import turned

    viewer.state.change_view(surface=viewer.view.surface)
    wheel(viewer.canvas, -6)
    first = viewer.pixels()
    viewer.state.set_view(turned(viewer.view, 120.0, viewer.state.bounds.centre))
    second = viewer.pixels()
    corner = np.s_[: first.shape[0] // 6, : first.shape[1] // 6]
    assert np.abs(first[corner].astype(int) - second[corner]).max() <= 3
    middle = np.s_[first.shape[0] // 2 - 20 : first.shape[0] // 2 + 20, first.shape[1] // 2 - 20 :]
    moved = np.abs(first[middle].astype(int) - second[middle]).max(axis=-1) > 3
    # A sphere looks the same all round, but for single pixels of its rim, where another edge of the mesh is drawn.
    assert moved.sum() <= 6


def test_the_turntable_turns_the_object_about_itself_where_the_camera_looks_past_it(viewer) -> None:
    from brdf_suite.output.turning import turned

    viewer.state.change_view(background="grey")
    grey = viewer.pixels()[2, 2]
    drag(viewer.canvas, 60, 20, MIDDLE)
    place = object_centre(viewer.pixels(), grey)
    for degrees in (30.0, 120.0):
        viewer.state.set_view(turned(viewer.view, degrees, viewer.state.bounds.centre))
        assert object_centre(viewer.pixels(), grey) == pytest.approx(place, abs=1.0)


def test_the_wheel_keeps_what_is_under_the_cursor(viewer) -> None:
    viewer.state.change_view(background="grey")
    grey = viewer.pixels()[2, 2]
    x, y = object_centre(viewer.pixels(), grey)
    cursor = QPointF(viewer.canvas.width() / 2 + 100, viewer.canvas.height() / 2 - 50)
    wheel(viewer.canvas, -5, cursor)
    share = 0.88**5  # what was 100 pixels left of the cursor is so much nearer to it
    new = object_centre(viewer.pixels(), grey)
    expected = cursor.x() + share * (x - cursor.x()), cursor.y() + share * (y - cursor.y())
    assert new == pytest.approx(expected, abs=3)


def test_a_right_drag_turns_the_light_and_ctrl_makes_it_fine(viewer) -> None:
    before = viewer.view
    drag(viewer.canvas, 40, 0, Qt.MouseButton.RightButton)
    assert viewer.view == dataclasses.replace(before, rotation_deg=20.0)
    drag(viewer.canvas, 40, 0, Qt.MouseButton.RightButton, Qt.KeyboardModifier.ControlModifier)
    assert viewer.view.rotation_deg == pytest.approx(22.0)


def test_an_orbit_stops_at_the_poles_and_comes_back_without_a_jump(viewer) -> None:
    azimuth = viewer.view.camera.azimuth_deg
    drag(viewer.canvas, 0, 2000)
    assert (viewer.view.camera.elevation_deg, viewer.view.camera.azimuth_deg) == (89.0, azimuth)
    top = viewer.pixels()
    drag(viewer.canvas, 0, -4000)
    assert viewer.view.camera.elevation_deg == -89.0
    drag(viewer.canvas, 0, 4000)
    assert (viewer.pixels() == top).all()


def test_tab_on_the_picture_hides_and_shows_the_inspector(filled, qtbot) -> None:
    filled.canvas.setFocus()
    qtbot.waitUntil(filled.canvas.hasFocus)
    width = filled.canvas.width()
    QTest.keyClick(filled.canvas, Qt.Key.Key_Tab)
    qtbot.waitUntil(lambda: not filled.window.inspector_dock.isVisible())
    qtbot.waitUntil(lambda: filled.canvas.width() > width + 100)
    QTest.keyClick(filled.canvas, Qt.Key.Key_Tab)
    qtbot.waitUntil(filled.window.inspector_dock.isVisible)


def test_the_fields_of_the_inspector(viewer) -> None:
    camera = viewer.window.camera
    camera.azimuth.setValue(-90)
    camera.elevation.setValue(30)
    assert viewer.view.camera.azimuth_deg == pytest.approx(270)
    assert viewer.view.camera.elevation_deg == pytest.approx(30)
    before = viewer.view.camera
    camera.focal_length.setValue(100)
    assert viewer.view.camera.focal_length_mm == 100
    assert viewer.view.camera.distance == pytest.approx(2 * before.distance)
    camera.presets[2].click()
    assert viewer.view.camera.azimuth_deg == 90


def test_digits_typed_into_a_field_are_no_presets(viewer, qtbot) -> None:
    field = viewer.window.camera.focal_length
    field.setFocus()
    qtbot.waitUntil(field.hasFocus)
    field.selectAll()
    azimuth = viewer.view.camera.azimuth_deg
    QTest.keyClicks(field, "85")
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert viewer.view.camera.focal_length_mm == 85
    assert viewer.view.camera.azimuth_deg == azimuth

"""Two paints beside each other: chosen, frozen, swiped, blinked, and as a difference."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_viewer.compare.control import labels_of
from brdf_viewer.compare.divider_gesture import DividerGesture
from brdf_viewer.overlay.overlay import OverlayLabel, Scale
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from brdf_suite.documents.view_settings import Compare

LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


def send_move(widget, x: float, buttons=LEFT) -> None:
    place = QPointF(x, widget.height() / 2)
    event = QMouseEvent(
        QEvent.Type.MouseMove, place, widget.mapToGlobal(place), Qt.MouseButton.NoButton, buttons, NONE
    )
    QApplication.sendEvent(widget, event)


def compare_with(viewer, key: str) -> None:
    chooser = viewer.window.compare.chooser
    index = chooser.list.findData(key)
    chooser.list.setCurrentIndex(index)
    chooser.list.activated.emit(index)
    wait_second(viewer, key)


def wait_second(viewer, key: str) -> None:
    viewer.qtbot.waitUntil(
        lambda: viewer.state.second is not None and viewer.state.second.key == key, timeout=60_000
    )


def pick(viewer, mode: str) -> None:
    box = viewer.window.compare.mode
    box.activated.emit(box.findData(mode))


def alone(start, paint: str) -> np.ndarray:
    viewer = start(paint=paint, follow=False)
    pixels = viewer.pixels()
    viewer.close()
    return pixels


def test_choosing_a_second_paint_shows_both_side_by_side(viewer) -> None:
    compare_with(viewer, "solid_red")
    assert viewer.view.compare == Compare("side", "solid_red")
    pixels = viewer.pixels().astype(int)
    half = pixels.shape[1] // 2
    middle = slice(pixels.shape[0] // 2 - 20, pixels.shape[0] // 2 + 20)
    blue, red = pixels[middle, half // 2], pixels[middle, half + half // 2]
    assert (blue[:, 2] > blue[:, 0]).mean() > 0.9
    assert (red[:, 0] > red[:, 2]).mean() > 0.9
    labels = viewer.window.overlay.labels
    assert [label.text[:1] for label in labels] == ["A", "B"]
    assert labels[1].begins == 0.5
    assert viewer.window.compare.mode.currentData() == "side"


@pytest.mark.usefixtures("four_samples")
def test_a_swipe_is_dragged_by_its_line_as_one_step(start) -> None:
    red = alone(start, "solid_red")
    viewer = start(follow=False)
    blue = viewer.pixels()
    compare_with(viewer, "solid_red")
    pick(viewer, "swipe")
    canvas = viewer.canvas
    width = canvas.width()
    steps, camera = viewer.state.history.steps, viewer.view.camera
    QTest.mousePress(canvas, LEFT, NONE, QPoint(width // 2 + 3, 100))
    for share in (0.6, 0.5, 0.25):
        send_move(canvas, share * width + 3)
    QTest.mouseRelease(canvas, LEFT, NONE, QPoint(width // 4 + 3, 100))
    assert viewer.view.compare.divider == pytest.approx(0.25, abs=0.01)
    assert viewer.view.camera == camera
    assert viewer.state.history.steps == steps + 1
    pixels = viewer.pixels()
    split = round(viewer.view.compare.divider * width)
    assert (pixels[:, : split - 1] == blue[:, : split - 1]).all()
    assert np.abs(pixels[:, split + 1 :].astype(int) - red[:, split + 1 :]).max() <= 1
    assert viewer.window.compare.divider.value() == pytest.approx(100 * viewer.view.compare.divider, abs=0.1)
    # Away from the line the same drag orbits.
    QTest.mousePress(canvas, LEFT, NONE, QPoint(width // 2, 100))
    send_move(canvas, 0.6 * width)
    QTest.mouseRelease(canvas, LEFT, NONE, QPoint(round(0.6 * width), 100))
    assert viewer.view.camera != camera


def test_b_blinks_and_goes_back_and_shift_b_blinks_by_hand(viewer, qtbot) -> None:
    compare_with(viewer, "solid_red")
    pick(viewer, "swipe")
    viewer.window.compare.rate.setValue(10.0)
    viewer.canvas.setFocus()
    qtbot.waitUntil(viewer.canvas.hasFocus)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_B)
    assert viewer.view.compare.mode == "blink"
    assert viewer.state.shows_second
    seen = set()

    def both_were_named() -> bool:
        seen.add(viewer.window.overlay.labels[0].text[:1])
        return seen == {"A", "B"}

    qtbot.waitUntil(both_were_named)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_B, Qt.KeyboardModifier.ShiftModifier)
    held = viewer.state.shows_second
    qtbot.wait(350)
    assert viewer.state.shows_second == held
    first = viewer.pixels()
    QTest.keyClick(viewer.canvas, Qt.Key.Key_B, Qt.KeyboardModifier.ShiftModifier)
    assert viewer.state.shows_second != held
    assert np.abs(viewer.pixels().astype(int) - first).max() > 40
    QTest.keyClick(viewer.canvas, Qt.Key.Key_B)
    assert viewer.view.compare.mode == "swipe"
    assert not viewer.state.shows_second


def test_the_difference_of_a_paint_with_itself_is_nothing(viewer) -> None:
    viewer.window.compare.freeze.click()
    wait_second(viewer, viewer.view.compare.paint)
    pick(viewer, "difference")
    pixels = viewer.pixels()
    # A designed paint is fitted alike both times; the lowest colour of the scale stands for no difference.
    assert np.abs(pixels.astype(int) - pixels[0, 0]).max() <= 6
    assert viewer.window.overlay.scale == Scale(5.0, "of the light, before the tone curve")
    viewer.window.compare.scale.setValue(2.0)
    viewer.window.compare.basis.activated.emit(1)
    assert viewer.window.overlay.scale == Scale(2.0, "of the picture, as shown")
    compare_with(viewer, "solid_red")
    assert np.abs(viewer.pixels().astype(int) - pixels).max() > 100


def test_a_frozen_paint_stays_while_the_first_changes(viewer, tmp_path) -> None:
    viewer.window.commands.freeze.trigger()
    wait_second(viewer, viewer.view.compare.paint)
    frozen = viewer.state.second.value.name
    assert frozen == viewer.state.fit.name
    assert str(tmp_path) in viewer.view.compare.paint
    assert viewer.window.compare.chooser.list.currentText() == f"{frozen} (frozen)"
    viewer.controller.paint.open("solid_red")
    assert viewer.state.second.value.name == frozen
    assert viewer.window.overlay.labels[0].text != f"A  {frozen}"
    assert viewer.window.overlay.labels[1].text == f"B  {frozen}"


def test_without_a_second_paint_it_says_how_to_get_one(viewer) -> None:
    pick(viewer, "swipe")
    assert "No second paint is selected." in viewer.messages()["no second paint"]
    assert viewer.window.overlay.labels == ()
    viewer.window.findChild(QWidget, "message_action_Freeze A as B").click()
    wait_second(viewer, viewer.view.compare.paint)
    assert viewer.messages() == {}
    assert viewer.view.compare.mode == "swipe"


def test_a_file_that_is_no_paint_is_reported_and_the_second_stays(viewer, tmp_path, qtbot) -> None:
    compare_with(viewer, "solid_red")
    bad = tmp_path / "bad.brdfpaint"
    bad.write_text("{}")
    viewer.controller.compare.choose(str(bad))
    qtbot.waitUntil(lambda: "compare" in viewer.messages())
    assert "bad.brdfpaint" in viewer.messages()["compare"]
    assert viewer.view.compare.paint == viewer.state.second.key == "solid_red"


def test_undo_takes_the_comparison_back(viewer, qtbot) -> None:
    compare_with(viewer, "solid_red")
    viewer.window.commands.undo.trigger()
    assert viewer.view.compare == Compare()
    assert viewer.state.second is None
    viewer.window.commands.redo.trigger()
    wait_second(viewer, "solid_red")


def test_a_picture_of_light_is_compared_with_the_paint(start, lights, tmp_path, qtbot) -> None:
    from dataclasses import replace

    from brdf_suite.documents.view import Camera
    from brdf_suite.files.images.environments import write_exr

    viewer = start(follow=False)
    viewer.state.change_view(camera=Camera(distance=0.6, target=(0.0, 0.1, 0.0)))
    qtbot.waitUntil(viewer.window.progress.isHidden)  # its strip takes height from the picture
    drawer, size = viewer.controller.drawer, viewer.window.picture.device_size
    light = []
    viewer.window.picture.with_context(
        lambda: light.append(drawer.renderer.linear_image(viewer.view, size)[..., :3])
    )
    file = tmp_path / "reference.exr"
    write_exr(file, light[0])
    viewer.controller.compare.choose(str(file))
    wait_second(viewer, str(file))
    pick(viewer, "difference")
    qtbot.waitUntil(viewer.window.progress.isHidden)
    assert viewer.window.picture.device_size == size
    shown = viewer.pixels().astype(int)
    far = np.abs(shown - shown[0, 0]).max(axis=-1)
    # The object's edge, where a sample more or less of the background makes the colour, is left some pixels.
    assert np.percentile(far, 99.9) <= 12
    assert far.max() <= 40
    assert "picture of" in viewer.window.compare.facts.text()
    viewer.state.change_view(camera=replace(viewer.view.camera, distance=1.2))
    assert np.abs(viewer.pixels().astype(int) - shown).max() > 100


@pytest.mark.parametrize(
    ("mode", "labels"),
    [
        ("off", ()),
        ("side", (OverlayLabel("A  x", 0.0, 0.5), OverlayLabel("B  y", 0.5, 0.5))),
        ("swipe", (OverlayLabel("A  x", 0.0, 0.3), OverlayLabel("B  y", 0.3, 0.7))),
        ("blink", (OverlayLabel("B  y"),)),
        ("difference", (OverlayLabel("A  x  –  B  y"),)),
    ],
)
def test_labels(mode, labels) -> None:
    assert labels_of(mode, ("A  x", "B  y"), True, 0.3) == labels


def test_the_line_is_taken_near_it_and_only_there(qtbot) -> None:
    widget = QWidget()
    widget.resize(400, 100)
    widget.setMouseTracking(True)
    qtbot.addWidget(widget)
    with qtbot.waitExposed(widget):
        widget.show()
    gesture = DividerGesture(widget)
    heard = []
    gesture.moved.connect(heard.append)
    gesture.started.connect(lambda: heard.append("start"))
    gesture.finished.connect(lambda: heard.append("finish"))
    send_move(widget, 200, Qt.MouseButton.NoButton)
    assert widget.cursor().shape() == Qt.CursorShape.ArrowCursor
    gesture.set_divider(0.5)
    send_move(widget, 203, Qt.MouseButton.NoButton)
    assert widget.cursor().shape() == Qt.CursorShape.SplitHCursor
    send_move(widget, 230, Qt.MouseButton.NoButton)
    assert widget.cursor().shape() == Qt.CursorShape.ArrowCursor
    QTest.mousePress(widget, LEFT, NONE, QPoint(230, 50))
    QTest.mouseRelease(widget, LEFT, NONE, QPoint(230, 50))
    assert heard == []
    QTest.mousePress(widget, LEFT, NONE, QPoint(204, 50))
    send_move(widget, 104)
    send_move(widget, 900)
    QTest.mouseRelease(widget, LEFT, NONE, QPoint(399, 50))
    assert heard == ["start", pytest.approx(0.25), 1.0, "finish"]
    QTest.mousePress(widget, LEFT, NONE, QPoint(204, 50))
    gesture.set_divider(None)
    assert heard[-2:] == ["start", "finish"]
    # A button that stays down is down for every later test of this process.
    QTest.mouseRelease(widget, LEFT, NONE, QPoint(204, 50))

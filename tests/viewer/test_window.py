"""The Viewer's window: drops, full screen, the list of keys, themes, fine pixels."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_qt.program import theme
from brdf_qt.window.command_palette import commands
from brdf_qt.window.help_windows import ShortcutsWindow
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QTreeWidget

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import save_paint, save_view
from brdf_suite.documents.view import View

COPY, LEFT, NONE = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


def drop(window, *paths) -> bool:
    """Drop files as a file manager does; return whether the window takes them."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    place = QPointF(window.rect().center())
    enter = QDragEnterEvent(place.toPoint(), COPY, data, LEFT, NONE)
    QApplication.sendEvent(window, enter)
    if not enter.isAccepted():
        return False
    QApplication.sendEvent(window, QDropEvent(place, COPY, data, LEFT, NONE))
    return True


def test_everything_that_is_dropped_is_opened(viewer, lights, tmp_path) -> None:
    paint, view = tmp_path / "brick.brdfpaint", tmp_path / "dark.brdfview"
    save_paint(solid_paint("brick", (40.0, 40.0, 30.0)), paint)
    save_view(View(environment=str(lights["bright"]), surface="sphere", exposure_ev=-2.0), view)
    assert drop(viewer.window, paint, view)
    viewer.wait_idle()
    assert viewer.state.fit.name == "brick"
    assert viewer.view.exposure_ev == -2.0
    assert viewer.state.environment.key == str(lights["bright"])
    assert drop(viewer.window, lights["dim"])
    viewer.wait_idle()
    assert viewer.view.environment == str(lights["dim"])


def test_a_drop_that_is_no_file_is_not_taken(viewer) -> None:
    data = QMimeData()
    data.setText("some words")
    event = QDragEnterEvent(viewer.window.rect().center(), COPY, data, LEFT, NONE)
    event.ignore()
    QApplication.sendEvent(viewer.window, event)
    assert not event.isAccepted()


def test_f11_fills_the_screen_and_escape_leaves_it(viewer, qtbot) -> None:
    viewer.canvas.setFocus()
    qtbot.waitUntil(viewer.canvas.hasFocus)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_F11)
    qtbot.waitUntil(viewer.window.isFullScreen)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not viewer.window.isFullScreen())


def test_f1_lists_every_key_and_no_key_is_given_twice(viewer, qtbot) -> None:
    keys = [
        (action.shortcut().toString(), text)
        for text, action in commands(viewer.window, also_disabled=True)
        if not action.shortcut().isEmpty()
    ]
    assert len({key for key, _ in keys}) == len(keys)
    known = {key for key, _ in keys}
    assert {"B", "H", "F", "1", "4", "F11", "Ctrl+Z", "Ctrl+K", "Left", "Right", "Space", "Ctrl+B"} <= known
    dialog = ShortcutsWindow(viewer.window)
    dialog.show()
    rows = dialog.findChild(QTreeWidget)
    listed = {
        keys for i in range(rows.topLevelItemCount()) for keys in rows.topLevelItem(i).text(1).split(", ")
    }
    native = QKeySequence.SequenceFormat.NativeText
    assert {QKeySequence(key).toString(native) for key in known} <= listed
    dialog.close()


@pytest.mark.parametrize("name", ["dark", "booth", "light"])
def test_the_window_is_neutral_in_every_theme(viewer, qapp, name) -> None:
    theme.apply(qapp, name, remember=False)
    try:
        viewer.controller.compare.choose("solid_white")
        QApplication.processEvents()
        image = viewer.window.inspector.grab().toImage()
        levels = np.array(
            [image.pixelColor(x, y).getRgb()[:3] for x in range(5, image.width(), 37) for y in (3, 9, 200)]
        )
        spread = levels.max(axis=1) - levels.min(axis=1)
        assert np.median(spread) == 0
    finally:
        theme.apply(qapp, theme.DEFAULT, remember=False)


def test_a_pan_side_by_side_takes_the_surface_with_the_cursor(viewer, qtbot) -> None:
    from dataclasses import replace

    from brdf_suite.realtime.camera import matrices

    viewer.controller.compare.choose("solid_white")
    qtbot.waitUntil(lambda: viewer.state.second is not None)
    half = viewer.controller.camera.picture_size
    assert half[0] == viewer.window.picture.device_size[0] // 2
    viewer.controller.camera.pan(50 / half[1], 0.0)
    target = viewer.state.bounds.centre
    moved = matrices(viewer.view.camera, viewer.state.bounds, half).world_to_clip @ np.append(target, 1.0)
    assert moved[0] / moved[3] * half[0] / 2 == pytest.approx(50, abs=0.5)
    viewer.state.change_view(compare=replace(viewer.view.compare, mode="swipe"))
    assert viewer.controller.camera.picture_size == viewer.window.picture.device_size

"""The picture in the middle of Designer: the real renderer in the real window."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from brdf_designer.assembly import Designer
from brdf_designer.picture.control import PictureControl
from brdf_designer.picture.pace import FAST_MS, FULL_REST_MS, REST_MS, PicturePace
from brdf_designer.picture.three_lights import LIGHTS
from brdf_designer.session.edits import SetLab, SetNumber
from brdf_qt.window.dialogs import Answer
from brdf_qt.work import pictures
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu, QToolButton

from brdf_suite.pipeline.scene import map_exponents
from brdf_suite.pipeline.seen_queue import SeenWeights

pytestmark = pytest.mark.usefixtures("shared_cache")


class NoDialogs:
    def unsaved(self, _name: str) -> Answer:
        return Answer.DISCARD


def started(qtbot, monkeypatch) -> Designer:
    # The pictures of the history come from a process of their own, which is no matter of these tests.
    monkeypatch.setattr(pictures, "child_command", lambda _module: [])
    designer = Designer(dialogs=lambda _window: NoDialogs())
    qtbot.addWidget(designer.window)
    designer.window.resize(800, 560)
    designer.window.show()
    return designer


@pytest.fixture
def designer(qtbot, monkeypatch) -> Designer:
    designer = started(qtbot, monkeypatch)
    yield designer
    designer.close()


@pytest.fixture
def shown(designer, qtbot) -> PictureControl:
    control = designer.feature(PictureControl)
    qtbot.waitUntil(lambda: control.drawn is not None and control.is_idle)
    return control


def pixels_of(shown) -> np.ndarray:
    return grab_of(shown.panel.surface)


def grab_of(surface) -> np.ndarray:
    image = surface.grab_image().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def middle(shown) -> np.ndarray:
    pixels = pixels_of(shown)
    rows, columns = pixels.shape[:2]
    return pixels[rows * 2 // 5 : rows * 3 // 5, columns * 2 // 5 : columns * 3 // 5].mean((0, 1))


def test_it_shows_the_paint_follows_edits_and_waits_for_the_numbers(designer, shown, qtbot):
    assert shown.panel.surface.failure == ""
    assert shown._contents.light.maps.exponents == map_exponents(designer.session.fitting.basis)
    red, _, blue = middle(shown)
    assert blue > 1.5 * red

    # Another paint is drawn by itself.
    designer.open("red")
    qtbot.waitUntil(lambda: shown.drawn is designer.session.fit)
    red, _, blue = middle(shown)
    assert red > 1.5 * blue

    # A slow picture is not drawn while edits come; each of them puts it off anew.
    shown.pace = PicturePace(full_ms=10 * FAST_MS)
    for lightness in (50.0, 55.0, 60.0):
        designer.session.edit(SetLab(0, 0, lightness))
        assert shown._drawing.isActive()
        assert shown._drawing.interval() == REST_MS
    assert shown.drawn is not designer.session.fit
    qtbot.waitUntil(lambda: shown.drawn is designer.session.fit)
    # First a coarser one, then, when the hand rests, the whole.
    qtbot.waitUntil(lambda: shown.is_idle and shown._drawer.is_whole)
    shown.pace = PicturePace(full_ms=FAST_MS)
    designer.session.edit(SetLab(0, 0, 61.0))
    assert shown._drawing.interval() == 0

    # A paint that cannot be leaves the picture, and says so over it.
    designer.session.edit(SetNumber("gloss.gu_20", 199.0))
    assert "Last possible paint" in shown.panel.word.text()
    assert shown.panel.word.isVisible()
    designer.session.undo()
    assert not shown.panel.word.isVisible()


def test_light_and_form_are_chosen_in_their_tabs_and_the_hand_turns_the_form(designer, shown, qtbot):
    panel, pages = designer.window.panel, shown.pages
    QTest.mouseClick(panel.buttons["light"], Qt.MouseButton.LeftButton)
    before = pixels_of(shown)
    QTest.mouseClick(pages.lights.buttons["overcast"], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: shown.view.environment == "overcast" and shown.is_idle)
    assert np.abs(pixels_of(shown) - before).mean() > 5.0
    before = pixels_of(shown)
    pages.exposure.number.setFocus()
    pages.exposure.number.selectAll()
    QTest.keyClicks(pages.exposure.number, "-2")
    QTest.keyClick(pages.exposure.number, Qt.Key.Key_Return)
    assert shown.view.exposure_ev == -2.0
    qtbot.waitUntil(lambda: shown.is_idle)
    assert pixels_of(shown).mean() < 0.7 * before.mean()

    QTest.mouseClick(panel.buttons["form"], Qt.MouseButton.LeftButton)
    QTest.mouseClick(pages.forms.buttons["sphere"], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: shown.view.surface == "sphere" and shown.is_idle)
    QTest.mouseClick(pages.places["side"], Qt.MouseButton.LeftButton)
    assert shown.view.camera.azimuth_deg == 90.0

    # A drag turns the form, and nothing of the paint.
    steps, canvas = designer.store.stack.count(), shown.panel.surface.canvas
    start = QPoint(canvas.width() // 2, canvas.height() // 2)
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(canvas, start + QPoint(60, 10))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=start + QPoint(60, 10))
    assert shown.view.camera.azimuth_deg != pytest.approx(90.0)
    assert designer.store.stack.count() == steps
    # Another test's window may still have the keys.
    designer.window.activateWindow()
    qtbot.waitUntil(designer.window.isActiveWindow)
    QTest.keyClick(canvas, Qt.Key.Key_F)
    assert shown.view.camera.distance is None


def test_light_form_and_drawers_are_there_again_at_the_next_start(qtbot, monkeypatch):
    first = started(qtbot, monkeypatch)
    picture = first.feature(PictureControl)
    qtbot.waitUntil(lambda: picture.drawn is not None and picture.is_idle)
    picture.choose_form("sphere")
    qtbot.waitUntil(lambda: picture.view.surface == "sphere" and picture.is_idle)
    place = picture.panel.geometry()
    handle = first.window.stage.bar.findChildren(QToolButton)[0]
    QTest.mouseClick(handle, Qt.MouseButton.LeftButton)
    curves = first.window.stage.drawers["curves"]
    qtbot.waitUntil(lambda: curves.isVisible() and curves.x() == 0)
    # It lies over the picture, which keeps its place.
    assert picture.panel.geometry() == place
    first.close()
    second = started(qtbot, monkeypatch)
    again = second.feature(PictureControl)
    qtbot.waitUntil(lambda: again.drawn is not None and again.is_idle)
    assert again.view.surface == "sphere"
    assert second.window.stage.drawers["curves"].isVisible()
    assert not second.window.stage.drawers["history"].isVisible()
    second.close()


def test_a_slow_picture_waits_and_a_fast_one_does_not():
    assert PicturePace(full_ms=2.0).after_change() == ((0, False),)
    (rest, coarser), (long_rest, last) = PicturePace(full_ms=200.0).after_change()
    assert (coarser, last) == (True, False)
    assert (rest, long_rest) == (REST_MS, FULL_REST_MS)
    assert PicturePace(full_ms=900.0).after_change()[-1] == (900, False)


def test_weights_for_every_angle_of_the_view_come_later_and_are_drawn(designer, shown, qtbot, monkeypatch):
    """A paint read under two lights is drawn at once by its single fit, and again when the better weights are there."""
    find, go_on = SeenWeights.find, threading.Event()

    def find_when_allowed(weights: SeenWeights) -> None:
        assert go_on.wait(120.0)
        find(weights)

    monkeypatch.setattr(SeenWeights, "find", find_when_allowed)
    designer.open("gold_green_shift")
    qtbot.waitUntil(lambda: shown.is_idle and shown.drawn is designer.session.fit)
    frames = []
    shown.panel.surface.frame_drawn.connect(lambda *_: frames.append(1))
    go_on.set()
    qtbot.waitUntil(lambda: len(frames) > 0)


def test_three_lights_show_the_same_paint_and_follow_it(designer, shown, qtbot):
    window, lights = designer.window, shown.lights
    whole = shown.panel.surface.width()
    button = next(one for one in window.stage.bar.findChildren(QToolButton) if one.text() == "Three Lights")
    assert not lights.panes
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: shown.is_idle)
    assert sorted([shown.view.environment, *(pane.light for pane in lights.panes)]) == sorted(LIGHTS)
    assert shown.panel.surface.width() < 0.7 * whole
    assert [pane.surface.failure for pane in lights.panes] == ["", ""]
    before = [grab_of(pane.surface) for pane in lights.panes]
    assert np.abs(before[0].mean((0, 1)) - before[1].mean((0, 1))).max() > 5.0

    # Another paint is seen in all of them, and so is where it is seen from.
    designer.open("red")
    qtbot.waitUntil(lambda: shown.drawn is designer.session.fit and shown.is_idle)
    red = [grab_of(pane.surface) for pane in lights.panes]
    for one, other in zip(before, red, strict=True):
        assert (other - one)[..., 0].max() > 40
    lights.panes[0].surface.canvas.setFocus()
    QTest.mousePress(lights.panes[0].surface.canvas, Qt.MouseButton.LeftButton, pos=QPoint(20, 20))
    QTest.mouseMove(lights.panes[0].surface.canvas, QPoint(60, 20))
    QTest.mouseRelease(lights.panes[0].surface.canvas, Qt.MouseButton.LeftButton, pos=QPoint(60, 20))
    qtbot.waitUntil(lambda: shown.is_idle)
    assert all(np.abs(grab_of(p.surface) - r).max() > 40 for p, r in zip(lights.panes, red, strict=True))

    # The light of one of them becomes that of the first, and they take the others.
    first, second = shown.view.environment, lights.panes[0].light
    shown.choose_light(second)
    qtbot.waitUntil(lambda: shown.view.environment == second and shown.is_idle)
    assert first in [pane.light for pane in lights.panes]
    assert sorted([second, *(pane.light for pane in lights.panes)]) == sorted(LIGHTS)

    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: shown.is_idle)
    assert shown.panel.surface.width() == whole
    assert not any(pane.isVisible() for pane in lights.panes)


def test_highlights_are_put_by_the_right_button_and_moved_by_their_handles(designer, shown, qtbot):
    canvas, lamps = shown.panel.surface.canvas, shown.lamps
    middle = canvas.rect().center()

    def click(place: QPoint, text: str) -> None:
        """Click with the right button, and take an entry of the menu that opens."""
        QTest.mouseClick(canvas, Qt.MouseButton.RightButton, pos=place)
        (menu,) = [one for one in designer.window.findChildren(QMenu, "lamp_menu") if one.isVisible()]
        next(action for action in menu.actions() if action.text() == text).trigger()
        menu.close()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    before = pixels_of(shown)
    turned = shown.view.rotation_deg
    click(middle, "Put the Highlight Here")
    (lamp,) = shown.view.lamps
    assert shown.view.rotation_deg == turned
    qtbot.waitUntil(lambda: shown.is_idle)
    ratio = canvas.devicePixelRatioF()
    x, y = round(middle.x() * ratio), round(middle.y() * ratio)
    around = np.s_[y - 6 : y + 7, x - 6 : x + 7]
    assert pixels_of(shown)[around].mean() > before[around].mean() + 10
    assert not lamps.handles.layer.isVisible()
    designer.window.panel.show_page("light")
    qtbot.waitUntil(lambda: len(lamps.handles.layer.handles) == 1)
    start = lamps.handles.layer.handles[0].place.toPoint()
    camera = shown.view.camera
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(canvas, start + QPoint(0, -30))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=start + QPoint(0, -30))
    assert shown.view.camera == camera
    assert shown.view.lamps[0] != lamp
    away = lamps.handles.layer.handles[0].place - (start + QPoint(0, -30))
    assert abs(away.x()) + abs(away.y()) < 3.0
    click(middle, "Put Another Highlight Here")
    assert len(shown.view.lamps) == 2
    assert [handle.number for handle in lamps.handles.layer.handles if handle.chosen] == [2]
    click(lamps.handles.layer.handles[0].place.toPoint(), "Remove Lamp")
    assert len(shown.view.lamps) == 1
    assert shown.view.lamps[0].elevation_deg == pytest.approx(lamp.elevation_deg, abs=1e-6)
    # A drag of the same button turns the light, and opens no menu.
    QTest.mousePress(canvas, Qt.MouseButton.RightButton, pos=middle)
    QTest.mouseMove(canvas, middle + QPoint(40, 0))
    QTest.mouseRelease(canvas, Qt.MouseButton.RightButton, pos=middle + QPoint(40, 0))
    assert shown.view.rotation_deg != turned
    assert not [one for one in designer.window.findChildren(QMenu, "lamp_menu") if one.isVisible()]
    click(middle, "Remove All Lamps")
    assert shown.view.lamps == ()
    qtbot.waitUntil(lambda: shown.is_idle)

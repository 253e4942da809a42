"""Designer's small picture: the real renderer in the real window."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from brdf_designer.assembly import Designer
from brdf_designer.picture.control import PreviewControl
from brdf_designer.picture.pace import FAST_MS, REST_MS, PreviewPace
from brdf_designer.picture.scene import LIGHT_WIDTH
from brdf_designer.session.edits import SetLab, SetNumber
from brdf_qt.window.dialogs import Answer
from brdf_qt.work import pictures
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.pipeline.scene import narrowed
from brdf_suite.pipeline.seen_queue import SeenWeights

pytestmark = pytest.mark.usefixtures("shared_cache")


class NoDialogs:
    def unsaved(self, _name: str) -> Answer:
        return Answer.DISCARD


@pytest.fixture
def designer(qtbot, monkeypatch) -> Designer:
    # The pictures of the history come from a process of their own, which is no matter of these tests.
    monkeypatch.setattr(pictures, "child_command", lambda _module: [])
    designer = Designer(dialogs=lambda _window: NoDialogs())
    qtbot.addWidget(designer.window)
    designer.window.resize(800, 560)
    designer.window.show()
    yield designer
    designer.close()


@pytest.fixture
def preview(designer, qtbot) -> PreviewControl:
    control = designer.feature(PreviewControl)
    qtbot.waitUntil(lambda: control.drawn is not None)
    return control


def picture(preview) -> np.ndarray:
    image = preview.panel.surface.grab_image().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def middle(preview) -> np.ndarray:
    pixels = picture(preview)
    rows, columns = pixels.shape[:2]
    return pixels[rows * 2 // 5 : rows * 3 // 5, columns * 2 // 5 : columns * 3 // 5].mean((0, 1))


def test_it_shows_the_paint_follows_edits_light_and_hand_and_waits_for_the_numbers(designer, preview, qtbot):
    surface = preview.panel.surface
    assert surface.failure == ""
    red, _, blue = middle(preview)
    assert blue > 1.5 * red

    # Another paint is drawn by itself.
    designer.open("red")
    qtbot.waitUntil(lambda: preview.drawn is designer.session.fit)
    red, _, blue = middle(preview)
    assert red > 1.5 * blue

    # A slow picture is not drawn while edits come; each of them puts it off anew.
    preview.pace = PreviewPace(full_ms=10 * FAST_MS)
    for lightness in (50.0, 55.0, 60.0):
        designer.session.edit(SetLab(0, 0, lightness))
        assert preview._drawing.isActive()
        assert preview._drawing.interval() == REST_MS
    assert preview.drawn is not designer.session.fit
    qtbot.waitUntil(lambda: preview.drawn is designer.session.fit)
    # First a draft, then, when the hand rests, the whole.
    qtbot.waitUntil(lambda: preview.is_idle and not preview._drawer.draft)
    preview.pace = PreviewPace(full_ms=FAST_MS)
    designer.session.edit(SetLab(0, 0, 61.0))
    assert preview._drawing.interval() == 0
    preview.pace = PreviewPace()

    # Another light, chosen by hand.
    booth = picture(preview)
    row = preview.panel.light.findData("sunny")
    preview.panel.light.setCurrentIndex(row)
    preview.panel.light.activated.emit(row)
    qtbot.waitUntil(lambda: preview._view.environment == "sunny" and preview.is_idle)
    assert np.abs(picture(preview) - booth).mean() > 5.0

    # A drag turns the form, and nothing of the paint.
    before, steps = picture(preview), designer.store.stack.count()
    canvas = surface.canvas
    start = QPoint(canvas.width() // 2, canvas.height() // 2)
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(canvas, start + QPoint(60, 10))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=start + QPoint(60, 10))
    assert preview._view.camera.azimuth_deg != pytest.approx(35.0)
    qtbot.waitUntil(lambda: preview.is_idle)
    assert np.abs(picture(preview) - before).mean() > 2.0
    assert designer.store.stack.count() == steps
    QTest.keyClick(canvas, Qt.Key.Key_F)
    assert preview._view.camera.distance is None

    # A paint that cannot be leaves the picture, and says so.
    designer.session.edit(SetNumber("gloss.gu_20", 199.0))
    assert "last possible paint" in preview.panel.caption.accessibleName()
    designer.session.undo()
    assert "last possible paint" not in preview.panel.caption.accessibleName()

    # Hidden, it draws nothing.
    preview.show(False)
    kept = preview.drawn
    designer.session.set_paint(load_shipped_paint("copper"), "Copper")
    qtbot.wait(2 * REST_MS)
    assert preview.drawn is kept
    preview.show(True)
    qtbot.waitUntil(lambda: preview.drawn is designer.session.fit)


def test_a_slow_picture_waits_and_a_fast_one_does_not():
    assert PreviewPace(full_ms=2.0, draft_ms=300.0).after_change() == ((0, False),)
    (rest, draft), (long_rest, last) = PreviewPace(full_ms=200.0, draft_ms=50.0).after_change()
    assert (draft, last) == (True, False)
    assert 0 < rest < long_rest
    assert PreviewPace(full_ms=900.0, draft_ms=300.0).after_change() == ((long_rest, False),)


def test_a_smaller_light_holds_the_same_light():
    radiance = np.random.default_rng(3).random((512, 1024, 3), np.float32)
    small = narrowed(Environment("noise", radiance), LIGHT_WIDTH)
    assert small.radiance.shape == (256, 512, 3)
    assert small.radiance.mean() == pytest.approx(float(radiance.mean()), rel=1e-5)
    odd = Environment("odd", radiance[:, :1000])
    assert narrowed(odd, LIGHT_WIDTH) is odd


def test_weights_for_every_angle_of_the_view_come_later_and_are_drawn(designer, preview, qtbot, monkeypatch):
    """A paint read under two lights is drawn at once by its single fit, and again when the better weights are there."""
    find, go_on = SeenWeights.find, threading.Event()

    def find_when_allowed(weights: SeenWeights) -> None:
        assert go_on.wait(120.0)
        find(weights)

    monkeypatch.setattr(SeenWeights, "find", find_when_allowed)
    designer.open("gold_green_shift")
    qtbot.waitUntil(lambda: preview.is_idle and preview.drawn is designer.session.fit)
    frames = []
    preview.panel.surface.frame_drawn.connect(lambda *_: frames.append(1))
    go_on.set()
    qtbot.waitUntil(lambda: len(frames) > 0)

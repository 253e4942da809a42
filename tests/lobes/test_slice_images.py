"""Images of the slices in the real window: the unrolled hemisphere and the half-angle slice, on the screen too."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_lobe_visualizer.cuts.image_layout import Room, best_layout
from brdf_lobe_visualizer.cuts.panel import HALF_ANGLE, UNROLLED
from brdf_lobe_visualizer.cuts.section import SliceOptions
from brdf_lobe_visualizer.subjects.subjects import DASHES, LINE_COLOURS, PlottedMaterial
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import mirror
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier


class Spike:
    """Exponent 10⁵ about the mirror direction, 10,000 high."""

    def eval(self, wi, wo):
        dot = np.einsum("...i,...i", mirror(wi), wo)
        return np.repeat((1e4 * np.maximum(dot, 0.0) ** 1e5)[..., None], 3, axis=-1)


def matt_fit() -> LobeFit:
    zero = np.zeros((1, 3))
    return LobeFit(
        Material("fit", LobeWeights(np.array([9.0]), np.full(3, 0.1), zero, zero, np.pi / 4.0, 1.0)),
        "measured",
        LobeWeights(np.array([9.0]), np.full(3, 0.1), zero, zero, np.pi / 4.0, 1.0),
        {},
        (),
        0.0,
    )


def subject(key: str, reflectance: object, **more: object) -> PlottedMaterial:
    return PlottedMaterial(key, key, Material(key, reflectance), LINE_COLOURS[0], DASHES[0], **more)


@pytest.fixture
def session(slices, window_with_slices):
    return window_with_slices.session


def move(widget, place: QPointF) -> None:
    none = Qt.MouseButton.NoButton
    event = QMouseEvent(
        QEvent.Type.MouseMove, place, widget.mapToGlobal(place), none, none, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(widget, event)


def test_the_unrolled_images_have_target_above_and_fit_below(slices, session, qtbot) -> None:
    session.add(subject("spike", Spike(), fit=matt_fit()))
    slices.window.plots.set_shown(UNROLLED, True)
    qtbot.waitUntil(lambda: slices.is_idle)
    grid = slices.unrolled.grid
    assert grid.columns == ("10°", "40°", "70°")
    assert set(grid.pictures) == {(row, column) for row in range(2) for column in range(3)}
    values = [grid.pictures[0, column].value for column in range(3)]
    peaks = [int(np.argmax(value) % value.shape[1]) for value in values]
    assert peaks == sorted(peaks)
    assert peaks[0] > values[0].shape[1] // 2
    # On the screen too: the brightest place of the third picture is far at the right, in its middle.
    place = slices.unrolled.images.place_of(0, 2)
    shot = slices.unrolled.images.grab().toImage()
    ratio = shot.devicePixelRatio()
    lit = [
        (x, y)
        for x in range(int(place.left()) + 1, int(place.right()))
        for y in range(int(place.top()) + 1, int(place.bottom()))
        if shot.pixelColor(int(x * ratio), int(y * ratio)).lightness() > 120
    ]
    assert lit
    across = (np.mean([x for x, _ in lit]) - place.left()) / place.width()
    down = (np.mean([y for _, y in lit]) - place.top()) / place.height()
    assert across > 0.8
    assert down == pytest.approx(0.5, abs=0.06)
    move(slices.unrolled.images, place.center())
    assert "θo 0" in slices.unrolled.readout.text() or "θo 1" in slices.unrolled.readout.text()
    assert "target" in slices.unrolled.readout.text()
    assert "fit" in slices.unrolled.readout.text()
    session.set_options(shown="difference", channel="r")
    qtbot.waitUntil(lambda: slices.is_idle)
    assert len(slices.unrolled.grid.rows) == 3
    assert slices.unrolled.grid.rows[2].startswith("fit − target")


def test_the_half_angle_slice_follows_its_slider(slices, session, qtbot) -> None:
    metal = PoulinFournier()
    session.add(subject("metal", metal))
    slices.window.plots.set_shown(HALF_ANGLE, True)
    qtbot.waitUntil(lambda: slices.is_idle)
    before = slices.half_angle.grid.pictures[0, 0].value
    slices.section.phi_d_slider.setValue(20)
    qtbot.waitUntil(lambda: slices.is_idle)
    after = slices.half_angle.grid.pictures[0, 0].value
    assert slices.state.options.phi_d_deg == 20.0
    assert not np.array_equal(before, after, equal_nan=True)
    nothing = slices.half_angle.grid.pictures[0, 0].nothing
    assert nothing[0, -1]  # below the horizon
    place = slices.half_angle.images.place_of(0, 0)
    move(slices.half_angle.images, QPointF(place.left() + 2.0, place.center().y()))
    assert "φd 20°" in slices.half_angle.readout.text()
    slices.section.reset.click()
    assert slices.state.options == SliceOptions()
    assert slices.section.phi_d_slider.value() == 90


@pytest.mark.parametrize("below", [False, True])
def test_the_numbers_at_the_ends_of_the_bar_have_their_room(below: bool) -> None:
    room = Room(14.0, True, True, 0.0, False, False, False, 44.0)
    width, height = (300.0, 500.0) if below else (420.0, 300.0)
    for rows, columns in ((3, 2), (2, 3), (1, 1), (3, 1)):
        way = best_layout(width, height, rows, columns, room)
        if way.bar_below:
            assert way.whole.left() >= 0.5 * room.bar_ticks
            assert way.whole.right() <= width - 0.5 * room.bar_ticks
        else:
            assert way.whole.top() >= 0.5 * room.line
            assert way.whole.bottom() <= height - 0.5 * room.line

"""What the window's own pieces do: grid, panes, map, notes and titles."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from brdf_color_swatch.assembly import ColorSwatch
from brdf_color_swatch.colour_map.panel import ColourMap
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.paint_exchange import PaintExchange
from PySide6.QtCore import QCoreApplication, QEvent, QPointF, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPalette
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QLineEdit, QWidget

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette


def test_the_return_that_ends_a_name_opens_nothing(swatch: ColorSwatch, select, qtbot, monkeypatch) -> None:
    link = swatch.feature(PaintExchange)
    monkeypatch.setattr(link, "start_program", lambda role: True)  # no Designer is left running
    pane = swatch.window.panes[0]
    opened: list[str] = []
    pane.opened.connect(opened.append)
    try:
        select(swatch, "Red")
        pane.rename_current()
        (editor,) = pane.grid.findChildren(QLineEdit)
        editor.setText("Scarlet")
        QTest.keyClick(editor, Qt.Key.Key_Return)
        qtbot.waitUntil(lambda: "Scarlet" in [entry.name for entry in swatch.session.palette.entries])
        qtbot.waitUntil(lambda: pane.grid.state() == pane.grid.State.NoState)
        assert opened == []
        QTest.keyClick(pane.grid, Qt.Key.Key_Return)
        assert opened == ["red"]
    finally:
        pane.opened.disconnect(opened.append)


def marked(swatch: ColorSwatch) -> list[bool]:
    """Return which panes have the mark of the one that is worked in."""
    return [not pane.findChild(QLabel, "front_mark").isHidden() for pane in swatch.window.panes]


def test_a_click_on_a_title_makes_the_pane_the_one_worked_in(swatch: ColorSwatch) -> None:
    assert marked(swatch) == [False, False]
    swatch.controller.show_second(True)
    assert marked(swatch) == [False, True]
    for number in (0, 1):
        head = swatch.window.panes[number].head
        QTest.mouseClick(head.childAt(head.rect().center()), Qt.MouseButton.LeftButton)
        assert swatch.session.front == number
        assert marked(swatch) == [number == 0, number == 1]


@pytest.fixture
def map_part(swatch: ColorSwatch):
    """The map in a window with room for it beside the inspector; hidden before and after."""
    part = swatch.feature(ColourMap)
    window = swatch.window
    size = window.size()
    window.resize(1500, 900)
    yield part
    if not part.dock.isHidden():
        part.toggle()
    window.resize(size)


def test_the_map_takes_its_room_from_the_swatches_and_gives_it_back(
    swatch: ColorSwatch, map_part: ColourMap, qtbot
) -> None:
    window = swatch.window
    docks = window.library_dock, window.inspector_dock
    window.resizeDocks(list(docks), [190, 290], Qt.Orientation.Horizontal)
    QCoreApplication.processEvents()
    before = [dock.width() for dock in docks]  # as near to that as a font allows
    for _ in range(2):
        map_part.toggle()
        QCoreApplication.processEvents()
        assert not map_part.dock.isHidden()
        qtbot.waitUntil(lambda: [dock.width() for dock in docks] == before)
        map_part.toggle()
        QCoreApplication.processEvents()
        assert map_part.dock.isHidden()
        qtbot.waitUntil(lambda: [dock.width() for dock in docks] == before)


def test_one_swatch_is_counted_in_the_singular(swatch: ColorSwatch) -> None:
    swatch.session.edit("Keep one", lambda palette: replace(palette, entries=palette.entries[:1], groups=()))
    texts = [label.text() for label in swatch.window.panes[0].head.findChildren(QLabel)]
    assert "1 swatch" in texts


def test_the_map_of_flat_colours_shows_a_and_b_until_another_is_chosen(
    swatch: ColorSwatch, map_part: ColourMap, qtbot
) -> None:
    map_part.chosen_kind = ""
    map_part.toggle()
    qtbot.waitUntil(lambda: map_part.is_idle)
    assert map_part.kind == "flop"
    ink = Entry(FlatColour("Ink", "RGB", (0.1, 0.1, 0.2), space="sRGB"), id="ink")
    swatch.session.show_scope(Scope(swatch.library.add_palette(Palette("Flat", (ink,)))))
    qtbot.waitUntil(lambda: map_part.is_idle and map_part.kind == "ab")
    assert map_part.kinds.currentData() == "ab"
    map_part.choose("flop")
    assert map_part.kind == "flop"
    assert map_part.plane is not None
    assert not map_part.plane.getAxis("left").autoSIPrefix
    low, high = map_part.plane.getViewBox().viewRange()[1]
    assert -1.0 < low <= 0.0
    assert 5.0 <= high < 6.0
    map_part.chosen_kind = ""


@pytest.mark.parametrize("width", [1000, 1280, 1600])
def test_the_search_field_keeps_room_for_what_is_typed(
    swatch: ColorSwatch, map_part: ColourMap, qtbot, width: int
) -> None:
    swatch.window.resize(width, 900)
    map_part.toggle()
    qtbot.waitUntil(lambda: map_part.is_idle)
    search = swatch.window.bar.search
    text = "metallic orange"
    needed = search.fontMetrics().horizontalAdvance(text)
    assert search.width() >= needed + 60  # and the two signs
    assert swatch.window.bar.geometry().right() <= swatch.window.pane_split.geometry().right()


def _move(widget: QWidget, x: float, y: float) -> None:
    """Move the pointer over a widget without a button; the offscreen platform moves none by itself."""
    at, none = QPointF(x, y), Qt.MouseButton.NoButton
    place = QPointF(widget.mapToGlobal(at))
    event = QMouseEvent(QEvent.Type.MouseMove, at, place, none, none, Qt.KeyboardModifier.NoModifier)
    QCoreApplication.sendEvent(widget, event)


@pytest.mark.parametrize("ground", ["#202020", "#e0e0e0"])
def test_a_point_of_the_ground_s_own_colour_is_seen_and_named(qtbot, ground: str) -> None:
    from brdf_color_swatch.colour_map.plane import PlaneMap
    from brdf_color_swatch.colour_map.points import MapPoints

    view = PlaneMap()
    qtbot.addWidget(view)
    colours = QPalette(QColor(ground))
    view.setPalette(colours)
    view.resize(420, 320)
    lab = np.array([[50.0, 10.0, 10.0], [50.0, -30.0, -30.0]])
    codes = np.array([QColor(ground).getRgb()[:3]] * 2, np.uint8)
    names = ("Night", "Fog")
    view.show_points(MapPoints(names, names, lab, np.zeros(2), np.zeros(2), codes), "ab")
    with qtbot.waitExposed(view):
        view.show()
    x, y = view.pixels()[0]

    def contrast() -> int:
        picture = view.grab().toImage()
        ratio = picture.devicePixelRatio()
        around = [
            picture.pixelColor(round((x + dx) * ratio), round((y + dy) * ratio)).lightness()
            for dx in range(-8, 9)
            for dy in range(-8, 9)
        ]
        return max(abs(value - QColor(ground).lightness()) for value in around)

    assert contrast() > 60
    before = view.grab().toImage()
    _move(view.viewport(), x, y)
    assert view.hovered == 0
    assert view.grab().toImage() != before
    _move(view.viewport(), x + 60, y + 60)
    assert view.hovered == -1


def test_the_axes_of_the_map_have_labels_that_can_be_told_apart(qtbot) -> None:
    from brdf_color_swatch.colour_map.plane import PlaneMap

    view = PlaneMap()
    qtbot.addWidget(view)
    for span in (0.013, 7.0, 220.0):
        ((step, _),) = view.getAxis("left").tickSpacing(-span / 2, span / 2, 640.0)
        assert 4 <= span / step <= 10

"""The map in three dimensions: points where their L*a*b* lies, clicks that find, lassos that select."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMainWindow

LAB = np.array([[20.0, 0.0, 0.0], [50.0, 60.0, 0.0], [50.0, -60.0, 0.0], [90.0, 0.0, 50.0]])
IDS = ("dark", "red", "green", "yellow")
CODES = np.array([[48, 48, 48], [222, 60, 120], [0, 140, 120], [250, 226, 120]], np.uint8)


@pytest.fixture
def view(qtbot):
    # Deferred: with it comes OpenGL, and the screen must be there before.
    from brdf_color_swatch.colour_map.points import MapPoints
    from brdf_color_swatch.colour_map.space import SpaceMap

    made = SpaceMap()
    qtbot.addWidget(made)
    made.resize(400, 300)
    made.show_points(MapPoints(IDS, IDS, LAB, np.zeros(4), np.zeros(4), CODES))
    with qtbot.waitExposed(made):
        made.show()
    made.heard = []
    made.chosen.connect(lambda ids, mode: made.heard.append((ids, mode)))
    return made


def drawn(view, place: int) -> int:
    """Pixels about a point that have its colour."""
    image, (at, _) = view.grabFramebuffer(), view.pixels()
    scale = image.width() / view.width()
    wanted = CODES[place].astype(int)
    found = 0
    for dx in range(-9, 10):
        for dy in range(-9, 10):
            colour = image.pixelColor(round((at[place, 0] + dx) * scale), round((at[place, 1] + dy) * scale))
            found += abs(np.array(colour.getRgb()[:3]) - wanted).max() < 12
    return found


def test_points_are_drawn_in_their_colours_and_those_selected_larger(view) -> None:
    at, depth = view.pixels()
    assert np.isfinite(at).all()
    # Lighter lies higher, and all of it lies in the view.
    assert at[3, 1] < at[0, 1]
    assert ((at > 0) & (at < [400, 300])).all()
    assert (depth > 0).all()

    assert drawn(view, 1) > 20
    accent = view.palette().highlight().color()

    def ringed(place: int) -> bool:
        image = view.grabFramebuffer()
        scale = image.width() / view.width()
        across = [
            image.pixelColor(round((at[place, 0] + dx) * scale), round(at[place, 1] * scale))
            for dx in (-7, 7)
        ]
        return all(
            abs(one.blue() - accent.blue()) < 40 and abs(one.red() - accent.red()) < 40 for one in across
        )

    assert not ringed(1)
    view.show_chosen({"red"})
    assert ringed(1)


def test_a_click_finds_and_a_drag_turns(view) -> None:
    at, _ = view.pixels()
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=QPoint(*np.rint(at[1]).astype(int).tolist()))
    assert view.heard == [(("red",), "set")]
    before = view.opts["azimuth"]
    QTest.mousePress(view, Qt.MouseButton.LeftButton, pos=QPoint(20, 20))
    QTest.mouseMove(view, QPoint(80, 40))
    QTest.mouseRelease(view, Qt.MouseButton.LeftButton, pos=QPoint(80, 40))
    assert view.opts["azimuth"] != before
    assert len(view.heard) == 1
    QTest.keyClick(view, Qt.Key.Key_F)
    assert view.opts["azimuth"] == -60
    assert np.allclose(view.pixels()[0], at, atol=0.5)


def test_the_name_of_a_point_is_shown_under_the_pointer(view, qtbot) -> None:
    at, _ = view.pixels()
    before = view.grabFramebuffer()
    QTest.mouseMove(view, QPoint(*np.rint(at[2]).astype(int).tolist()))
    qtbot.waitUntil(lambda: view.hovered == 2)
    assert view.grabFramebuffer() != before
    QTest.mouseMove(view, QPoint(2, 2))
    qtbot.waitUntil(lambda: view.hovered == -1)


def test_a_lasso_selects_what_it_is_drawn_around(view) -> None:
    view.lasso = True
    at, _ = view.pixels()
    low, high = at[[1, 3]].min(axis=0) - 8, at[[1, 3]].max(axis=0) + 8
    corners = [
        QPoint(round(x), round(y)) for x, y in ((low[0], low[1]), (high[0], low[1]), high, (low[0], high[1]))
    ]
    before = view.opts["azimuth"]
    QTest.mousePress(view, Qt.MouseButton.LeftButton, pos=corners[0])
    for corner in corners[1:]:
        QTest.mouseMove(view, corner)
    QTest.mouseRelease(view, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.AltModifier, corners[0])
    wanted = {key for key, point in zip(IDS, at, strict=True) if (point > low).all() and (point < high).all()}
    assert {"red", "yellow"} <= wanted
    ((ids, mode),) = view.heard
    assert (set(ids), mode) == (wanted, "drop")
    assert view.opts["azimuth"] == before


def test_points_are_drawn_in_another_window_too(view, qtbot) -> None:
    """A panel that is floated or docked gets another context, in which nothing of the first one is valid."""
    before = view.context()
    window = QMainWindow()
    qtbot.addWidget(window)
    window.setCentralWidget(view)
    window.resize(500, 400)
    with qtbot.waitExposed(window):
        window.show()
    qtbot.waitUntil(lambda: view.isValid() and view.context() is not before)
    assert drawn(view, 1) > 20
    assert drawn(view, 3) > 20
    window.takeCentralWidget()

"""Search, filters, orders, the nearest, duplicates and the map, through the window."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_color_swatch.colour_map.panel import ColourMap
from brdf_color_swatch.grid import filtering
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.search.comparison import PaintComparison
from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtTest import QTest


def test_typing_narrows_and_escape_shows_all_again(swatch, names, qtbot) -> None:
    search = swatch.window.bar.search
    QTest.keyClicks(search, "hot")
    qtbot.waitUntil(lambda: names(swatch) == ["Red", "Orange"])
    QTest.keyClicks(search, " C1")
    qtbot.waitUntil(lambda: names(swatch) == ["Orange"])
    QTest.keyClicks(search, "zzz")
    qtbot.waitUntil(lambda: "No swatch matches" in swatch.window.panes[0].note)
    QTest.keyClick(search, Qt.Key.Key_Escape)
    assert len(names(swatch)) == 6


def test_filters_let_ranges_pass_and_the_hue_goes_over_red(swatch, names) -> None:
    filters = swatch.window.filters
    hue = filters.fields["hue"]
    hue.low.edited.emit(0.0)
    hue.low.setValue(250.0)
    hue.high.setValue(40.0)
    hue.edited.emit(250.0, 40.0)
    assert names(swatch) == ["Red", "Blue"]
    filters.fields["lightness"].edited.emit(50.0, 150.0)
    assert names(swatch) == ["Red"]
    filters.clear.click()
    assert len(names(swatch)) == 6
    assert hue.track.values == [0.0, 360.0]


def test_a_filter_is_dragged_at_its_ends(swatch, names, qtbot) -> None:
    track = swatch.window.filters.fields["lightness"].track
    swatch.window.section("filters").set_open(True)
    qtbot.waitUntil(track.isVisible)
    QCoreApplication.processEvents()
    low, half = (QPoint(round(track.x_of(value)), 11) for value in (0.0, 75.0))
    QTest.mousePress(track, Qt.MouseButton.LeftButton, pos=low)
    QTest.mouseMove(track, half)
    QTest.mouseRelease(track, Qt.MouseButton.LeftButton, pos=half)
    assert names(swatch) == ["Ice"]
    track.setFocus()
    QTest.keyClick(track, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert names(swatch) == ["Silver", "Orange", "Ice"]


@pytest.mark.parametrize(
    ("key", "first"),
    [("lightness", "Black"), ("name", "Black"), ("code", "Red"), ("L_15", "Black"), ("tags", "Red")],
)
def test_orders_run_both_ways(swatch, names, key: str, first: str) -> None:
    pane = swatch.window.panes[0]
    pane.model.sort_requested.emit(key, False)
    up = names(swatch)
    assert up[0] == first or key == "tags"
    pane.model.sort_requested.emit(key, True)
    assert sorted(names(swatch)) == sorted(up)
    assert names(swatch) != up


def test_a_head_of_the_list_orders_and_says_so(swatch, names, command) -> None:
    command(swatch, "list")
    table = swatch.window.panes[0].list
    assert swatch.window.panes[0].stack.currentWidget() is table
    table.sortByColumn(0, Qt.SortOrder.DescendingOrder)
    assert names(swatch)[0] == "Silver"
    assert swatch.window.bar.sort.currentData() == "name"


def test_the_nearest_come_first_with_their_difference(swatch, names, select, command) -> None:
    select(swatch, "Red")
    command(swatch, "nearest")
    assert names(swatch)[:2] == ["Red", "Orange"]
    shown = swatch.session.shown[0]
    assert shown.figure[shown.places[0]] == pytest.approx(0.0, abs=1e-9)
    values = [shown.figure[place] for place in shown.places]
    assert values == sorted(values)
    assert "nearest to Red" in swatch.window.panes[0].title
    command(swatch, "clear")
    assert swatch.session.state.near is None
    assert swatch.session.state.sort == "own"


def test_duplicates_stand_together_under_what_they_differ_by(swatch, names, select, command) -> None:
    select(swatch, "Blue")
    command(swatch, "duplicate")
    swatch.window.filters.duplicates.click()
    assert names(swatch) == ["Blue", "Blue"]
    assert "2 similar" in swatch.session.shown[0].parts[0].title


def test_long_work_is_done_beside_the_window(swatch, names, monkeypatch, qtbot) -> None:
    monkeypatch.setattr(filtering, "_MANY", 0)
    swatch.window.bar.sort_chosen.emit("hue")
    assert swatch.session.is_working(0)
    assert names(swatch)[0] == "Silver"
    qtbot.waitUntil(lambda: not swatch.session.is_working(0))
    assert names(swatch)[:2] == ["Black", "Silver"]


def test_the_map_finds_by_click_and_selects_by_lasso(swatch, qtbot, names) -> None:
    part = swatch.feature(ColourMap)
    part.run_script("map", "flop")
    qtbot.waitUntil(lambda: part.plane is not None and part.is_idle)
    plane = part.plane
    qtbot.waitUntil(lambda: bool(plane.pixels().size) and plane.pixels()[:, 0].std() > 5)
    order = names(swatch)
    at = plane.pixels()[order.index("Blue")]
    QTest.mouseClick(plane.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(round(at[0]), round(at[1])))
    assert swatch.session.selected == ("blue",)
    wanted = [order.index("Red"), order.index("Silver")]
    points = plane.pixels()
    low = points[wanted].min(axis=0) - 6
    high = points[wanted].max(axis=0) + 6
    corners = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    spots = [QPoint(round(x), round(y)) for x, y in corners]
    QTest.mousePress(plane.viewport(), Qt.MouseButton.LeftButton, pos=spots[0])
    for spot in spots[1:]:
        QTest.mouseMove(plane.viewport(), spot)
    QTest.mouseRelease(plane.viewport(), Qt.MouseButton.LeftButton, pos=spots[0])
    inside = [
        key
        for key, point in zip(part.points.ids, points, strict=True)
        if np.all(point > low) and np.all(point < high)
    ]
    assert {"red", "silver"} <= set(inside)
    assert set(swatch.session.selected) == set(inside)
    part.choose("space")
    assert "needs OpenGL" in part.note.text()
    part.toggle()


def test_two_selected_are_compared_also_one_in_each_pane(swatch, select, command) -> None:
    select(swatch, "Red", "Blue")
    command(swatch, "compare")
    part = swatch.feature(PaintComparison)
    assert part.panel.table.rowCount() == 3
    assert "Red" in part.panel.names.text()
    command(swatch, "two_panes")
    swatch.session.show_scope(Scope(swatch.session.states[0].scope.palette), 1)
    select(swatch, "Ice", pane=1)
    select(swatch, "Black", pane=0)
    assert [entry.name for entry in part.pair()] == ["Black", "Ice"]

"""What a line around points holds, compared with Qt's own polygons."""

from __future__ import annotations

import numpy as np
from brdf_color_swatch.colour_map.points import LassoLine, inside, nearest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPolygonF

corner = st.tuples(st.floats(0.0, 100.0), st.floats(0.0, 100.0))


@settings(max_examples=settings.default.max_examples // 2)
@given(st.lists(corner, min_size=3, max_size=9), st.integers(0, 2**31))
def test_inside_is_what_qt_says(corners: list[tuple[float, float]], seed: int) -> None:
    points = np.random.default_rng(seed).uniform(-5.0, 105.0, (50, 2))
    polygon = QPolygonF([QPointF(*at) for at in [*corners, corners[0]]])
    wanted = [polygon.containsPoint(QPointF(*at), Qt.FillRule.OddEvenFill) for at in points]
    found = inside(points, corners)
    # On an edge, to the last digit, either answer is right.
    assert np.count_nonzero(found != np.array(wanted)) <= 1


def test_nothing_lies_in_a_line_or_beyond_numbers() -> None:
    assert not inside([[0.5, 0.5]], [[0, 0], [1, 1]]).any()
    assert inside([[np.nan, 0.5], [0.5, 0.5]], [[0, 0], [1, 0], [1, 1], [0, 1]]).tolist() == [False, True]


def test_a_click_finds_the_nearest_and_of_several_the_foremost() -> None:
    points = [[10.0, 10.0], [12.0, 10.0], [50.0, 50.0]]
    assert nearest(points, (10.5, 10.0)) == 0
    assert nearest(points, (11.0, 10.0), depth=[5.0, 2.0, 1.0]) == 1
    assert nearest(points, (80.0, 80.0)) is None
    assert nearest(np.zeros((0, 2)), (1.0, 1.0)) is None


def test_a_short_way_is_a_click() -> None:
    line = LassoLine()
    line.begin(5.0, 5.0)
    line.extend(7.0, 5.0)
    assert line.is_click
    line.extend(40.0, 5.0)
    line.extend(5.0, 5.0)
    assert not line.is_click
    line.end()
    assert not line.is_drawn

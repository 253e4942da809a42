"""Where swatches lie: found by halving as by looking at each."""

from __future__ import annotations

from brdf_color_swatch.grid.layout import GAP, GridLayout, Part
from hypothesis import given
from hypothesis import strategies as st

counts = st.lists(st.integers(0, 9), max_size=5)


def layout_of(counts: list[int], width: int) -> GridLayout:
    parts, first = [], 0
    for number, count in enumerate(counts):
        parts.append(Part(f"part {number}" if number else "", first, count))
        first += count
    return GridLayout(parts, (40, 50), width)


@given(counts, st.integers(10, 400), st.integers(0, 399), st.integers(0, 900))
def test_a_point_finds_the_swatch_that_lies_there(counts: list[int], width: int, x: int, y: int) -> None:
    layout = layout_of(counts, width)
    boxes = [layout.box(place) for place in range(layout.count)]
    there = [
        place for place, (left, top, w, h) in enumerate(boxes) if left <= x < left + w and top <= y < top + h
    ]
    assert layout.at(x, y) == (there[0] if there else None)
    assert all(top + h <= layout.height for _, top, _, h in boxes)
    near = layout.near(x, y)
    assert (near is None) == (layout.count == 0)


@given(counts, st.integers(100, 400), st.integers(0, 600), st.integers(1, 300))
def test_what_is_seen_is_all_that_touches_the_window(
    counts: list[int], width: int, top: int, high: int
) -> None:
    layout = layout_of(counts, width)
    listed = [place for _, places in layout.between(top, top + high) for place in places]
    touching = layout.inside((0, top, width, high))
    assert len(listed) == len(set(listed))
    wanted = [
        place
        for place in range(layout.count)
        if layout.box(place)[1] < top + high and top < layout.box(place)[1] + layout.box(place)[3]
    ]
    assert set(wanted) <= set(listed)
    assert touching == wanted


def test_steps_go_over_headings_in_the_same_column() -> None:
    layout = layout_of([5, 0, 4], 4 * 48 + GAP)
    assert layout.columns == 4
    assert layout.step(1, 1) == 4
    assert layout.step(0, 2) == 5
    assert layout.step(6, -1) == 4
    assert layout.step(7, 5) == 7
    assert layout.step(2, -3) == 2

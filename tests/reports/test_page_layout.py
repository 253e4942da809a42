"""Where the marks of a contact sheet stand: on the paper, apart from each other, with every item once."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.errors import ValueRangeError
from brdf_suite.reports.contact_sheet.page_layout import (
    FIELDS,
    MARGIN,
    PAGE_SIZES,
    CellText,
    PageLayout,
    PageStyle,
)

LABS = ((15.0, (90.0, 1.0, -2.0)), (45.0, (50.0, -10.0, 20.0)), (110.0, (20.0, 3.0, 4.0)))


def measure(text: str, size: float, bold: bool) -> float:
    return len(text) * size * (0.6 if bold else 0.55)


@given(
    st.lists(st.integers(0, 40), min_size=1, max_size=5),
    st.sampled_from(sorted(PAGE_SIZES)),
    st.booleans(),
    st.integers(1, 8),
    st.sets(st.sampled_from(FIELDS)),
    st.floats(0.3, 3.0),
)
def test_every_item_is_on_the_paper_and_on_no_other(
    counts: list[int], page: str, landscape: bool, columns: int, fields: set[str], aspect: float
) -> None:
    groups = [
        f"Group {number}" if number else "" for number, count in enumerate(counts) for _ in range(count)
    ]
    style = PageStyle(page, landscape, columns, tuple(name for name in FIELDS if name in fields))
    layout = PageLayout.of("A title that is long " * 9, "how " * 60, "1 May", groups, style, aspect)
    assert len(layout.slots) == len(groups)
    width, height = style.size
    boxes = []
    for place, slot in enumerate(layout.slots):
        marks = layout.cell(place, CellText("A name of some length " * 3, "C1", "flop 3", LABS), measure)
        right = max([slot.x + slot.width, *(p.x + p.width for p in marks.patches)])
        low = max([slot.y + slot.height, *(label.y for label in marks.labels)])
        assert slot.x >= MARGIN - 1e-6
        assert right <= width - MARGIN + 1e-6
        for label in marks.labels:
            wide = measure(label.text, label.size, label.bold)
            start = label.x - wide if label.anchor == "end" else label.x
            assert start >= slot.x - 1e-6
            assert start + wide <= width - MARGIN + 1e-6
        boxes.append((slot.page, slot.x, slot.y, right, low))
        assert low <= height - MARGIN
    for before, after in pairwise(boxes):
        same_row = before[:1] == after[:1] and before[2] == after[2]
        assert after[0] >= before[0]
        assert before[3] <= after[1] if same_row else (after[0] > before[0] or after[2] >= before[4])
    assert [text for _, _, text in layout.headings] == list(dict.fromkeys(filter(None, groups)))
    assert layout.pages == (max(slot.page for slot in layout.slots) + 1 if groups else 0)
    for number in range(layout.pages):
        for label in layout.frame(number, measure).labels:
            assert 0.0 < label.y < height


def test_a_problem_stands_in_the_picture_s_place() -> None:
    layout = PageLayout.of("T", "", "", [""], PageStyle(), 1.0)
    marks = layout.cell(0, CellText("Red", problem="could not be drawn: no gloss is so high"), measure)
    slot = layout.slots[0]
    lines = [label for label in marks.labels if slot.y < label.y < slot.y + slot.height]
    assert " ".join(label.text for label in lines) == "could not be drawn: no gloss is so high"


@pytest.mark.parametrize("wrong", [{"page": "a7"}, {"columns": 0}, {"columns": 41}, {"fields": ("smell",)}])
def test_what_is_not_known_is_refused(wrong: dict[str, object]) -> None:
    with pytest.raises(ValueRangeError):
        PageStyle(**wrong)

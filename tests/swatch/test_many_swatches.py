"""What a palette of many swatches does not do on the window's thread, nor once for each of them."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from brdf_color_swatch.grid import filtering
from brdf_color_swatch.grid.filtering import by_group, filter_and_sort, is_slow
from brdf_color_swatch.grid.rows import Rows, finish_rows, rows_of
from brdf_color_swatch.grid.view_state import PaneState
from brdf_color_swatch.library.loading import read_palette_file
from PySide6.QtCore import QItemSelectionModel

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.palettes import columns

GREY = solid_paint("Grey", (50.0, 0.0, 0.0))


def many(count: int) -> tuple[Entry, ...]:
    paths = ((), ("A",), ("B",), ("A", "Inner"))
    return tuple(
        Entry(GREY, id=str(n), code=f"C{n * 7 % 11}", group=paths[n * n % 4], tags=("t", str(n % 3))[: n % 3])
        for n in range(count)
    )


def test_groups_and_tags_are_those_of_the_entries() -> None:
    entries = many(200)
    rows = rows_of(entries)
    assert rows.tag_counts == Counter(tag for entry in entries for tag in entry.tags)
    places = np.arange(17, 190, 3)
    found, parts = by_group(rows, places)
    of = [entries[place].group for place in places]
    order = sorted(dict.fromkeys(of), key=lambda path: (path != (), of.index(path)))
    wanted = [place for path in order for place in places if entries[place].group == path]
    assert found.tolist() == wanted
    assert [(part.first, part.count) for part in parts] == [
        (sum(of.count(other) for other in order[:n]), of.count(path)) for n, path in enumerate(order)
    ]
    assert [part.title for part in parts] == [" › ".join(path) or "Ungrouped" for path in order]
    alone, (part,) = by_group(rows_of(many(1)), np.array([0]))
    assert (alone.tolist(), part.title) == ([0], "")


def test_orders_by_text_and_a_first_search_of_many_are_slow(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(filtering, "_MANY_TEXTS", 500)
    rows, few = rows_of(many(600)), rows_of(many(450))
    for state in (PaneState(sort="name"), PaneState(sort="code"), PaneState(text="grey")):
        assert is_slow(rows, state)
        assert not is_slow(few, state)
        filter_and_sort(rows, state)
        assert not is_slow(rows, state)  # worked out once
    assert not is_slow(rows, PaneState(sort="lightness"))


def test_the_reading_thread_works_out_what_the_window_shows_first(tmp_path) -> None:
    path = tmp_path / "many.brdfpalette"
    save_palette(Palette("Many", many(30)), path)
    read = read_palette_file(path, lambda *_: None)
    assert {"groups", "tag_counts", "ids", "has_codes"} <= vars(read.rows).keys()
    assert "by_id" in vars(read.palette)


def test_an_edit_of_one_swatch_works_out_one_row(monkeypatch: pytest.MonkeyPatch) -> None:
    entries = tuple(replace(entry, content=replace(GREY, name=entry.id)) for entry in many(400))
    before = rows_of(entries)
    read: list[int] = []
    take = columns.ColumnsWork._take_readings
    monkeypatch.setattr(
        columns.ColumnsWork, "_take_readings", lambda self, rows: (read.extend(rows), take(self, rows))
    )
    renamed = replace(entries[123], content=replace(GREY, name="Other"))
    for changed in (
        (*entries[:123], renamed, *entries[124:]),
        (*entries[:123], renamed, *entries[123:]),
        (*entries[:123], *entries[124:], renamed),
    ):
        read.clear()
        after = rows_of(changed, before)
        assert [changed[row] for row in read] == [renamed]
        assert np.array_equal(after.lab, rows_of(changed).lab)
        assert np.array_equal(after.codes, rows_of(changed).codes)


@pytest.mark.parametrize(
    "change",
    [
        {"content": replace(GREY, name="Other")},
        {"tags": ("winter", "tag 0")},
        {"tags": ()},
        {"group": ("Elsewhere",)},
        {"code": ""},
        {"code": "C 1"},
        {"id": "another"},
        {"content": FlatColour("", "Lab", (50.0, 20.0, 10.0))},
    ],
)
def test_what_is_counted_is_right_after_an_edit_of_one_swatch(change) -> None:
    entries = tuple(replace(entry, tags=(f"tag {row % 3}",)) for row, entry in enumerate(many(60)))
    names = ("groups", "ids", "has_codes", "notes", "tag_counts")
    before = rows_of(entries)
    known = {name: getattr(before, name) for name in names}
    changed = (*entries[:7], replace(entries[7], **change), *entries[8:])
    after, fresh = rows_of(changed, before), rows_of(changed)
    for name in ("ids", "has_codes", "notes", "tag_counts"):
        assert getattr(after, name) == getattr(fresh, name)
    assert after.groups[1] == fresh.groups[1]
    assert np.array_equal(after.groups[0], fresh.groups[0])
    back = rows_of(entries, after)
    assert back.tag_counts == known["tag_counts"]
    # What the edit did not touch is not worked out again.
    assert (after.groups is known["groups"]) == ("group" not in change)
    assert (after.ids is known["ids"]) == ("id" not in change)


def test_rows_that_are_finished_keep_what_was_counted() -> None:
    rows = rows_of(many(20))
    groups, counts = rows.groups, rows.tag_counts
    finished = finish_rows(rows, lambda *_: None)
    assert not finished.columns.waiting.any()
    assert finished.groups is groups
    assert finished.tag_counts == counts


def test_all_that_is_selected_is_one_range_looked_up_once(swatch) -> None:
    session, pane = swatch.session, swatch.window.panes[0]
    pane.grid.selectAll()
    assert pane.grid.selectionModel().selection().count() == 1
    assert len(session.selected) == pane.model.rowCount()
    assert session.selected is session.selected
    assert session.selected_entries is session.selected_in(0)
    assert [entry.id for entry in session.selected_entries] == list(session.selected)
    pane.grid.selectionModel().select(
        pane.model.index(0, 0), QItemSelectionModel.SelectionFlag.ClearAndSelect
    )
    assert session.selected == (pane.model.id_at(0),)


def test_empty_rows_have_no_groups() -> None:
    found, parts = by_group(Rows.empty(), np.zeros(0, int))
    assert (len(found), parts) == (0, ())

"""Two changes of one palette become one: what each side changed, and what collides."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.palettes.merge import merge


def colour(name: str, lightness: float = 50.0) -> FlatColour:
    return FlatColour(name, "Lab", (lightness, 0.0, 0.0))


BASE = Palette(
    "Car",
    tuple(Entry(colour(f"c{i}", 10.0 * i), str(i), ("A",) if i < 3 else ()) for i in range(1, 6)),
    notes="old",
)


def edited(palette: Palette, id_: str, **changes: object) -> Palette:
    entries = tuple(replace(entry, **changes) if entry.id == id_ else entry for entry in palette)  # type: ignore[arg-type]
    return replace(palette, entries=entries)


def ids(palette: Palette) -> list[str]:
    return [entry.id for entry in palette]


ENTRY = st.builds(
    Entry,
    content=st.builds(colour, st.sampled_from("xyz"), st.sampled_from([10.0, 20.0])),
    id=st.sampled_from("123456789"),
    group=st.sampled_from([(), ("A",), ("A", "B")]),
    tags=st.sampled_from([(), ("t",), ("u", "t")]),
    notes=st.sampled_from(["", "n"]),
)
PALETTES = st.builds(
    Palette,
    name=st.sampled_from(["P", "Q"]),
    entries=st.lists(ENTRY, max_size=6, unique_by=lambda entry: entry.id).map(tuple),
    groups=st.sampled_from([(), (Group(("A",), "n"),), (Group(("Z",)), Group(("A",)))]),
    notes=st.sampled_from(["", "m"]),
)


@given(PALETTES, PALETTES, PALETTES)
def test_the_laws(base: Palette, ours: Palette, theirs: Palette) -> None:
    assert merge(base, ours, base).palette == ours
    assert merge(base, base, theirs).palette == theirs
    assert merge(base, ours, ours).palette == ours
    assert not merge(base, ours, base).conflicts
    assert not merge(base, base, theirs).conflicts
    assert not merge(base, ours, ours).conflicts
    both = merge(base, ours, theirs)
    # Nothing that either side added is lost, and nothing comes back that both removed.
    for side in (ours, theirs):
        for entry in side:
            if entry.id not in base.by_id:
                assert entry.content in [item.content for item in both.palette]
    assert not {name for name in base.by_id if name not in ours.by_id and name not in theirs.by_id} & {
        *both.palette.by_id
    } - {*ours.by_id, *theirs.by_id}


@given(PALETTES, PALETTES)
def test_a_merge_that_was_taken_over_has_nothing_new(base: Palette, theirs: Palette) -> None:
    ours = replace(base, name="R")
    once = merge(base, ours, theirs)
    again = merge(theirs, once.palette, theirs)
    assert again.palette == once.palette
    assert not again.conflicts


def test_changes_of_different_fields_go_together() -> None:
    ours = edited(BASE, "2", notes="mine", tags=("a",))
    theirs = edited(replace(BASE, notes="new"), "2", code="B7", tags=("b",))
    found = merge(BASE, ours, theirs)
    entry = found.palette.entry("2")
    assert (entry.notes, entry.code, entry.tags) == ("mine", "B7", ("a", "b"))
    assert found.palette.notes == "new"
    assert found.conflicts == ()
    assert found.taken == ("The entry c2 is changed.",)


def test_a_new_name_and_a_new_gloss_of_one_paint_go_together() -> None:
    white = solid_paint("white", (90.0, 0.0, 0.0))
    base = Palette("P", (Entry(white, "1"),))
    ours = edited(base, "1", content=replace(white, name="Weiss"))
    theirs = edited(base, "1", content=replace(white, gloss=Gloss(80.0)))
    found = merge(base, ours, theirs)
    assert found.conflicts == ()
    assert found.palette.entry("1").content == replace(white, name="Weiss", gloss=Gloss(80.0))


def test_the_same_field_changed_twice_stays_ours_and_is_reported() -> None:
    found = merge(BASE, edited(BASE, "3", code="A"), edited(BASE, "3", code="B"))
    assert found.palette.entry("3").code == "A"
    assert found.conflicts == (
        "The code of the entry c3 was changed here and in the file; it stays as it is here.",
    )


def test_two_names_that_meet_are_reported_as_names() -> None:
    base = Palette("P", (Entry(solid_paint("Red", (40.0, 50.0, 30.0)), "1"),))
    content = base.entries[0].content
    found = merge(
        base,
        edited(base, "1", content=replace(content, name="Brick")),
        edited(base, "1", content=replace(content, name="Rouge")),
    )
    assert found.palette.entry("1").name == "Brick"
    assert found.conflicts == (
        "The name of the entry Brick was changed here and in the file: here Brick, in the file Rouge; "
        "it stays as it is here.",
    )


@pytest.mark.parametrize("ours_removes", [True, False])
def test_what_one_removes_and_the_other_changes_is_kept(ours_removes: bool) -> None:
    removed = replace(BASE, entries=BASE.entries[1:])
    changed = edited(BASE, "1", notes="x")
    ours, theirs = (removed, changed) if ours_removes else (changed, removed)
    found = merge(BASE, ours, theirs)
    assert found.palette.entry("1").notes == "x"
    assert len(found.conflicts) == 1
    assert "it is kept" in found.conflicts[0]


def test_what_one_removes_and_the_other_leaves_goes() -> None:
    found = merge(BASE, replace(BASE, name="New"), replace(BASE, entries=BASE.entries[1:]))
    assert ids(found.palette) == ["2", "3", "4", "5"]
    assert found.palette.name == "New"
    assert found.taken == ("The entry c1 is removed.",)


def test_new_entries_of_both_stand_behind_what_they_followed() -> None:
    mine, other = Entry(colour("mine"), "m"), Entry(colour("other"), "o")
    ours = replace(BASE, entries=(*BASE.entries[:2], mine, *BASE.entries[2:]))
    theirs = replace(BASE, entries=(BASE.entries[0], other, *BASE.entries[1:]))
    assert ids(merge(BASE, ours, theirs).palette) == ["1", "o", "2", "m", "3", "4", "5"]


def test_the_order_is_that_of_who_moved_something() -> None:
    moved = replace(BASE, entries=tuple(reversed(BASE.entries)))
    assert ids(merge(BASE, edited(BASE, "1", code="x"), moved).palette) == ["5", "4", "3", "2", "1"]
    assert ids(merge(BASE, moved, edited(BASE, "1", code="x")).palette) == ["5", "4", "3", "2", "1"]


def test_entries_that_both_added_under_one_id_are_both_kept() -> None:
    ours = replace(BASE, entries=(*BASE.entries, Entry(colour("mine"), "6")))
    theirs = replace(BASE, entries=(*BASE.entries, Entry(colour("other"), "6")))
    found = merge(BASE, ours, theirs)
    assert sorted(entry.name for entry in found.palette) == ["c1", "c2", "c3", "c4", "c5", "mine", "other"]
    assert found.conflicts == ()

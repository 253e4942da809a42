"""Edits of palettes: what moves, what stays, what is refused."""

from __future__ import annotations

from dataclasses import replace

import pytest

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.documents.palette_edits import (
    added,
    changed,
    changed_group,
    moved,
    moved_group,
    removed,
    renamed,
    renamed_group,
    reordered,
    tagged,
    with_group,
    without_group,
)
from brdf_suite.errors import ValueRangeError


def entry(name: str, *group: str) -> Entry:
    return Entry(FlatColour(name, "Gray", (0.5,)), id=name, group=group)


PALETTE = Palette(
    "p",
    (entry("a"), entry("b", "G"), entry("c", "G", "H"), entry("d"), entry("e", "I")),
    (Group(("G",), "notes"),),
)


def ids(palette: Palette) -> str:
    return "".join(item.id for item in palette)


def test_entries_are_added_as_others_where_their_id_is_taken() -> None:
    more = added(PALETTE, [entry("x"), entry("a", "Z")], before="b")
    assert [item.name for item in more] == ["a", "x", "a", "b", "c", "d", "e"]
    assert len(more.by_id) == 7
    assert more.entry("x").group == ()
    assert ("Z",) in {group.path for group in more.groups}
    assert added(PALETTE, [entry("x", "Z")], group=("G",)).entry("x").group == ("G",)


def test_entries_move_together_and_keep_their_order() -> None:
    assert ids(moved(PALETTE, ("e", "a"), before="c")) == "baecd"
    assert ids(moved(PALETTE, ("a", "b"))) == "cdeab"
    assert ids(moved(PALETTE, ("a", "c", "d"), before="c")) == "bacde"
    inside = moved(PALETTE, ("a", "e"), ("G", "H"))
    assert ids(inside) == "bcdae"
    assert inside.entry("e").group == ("G", "H")
    assert inside.entry("b") is PALETTE.entry("b")
    assert ids(removed(PALETTE, ("b", "e"))) == "acd"
    assert removed(PALETTE, ("e",)).groups == PALETTE.groups
    assert ids(reordered(PALETTE, ("e", "a", "c"))) == "ebadc"


def test_entries_are_changed_and_keep_their_ids() -> None:
    assert renamed(PALETTE, "a", "ä").entry("a").name == "ä"
    tags = tagged(tagged(PALETTE, ("a", "b"), add=("x", "y")), ("a",), add=("x", "z"), drop=("y",))
    assert (tags.entry("a").tags, tags.entry("b").tags) == (("x", "z"), ("x", "y"))
    assert ids(changed(PALETTE, ("a",), lambda item: replace(item, id="other", code="1"))) == "abcde"


def test_groups_take_what_is_in_them_along() -> None:
    more = with_group(PALETTE, Group(("New",)), before=("I",))
    assert [group.path for group in more.groups] == [("G",), ("G", "H"), ("New",), ("I",)]
    other = renamed_group(PALETTE, ("G",), "K")
    assert [item.group for item in other] == [(), ("K",), ("K", "H"), (), ("I",)]
    assert other.groups[0] == Group(("K",), "notes")
    deeper = moved_group(PALETTE, ("I",), ("G", "I"), before=("G", "H"))
    assert [group.path for group in deeper.groups] == [("G",), ("G", "I"), ("G", "H")]
    one = moved_group(PALETTE, ("I",), ("G",))
    assert one.entry("e").group == ("G",)
    assert one.groups == PALETTE.groups[:2]
    assert changed_group(PALETTE, ("I",), lambda group: replace(group, notes="n")).groups[2].notes == "n"
    assert ids(without_group(PALETTE, ("G",))) == "ade"
    kept = without_group(PALETTE, ("G",), keep_entries=True)
    assert ids(kept) == "abcde"
    assert kept.entry("c").group == ()


def test_what_is_not_there_is_reported() -> None:
    for call in (
        lambda: removed(PALETTE, ("z",)),
        lambda: moved(PALETTE, ("a",), before="z"),
        lambda: reordered(PALETTE, ("a", "a")),
        lambda: renamed_group(PALETTE, ("Z",), "Y"),
        lambda: with_group(PALETTE, Group(("G",))),
        lambda: moved_group(PALETTE, ("G",), ("G", "H", "G")),
        lambda: tagged(PALETTE, ("a",), add=("",)),
    ):
        with pytest.raises(ValueRangeError):
            call()

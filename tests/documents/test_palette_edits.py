"""Edits of palettes: what moves, what stays, what is refused."""

from __future__ import annotations

from dataclasses import replace

import pytest

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.documents.palette_edits import (
    add_entries,
    change_entries,
    change_group,
    move_entries,
    move_group,
    remove_entries,
    remove_group,
    rename_entry,
    rename_group,
    reorder_entries,
    tag_entries,
    with_group,
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
    more = add_entries(PALETTE, [entry("x"), entry("a", "Z")], before="b")
    assert [item.name for item in more] == ["a", "x", "a", "b", "c", "d", "e"]
    assert len(more.by_id) == 7
    assert more.entry("x").group == ()
    assert ("Z",) in {group.path for group in more.groups}
    assert add_entries(PALETTE, [entry("x", "Z")], group=("G",)).entry("x").group == ("G",)


def test_entries_move_together_and_keep_their_order() -> None:
    assert ids(move_entries(PALETTE, ("e", "a"), before="c")) == "baecd"
    assert ids(move_entries(PALETTE, ("a", "b"))) == "cdeab"
    assert ids(move_entries(PALETTE, ("a", "c", "d"), before="c")) == "bacde"
    inside = move_entries(PALETTE, ("a", "e"), ("G", "H"))
    assert ids(inside) == "bcdae"
    assert inside.entry("e").group == ("G", "H")
    assert inside.entry("b") is PALETTE.entry("b")
    assert ids(remove_entries(PALETTE, ("b", "e"))) == "acd"
    assert remove_entries(PALETTE, ("e",)).groups == PALETTE.groups
    assert ids(reorder_entries(PALETTE, ("e", "a", "c"))) == "ebadc"


def test_entries_are_changed_and_keep_their_ids() -> None:
    assert rename_entry(PALETTE, "a", "ä").entry("a").name == "ä"
    tags = tag_entries(tag_entries(PALETTE, ("a", "b"), add=("x", "y")), ("a",), add=("x", "z"), drop=("y",))
    assert (tags.entry("a").tags, tags.entry("b").tags) == (("x", "z"), ("x", "y"))
    assert ids(change_entries(PALETTE, ("a",), lambda item: replace(item, id="other", code="1"))) == "abcde"


def test_groups_take_what_is_in_them_along() -> None:
    more = with_group(PALETTE, Group(("New",)), before=("I",))
    assert [group.path for group in more.groups] == [("G",), ("G", "H"), ("New",), ("I",)]
    other = rename_group(PALETTE, ("G",), "K")
    assert [item.group for item in other] == [(), ("K",), ("K", "H"), (), ("I",)]
    assert other.groups[0] == Group(("K",), "notes")
    deeper = move_group(PALETTE, ("I",), ("G", "I"), before=("G", "H"))
    assert [group.path for group in deeper.groups] == [("G",), ("G", "I"), ("G", "H")]
    one = move_group(PALETTE, ("I",), ("G",))
    assert one.entry("e").group == ("G",)
    assert one.groups == PALETTE.groups[:2]
    assert change_group(PALETTE, ("I",), lambda group: replace(group, notes="n")).groups[2].notes == "n"
    assert ids(remove_group(PALETTE, ("G",))) == "ade"
    kept = remove_group(PALETTE, ("G",), keep_entries=True)
    assert ids(kept) == "abcde"
    assert kept.entry("c").group == ()


def test_what_is_not_there_is_reported() -> None:
    for call in (
        lambda: remove_entries(PALETTE, ("z",)),
        lambda: move_entries(PALETTE, ("a",), before="z"),
        lambda: reorder_entries(PALETTE, ("a", "a")),
        lambda: rename_group(PALETTE, ("Z",), "Y"),
        lambda: with_group(PALETTE, Group(("G",))),
        lambda: move_group(PALETTE, ("G",), ("G", "H", "G")),
        lambda: tag_entries(PALETTE, ("a",), add=("",)),
    ):
        with pytest.raises(ValueRangeError):
            call()

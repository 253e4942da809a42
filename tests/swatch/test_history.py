"""Any sequence of edits and as many undos gives the palettes that there were, and redo gives them back."""

from __future__ import annotations

from dataclasses import replace

import pytest
from brdf_color_swatch.grid.view_state import Scope
from brdf_color_swatch.library.history import History, Store
from brdf_qt.documents.open_document import DocumentStore
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.documents import palette_edits as edits
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Group, Palette

KINDS = ("rename", "remove", "add", "move", "tag", "group", "across", "notes", "reload")


def palette(name: str, count: int) -> Palette:
    paints = [solid_paint(f"{name}{number}", (10.0 * number, 0.0, 0.0)) for number in range(count)]
    return Palette(name, tuple(Entry(one, id=f"{name}{number}") for number, one in enumerate(paints)))


def edit(kind: str, number: int, stores: list[Store], history: History) -> bool:
    store, other = stores[number % 2], stores[1 - number % 2]
    value = store.value
    if not len(value):
        return False
    key = value.entries[number % len(value)].id
    if kind == "across":
        moved = edits.add_entries(other.value, [value.entry(key)])
        return history.apply("across", [(store, edits.remove_entries(value, [key])), (other, moved)])
    made = {
        "rename": lambda: edits.rename_entry(value, key, f"n{number}"),
        "remove": lambda: edits.remove_entries(value, [key]),
        "add": lambda: edits.add_entries(value, [value.entry(key)]),
        "move": lambda: edits.move_entries(value, [key], ("G",), value.entries[0].id),
        "tag": lambda: edits.tag_entries(value, [key], [f"t{number % 5}"]),
        "group": lambda: edits.with_group(value, Group((f"g{len(value.groups)}-{number}",))),
        "notes": lambda: replace(value, notes=f"{number}"),
        "reload": lambda: palette(value.name, number % 4),
    }[kind]()
    return history.apply(kind, [(store, made)])


@settings(max_examples=settings.default.max_examples // 2)
@given(st.lists(st.tuples(st.sampled_from(KINDS), st.integers(0, 99)), max_size=12))
def test_undo_brings_everything_back_and_redo_too(qapp, steps: list[tuple[str, int]]) -> None:
    stores = [DocumentStore(palette("a", 4)), DocumentStore(palette("b", 3))]
    history = History()
    states = [[store.value for store in stores]]
    for kind, number in steps:
        if edit(kind, number, stores, history):
            states.append([store.value for store in stores])
    for wanted in reversed(states[:-1]):
        history.undo()
        assert [store.value for store in stores] == wanted
    assert not history.can_undo
    assert all(store.is_clean for store in stores)
    for wanted in states[1:]:
        history.redo()
        assert [store.value for store in stores] == wanted
    assert not history.can_redo


def test_a_closed_palette_takes_its_steps_along(qapp) -> None:
    stores = [DocumentStore(palette("a", 4)), DocumentStore(palette("b", 3))]
    history = History()
    edit("notes", 0, stores, history)
    edit("rename", 1, stores, history)
    edit("tag", 0, stores, history)
    history.undo()
    history.forget(stores[1])
    assert (history.undo_name, history.redo_name) == ("notes", "tag")
    history.undo()
    assert stores[0].value == palette("a", 4)
    assert not history.can_undo


@pytest.mark.parametrize("closed", [0, 1])
def test_a_move_to_or_from_a_closed_palette_is_not_half_undone(qapp, closed: int) -> None:
    stores = [DocumentStore(palette("a", 4)), DocumentStore(palette("b", 3))]
    history, still = History(), stores[1 - closed]
    edit("rename", 1 - closed, stores, history)
    edit("across", 0, stores, history)
    moved = still.value
    edit("notes", 1 - closed, stores, history)
    history.forget(stores[closed])
    assert history.undo_name == "notes"
    history.undo()
    assert not history.can_undo
    assert still.value == moved
    history.redo()
    assert still.value.notes


def test_a_move_that_was_undone_is_not_half_done_again(qapp) -> None:
    stores = [DocumentStore(palette(name, 3)) for name in "abc"]
    history = History()
    edit("across", 0, stores, history)
    edit("notes", 1, stores, history)
    history.apply("other", [(stores[2], palette("c", 1))])
    for _ in range(3):
        history.undo()
    history.forget(stores[0])
    # What followed on the move in the other palette cannot be done without it; a third one's step can.
    assert history.redo_name == "other"
    history.redo()
    assert not history.can_redo
    assert stores[1].value == palette("b", 3)
    assert len(stores[2].value) == 1


def test_swatches_moved_out_of_a_closed_palette_stay_where_they_are(swatch, names) -> None:
    library, first = swatch.library, swatch.session.state.scope.palette
    second = library.add_palette(palette("b", 1))
    entry = library.palette(first).entry("red")
    library.edit(
        "Move",
        (first, edits.remove_entries(library.palette(first), ["red"])),
        (second, edits.add_entries(library.palette(second), [entry])),
    )
    swatch.session.show_scope(Scope(second))
    assert library.close(first)
    undo = swatch.window.command("undo")
    assert not undo.isEnabled()
    undo.trigger()
    assert "Red" in names(swatch)

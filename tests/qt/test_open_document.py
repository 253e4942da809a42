"""Edits, gestures and undo on plain values."""

from __future__ import annotations

from pathlib import Path

import pytest
from brdf_qt.documents.open_document import DocumentStore
from hypothesis import given
from hypothesis import strategies as st

pytestmark = pytest.mark.usefixtures("qapp")


def test_an_edit_is_undone_and_redone_by_its_name():
    store = DocumentStore(1)
    heard = []
    store.changed.connect(lambda old, new: heard.append((old, new)))
    assert store.set(2, "Double")
    assert (store.stack.undoText(), store.stack.redoText()) == ("Double", "")
    store.undo()
    assert (store.value, store.stack.redoText()) == (1, "Double")
    store.redo()
    assert heard == [(1, 2), (2, 1), (1, 2)]


def test_the_same_value_is_no_edit():
    store = DocumentStore(1)
    assert not store.set(1, "Nothing")
    assert store.stack.count() == 0
    assert store.is_clean


def test_a_drag_is_one_step():
    store = DocumentStore(0)
    store.set(1, "Before")
    store.begin_gesture("Drag")
    for value in range(2, 50):
        store.set(value, "ignored")
    store.end_gesture()
    store.set(99, "After")
    assert store.stack.count() == 3
    store.undo()
    assert store.stack.undoText() == "Drag"
    store.undo()
    assert store.value == 1


def test_two_drags_of_one_name_are_two_steps():
    store = DocumentStore(0)
    for value in (1, 2):
        store.begin_gesture("Drag")
        store.set(value, "")
        store.end_gesture()
    assert store.stack.count() == 2


def test_a_drag_that_comes_back_leaves_no_step():
    store = DocumentStore(5)
    store.begin_gesture("Drag")
    for value in (6, 7, 5):
        store.set(value, "")
    store.end_gesture()
    assert store.stack.count() == 0
    assert store.is_clean


def test_a_save_in_the_middle_of_a_drag_is_a_place_to_return_to(tmp_path: Path):
    store = DocumentStore(0)
    store.begin_gesture("Drag")
    store.set(1, "")
    store.mark_clean(tmp_path / "x")
    store.set(2, "")
    assert not store.is_clean
    store.undo()
    assert (store.value, store.is_clean) == (1, True)


def test_undo_ends_a_running_gesture():
    store = DocumentStore(0)
    store.begin_gesture("Drag")
    store.set(1, "")
    store.undo()
    store.set(2, "Typed")
    assert not store.in_gesture
    assert store.stack.undoText() == "Typed"


def test_a_recovered_document_is_unsaved_and_has_no_history():
    store = DocumentStore(0)
    store.set(1, "x")
    store.replace(7, None, clean=False)
    assert (store.value, store.is_clean, store.stack.count()) == (7, False, 0)
    store.replace(8, None)
    assert store.is_clean


@given(st.lists(st.tuples(st.integers(0, 5), st.sampled_from(["edit", "begin", "end"])), max_size=40))
def test_as_many_undos_as_steps_give_the_first_value(actions):
    store = DocumentStore(0)
    for value, action in actions:
        if action == "begin":
            store.begin_gesture("g")
        elif action == "end":
            store.end_gesture()
        store.set(value, "e")
    last, steps = store.value, store.stack.count()
    for _ in range(steps):
        store.undo()
    assert store.value == 0
    for _ in range(steps):
        store.redo()
    assert store.value == last

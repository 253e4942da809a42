"""One open document: its value, its undo history, its file, and whether it is saved.

Documents are frozen values. An edit is a pair of values on a :class:`QUndoStack`, and views hear
``changed(old, new)``. Between :meth:`DocumentStore.begin_gesture` and :meth:`~DocumentStore.end_gesture` all
edits merge into one step; a gesture that ends where it began leaves no step.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack
from shiboken6 import isValid

from brdf_qt.documents.stamp import FileStamp

T = TypeVar("T")
MOST_STEPS = 1000


class _Edit(QUndoCommand, Generic[T]):
    """From ``old`` to ``new``; edits of the same gesture merge."""

    def __init__(self, store: DocumentStore[T], old: T, new: T, name: str, gesture: int) -> None:
        super().__init__(name)
        self._store, self.old, self.new, self._gesture = store, old, new, gesture

    def id(self) -> int:
        return self._gesture

    def redo(self) -> None:
        self._store.amend(self.new)

    def undo(self) -> None:
        self._store.amend(self.old)

    def mergeWith(self, later: QUndoCommand) -> bool:
        assert isinstance(later, _Edit)
        self.new = later.new
        if self.new == self.old:
            self.setObsolete(True)
        return True


class DocumentStore(QObject, Generic[T]):
    """The open document of a program.

    Signals: ``changed(old, new)`` after every change of the value; ``replaced()`` where another document took
    its place; ``path_changed(path)`` with a Path or None; ``clean_changed(bool)``; ``history_changed()`` where
    Undo or Redo would do something else than before.
    """

    changed = Signal(object, object)
    replaced = Signal()
    path_changed = Signal(object)
    clean_changed = Signal(bool)
    history_changed = Signal()

    def __init__(self, value: T, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._value = value
        self.path: Path | None = None
        """The file of the document; ``None`` while it has none."""
        self.stamp: FileStamp | None = None
        """What the file held when this program read or wrote it last; ``None`` where that is not known."""
        self._gesture = 0
        self._gesture_name: str | None = None
        self._travelling = False
        self.stack = QUndoStack(self)
        self.stack.setUndoLimit(MOST_STEPS)
        stack = self.stack
        stack.cleanChanged.connect(self._on_clean_changed)
        # Of the five signals of a change this one comes first, when the others' values are already the new ones.
        stack.indexChanged.connect(self._on_history_changed)

    @property
    def value(self) -> T:
        return self._value

    @property
    def is_clean(self) -> bool:
        """Whether the value is the one last saved or opened."""
        return self.stack.isClean()

    @property
    def in_gesture(self) -> bool:
        return self._gesture_name is not None

    def set(self, value: T, name: str) -> bool:
        """Make ``value`` the document, undone as ``name``; False where it is the same already."""
        if value == self._value:
            return False
        step = (name, -1) if self._gesture_name is None else (self._gesture_name, self._gesture)
        self.stack.push(_Edit(self, self._value, value, *step))
        return True

    def amend(self, value: T) -> None:
        """Make ``value`` the document without a step of its own; Undo goes to where the last step began."""
        old, self._value = self._value, value
        if old != value and not self._travelling:
            self.changed.emit(old, value)

    def begin_gesture(self, name: str) -> None:
        """Merge the edits that follow into one step called ``name``; a gesture that runs is ended first."""
        self.end_gesture()
        self._gesture += 1
        self._gesture_name = name

    def end_gesture(self) -> None:
        """End the gesture; nothing where none runs."""
        self._gesture_name = None

    def undo(self) -> None:
        self.end_gesture()
        self.stack.undo()

    def redo(self) -> None:
        self.end_gesture()
        self.stack.redo()

    def states(self) -> tuple[tuple[str, T], ...]:
        """Return every state of the history, the oldest first: the step that led to it and its value.

        The first has no step (""). The present one is at place ``stack.index()``; those behind it are what Redo
        would bring back.
        """
        commands = [self.stack.command(place) for place in range(self.stack.count())]
        steps = [command for command in commands if isinstance(command, _Edit)]
        if not steps:
            return (("", self._value),)
        return (("", steps[0].old), *((step.actionText(), step.new) for step in steps))

    def go_to(self, place: int) -> None:
        """Undo or redo to place ``place`` of :meth:`states`; ``changed`` reports it once."""
        self.end_gesture()
        old = self._value
        self._travelling = True
        try:
            self.stack.setIndex(place)
        finally:
            self._travelling = False
        if old != self._value:
            self.changed.emit(old, self._value)

    def replace(
        self, value: T, path: Path | None, *, clean: bool = True, stamp: FileStamp | None = None
    ) -> None:
        """Open another document; ``clean=False`` for work that no file holds, as after a recovery.

        ``stamp`` is what the file at ``path`` held when it was read.
        """
        self.end_gesture()
        was_clean = self.is_clean
        self.stack.clear()
        # Clearing an empty stack leaves its clean state as it was.
        if clean:
            self.stack.setClean()
        else:
            self.stack.resetClean()
        self.amend(value)
        self.stamp = stamp
        self._set_path(path)
        self.replaced.emit()
        if was_clean != self.is_clean:
            self.clean_changed.emit(self.is_clean)

    def restore(
        self,
        states: Sequence[tuple[str, T]],
        place: int,
        path: Path | None,
        *,
        saved: int = -1,
        stamp: FileStamp | None = None,
    ) -> None:
        """Open a document with its history, as :meth:`states` gave it, at place ``place``.

        ``saved`` is the place of the state that the file at ``path`` holds; -1 where none of them is in a file.
        """
        self.end_gesture()
        was_clean = self.is_clean
        self._travelling = True
        try:
            self.stack.clear()
            self.stack.resetClean()
            self._value = states[0][1]
            for (_, old), (name, new) in pairwise(states):
                self.stack.push(_Edit(self, old, new, name, -1))
            if saved >= 0:
                self.stack.setIndex(saved)
                self.stack.setClean()
            self.stack.setIndex(place)
        finally:
            self._travelling = False
        self.stamp = stamp
        self._set_path(path)
        self.replaced.emit()
        if was_clean != self.is_clean:
            self.clean_changed.emit(self.is_clean)

    def mark_clean(self, path: Path, stamp: FileStamp | None = None) -> None:
        """Note that the value is now what file ``path`` holds, with its ``stamp``."""
        self.end_gesture()
        self.stamp = stamp
        self.stack.setClean()
        self._set_path(path)

    def _is_alive(self) -> bool:
        """Return false while Qt destroys the stack, which clears it with all its signals first."""
        return isValid(self) and isValid(self.stack)

    def _on_clean_changed(self, clean: bool) -> None:
        if self._is_alive():
            self.clean_changed.emit(clean)

    def _on_history_changed(self, *_: object) -> None:
        if self._is_alive():
            self.history_changed.emit()

    def _set_path(self, path: Path | None) -> None:
        if path != self.path:
            self.path = path
            self.path_changed.emit(path)

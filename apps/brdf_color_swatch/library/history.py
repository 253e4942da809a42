"""Undo over all open palettes in the order of the work: a move from one palette to another is one step of both.

Each palette keeps its own stack in its store, which knows what is saved; here is only kept whose turn it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from brdf_qt.documents.open_document import MOST_STEPS, DocumentStore
from PySide6.QtCore import QObject, Signal

from brdf_suite.documents.palette import Palette

Store = DocumentStore[Palette]


@dataclass(frozen=True, eq=False)
class Step:
    """One gesture: its name, and the stores that it changed."""

    name: str
    stores: tuple[Store, ...]


class History(QObject):
    """``changed()`` where Undo or Redo would do something else; ``travelled(step)`` after either, to show where."""

    changed = Signal()
    travelled = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._done: list[Step] = []
        self._undone: list[Step] = []

    def apply(self, name: str, edits: Sequence[tuple[Store, Palette]]) -> bool:
        """Make each value the document of its store, all of it one step; False where nothing changed."""
        changed = []
        for store, value in edits:
            store.end_gesture()
            if store.set(value, name):
                changed.append(store)
        if not changed:
            return False
        self._undone.clear()
        # No store has more steps than all of them together, so none of these has lost the step that it needs.
        self._done = [*self._done, Step(name, tuple(changed))][-MOST_STEPS:]
        self.changed.emit()
        return True

    @property
    def undo_name(self) -> str:
        """What Undo would take back; empty where there is nothing."""
        return self._done[-1].name if self._done else ""

    @property
    def redo_name(self) -> str:
        """What Redo would do again; empty where there is nothing."""
        return self._undone[-1].name if self._undone else ""

    @property
    def can_undo(self) -> bool:
        return bool(self._done)

    @property
    def can_redo(self) -> bool:
        return bool(self._undone)

    def undo(self) -> None:
        self._travel(self._done, self._undone, forth=False)

    def redo(self) -> None:
        self._travel(self._undone, self._done, forth=True)

    def forget(self, store: Store) -> None:
        """A palette is closed, or another file took its place: its steps cannot be travelled any more.

        A step that it shares with another palette goes whole: half of a move would take swatches out of the one and
        put them nowhere. What lies behind such a step in the other palette cannot be come to without it, and goes too.
        """
        for steps in (self._done, self._undone):
            gone = {store}
            kept = []
            for step in reversed(steps):
                if gone.isdisjoint(step.stores):
                    kept.append(step)
                else:
                    gone.update(step.stores)
            steps[:] = reversed(kept)
        self.changed.emit()

    def _travel(self, source: list[Step], target: list[Step], *, forth: bool) -> None:
        if not source:
            return
        step = source.pop()
        for store in step.stores:
            if forth:
                store.redo()
            else:
                store.undo()
        target.append(step)
        self.changed.emit()
        self.travelled.emit(step)

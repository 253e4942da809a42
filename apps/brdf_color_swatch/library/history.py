"""Undo over all open palettes in the order of the work: a move from one palette to another is one step of both.

Each palette keeps its own stack in its store, which knows what is saved; here is only kept whose turn it is. Every step
has a mark, so that the order can be restored from the histories of the single palettes.
"""

from __future__ import annotations

import time
from bisect import insort
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from brdf_qt.documents.open_document import MOST_STEPS, DocumentStore
from PySide6.QtCore import QObject, Signal

from brdf_suite.documents.palette import Palette

Store = DocumentStore[Palette]


class StepMark(NamedTuple):
    """Which step it is: a number that grows from step to step, also from run to run, and how many stores it changed."""

    serial: int
    stores: int


class StepMarks(NamedTuple):
    """The steps of one store: those that were done, the oldest first, and those that Redo would do, the next first."""

    done: tuple[StepMark, ...]
    undone: tuple[StepMark, ...]


@dataclass(frozen=True, eq=False)
class Step:
    """One gesture: its name, the stores that it changed, and its number."""

    name: str
    stores: tuple[Store, ...]
    serial: int


@dataclass(eq=False)
class _Left:
    """A step of an ended run, of which the stores come back one by one."""

    name: str
    mark: StepMark
    stores: list[Store] = field(default_factory=list)
    done: set[bool] = field(default_factory=set)
    """Whether it was done: both, where its stores do not agree."""
    taken: bool = False

    @property
    def is_whole(self) -> bool:
        return len(self.stores) == self.mark.stores and len(self.done) == 1


class History(QObject):
    """``changed()`` where Undo or Redo would do something else; ``travelled(step)`` after either, to show where."""

    changed = Signal()
    travelled = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._done: list[Step] = []
        self._undone: list[Step] = []
        self._left: dict[int, _Left] = {}
        self._serial = 0

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
        self._left = {serial: left for serial, left in self._left.items() if False not in left.done}
        # No store has more steps than all of them together, so none of these has lost the step that it needs.
        self._done = [*self._done, Step(name, tuple(changed), self._next())][-MOST_STEPS:]
        self.changed.emit()
        return True

    def _next(self) -> int:
        self._serial = max(self._serial + 1, time.time_ns())
        return self._serial

    def marks(self, store: Store) -> StepMarks:
        """Return the marks of the steps of one store."""

        def of(steps: Sequence[Step]) -> tuple[StepMark, ...]:
            return tuple(StepMark(one.serial, len(one.stores)) for one in steps if store in one.stores)

        return StepMarks(of(self._done), of(self._undone[::-1]))

    def adopt(self, store: Store, marks: Sequence[StepMark], place: int) -> None:
        """Take the steps of a store whose history was restored; ``place`` of them are done.

        A step that changed several palettes can be travelled once all of them are back, and what lies behind it too.
        """
        names = [name for name, _ in store.states()[1:]]
        for number, (name, mark) in enumerate(zip(names, marks, strict=True)):
            left = self._left.setdefault(mark.serial, _Left(name, mark))
            left.stores.append(store)
            left.done.add(number < place)
        edited = any(step.serial not in self._left for step in self._done)
        waiting = sorted(self._left.values(), key=lambda left: left.mark.serial)
        self._take([left for left in reversed(waiting) if True in left.done], self._done, 1)
        if not edited:
            self._take([left for left in waiting if False in left.done], self._undone, -1)
        self.changed.emit()

    def _take(self, waiting: Sequence[_Left], steps: list[Step], order: int) -> None:
        """Put steps in their places, from the present one on: nothing behind one that is not whole."""
        gone: set[Store] = set()
        for left in waiting:
            if not left.is_whole or not gone.isdisjoint(left.stores):
                gone.update(left.stores)
            elif not left.taken:
                left.taken = True
                step = Step(left.name, tuple(left.stores), left.mark.serial)
                insort(steps, step, key=lambda one: order * one.serial)

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
        for left in self._left.values():
            if store in left.stores:
                left.stores.remove(store)
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

"""The library: palettes, each with its store, autosave and watch, and one history over all of them.

Nothing here is a widget. An item of the library is a file that may not be read yet, or a palette that has no file yet.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from brdf_qt.documents.files import DocumentFiles, DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.stamp import FileStamp, stamp_of
from brdf_qt.documents.watch import FileWatch
from brdf_qt.program.settings import settings
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_color_swatch.export.dialog import QtExportDialogs
from brdf_color_swatch.grid.rows import Rows, finish_rows, rows_of
from brdf_color_swatch.library.autosave import KeptPalette, PaletteRecovery
from brdf_color_swatch.library.history import History, Step
from brdf_suite.documents.palette import Palette
from brdf_suite.regular_files import is_file

State = Literal["closed", "reading", "open", "wrong"]


@dataclass(eq=False)
class OpenPalette:
    """A palette in memory. ``base`` is what its file held when it was read or written last, for a merge."""

    store: DocumentStore[Palette]
    files: DocumentFiles[Palette]
    recovery: PaletteRecovery
    watch: FileWatch
    rows: Rows
    base: Palette
    origin: Path | None = None
    """The foreign file that it was imported from; it has none of its own then."""


@dataclass(eq=False)
class Item:
    """One line of the library. ``key`` is its own for the run of the program."""

    key: str
    path: Path | None
    name: str
    state: State = "closed"
    problem: str = ""
    palette: OpenPalette | None = None
    read_only: bool = False
    """Whether it comes with the suite: it is shown, copied from and saved under a name, and not changed."""
    waiting: list[Callable[[], None]] = field(default_factory=list)

    def run_waiting(self) -> None:
        """Call those that wait for the palette."""
        waiting, self.waiting = self.waiting, []
        for then in waiting:
            then()

    @property
    def title(self) -> str:
        """The palette's name once it is known, and until then the file's."""
        return self.palette.store.value.name if self.palette is not None else self.name

    @property
    def is_clean(self) -> bool:
        """Whether all of it is in a file."""
        return self.palette is None or self.palette.store.is_clean


KEY = "library"


class Library(QObject):
    """The palettes of the library: holds, changes, saves and closes them.

    Signals:

    - ``items_changed()``: a palette came, went, or has another title or state.
    - ``read(key)``: a palette was read from its file.
    - ``palette_changed(key)``: what a palette holds is something else now; its rows are there.
    - ``message(Message)``, ``settled(str)``: a message for the user; the key of a message that no longer holds.
    - ``changed_outside(key)``: the file of an open palette holds something that neither this program wrote nor
      read.
    - ``profile_requested(key)``: the user wants to choose an ICC profile for the CMYK colours of a palette.
    """

    items_changed = Signal()
    read = Signal(str)
    palette_changed = Signal(str)
    message = Signal(Message)
    settled = Signal(str)
    changed_outside = Signal(str)
    profile_requested = Signal(str)

    def __init__(
        self,
        form: DocumentFormat[Palette],
        dialogs: QtExportDialogs,
        autosave_failed: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._format, self.dialogs, self._autosave_failed = form, dialogs, autosave_failed
        self.history = History(self)
        self.tasks = TaskRunner(self)
        self._numbers = itertools.count(1)
        self._items: dict[str, Item] = {}

    @property
    def items(self) -> tuple[Item, ...]:
        return tuple(self._items.values())

    def item(self, key: str) -> Item | None:
        return self._items.get(key)

    def palette(self, key: str) -> Palette | None:
        """Return what a palette holds now; ``None`` where it is not read."""
        item = self._items.get(key)
        return item.palette.store.value if item is not None and item.palette is not None else None

    def is_read_only(self, key: str) -> bool:
        item = self._items.get(key)
        return item is not None and item.read_only

    def rows(self, key: str) -> Rows:
        """Return the rows of a palette; none where it is not read."""
        item = self._items.get(key)
        return item.palette.rows if item is not None and item.palette is not None else Rows.empty()

    def add_path(self, path: Path) -> str:
        """Put a file into the library, unread; return its key, also where it was there already."""
        path = path.absolute()
        for item in self.items:
            origin = item.palette.origin if item.palette is not None else None
            if path in (item.path, origin):
                return item.key
        item = self.add_item(path, path.stem)
        self.items_changed.emit()
        self.remember()
        return item.key

    def add_item(self, path: Path | None, name: str) -> Item:
        """Put a line without a palette into the library, and return it."""
        item = Item(f"p{next(self._numbers)}", path, name)
        self._items[item.key] = item
        return item

    def remove_item(self, key: str) -> None:
        """Remove a line without asking; its autosave stays."""
        opened = self._items.pop(key).palette
        if opened is not None:
            # They live as long as the library otherwise, with every state of the history.
            for part in (opened.watch, opened.recovery, opened.files, opened.store):
                part.deleteLater()
        self.items_changed.emit()

    def add_palette(
        self,
        palette: Palette,
        path: Path | None = None,
        *,
        clean: bool = True,
        stamp: FileStamp | None = None,
        rows: Rows | None = None,
        read_only: bool = False,
    ) -> str:
        """Put a palette that is in memory into the library, and return its key."""
        item = self.add_item(path, palette.name)
        item.read_only = read_only
        self.fill(item, palette, path, clean=clean, stamp=stamp, rows=rows)
        return item.key

    def fill(
        self,
        item: Item,
        palette: Palette,
        path: Path | None,
        *,
        clean: bool,
        stamp: FileStamp | None,
        rows: Rows | None = None,
        origin: Path | None = None,
    ) -> None:
        """Give a line of the library its palette: store, autosave, watch and rows."""
        store: DocumentStore[Palette] = DocumentStore(palette, self)
        store.replace(palette, path, clean=clean, stamp=stamp)
        files = DocumentFiles(store, self._format, self.dialogs, self)
        watch = FileWatch(self)
        opened = OpenPalette(
            store, files, self.recovery_of(store), watch, rows or rows_of(palette.entries), palette, origin
        )
        item.palette, item.path, item.state = opened, path, "open"
        files.failed.connect(self.message)
        files.succeeded.connect(lambda what: self._done(item, what))
        store.changed.connect(lambda _old, new: self._changed(item, new))
        store.clean_changed.connect(lambda _clean: self.items_changed.emit())
        store.path_changed.connect(lambda new: self._moved(item, new))
        watch.changed.connect(lambda _path: self._on_file_changed(item))
        watch.watch("" if path is None else str(path), stamp)
        self.items_changed.emit()
        self.palette_changed.emit(item.key)
        self._finish_rows(item)
        self.remember()

    def _on_file_changed(self, item: Item) -> None:
        opened = item.palette
        if opened is None or opened.store.path is None:
            return
        now, known = stamp_of(opened.store.path), opened.store.stamp
        if now is not None and (known is None or not known.same_content(now)):
            self.changed_outside.emit(item.key)

    def restore_history(
        self, item: Item, kept: KeptPalette, path: Path | None, stamp: FileStamp | None
    ) -> None:
        """Give an open palette the history of an ended run, and the state that it ends at."""
        opened, history = item.palette, kept.history
        if opened is None:
            return
        before = opened.store.value
        opened.store.restore(history.states, history.place, path, saved=history.saved, stamp=stamp)
        if history.saved >= 0:
            opened.base = history.states[history.saved][1]
        self.history.adopt(opened.store, kept.marks, history.place)
        if opened.store.value != before:
            self._changed(item, opened.store.value)

    def recovery_of(self, store: DocumentStore[Palette]) -> PaletteRecovery:
        """Return a new autosave of a store."""
        recovery = PaletteRecovery(
            store, self._format, self._autosave_failed, self.tasks, self, marks=self.history.marks
        )
        recovery.written_again.connect(lambda: self.settled.emit("autosave"))
        return recovery

    def empty_store(self) -> DocumentStore[Palette]:
        return DocumentStore(self._format.new(), self)

    def _any_files(self) -> DocumentFiles[Palette]:
        """Return the file dialogs of any palette, for questions that belong to none."""
        files = (item.palette.files for item in self.items if item.palette is not None)
        return next(files, None) or self._files_of_none

    @cached_property
    def _files_of_none(self) -> DocumentFiles[Palette]:
        return DocumentFiles(self.empty_store(), self._format, self.dialogs, self)

    def edit(self, name: str, *edits: tuple[str, Palette]) -> bool:
        """Make each palette another, all of it one step called ``name``; False where nothing changed."""
        pairs = [
            (item.palette.store, value)
            for key, value in edits
            if (item := self._items.get(key)) is not None and item.palette is not None
        ]
        return self.history.apply(name, pairs)

    def keys_of(self, step: Step) -> list[str]:
        """Return the palettes that a step changed."""
        return [i.key for i in self.items if i.palette is not None and i.palette.store in step.stores]

    def _changed(self, item: Item, palette: Palette) -> None:
        assert item.palette is not None
        item.palette.rows = rows_of(palette.entries, item.palette.rows)
        self.palette_changed.emit(item.key)
        self.items_changed.emit()
        self._finish_rows(item)

    def _finish_rows(self, item: Item) -> None:
        """Work out in the background what no instrument has read."""
        assert item.palette is not None
        rows = item.palette.rows
        if rows.columns.waiting.any():
            self.tasks.submit(
                f"columns {item.key}", finish_rows, rows, lambda more: self._take_rows(item, rows, more),
                lambda error: self.message.emit(message_of(error, "columns")),
            )  # fmt: skip

    def _take_rows(self, item: Item, before: Rows, rows: Rows) -> None:
        if item.palette is not None and item.palette.rows is before:
            item.palette.rows = rows
            self.palette_changed.emit(item.key)

    def _done(self, item: Item, what: str) -> None:
        assert item.palette is not None
        if what == "save":
            item.palette.base = item.palette.store.value
            item.palette.watch.watch(str(item.palette.store.path))
            self.settled.emit(f"outside {item.key}")
        self.settled.emit(what)

    def _moved(self, item: Item, path: Path | None) -> None:
        item.path = path
        if item.palette is not None:
            item.palette.watch.watch("" if path is None else str(path))
            if path is not None:
                # It is in a file of its own now; the one that it was imported from is another palette again.
                item.palette.origin = None
                item.read_only = False
        self.remember()
        self.items_changed.emit()

    def remember(self) -> None:
        """Note which files the library has, for the next start."""
        paths = [
            item.path or (item.palette.origin if item.palette is not None else None) for item in self.items
        ]
        settings().setValue(KEY, [str(path) for path in paths if path is not None])

    def remember_file(self, path: Path) -> None:
        self._any_files().remember(path)

    def recent(self) -> list[Path]:
        return self._any_files().recent()

    def fails(self, error: Exception, key: str, todo: str = "") -> None:
        self.message.emit(message_of(error, key, todo=todo))

    def save(self, key: str) -> bool:
        """Save a palette, asking for a file where it has none; True where it is saved."""
        item = self._items.get(key)
        return item is not None and item.palette is not None and item.palette.files.save()

    def save_as(self, key: str) -> bool:
        """Ask for a file and save a palette there; True where it is saved."""
        item = self._items.get(key)
        return item is not None and item.palette is not None and item.palette.files.save_as()

    def save_to(self, key: str, path: Path) -> bool:
        """Save a palette to a file; True where it is saved."""
        item = self._items.get(key)
        return item is not None and item.palette is not None and item.palette.files.save_to(path)

    def close(self, key: str) -> bool:
        """Ask about unsaved work, and take a palette out of the library; its file stays. True where it went."""
        item = self._items.get(key)
        if item is None:
            return False
        if item.palette is not None:
            if not item.palette.files.may_discard():
                return False
            item.palette.recovery.close(keep=False)
            item.palette.watch.watch("")
            self.history.forget(item.palette.store)
        for task in ("read", "again", "merge", "columns"):
            self.tasks.cancel(f"{task} {key}")
        self.remove_item(key)
        for topic in ("open", "outside"):
            # Messages about a closed palette are dismissed.
            self.settled.emit(f"{topic} {key}")
        self.remember()
        return True

    def may_close_all(self) -> bool:
        """Ask about every palette with unsaved work; True where all may go, and their autosaves with them."""
        opened = [item.palette for item in self.items if item.palette is not None]
        if not all(palette.files.may_discard() for palette in opened):
            return False
        for palette in opened:
            palette.recovery.close(keep=False)
        return True

    def keep_unsaved(self) -> None:
        """Write unsaved work for the next start, and end the threads; for a program that has to quit."""
        for item in self.items:
            if item.palette is not None:
                item.palette.recovery.close(keep=True)
        self.tasks.stop()

    def restore(self) -> None:
        """Put the files of the last run into the library, unread; those that are gone are left out."""
        found: Any = settings().value(KEY, [])
        names = [found] if isinstance(found, str) else list(found or [])
        for path in map(Path, names):
            if is_file(path):
                self.add_path(path)

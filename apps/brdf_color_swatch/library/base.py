"""What the library holds: palettes, each with its store, autosave and watch, and one history over all of them.

Nothing here is a widget. An item of the library is a file that may not be read yet, or a palette that has no file yet.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path

from brdf_qt.documents.files import DocumentFiles, DocumentFormat
from brdf_qt.documents.recovery import Recovery
from brdf_qt.documents.stamp import FileStamp
from brdf_qt.documents.store import DocumentStore
from brdf_qt.documents.watch import FileWatch
from brdf_qt.program.settings import settings
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_color_swatch.export.dialog import ExportDialogs
from brdf_color_swatch.grid.columns import finish_rows, rows_of
from brdf_color_swatch.grid.rows import Rows
from brdf_color_swatch.library.autosave import PaletteRecovery
from brdf_color_swatch.library.history import History, Step
from brdf_color_swatch.library.item import Item, OpenPalette
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import SuiteError

KEY = "library"


class LibraryBase(QObject):
    """Holds palettes and changes them.

    Signals
    -------
    items_changed()
        A palette came, went, or has another title or state.
    palette_changed(key)
        What a palette holds is something else now; its rows are there.
    message(Message), settled(str)
        A message for the user; the key of a message that no longer holds.
    changed_outside(key)
        The file of an open palette holds something that neither this program wrote nor read.
    """

    items_changed = Signal()
    palette_changed = Signal(str)
    message = Signal(Message)
    settled = Signal(str)
    changed_outside = Signal(str)

    def __init__(
        self,
        form: DocumentFormat[Palette],
        dialogs: ExportDialogs,
        autosave_failed: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._format, self.dialogs, self._autosave_failed = form, dialogs, autosave_failed
        self.history = History(self)
        self.tasks = TaskRunner(self)
        self._numbers = itertools.count(1)
        self._items: dict[str, Item] = {}
        # Finds what earlier runs left, and never writes: its document is always clean.
        self._finder = self._recovery(DocumentStore(form.new(), self))

    # What there is.

    @property
    def items(self) -> tuple[Item, ...]:
        """The palettes in the library's order."""
        return tuple(self._items.values())

    def item(self, key: str) -> Item | None:
        """Return the item of a key; ``None`` where it is gone."""
        return self._items.get(key)

    def palette(self, key: str) -> Palette | None:
        """Return what a palette holds now; ``None`` where it is not read."""
        item = self._items.get(key)
        return item.palette.store.value if item is not None and item.palette is not None else None

    def rows(self, key: str) -> Rows:
        """Return the rows of a palette; none where it is not read."""
        item = self._items.get(key)
        return item.palette.rows if item is not None and item.palette is not None else Rows.empty()

    def open_keys(self) -> list[str]:
        """Return the keys of what is read."""
        return [item.key for item in self.items if item.palette is not None]

    def key_of_store(self, store: DocumentStore[Palette]) -> str | None:
        """Return the key of the palette that a store holds."""
        return next((i.key for i in self.items if i.palette is not None and i.palette.store is store), None)

    def add_path(self, path: Path) -> str:
        """Put a file into the library, unread; return its key, also where it was there already."""
        path = path.absolute()
        for item in self.items:
            origin = item.palette.origin if item.palette is not None else None
            if path in (item.path, origin):
                return item.key
        item = Item(f"p{next(self._numbers)}", path, path.stem)
        self._items[item.key] = item
        self.items_changed.emit()
        self.remember()
        return item.key

    def add_palette(
        self,
        palette: Palette,
        path: Path | None = None,
        *,
        clean: bool = True,
        stamp: FileStamp | None = None,
        rows: Rows | None = None,
    ) -> str:
        """Put a palette that is in memory into the library, and return its key."""
        item = Item(f"p{next(self._numbers)}", path, palette.name)
        self._items[item.key] = item
        self._fill(item, palette, path, clean=clean, stamp=stamp, rows=rows)
        return item.key

    def _fill(
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
        store: DocumentStore[Palette] = DocumentStore(palette, self)
        store.replace(palette, path, clean=clean, stamp=stamp)
        files = DocumentFiles(store, self._format, self.dialogs, self)
        watch = FileWatch(self)
        opened = OpenPalette(
            store, files, self._recovery(store), watch, rows or rows_of(palette.entries), palette, origin
        )
        item.palette, item.path, item.state = opened, path, "open"
        files.failed.connect(self.message)
        files.succeeded.connect(lambda what: self._done(item, what))
        store.changed.connect(lambda _old, new: self._changed(item, new))
        store.clean_changed.connect(lambda _clean: self.items_changed.emit())
        store.path_changed.connect(lambda new: self._moved(item, new))
        watch.changed.connect(lambda _path: self._on_file_changed(item))
        watch.watch("" if path is None else str(path))
        self.items_changed.emit()
        self.palette_changed.emit(item.key)
        self._finish_rows(item)
        self.remember()

    def _on_file_changed(self, item: Item) -> None:
        """Another program has written the file of a palette."""

    def _recovery(self, store: DocumentStore[Palette]) -> Recovery[Palette]:
        recovery = PaletteRecovery(store, self._format, self._autosave_failed, self.tasks, self)
        recovery.written_again.connect(lambda: self.settled.emit("autosave"))
        return recovery

    def _any_files(self) -> DocumentFiles[Palette]:
        """The file work of any palette: questions that belong to none."""
        for item in self.items:
            if item.palette is not None:
                return item.palette.files
        return DocumentFiles(DocumentStore(self._format.new(), self), self._format, self.dialogs, self)

    # Changes.

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
        return [key for store in step.stores if (key := self.key_of_store(store)) is not None]

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
        self.remember()
        self.items_changed.emit()

    def remember(self) -> None:
        """Note which files the library has, for the next start."""
        paths = [
            item.path or (item.palette.origin if item.palette is not None else None) for item in self.items
        ]
        settings().setValue(KEY, [str(path) for path in paths if path is not None])

    def recent(self) -> list[Path]:
        """Return the files opened or saved last."""
        return self._any_files().recent()

    def fails(self, error: SuiteError, key: str, todo: str = "") -> None:
        """Report an error to the user."""
        self.message.emit(message_of(error, key, todo=todo))

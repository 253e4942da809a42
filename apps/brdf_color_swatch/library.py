"""The library: palettes by their files, read when they are first wanted, each with store, history, autosave and watch.

Nothing here is a widget. An item of the library is a file that may not be read yet, or a palette that has no file yet.
"""

from __future__ import annotations

import gc
import itertools
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from brdf_qt.dialogs import Dialogs
from brdf_qt.document_files import DocumentFiles, DocumentFormat
from brdf_qt.document_store import DocumentStore
from brdf_qt.file_stamp import FileStamp, stamp_of
from brdf_qt.file_watch import FileWatch
from brdf_qt.message_bar import Message, message_of
from brdf_qt.recovery import Recovered, Recovery
from brdf_qt.settings import settings
from brdf_qt.tasks import TaskRunner
from brdf_qt.translation import tr
from PySide6.QtCore import QObject, Signal

from brdf_color_swatch.autosave import PaletteRecovery
from brdf_color_swatch.columns import finished_rows, rows_of
from brdf_color_swatch.history import History, Step
from brdf_color_swatch.reading import Read, read_palette_file
from brdf_color_swatch.rows import Rows
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import SuiteError

State = Literal["closed", "reading", "open", "wrong"]
_KEY = "library"
_MANY = 1000


@dataclass(eq=False)
class OpenPalette:
    """A palette in memory. ``base`` is what its file held when it was read or written last, for a merge."""

    store: DocumentStore[Palette]
    files: DocumentFiles[Palette]
    recovery: Recovery[Palette]
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
    waiting: list[Callable[[], None]] = field(default_factory=list)

    @property
    def title(self) -> str:
        """The palette's name once it is known, and until then the file's."""
        return self.palette.store.value.name if self.palette is not None else self.name

    @property
    def is_clean(self) -> bool:
        """Whether all of it is in a file."""
        return self.palette is None or self.palette.store.is_clean


class Library(QObject):
    """Opens, keeps and closes palettes.

    Signals
    -------
    items_changed()
        A palette came, went, or has another title or state.
    palette_changed(key)
        What a palette holds is something else now; its rows are there.
    message(Message), settled(str)
        Something to tell the user; the key of what was told is no longer so.
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
        dialogs: Dialogs,
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

    # Coming in.

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

    def recover(self, found: Recovered[Palette]) -> str:
        """Open unsaved work of a run that was ended."""
        item = next((i for i in self.items if found.path is not None and i.path == found.path), None)
        if item is None:
            item = Item(f"p{next(self._numbers)}", found.path, found.value.name)
            self._items[item.key] = item
        if item.palette is None:
            self._fill(item, found.value, found.path, clean=False, stamp=found.stamp)
            assert item.palette is not None
            if item.palette.recovery.write():
                item.palette.recovery.drop(found)
        else:
            # It is open, and perhaps changed: the recovered one comes as a step that can be undone.
            self.history.apply(tr("Recover unsaved work"), [(item.palette.store, found.value)])
            item.palette.recovery.drop(found)
        return item.key

    def unsaved_work(self) -> list[Recovered[Palette]]:
        """Return what ended runs left, newest first."""
        return self._finder.found()

    def drop_recovered(self, found: Recovered[Palette]) -> None:
        """Give unsaved work of an earlier run up."""
        self._finder.drop(found)

    def ask_open(self, path: Path | None = None) -> str | None:
        """Open ``path``, or ask for a file; return its key. It is read in the background."""
        if path is None:
            from brdf_color_swatch.export_part import open_filters

            recent = self.recent()
            folder = recent[0].parent if recent else Path.home()
            path = self.dialogs.open_path(folder, open_filters())
            if path is None:
                return None
        key = self.add_path(path)
        self.want(key)
        return key

    def want(self, key: str, then: Callable[[], None] | None = None) -> None:
        """Read a palette where it is not read yet, and call ``then`` once it is there."""
        item = self._items[key]
        if item.palette is not None:
            if then is not None:
                then()
            return
        if then is not None:
            item.waiting.append(then)
        if item.state == "reading" or item.path is None:
            return
        item.state, item.problem = "reading", ""
        self.items_changed.emit()
        self.tasks.submit(
            f"read {key}",
            read_palette_file,
            item.path,
            lambda read: self._arrived(key, read),
            lambda error: self._not_read(key, error),
        )

    def cancel_reading(self, key: str) -> None:
        """Leave a palette unread after all."""
        self.tasks.cancel(f"read {key}")
        item = self._items.get(key)
        if item is not None and item.state == "reading":
            item.state = "closed"
            item.waiting.clear()
            self.items_changed.emit()

    def _arrived(self, key: str, read: Read) -> None:
        item = self._items.get(key)
        if item is None:
            return
        path, stamp = (read.path, read.stamp) if read.is_ours else (None, None)
        # What was imported is in its own file still: nothing would be lost with it until it is changed.
        origin = None if read.is_ours else read.path
        self._fill(item, read.palette, path, clean=True, stamp=stamp, rows=read.rows, origin=origin)
        if len(read.palette) >= _MANY:
            # They live long and are in no cycle: a collection that looks through all of them would hold up a scroll.
            gc.freeze()
        self._any_files().remember(read.path)
        self.settled.emit(f"open {key}")
        if read.notices:
            self.message.emit(
                Message(
                    f"open {key}",
                    tr("“{name}” was read; {count} things to know about it.").format(
                        name=read.path.name, count=len(read.notices)
                    ),
                    todo="\n".join(read.notices[:6]) + ("\n…" if len(read.notices) > 6 else ""),
                )
            )
        waiting, item.waiting = item.waiting, []
        for then in waiting:
            then()

    def _not_read(self, key: str, error: Exception) -> None:
        item = self._items.get(key)
        if item is None:
            return
        item.state, item.problem = "wrong", str(error)
        item.waiting.clear()
        self.items_changed.emit()
        todo = tr("The library keeps its place; nothing else has changed.")
        self.message.emit(message_of(error, f"open {key}", todo=todo))

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
        watch.changed.connect(lambda _path: self._noticed(item))
        watch.watch("" if path is None else str(path))
        self.items_changed.emit()
        self.palette_changed.emit(item.key)
        self._finish_rows(item)
        self.remember()

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
                f"columns {item.key}", finished_rows, rows, lambda more: self._take_rows(item, rows, more),
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
        self.remember()
        self.items_changed.emit()

    # The file, and who else writes it.

    def _noticed(self, item: Item) -> None:
        opened = item.palette
        if opened is None or opened.store.path is None:
            return
        now, known = stamp_of(opened.store.path), opened.store.stamp
        if now is not None and (known is None or not known.same_content(now)):
            self.changed_outside.emit(item.key)

    def read_again(self, key: str, then: Callable[[Read], None]) -> None:
        """Read the file of an open palette once more, in the background."""
        item = self._items[key]
        assert item.palette is not None
        assert item.palette.store.path is not None
        self.tasks.submit(
            f"again {key}",
            read_palette_file,
            item.palette.store.path,
            then,
            lambda error: self.message.emit(
                message_of(error, f"outside {key}", todo=tr("The palette that is open is unchanged."))
            ),
        )

    def take_outside(self, key: str, value: Palette, read: Read, name: str) -> None:
        """Take what the file holds now, or what it was merged to, as one step; it is no longer asked about."""
        item = self._items[key]
        assert item.palette is not None
        opened = item.palette
        self.history.apply(name, [(opened.store, value)])
        if value == read.palette:
            opened.store.mark_clean(read.path, read.stamp)
        else:
            opened.store.note_stamp(read.stamp)
        opened.base = read.palette
        self.settled.emit(f"outside {key}")
        self.items_changed.emit()

    # Saving and closing.

    def save(self, key: str) -> bool:
        """Save a palette, asking for a file where it has none; True where it is saved."""
        item = self._items.get(key)
        return item is not None and item.palette is not None and item.palette.files.save()

    def save_as(self, key: str) -> bool:
        """Ask for a file and save a palette there; True where it is saved."""
        item = self._items.get(key)
        return item is not None and item.palette is not None and item.palette.files.save_as()

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
        self.tasks.cancel(f"read {key}")
        del self._items[key]
        self.items_changed.emit()
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
        """Write unsaved work for the next start, and end the threads; for a program that is told to end."""
        for item in self.items:
            if item.palette is not None:
                item.palette.recovery.close(keep=True)
        self._finder.close(keep=False)
        self.tasks.stop()

    # What is remembered.

    def remember(self) -> None:
        """Note which files the library has, for the next start."""
        paths = [
            item.path or (item.palette.origin if item.palette is not None else None) for item in self.items
        ]
        settings().setValue(_KEY, [str(path) for path in paths if path is not None])

    def restore(self) -> None:
        """Put the files of the last run into the library, unread; those that are gone are left out."""
        found: Any = settings().value(_KEY, [])
        names = [found] if isinstance(found, str) else list(found or [])
        self.add_files(Path(name) for name in names)

    def add_files(self, paths: Iterable[Path]) -> list[str]:
        """Put files into the library, unread; return the keys of those that are there."""
        return [self.add_path(path) for path in paths if path.is_file()]

    def recent(self) -> list[Path]:
        """Return the files opened or saved last."""
        return self._any_files().recent()

    def fails(self, error: SuiteError, key: str, todo: str = "") -> None:
        """Tell the user of an error."""
        self.message.emit(message_of(error, key, todo=todo))

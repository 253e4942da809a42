"""The paints that are open, in the order of their tabs; one of them is in front.

Each has its own store, undo history, file and autosave. There is always one: where the last is closed, an empty
one comes in its place.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from brdf_qt.documents.file_reading import FileReading
from brdf_qt.documents.files import DocumentFiles, DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.open_tabs import OpenTab, TabsLeft, TabsRecord
from brdf_qt.documents.recovery import Recovered, Recovery
from brdf_qt.documents.stamp import FileStamp
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import QObject, Signal

from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress
from brdf_suite.regular_files import is_file

Opener = Callable[[], None]
"""Shows what was read of a file; called on the thread of the window."""
FindOpener = Callable[[Path], Opener | None]
"""Reads a file that is no paint of Designer's; ``None`` where it is one, or an error that opening it reports.

Raises :class:`SuiteError` where it is damaged.
"""
_Files = dict[Path, "tuple[Paint, FileStamp | None] | SuiteError"]
"""What files hold, or why they cannot be read."""
MOST_CLOSED = 20
"""Closed tabs that can be reopened, each with its undo history."""


@dataclass(eq=False)
class OpenDocument:
    """One open paint. ``key`` is its own for the run of the program, also after it was reopened.

    ``original`` is the paint as opened; ``pristine``: the program began with it, and the user did not ask for it;
    ``beside`` what was kept beside it, where it was recovered, and ``autosave`` the name of the file that it came
    from then.
    """

    key: int
    store: DocumentStore[Paint]
    files: DocumentFiles[Paint]
    recovery: Recovery[Paint]
    original: Paint
    pristine: bool = False
    beside: Any = None
    autosave: str = ""

    @property
    def title(self) -> str:
        """The name of its file, or of the paint while it has none."""
        return self.files.title()

    @property
    def is_untouched(self) -> bool:
        """Whether it was never changed, and is in no file."""
        return self.store.is_clean and self.store.path is None and not self.store.stack.count()


class Documents(QObject):
    """Opens, closes, orders and finds the open paints.

    Signals
    -------
    opened(document), closed(document)
        An :class:`OpenDocument` came into the row, or left it.
    front_changed()
        Another document is in front.
    row_changed()
        The order, a title or a mark of unsaved work is another.
    failed(Message), succeeded(str), recent_changed()
        As :class:`DocumentFiles` has them, of every document.
    """

    opened = Signal(object)
    closed = Signal(object)
    front_changed = Signal()
    row_changed = Signal()
    failed = Signal(Message)
    succeeded = Signal(str)
    recent_changed = Signal()

    def __init__(
        self,
        first: Paint,
        form: DocumentFormat[Paint],
        dialogs: QtDialogs,
        reading: FileReading,
        autosave_failed: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._format, self._autosave_failed = form, autosave_failed
        self.dialogs = dialogs
        """Asks the user for files."""
        self.reading = reading
        """Reads them on a thread."""
        self.find_opener: FindOpener = lambda _path: None
        """Called first with every file to be opened, on a thread."""
        self._last_key = 0
        self._closed: list[OpenDocument] = []
        self._front = self._made(DocumentStore(first, self), pristine=True)
        self._row = [self._front]
        self.record = TabsRecord(self._open_tabs, self)
        """Which tabs are open, for the start after a kill."""
        for signal in (self.row_changed, self.front_changed):
            signal.connect(self.record.note)

    @property
    def row(self) -> tuple[OpenDocument, ...]:
        """The documents in the order of their tabs."""
        return tuple(self._row)

    @property
    def front(self) -> OpenDocument:
        """The document that is shown."""
        return self._front

    @property
    def can_reopen(self) -> bool:
        """Whether a closed tab can be reopened."""
        return bool(self._closed)

    # Opening.

    def new(self) -> None:
        """Open an empty paint."""
        self.add(self._format.new())

    def open(self, path: Path | None = None) -> None:
        """Open ``path``, or ask for one, read on a thread; a file that is open comes to the front."""
        files = self._front.files
        if path is None:
            path = files.ask_open_path()
            if path is None:
                return
        present = self.with_path(path)
        if present is not None:
            self.show(present)
            return
        asked = path

        def read(path: Path, progress: Progress) -> Opener:
            progress(0.0, path.name)
            opener = self.find_opener(path)
            if opener is not None:
                return opener
            progress(0.5, path.name)
            return partial(self._take, path.absolute(), *files.read(path))

        self.reading.begin(
            asked, read, lambda opener: opener(), lambda error: files.report_unread(asked, error)
        )

    def _take(self, path: Path, value: Paint, stamp: FileStamp | None) -> None:
        """Show what a file holds, in a tab of its own unless it was opened meanwhile."""
        present = self.with_path(path)
        if present is not None:
            self.show(present)
            return
        self.add(value, path, stamp=stamp)
        self._front.files.remember(path)
        self.succeeded.emit("open")

    def ask(self, named: str) -> Path | None:
        """Ask for a file, beside that of the paint in front; ``named`` is the filter of the kinds that fit."""
        present = self._front.store.path
        filters = ";;".join((named, tr("All files (*)")))
        return self.dialogs.open_path(present.parent if present is not None else Path.home(), filters)

    def add(
        self,
        paint: Paint,
        path: Path | None = None,
        *,
        clean: bool = True,
        stamp: FileStamp | None = None,
    ) -> OpenDocument:
        """Open a paint beside the others, and in front; ``clean=False`` for work that no file holds."""
        document = self._made(DocumentStore(paint, self))
        document.store.replace(paint, path, clean=clean, stamp=stamp)
        self._insert(document)
        return document

    def recover(self, item: Recovered[Paint]) -> OpenDocument:
        """Open unsaved work of a run that was ended."""
        document = self._made(DocumentStore(item.value, self))
        document.beside, document.autosave = item.beside, item.file.name
        document.recovery.take(item)
        self._insert(document)
        return document

    def restore_tabs(self, left: TabsLeft) -> None:
        """Bring the tabs of a run that was ended back, in their order; the unsaved ones are recovered before.

        Saved ones are read from their files on a thread; what is gone is left out, and what was open besides stays at
        the right.
        """
        paths = [tab.path for tab in left.tabs if tab.path is not None and self.with_path(tab.path) is None]
        files = self._front.files

        def read(_first: Path, progress: Progress) -> _Files:
            found: _Files = {}
            for place, path in enumerate(paths):
                progress(place / len(paths), path.name)
                if is_file(path):
                    try:
                        found[path] = files.read(path)
                    except SuiteError as error:
                        found[path] = error
            return found

        if paths:
            self.reading.begin(
                paths[0],
                read,
                partial(self._restore, left),
                lambda error: files.report_unread(paths[0], error),
            )
        else:
            self._restore(left, {})

    def _restore(self, left: TabsLeft, files: _Files) -> None:
        found: list[OpenDocument] = []
        front = self._front
        for place, tab in enumerate(left.tabs):
            document = next((one for one in self._row if one.autosave == tab.autosave != ""), None)
            if document is None:
                document = self._restored(tab, files)
            if document is not None and document not in found:
                found.append(document)
                if place == left.front:
                    front = document
        self._row = [*found, *(one for one in self._row if one not in found)]
        self.drop_tabs(left)
        self.row_changed.emit()
        if front in self._row:
            self.show(front)

    def drop_tabs(self, left: TabsLeft) -> None:
        """Give the tabs of a run that was ended up, and the histories that were kept for them."""
        self.record.drop(left)
        self._front.recovery.sweep()

    def title_of_left(self, tab: OpenTab) -> str:
        """Return the name of a saved tab of a run that was ended; empty where it cannot come back."""
        if tab.path is not None:
            return tab.path.name if is_file(tab.path) else ""
        history = self._front.recovery.saved_history(tab.autosave)
        return "" if history is None else history.states[history.place][1].name

    def _restored(self, tab: OpenTab, files: _Files) -> OpenDocument | None:
        """Open a saved tab with its history, where that still ends in what the file holds."""
        history = self._front.recovery.saved_history(tab.autosave)
        if tab.path is None:
            if history is None:
                return None
            document = self.add(history.states[history.place][1])
        else:
            present = self.with_path(tab.path)
            read = files.get(tab.path)
            if present is not None or read is None:
                return present
            if isinstance(read, SuiteError):
                self._front.files.report_unread(tab.path, read)
                return None
            document = self.add(read[0], tab.path, stamp=read[1])
            self._front.files.remember(tab.path)
        store = document.store
        if history is not None and history.states[history.place][1] == store.value:
            place = history.place
            store.restore(history.states, place, store.path, saved=place, stamp=store.stamp)
        return document

    def _open_tabs(self) -> tuple[list[OpenTab], int]:
        """Return what a kill leaves of the tabs; those that were never touched are nothing."""
        tabs = [one for one in self._row if not (one.is_untouched and one.pristine)]
        rows = [OpenTab(one.store.path, one.recovery.file.name) for one in tabs]
        return rows, tabs.index(self._front) if self._front in tabs else 0

    def with_path(self, path: Path) -> OpenDocument | None:
        """Return the document of file ``path``, also by another name of it; ``None`` where it is not open."""
        for document in self._row:
            known = document.store.path
            if known is not None and _same_file(known, path):
                return document
        return None

    # The row.

    def show(self, document: OpenDocument) -> None:
        """Bring a document to the front."""
        if document is not self._front:
            self._front.store.end_gesture()
            self._front = document
            self.front_changed.emit()

    def step(self, by: int) -> None:
        """Bring the document ``by`` places further along the row to the front; the ends meet."""
        place = (self._row.index(self._front) + by) % len(self._row)
        self.show(self._row[place])

    def move(self, before: int, after: int) -> None:
        """Move the document at place ``before`` of the row to place ``after``."""
        if before != after:
            self._row.insert(after, self._row.pop(before))
            self.row_changed.emit()

    # Closing.

    def close(self, document: OpenDocument) -> bool:
        """Ask about unsaved work where there is some, and close; True where it was closed.

        The last one stays where it is empty already: there is nothing to close.
        """
        if len(self._row) == 1 and self._is_empty(document):
            return False
        if not document.store.is_clean:
            self.show(document)
        if not document.files.may_discard():
            return False
        if len(self._row) == 1:
            self.add(self._format.new())
            if document not in self._row:
                return True
        self._remove(document)
        return True

    def close_all(self, keep: OpenDocument | None = None) -> bool:
        """Ask about unsaved work where there is some, and close all but ``keep`` together; False where one was to stay.

        An empty one comes in their place where none is kept; what is shown changes once, however many go.
        """
        if keep is None and len(self._row) == 1 and self._is_empty(self._front):
            return True
        for document in self._row:
            if document is keep:
                continue
            if not document.store.is_clean:
                self.show(document)
            if not document.files.may_discard():
                return False
        going = [document for document in self._row if document is not keep]
        self.show(keep or self.add(self._format.new()))
        for document in going:
            if document in self._row:
                self._take_out(document)
        self.row_changed.emit()
        return True

    def reopen(self) -> None:
        """Have the tab back that was closed last, with its undo history and what was not saved."""
        if not self._closed:
            return
        old = self._closed.pop()
        present = self.with_path(old.store.path) if old.store.path is not None else None
        if present is not None:
            self.show(present)
            _discard(old)
            return
        # Its autosave ended with its tab.
        old.recovery.deleteLater()
        old.recovery = self._recovery(old.store)
        old.recovery.write()
        self._insert(old)

    def may_close_all(self) -> bool:
        """Ask about the unsaved work of every document; True where all may go, and their autosaves with them."""
        for document in self._row:
            if not document.store.is_clean:
                self.show(document)
            if not document.files.may_discard():
                return False
        for document in self._row:
            document.recovery.close(keep=False)
        self.record.close(keep=False)
        return True

    def keep_unsaved(self) -> None:
        """Write the unsaved work of every document for the next start; for a program that has to end."""
        for document in self._row:
            document.recovery.close(keep=True)
        self.record.close(keep=True)

    def _made(self, store: DocumentStore[Paint], *, pristine: bool = False) -> OpenDocument:
        self._last_key += 1
        files = DocumentFiles(store, self._format, self.dialogs, self)
        document = OpenDocument(self._last_key, store, files, self._recovery(store), store.value, pristine)
        files.failed.connect(self.failed)
        files.succeeded.connect(self.succeeded)
        files.recent_changed.connect(self.recent_changed)
        store.path_changed.connect(lambda _path: self.row_changed.emit())
        store.clean_changed.connect(lambda _clean: self.row_changed.emit())
        store.changed.connect(self._renamed)
        store.replaced.connect(lambda: setattr(document, "original", store.value))
        return document

    def _recovery(self, store: DocumentStore[Paint]) -> Recovery[Paint]:
        recovery = Recovery(store, self._format, self._autosave_failed, self, keeps_history=True)
        recovery.written_again.connect(lambda: self.succeeded.emit("autosave"))
        return recovery

    def _is_empty(self, document: OpenDocument) -> bool:
        """Whether nothing would be lost with it: as New makes it, and never changed."""
        return document.is_untouched and document.store.value == self._format.new()

    def _renamed(self, old: Paint, new: Paint) -> None:
        if old.name != new.name:
            self.row_changed.emit()

    def _insert(self, document: OpenDocument) -> None:
        # What is opened takes the place of the first, never touched.
        giving_way = self._front if self._front.pristine and self._front.is_untouched else None
        self._row.insert(self._row.index(self._front) + 1, document)
        self.opened.emit(document)
        self.show(document)
        if giving_way is not None:
            self._remove(giving_way, for_good=True)
        self.row_changed.emit()

    def _remove(self, document: OpenDocument, *, for_good: bool = False) -> None:
        place = self._row.index(document)
        if document is self._front:
            self.show(self._row[place + 1 if place + 1 < len(self._row) else place - 1])
        self._take_out(document, for_good=for_good)
        self.row_changed.emit()

    def _take_out(self, document: OpenDocument, *, for_good: bool = False) -> None:
        """Let a document that is not in front leave the row; the caller reports that the row is another."""
        self._row.remove(document)
        document.store.end_gesture()
        document.recovery.close(keep=False)
        gone: OpenDocument | None = document
        if not (for_good or self._is_empty(document)):
            self._closed.append(document)
            gone = self._closed.pop(0) if len(self._closed) > MOST_CLOSED else None
        self.closed.emit(document)
        if gone is not None:
            _discard(gone)


def _discard(document: OpenDocument) -> None:
    """Let a document go that cannot be reopened; otherwise it would live, with its history, as long as the row."""
    for part in (document.recovery, document.files, document.store):
        part.deleteLater()


def _same_file(known: Path, path: Path) -> bool:
    try:
        return known.samefile(path)
    except OSError:
        # One of them is not there: then only the names can say it.
        return known.absolute() == path.absolute()

"""New, open, save, save as, recent files, and the question about unsaved changes; the same for every document.

A file that cannot be read or written leaves the open document as it was; ``failed`` carries the message.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recent_files import RecentFiles, folder_beside
from brdf_qt.documents.stamp import FileStamp, is_changed, stamp_of
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import Answer, Overwrite, QtDialogs
from brdf_qt.window.message_bar import Message, message_of
from brdf_suite.documents.atomic import remove_unfinished
from brdf_suite.errors import SuiteError

T = TypeVar("T")


@dataclass(frozen=True)
class DocumentFormat(Generic[T]):
    """How a kind of document is made, read, written and named.

    ``kind`` is the word for the user ("paint"), marked for translation; ``ending`` has its dot; ``name_of`` gives
    the document's name.
    """

    kind: str
    ending: str
    new: Callable[[], T]
    load: Callable[[Path], T]
    save: Callable[[T, Path], None]
    to_json: Callable[[T], dict[str, Any]]
    from_json: Callable[[dict[str, Any], Path], T]
    name_of: Callable[[T], str]

    @property
    def filters(self) -> str:
        return f"{tr(self.kind).capitalize()} (*{self.ending});;" + tr("All files (*)")


class DocumentFiles(QObject, Generic[T]):
    """The File menu's work on one :class:`DocumentStore`."""

    failed = Signal(Message)
    succeeded = Signal(str)
    recent_changed = Signal()

    def __init__(
        self,
        store: DocumentStore[T],
        form: DocumentFormat[T],
        dialogs: QtDialogs,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.store, self.format, self.dialogs = store, form, dialogs

    def new(self) -> bool:
        """Start a new document, after asking about the old one; True where it was done."""
        if not self.may_discard():
            return False
        self.store.replace(self.format.new(), None)
        return True

    def open(self, path: Path | None = None) -> bool:
        """Open ``path``, or ask for one; True where a document was opened."""
        if not self.may_discard():
            return False
        path = path or self.ask_open_path()
        if path is None:
            return False
        try:
            value, stamp = self.read(path)
        except SuiteError as error:
            self.report_unread(path, error)
            return False
        self.take(path, value, stamp)
        return True

    def ask_open_path(self) -> Path | None:
        """Ask which file to open; ``None`` where the user gives up."""
        return self.dialogs.open_path(self._folder(), self.format.filters)

    def read(self, path: Path) -> tuple[T, FileStamp | None]:
        """Return what ``path`` holds, and its stamp; on any thread.

        Raises :class:`~brdf_suite.errors.SuiteError` where it cannot be read; see :meth:`report_unread`.
        """
        # Before the content is read: a change in between is then asked about once too often, never lost.
        stamp = stamp_of(path)
        remove_unfinished(path)
        return self.format.load(path), stamp

    def take(self, path: Path, value: T, stamp: FileStamp | None) -> None:
        """Open what :meth:`read` returned in the place of the document."""
        self.store.replace(value, path.absolute(), stamp=stamp)
        self.remember(path.absolute())
        self.succeeded.emit("open")

    def report_unread(self, path: Path, error: Exception) -> None:
        """Report a file that could not be read, and list it no more."""
        todo = tr("The {kind} that was open is unchanged.").format(kind=tr(self.format.kind))
        self.failed.emit(message_of(error, "open", todo=todo))
        RecentFiles().remove(path)
        self.recent_changed.emit()

    def save(self) -> bool:
        """Write the document to its file, asking for one where it has none; True where it was written.

        A file that another program has changed is written over only where the user says so.
        """
        path = self.store.path
        if path is None:
            return self.save_as()
        if is_changed(path, self.store.stamp):
            answer = self.dialogs.changed_file(path)
            if answer is not Overwrite.OVERWRITE:
                return answer is Overwrite.SAVE_AS and self.save_as()
        return self.save_to(path)

    def save_as(self) -> bool:
        """Ask for a file and write the document to it; True where it was written."""
        suggested = self.store.path
        if suggested is None:
            name = re.sub(r"[^\w\- .]+", "_", self.format.name_of(self.store.value)).strip(" .")
            suggested = self._folder() / f"{name or self.format.kind}{self.format.ending}"
        path = self.dialogs.save_path(suggested, self.format.filters)
        if path is None:
            return False
        if not path.suffix:
            path = path.with_name(path.name + self.format.ending)
        return self.save_to(path.absolute())

    def may_discard(self) -> bool:
        """Ask about unsaved changes where there are any; True where the document may be given up."""
        if self.store.is_clean:
            return True
        answer = self.dialogs.unsaved(self.title())
        if answer is Answer.SAVE:
            return self.save()
        return answer is Answer.DISCARD

    def title(self) -> str:
        """Return the name of the file, or of the document while it has no file."""
        return self.store.path.name if self.store.path else self.format.name_of(self.store.value)

    def recent(self) -> list[Path]:
        """Return the files opened or saved last, newest first."""
        return [Path(path) for path in RecentFiles().paths()]

    def clear_recent(self) -> None:
        RecentFiles().clear()
        self.recent_changed.emit()

    def save_to(self, path: Path) -> bool:
        """Write the document to a file, which is its own from then on; True where it was written."""
        try:
            self.format.save(self.store.value, path)
        except SuiteError as error:
            todo = tr("The document is still open with all changes. Choose another place with Save As.")
            self.failed.emit(message_of(error, "save", todo=todo))
            return False
        self.store.mark_clean(path, stamp_of(path))
        self.remember(path)
        self.succeeded.emit("save")
        return True

    def remember(self, path: Path) -> None:
        """Put ``path`` first among the recent files."""
        RecentFiles().add(path)
        self.recent_changed.emit()

    def _folder(self) -> Path:
        return folder_beside(self.store.path, [str(path) for path in self.recent()])

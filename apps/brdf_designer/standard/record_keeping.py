"""Keeps the standard of every open paint: with the file it is in, and with the autosave of what no file has yet."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from brdf_qt.window.message_bar import message_of
from PySide6.QtCore import QObject

from brdf_designer.documents.tabs import OpenDocument
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard.records import Record, keep, kept, record_from_json
from brdf_suite.errors import FileError

_KEY = "standard kept"


class Holder(Protocol):
    """Who has the standards: :class:`brdf_designer.standard.control.StandardControl`."""

    def record(self, key: int) -> Record | None:
        """Return the standard of a document, to be kept."""

    def restore(self, key: int, record: Record) -> None:
        """Give a document the standard that was kept for it."""


class StandardKeeping(QObject):
    """Gives documents that are opened the standard that they had, and keeps what becomes of it."""

    def __init__(self, session: PaintSession, holder: Holder, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._holder = session, holder
        self._known: set[int] = set()
        for document in session.documents.row:
            self._take(document)
        session.documents.opened.connect(self._take)

    def note(self, document: OpenDocument) -> None:
        """The standard of a document is another: keep it."""
        document.recovery.note()
        path = document.store.path
        if path is None:
            return
        try:
            keep(path, self._holder.record(document.key))
        except OSError as error:
            reason = f"its standard cannot be kept for the next start ({error.strerror})"
            self._session.show_message(message_of(FileError(path, reason), _KEY))
        else:
            self._session.dismiss_message(_KEY)

    def _take(self, document: OpenDocument) -> None:
        document.recovery.beside = self._extra_writer(document.key)
        if document.key in self._known:
            # It was closed and reopened, with an autosave that is new.
            document.recovery.note()
            return
        self._known.add(document.key)
        document.store.path_changed.connect(lambda _path: self.note(document))
        record = record_from_json(document.beside)
        if record is None and document.beside is None and document.store.path is not None:
            record = kept(document.store.path)
        if record is not None:
            self._holder.restore(document.key, record)
            document.recovery.note()

    def _extra_writer(self, key: int) -> Callable[[], object]:
        def extra() -> object:
            record = self._holder.record(key)
            return None if record is None else record.to_json()

        return extra

"""Unsaved work survives a kill: it is written beside the settings at least once a second, and offered back.

Each run has a file of its own and holds a lock beside it; the system frees the lock of a process that dies.
So the work of a program that still runs is never offered to another. A file goes once its work is saved or
discarded.
"""

from __future__ import annotations

import json
import uuid
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QLockFile, QObject, Signal

from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.stamp import FileStamp
from brdf_qt.program.settings import state_folder
from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from brdf_suite.errors import FileError, SuiteError

T = TypeVar("T")
INTERVAL_MS = 700
_ENDING = ".recovery.json"


@dataclass(frozen=True)
class Recovered(Generic[T]):
    """Unsaved work of a run that ended without saving it."""

    value: T
    path: Path | None
    when: datetime
    file: Path
    stamp: FileStamp | None = None
    beside: Any = None
    """What the program kept beside the document, as plain values: see :attr:`Recovery.beside`."""


class Recovery(QObject, Generic[T]):
    """Keeps the autosave of one store; :meth:`found` gives what earlier runs left.

    Signal: ``written_again()`` where the autosave could be written after it had failed.
    """

    written_again = Signal()

    def __init__(
        self,
        store: DocumentStore[T],
        form: DocumentFormat[T],
        failed: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._store, self._format, self._failed = store, form, failed
        self._fails = self._closed = False
        self.beside: Callable[[], Any] | None = None
        """Asked for plain values to be kept beside an unsaved document; :meth:`note` where they are others."""
        self.folder = state_folder("autosave")
        """The folder of the autosaves of this program."""
        self.file = self.folder / f"{uuid.uuid4().hex}{_ENDING}"
        """The autosave of this store; missing while nothing is unsaved."""
        self._lock = _lock(self.file)
        self._lock.tryLock(0)
        self.timer = make_timer(self, self.write, INTERVAL_MS)
        """Runs from a change to the autosave."""
        self._signals = (store.changed, store.replaced, store.clean_changed)
        for signal in self._signals:
            signal.connect(self._schedule)

    def _schedule(self, *_: object) -> None:
        """Start the second that may be lost; a timer that runs is left alone, so that a drag is saved too."""
        if not self.timer.isActive():
            self.timer.start()

    def note(self) -> None:
        """What is kept beside the document is another: write it within the second."""
        if not self._closed:
            self._schedule()

    def write(self) -> bool:
        """Write the unsaved document now; where all is saved, remove the file. False where that failed."""
        self.timer.stop()
        try:
            if self._store.is_clean:
                self.file.unlink(missing_ok=True)
            else:
                self._write()
        except OSError as error:
            reason = tr("the autosave cannot be written ({reason})").format(reason=error.strerror)
            self._fails = True
            self._failed(FileError(self.file, reason))
            return False
        if self._fails:
            self._fails = False
            self.written_again.emit()
        return True

    def _write(self) -> None:
        path, stamp = self._store.path, self._store.stamp
        content = {
            "path": None if path is None else str(path),
            "stamp": None if stamp is None else stamp.to_json(),
            "time": datetime.now().isoformat(timespec="microseconds"),
            "document": self._format.to_json(self._store.value),
        }
        if self.beside is not None:
            content["beside"] = self.beside()
        # No fsync: what a killed process has written stays in the system, and this runs between two frames.
        draft = self.file.with_suffix(".tmp")
        draft.write_text(json.dumps(content, ensure_ascii=False), encoding="utf-8")
        draft.replace(self.file)

    def found(self) -> list[Recovered[T]]:
        """Return what ended runs left, newest first; a file that cannot be read is reported and put aside."""
        result = []
        for file in self.folder.glob(f"*{_ENDING}"):
            lock = _lock(file)
            if file == self.file or not lock.tryLock(0):
                continue
            lock.unlock()
            try:
                result.append(self._read(file))
            except (OSError, ValueError, KeyError, TypeError, SuiteError) as error:
                text = tr("unsaved work of an earlier run cannot be read ({reason})").format(reason=error)
                self._failed(FileError(_aside(file), text))
        return sorted(result, key=lambda item: item.when, reverse=True)

    def _read(self, file: Path) -> Recovered[T]:
        content: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
        path, stamp = content["path"], content.get("stamp")
        return Recovered(
            self._format.from_json(content["document"], file),
            None if path is None else Path(path),
            datetime.fromisoformat(content["time"]),
            file,
            None if stamp is None else FileStamp.from_json(stamp),
            content.get("beside"),
        )

    def take(self, item: Recovered[T]) -> None:
        """Open recovered work as unsaved; its file goes once this run has written its own, and not before."""
        self._store.replace(item.value, item.path, clean=False, stamp=item.stamp)
        if self.write():
            self.drop(item)

    def drop(self, item: Recovered[T]) -> None:
        """Give recovered work up."""
        try:
            item.file.unlink(missing_ok=True)
        except OSError as error:
            text = tr("it cannot be removed, and will be offered again ({reason})")
            self._failed(FileError(item.file, text.format(reason=error.strerror)))

    def close(self, *, keep: bool) -> None:
        """End this run's autosave: ``keep`` writes what is unsaved, otherwise the file is removed.

        Nothing that happens to the store afterwards is written; another call does nothing.
        """
        if self._closed:
            return
        self._closed = True
        for signal in self._signals:
            signal.disconnect(self._schedule)
        self.timer.stop()
        if keep:
            self.write()
        else:
            self.file.unlink(missing_ok=True)
        self._lock.unlock()


def _aside(file: Path) -> Path:
    """Take a damaged file out of the way and return where it is now; where that fails it stays."""
    aside = file.with_suffix(".damaged")
    try:
        return file.replace(aside)
    except OSError:
        return file


def _lock(file: Path) -> QLockFile:
    lock = QLockFile(str(file.with_suffix(".lock")))
    # Never stale by age: only a lock whose process is gone is free.
    lock.setStaleLockTime(0)
    return lock

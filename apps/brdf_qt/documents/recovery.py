"""Unsaved work survives a kill: it is written beside the settings at least once a second, and offered back.

A document that is saved has no work to lose, but a history: where that is kept, it lies in a file of its own, and
comes back with the document. Each run has a file of its own and holds a lock beside it; the system frees the lock of a
process that dies. So the work of a program that still runs is never offered to another. A file goes once its work is
saved or discarded.

A power loss can take what the system has not forced to the disk. A file gets its place at once, so that it survives a
kill, and a thread forces it to the disk. Until that is done the version before has a second name, which is read where
the file is damaged.
"""

from __future__ import annotations

import contextlib
import json
import os
import threading
import uuid
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QLockFile, QObject, QThreadPool, Signal

from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.stamp import FileStamp
from brdf_qt.program.settings import state_folder
from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from brdf_suite.documents.atomic import sync_folder
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.regular_files import read_bytes

T = TypeVar("T")
INTERVAL_MS = 700
_ENDING = ".recovery.json"
_SAVED_ENDING = ".history.json"
_FORCED = ".forced"
"""Ending of the second name of the last version that was forced to the disk."""
_LINK = ".link"
"""Ending of that name while it is made."""
_forcing = threading.Lock()
MOST_STATES = 200
"""States of a history that are kept, around the present one."""


@dataclass(frozen=True)
class KeptHistory(Generic[T]):
    """The states of a document as :meth:`DocumentStore.states` has them, the place of the present one, and of that
    which its file holds (-1: none of them).
    """

    states: tuple[tuple[str, T], ...]
    place: int
    saved: int


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
    history: KeptHistory[T] | None = None
    """The undo history, where one was kept."""


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
        *,
        keeps_history: bool = False,
        folder: str = "autosave",
    ) -> None:
        """Write to ``folder`` of the program's state, one for each kind of document."""
        super().__init__(parent)
        self._store, self._format, self._failed = store, form, failed
        self._keeps_history = keeps_history
        self._encoded: dict[int, tuple[T, str]] = {}
        """The JSON of states of the history by their identity: only new ones are encoded."""
        self._fails = self._closed = False
        self.beside: Callable[[], Any] | None = None
        """Asked for plain values to be kept beside the document; :meth:`note` where they are others."""
        self.folder = state_folder(folder)
        """The folder of the autosaves."""
        self.file = self.folder / f"{uuid.uuid4().hex}{_ENDING}"
        """The autosave of this store; missing while nothing is unsaved."""
        self._saved_file = _saved_file(self.file)
        self._lock = lock_of(self.file)
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
        self._hold_lock()
        try:
            if self._store.is_clean:
                self._write_saved()
                remove_autosave(self.file)
            else:
                self._write()
                remove_autosave(self._saved_file)
        except OSError as error:
            reason = tr("the autosave cannot be written ({reason})").format(reason=error.strerror or error)
            self._fails = True
            self._failed(FileError(self.file, reason))
            return False
        if self._fails:
            self._fails = False
            self.written_again.emit()
        return True

    def _hold_lock(self) -> None:
        """Take the lock before a file is there; most documents are closed before anything of them is written."""
        if not self._lock.isLocked():
            self._lock.tryLock(0)

    def head(self) -> dict[str, Any]:
        """Return what an autosave says about its document: file, time, and what is kept beside it."""
        path, stamp = self._store.path, self._store.stamp
        content = {
            "path": None if path is None else str(path),
            "stamp": None if stamp is None else stamp.to_json(),
            "time": datetime.now().isoformat(timespec="microseconds"),
        }
        if self.beside is not None:
            content["beside"] = self.beside()
        return content

    def _write(self) -> None:
        content = {**self.head(), "document": self._format.to_json(self._store.value)}
        text = json.dumps(content, ensure_ascii=False)
        if self._keeps_history:
            text = f'{text[:-1]}, "history": {self._history()}}}'
        _replace(self.file, text)

    @property
    def _keeps_saved(self) -> bool:
        """Whether a saved document has a history to be kept, or is one without a file that is not to be asked about."""
        return self._keeps_history and (self._store.stack.count() > 0 or self._store.path is None)

    def _write_saved(self) -> None:
        if self._keeps_saved:
            head = json.dumps(self.head(), ensure_ascii=False)
            _replace(self._saved_file, f'{head[:-1]}, "history": {self._history()}}}')
        else:
            remove_autosave(self._saved_file)

    def saved_history(self, autosave: str) -> KeptHistory[T] | None:
        """Return the history of a saved document of an ended run by the name of its autosave; None where none is kept.

        Its present state is the saved one.
        """
        item = self._read_saved(_saved_file(self.folder / Path(autosave).name))
        return None if item is None else item.history

    def found_saved(self) -> list[Recovered[T]]:
        """Return the saved documents of ended runs of which a history is kept, newest first."""
        files = self.folder.glob(f"*{_SAVED_ENDING}")
        items = [self._read_saved(file) for file in files if self._has_ended(file)]
        return sorted((one for one in items if one is not None), key=lambda item: item.when, reverse=True)

    def _read_saved(self, file: Path) -> Recovered[T] | None:
        """Return a saved document with its history; None where it cannot be read: the document is in its own file."""
        try:
            content = kept_content(file)
            rows = content["history"]
            value = self._format.from_json(rows["states"][int(rows["place"])][1], file)
            return self._recovered(content, value, file)
        except (OSError, ArithmeticError, ValueError, TypeError, LookupError, RecursionError, SuiteError):
            return None

    def _has_ended(self, file: Path) -> bool:
        """Whether a file is of another run, which has ended."""
        autosave = file.with_name(file.name.replace(_SAVED_ENDING, _ENDING))
        lock = lock_of(autosave)
        if autosave == self.file or not lock.tryLock(0):
            return False
        lock.unlock()
        return True

    def sweep(self) -> None:
        """Remove the histories of saved documents of ended runs: they were taken, or given up."""
        for file in self.folder.glob(f"*{_SAVED_ENDING}"):
            if self._has_ended(file):
                remove_autosave(file)

    def _history(self) -> str:
        """Return the history as JSON; a state that was encoded before is not encoded again."""
        states, place = self._store.states(), self._store.stack.index()
        saved = self._store.stack.cleanIndex()
        first = max(0, min(place - MOST_STATES // 2, len(states) - MOST_STATES))
        # The present value may differ from where its step led: what followed from it by itself has no step.
        states = (*states[:place], (states[place][0], self._store.value), *states[place + 1 :])
        kept = states[first : first + MOST_STATES]
        encoded: dict[int, tuple[T, str]] = {}
        rows = []
        for name, value in kept:
            known = self._encoded.get(id(value))
            if known is None or known[0] is not value:
                known = (value, json.dumps(self._format.to_json(value), ensure_ascii=False))
            encoded[id(value)] = known
            rows.append(f"[{json.dumps(name, ensure_ascii=False)}, {known[1]}]")
        self._encoded = encoded
        saved = saved - first if first <= saved < first + len(kept) else -1
        return f'{{"place": {place - first}, "saved": {saved}, "states": [{", ".join(rows)}]}}'

    def _sweep_unfinished(self) -> None:
        """Remove what a kill left of an autosave that was being written, and locks of runs without one."""
        for lock in self.folder.glob("*.lock"):
            autosave = lock.with_suffix(".json")
            if not any(
                lock_of(autosave).getLockInfo()
            ):  # its run was killed while it made it; Qt takes it for held
                lock.unlink(missing_ok=True)
            if self._has_ended(autosave):
                for content in (autosave, _saved_file(autosave)):
                    # Also the numbered drafts of palettes, which a thread writes.
                    for draft in self.folder.glob(f"{content.stem}*.tmp"):
                        draft.unlink(missing_ok=True)
        for link in self.folder.glob(f"*{_LINK}"):
            if self._has_ended(link.with_suffix(".json")):
                link.unlink(missing_ok=True)
        for forced in self.folder.glob(f"*{_FORCED}"):
            if not forced.with_suffix(".json").exists():
                forced.unlink(missing_ok=True)

    def found(self) -> list[Recovered[T]]:
        """Return what ended runs left, newest first; a file that cannot be read is reported and put aside."""
        self._sweep_unfinished()
        result = []
        for file in self.folder.glob(f"*{_ENDING}"):
            if not self._has_ended(file):
                continue
            try:
                result.append(self._read(file))
            except (
                OSError,
                ValueError,
                LookupError,
                TypeError,
                AttributeError,
                RecursionError,
                SuiteError,
            ) as error:
                if _is_blank(file):
                    remove_autosave(file)
                    continue
                text = tr("unsaved work of an earlier run cannot be read ({reason})").format(reason=error)
                self._failed(FileError(_aside(file), text))
        return sorted(result, key=lambda item: item.when, reverse=True)

    def _read(self, file: Path) -> Recovered[T]:
        content = kept_content(file)
        return self._recovered(content, self._format.from_json(content["document"], file), file)

    def _recovered(self, content: dict[str, Any], value: T, file: Path) -> Recovered[T]:
        path, stamp = content["path"], content.get("stamp")
        return Recovered(
            value,
            None if path is None else Path(path),
            datetime.fromisoformat(content["time"]),
            file,
            None if stamp is None else FileStamp.from_json(stamp),
            content.get("beside"),
            self._read_history(content.get("history"), value, file),
        )

    def _read_history(self, content: Any, value: T, file: Path) -> KeptHistory[T] | None:
        """Return the history in an autosave; None where there is none that ends at ``value``: the work counts."""
        if not self._keeps_history or content is None:
            return None
        try:
            rows = content["states"][:MOST_STATES]
            states = tuple((str(name), self._format.from_json(row, file)) for name, row in rows)
            place, saved = int(content["place"]), int(content["saved"])
        except (KeyError, TypeError, ValueError, OverflowError, SuiteError):
            return None
        if not 0 <= place < len(states) or states[place][1] != value or not -1 <= saved < len(states):
            return None
        return KeptHistory(states, place, saved)

    def take(self, item: Recovered[T]) -> None:
        """Open recovered work as unsaved; its file goes once this run has written its own, and not before."""
        history = item.history
        if history is None or history.place == history.saved:
            self._store.replace(item.value, item.path, clean=False, stamp=item.stamp)
        else:
            self._store.restore(
                history.states, history.place, item.path, saved=history.saved, stamp=item.stamp
            )
        if self.write():
            force(self.file)  # it is the only one from here on
            self.drop(item)

    def drop(self, item: Recovered[T]) -> None:
        """Give recovered work up."""
        try:
            remove_autosave(item.file)
        except OSError as error:
            text = tr("it cannot be removed, and will be offered again ({reason})")
            self._failed(FileError(item.file, text.format(reason=error.strerror or error)))

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
        try:
            if keep:
                self.write()
            else:
                remove_autosave(self.file)
                remove_autosave(self._saved_file)
        finally:
            if self._lock.isLocked():
                self._lock.unlock()


def _saved_file(autosave: Path) -> Path:
    return autosave.with_name(autosave.name.replace(_ENDING, _SAVED_ENDING))


def _replace(file: Path, text: str) -> None:
    # What a killed process has written stays in the system. The disk gets it on a thread: this runs between two frames.
    draft = file.with_suffix(".tmp")
    try:
        # A name of a file may be no text: its half surrogates become \udcff, as JSON writes them too.
        draft.write_text(text, encoding="utf-8", errors="backslashreplace")
        draft.replace(file)
    except OSError:
        draft.unlink(missing_ok=True)
        raise
    flush_later(file)


def flush_later(file: Path) -> None:
    """Have a thread force a file and the entry of its folder to the disk; a power loss from then on leaves it whole."""
    QThreadPool.globalInstance().start(partial(force, file))


def force(file: Path) -> None:
    """Force an autosave to the disk now, and give this version a second name for the time when the next is written."""
    # The file may be gone or replaced by now, and some file systems cannot: the autosave is there all the same.
    link = file.with_suffix(_LINK)
    with _forcing, contextlib.suppress(OSError):
        with file.open("rb+") as written:
            os.fsync(written.fileno())
            number = os.fstat(written.fileno()).st_ino
        link.unlink(missing_ok=True)
        link.hardlink_to(file)
        if link.stat().st_ino == number:
            link.replace(file.with_suffix(_FORCED))
        link.unlink(missing_ok=True)  # it is still there where both were names of one file already
        sync_folder(file.parent)


def remove_autosave(file: Path) -> None:
    """Remove an autosave, and the second name of it. OSError."""
    file.unlink(missing_ok=True)
    file.with_suffix(_FORCED).unlink(missing_ok=True)


def kept_content(file: Path) -> dict[str, Any]:
    """Return the content of an autosave; where a power loss has taken it, of the version before.

    Raises :class:`FileError` or :class:`ValueError`: neither can be read.
    """
    try:
        content: dict[str, Any] = json.loads(read_bytes(file))
    except (FileError, ValueError):
        forced = file.with_suffix(_FORCED)
        if not forced.exists():
            raise
        content = json.loads(read_bytes(forced))
    return content


def _is_blank(file: Path) -> bool:
    """Whether a file holds nothing: a power loss came before the disk had anything of it."""
    try:
        return not read_bytes(file).strip(b"\0")
    except FileError:
        return False


def _aside(file: Path) -> Path:
    """Take a damaged file out of the way and return where it is now; where that fails it stays."""
    aside = file.with_suffix(".damaged")
    try:
        return file.replace(aside)
    except OSError:
        return file


def lock_of(file: Path) -> QLockFile:
    """Return the lock beside a file, which a run holds while it lives."""
    lock = QLockFile(str(file.with_suffix(".lock")))
    # Never stale by age: only a lock whose process is gone is free.
    lock.setStaleLockTime(0)
    return lock

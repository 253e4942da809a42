"""Which documents were open, in the order of their tabs: kept in a file while a program runs, so that after a kill
not only the unsaved ones come back.

A record names files of documents and, of unsaved ones, their autosaves; it holds no document itself. It goes when its
program ends as it should.
"""

from __future__ import annotations

import json
import uuid
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject

from brdf_qt.documents.recovery import lock_of
from brdf_qt.program.settings import state_folder
from brdf_qt.work.timer import make_timer
from brdf_suite.errors import FileError
from brdf_suite.regular_files import read_bytes

_ENDING = ".tabs.json"
_LOCK = ".tabs.lock"
_SOON_MS = 300
_MOST_TABS = 200


@dataclass(frozen=True)
class OpenTab:
    """A document that was open: its file, None where it had none, and the name of its autosave ("": never written).

    ``source`` is what a program opens that has neither: the name of something shipped, or an entry of a palette.
    """

    path: Path | None
    autosave: str = ""
    source: str = ""


@dataclass(frozen=True)
class TabsLeft:
    """The tabs of a run that was ended, from the left; ``front`` is the place of the one that was shown."""

    tabs: tuple[OpenTab, ...]
    front: int
    file: Path


class TabsRecord(QObject):
    """Writes what ``read`` returns, tabs and the place of that in front, soon after each :meth:`note`."""

    def __init__(
        self, read: Callable[[], tuple[Sequence[OpenTab], int]], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._read = read
        self._folder = state_folder("autosave")
        self.file = self._folder / f"{uuid.uuid4().hex}{_ENDING}"
        self._lock = lock_of(self.file)
        self._lock.tryLock(0)
        self._closed = False
        self._soon = make_timer(self, self.write, _SOON_MS)

    def note(self) -> None:
        """The tabs are others."""
        if not self._closed and not self._soon.isActive():
            self._soon.start()

    def write(self) -> None:
        """Write the record now; where that fails, the tabs are lost with a kill, and the work in them is not."""
        self._soon.stop()
        if self._closed:
            return
        tabs, front = self._read()
        rows = [
            {
                "path": None if tab.path is None else str(tab.path),
                "autosave": tab.autosave,
                "source": tab.source,
            }
            for tab in tabs
        ]
        draft = self.file.with_suffix(".tmp")
        try:
            draft.write_text(json.dumps({"front": front, "tabs": rows}), encoding="utf-8")
            draft.replace(self.file)
        except OSError:
            draft.unlink(missing_ok=True)

    def left(self) -> TabsLeft | None:
        """Return the newest record of a run that was ended, and remove older ones; None where there is none.

        One that cannot be read is removed: it holds no work.
        """
        self._remove_unfinished()
        found: list[tuple[float, Path]] = []
        for file in self._folder.glob(f"*{_ENDING}"):
            lock = lock_of(file)
            if file == self.file or not lock.tryLock(0):
                continue
            lock.unlock()
            found.append((file.stat().st_mtime, file))
        newest: TabsLeft | None = None
        for _, file in sorted(found, reverse=True):
            read = _read_record(file) if newest is None else None
            if read is None:
                file.unlink(missing_ok=True)
            else:
                newest = read
        return newest

    def _remove_unfinished(self) -> None:
        """Remove what a kill left of a record that was being written, and locks of runs that have ended."""
        for left in self._folder.glob(f"*{_LOCK}"):
            file = left.with_suffix(".json")
            lock = lock_of(file)
            if file == self.file:
                continue
            if not any(lock.getLockInfo()):  # its run was killed while it made it; Qt takes it for held
                left.unlink(missing_ok=True)
            if lock.tryLock(0):
                file.with_suffix(".tmp").unlink(missing_ok=True)
                lock.unlock()

    def drop(self, left: TabsLeft) -> None:
        """Give a record up."""
        left.file.unlink(missing_ok=True)

    def close(self, *, keep: bool) -> None:
        """End the record: ``keep`` leaves it for the next start. Another call does nothing."""
        if self._closed:
            return
        if keep:
            self.write()
        self._closed = True
        self._soon.stop()
        if not keep:
            self.file.unlink(missing_ok=True)
        self._lock.unlock()


def _read_record(file: Path) -> TabsLeft | None:
    try:
        content: dict[str, Any] = json.loads(read_bytes(file))
        tabs = [
            OpenTab(
                None if row["path"] is None else Path(str(row["path"])),
                str(row["autosave"]),
                str(row.get("source", "")),
            )
            for row in content["tabs"][:_MOST_TABS]
        ]
        return TabsLeft(tuple(tabs), int(content["front"]), file)
    except (FileError, ArithmeticError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return None

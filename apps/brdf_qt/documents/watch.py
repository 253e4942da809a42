"""Notices that a file's content has changed on disk, also where an editor replaces the file as a whole."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QFileSystemWatcher, QObject, Signal

from brdf_qt.documents.stamp import FileStamp, stamp_of
from brdf_qt.work.timer import make_timer

_QUIET_MS = 150
"""Editors write in several steps; the file is looked at once they are done."""


class FileWatch(QObject):
    """Watches one file at a time and emits ``changed(path)``."""

    changed = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._path: Path | None = None
        self._stamp: FileStamp | None = None
        self._watcher = QFileSystemWatcher(self)
        self._quiet = make_timer(self, self._look, _QUIET_MS)
        self._watcher.fileChanged.connect(lambda _path: self._quiet.start())
        self._watcher.directoryChanged.connect(lambda _path: self._quiet.start())

    @property
    def path(self) -> str:
        """What is watched; empty where nothing is."""
        return "" if self._path is None else str(self._path)

    def watch(self, path: str, known: FileStamp | None = None) -> None:
        """Watch this file from now on, and no other; the empty path ends watching.

        ``known`` is what it held when it was read or written: only another content is a change, or another time of a
        file over 64 MiB. Without it the file is looked at now.
        """
        watched = [*self._watcher.files(), *self._watcher.directories()]
        if watched:
            self._watcher.removePaths(watched)
        self._quiet.stop()
        self._path = Path(path) if path else None
        if self._path is not None:
            self._stamp = known or stamp_of(self._path)
            # The folder too: a file that is replaced is another file, and its watch ends.
            self._watcher.addPaths([str(self._path), str(self._path.parent)])

    def _look(self) -> None:
        if self._path is None:
            return
        now = stamp_of(self._path)
        if now is None:
            return  # between the removal and the new file
        if str(self._path) not in self._watcher.files():
            self._watcher.addPath(str(self._path))
        before, self._stamp = self._stamp, now
        if before is None or not now.same_content(before):
            self.changed.emit(str(self._path))

"""The files that were opened last, newest first, remembered between runs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QStandardPaths

from brdf_qt.program.settings import SHARED, settings
from brdf_suite.regular_files import is_file, is_folder

MOST_RECENT = 10


class RecentFiles:
    """A list of recent files, kept under ``key`` in the settings of a program, by default of the running one."""

    def __init__(self, key: str = "recent", program: str = "") -> None:
        self._key, self._program = key, program

    def paths(self) -> list[str]:
        """Return absolute paths, newest first; files that are gone are left out."""
        stored = settings(self._program).value(self._key, [])
        stored = stored if isinstance(stored, list) else [stored]
        return [path for path in stored if isinstance(path, str) and (is_file(path) or is_folder(path))]

    def add(self, path: str | Path) -> None:
        """Put ``path`` first."""
        first = str(Path(path).absolute())
        paths = [first, *(known for known in self.paths() if known != first)]
        settings(self._program).setValue(self._key, paths[:MOST_RECENT])

    def remove(self, path: str | Path) -> None:
        """Leave ``path`` out from now on."""
        gone = str(Path(path).absolute())
        settings(self._program).setValue(self._key, [known for known in self.paths() if known != gone])

    def clear(self) -> None:
        settings(self._program).remove(self._key)


def recent_projects() -> RecentFiles:
    """Return the projects that were opened or saved last, in any of the programs; files and folders."""
    return RecentFiles("recent/projects", SHARED)


def folder_beside(path: Path | None, recent: Sequence[str]) -> Path:
    """Return where a dialog begins: at the open file, else at the newest recent one, else in the user's documents."""
    if path is not None:
        return path.parent
    if recent:
        return Path(recent[0]).parent
    documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
    return Path(documents) if is_folder(documents) else Path.home()

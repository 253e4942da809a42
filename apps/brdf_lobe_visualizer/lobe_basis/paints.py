"""Contents of a folder of paints: their number, and the checksum that identifies the paints of a search.

A folder may be large, or on a network: it is walked on a thread, and its paints are read only where names, sizes or
times are others than before.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from brdf_qt.window.message_bar import message_of
from PySide6.QtCore import QFileSystemWatcher, QObject, Signal

from brdf_lobe_visualizer.session import LobeSession
from brdf_suite.documents.atomic import documents_in
from brdf_suite.documents.store import PAINT_ENDING
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report
from brdf_suite.regular_files import is_folder

_TASK = "basis/paints"

Stamps = tuple[tuple[str, int, int], ...]


@dataclass(frozen=True)
class PaintsIn:
    """The paints of a folder: name, time of change in ns and size of each file, and the sum of a search of them.

    ``sha256`` is empty where there is no paint, or one cannot be read.
    """

    folder: Path
    stamps: Stamps
    sha256: str

    @property
    def count(self) -> int:
        return len(self.stamps)


def paints_in(request: tuple[Path, PaintsIn | None], progress: Progress | None = None) -> PaintsIn:
    """Return what is in a folder; what was found ``before`` where nothing has changed."""
    from brdf_suite.fitting.basis_search.database import database_sha256  # much to import for a start

    folder, before = request
    stamps = []
    for path in documents_in(folder, PAINT_ENDING, within=True):
        report(progress, 0.0, "looking for paints")
        try:
            status = path.stat()
        except OSError:  # it has gone since it was listed
            continue
        stamps.append((path.relative_to(folder).as_posix(), status.st_mtime_ns, status.st_size))
    found = tuple(sorted(stamps))
    if before is not None and (before.folder, before.stamps) == (folder, found):
        return before
    try:
        return PaintsIn(folder, found, database_sha256(folder) if found else "")
    except (SuiteError, OSError):
        return PaintsIn(folder, found, "")


class FolderPaints(QObject):
    """Tracks the contents of a folder. Signals: ``changed()`` when it has been looked at."""

    changed = Signal()

    def __init__(self, session: LobeSession, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._folder: Path | None = None
        self._known: dict[Path, PaintsIn] = {}
        self._watch = QFileSystemWatcher(self)
        self._watch.directoryChanged.connect(lambda _path: self.look())
        self.busy = False

    @property
    def known(self) -> PaintsIn | None:
        """What is in the folder, as it was last seen; None where it was not looked at yet."""
        return None if self._folder is None else self._known.get(self._folder)

    def follow(self, folder: Path) -> None:
        """Look at another folder from here on."""
        watched = self._watch.directories()
        if watched:
            self._watch.removePaths(watched)
        if is_folder(folder):
            self._watch.addPath(str(folder))
        self._folder = folder
        self.look()

    def look(self) -> None:
        """Look whether anything has changed; ``changed`` follows also where nothing has."""
        if self._folder is not None:
            self.busy = True
            request = (self._folder, self.known)
            self._session.tasks.submit(_TASK, paints_in, request, self._arrived, self._failed)

    def _arrived(self, found: PaintsIn) -> None:
        self.busy = False
        self._known[found.folder] = found
        self.changed.emit()

    def _failed(self, error: Exception) -> None:
        folder = self._folder
        if folder is not None:  # a folder that cannot be walked has no paints to offer
            self._session.messages.show_message(message_of(error, _TASK))
            self._arrived(PaintsIn(folder, (), ""))

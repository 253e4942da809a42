"""File ▸ Open Project, Save Project and Collect Files: the same in every program, which gives what it has open."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Protocol

from PySide6.QtCore import QObject, Signal

from brdf_qt.documents.file_reading import FileReading
from brdf_qt.documents.projects import OpenedProject, as_opened, open_project, projects_folder
from brdf_qt.documents.recent_files import folder_beside, recent_projects
from brdf_qt.documents.stamp import FileStamp, stamp_of
from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.dialogs import Overwrite, QtDialogs
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from brdf_suite.documents.project import MANIFEST, PROJECT_ENDING, Project, save_project
from brdf_suite.errors import SuiteError, ValueRangeError
from brdf_suite.progress import Progress
from brdf_suite.regular_files import is_folder

KEY = "project"
_CLOSING_MS = 20_000


class ProjectPart(Protocol):
    """What a program does with a project: shows the parts that concern it, and gives back what it has open."""

    def show_project(self, opened: OpenedProject) -> None:
        """Show a project that was read."""

    def gather_project(self, project: Project) -> Project:
        """Return ``project`` with what the program has open now, and all other parts of it as they are.

        Raises :class:`SuiteError` where something that is open cannot be in a project.
        """

    def project_saved(self, opened: OpenedProject) -> None:
        """Note that what :meth:`gather_project` gave is now what the file has."""


@dataclass(frozen=True)
class _Request:
    """What is written where."""

    project: Project
    path: Path
    collect: bool


class ProjectFiles(Feature, QObject):
    """The project that is open, and the commands on it.

    Signal: ``saved(OpenedProject)`` once a project was written.
    """

    saved = Signal(object)

    def __init__(self, window: SuiteWindow, part: ProjectPart, dialogs: QtDialogs) -> None:
        super().__init__(window)
        self._window, self._part, self._dialogs = window, part, dialogs
        self._tasks = TaskRunner(self, threads=1)
        self._reading = FileReading(window.progress, self)
        self.opened: OpenedProject | None = None
        """The project that was opened or saved last."""
        self._stamp: FileStamp | None = None
        add = window.add_command
        add("file", mark("Open Pro&ject…"), None, self.ask_open, "open_project", icon="archive",
            tip=mark("Paints, standard, views and lights of one design"))  # fmt: skip
        add("file", mark("Save Projec&t…"), None, self.save, "save_project",
            tip=mark("What is open here, and all other parts of the open project"))  # fmt: skip
        add("file", mark("Collect &Files…"), None, self.collect, "collect_files",
            tip=mark("Save the project with a copy of every file that it names"))  # fmt: skip

    @property
    def is_idle(self) -> bool:
        return not self._tasks.busy and self._reading.is_idle

    def close(self) -> None:
        """Wait for a project that is being written: it is there whole, or not at all."""
        self._reading.close()
        self._tasks.stop(_CLOSING_MS)

    def ask_open(self) -> None:
        """Ask for a project and open it."""
        path = self._dialogs.open_path(self._folder(), _filters())
        if path is not None:
            self.open(path)

    def open(self, path: Path) -> None:
        """Read a project on a thread, and show it; a message says why one cannot be read."""
        # A folder that was unpacked is chosen by its manifest.
        path = (path.parent if path.name == MANIFEST else path).absolute()

        def failed(error: Exception) -> None:
            todo = tr("What was open is unchanged.")
            self._window.show_message(message_of(error, KEY, todo=todo))
            recent_projects().remove(path)

        self._reading.begin(path, _read, self._show, failed)

    def _show(self, found: tuple[OpenedProject, FileStamp | None]) -> None:
        self._window.dismiss_message(KEY)
        self.opened, self._stamp = found
        recent_projects().add(self.opened.path)
        self._part.show_project(self.opened)

    def save(self) -> None:
        """Write what is open, with the other parts of the project; a folder is written again, a file asked for."""
        self._write(collect=False)

    def collect(self) -> None:
        """As :meth:`save`, with a copy of every file that the project names."""
        self._write(collect=True)

    def _write(self, *, collect: bool) -> None:
        opened = self.opened
        present = Project(tr("Untitled")) if opened is None else opened.project
        try:
            project = self._part.gather_project(present)
        except SuiteError as error:
            self._window.show_message(message_of(error, KEY))
            return
        path = self._target(project.name)
        if path is None:
            return
        if opened is None:
            # A project takes the name of its file, where that can be the name of a project.
            with suppress(ValueRangeError):
                project = replace(project, name=path.name.removesuffix(PROJECT_ENDING) or project.name)
        progress, what = self._window.progress, tr("Saving {name}").format(name=path.name)

        def moved(fraction: float, file: str) -> None:
            progress.set_job(KEY, fraction, f"{what}: {file}", self._cancel)

        def failed(error: Exception) -> None:
            progress.end_job(KEY)
            todo = tr("The project on disk is as it was. Choose another place, or correct this.")
            self._window.show_message(message_of(error, KEY, todo=todo))

        request = _Request(project, path, collect)
        self._tasks.submit(KEY, _save, request, self._saved, failed, moved)

    def _saved(self, found: tuple[OpenedProject, int]) -> None:
        opened, collected = found
        self._window.progress.end_job(KEY)
        self.opened, self._stamp = opened, _stamp(opened.path)
        recent_projects().add(opened.path)
        text = tr("Saved: {path} ({count} files collected)") if collected else tr("Saved: {path}")
        words = text.format(path=opened.path.name, count=collected)
        self._window.show_message(Message(KEY, words))
        self._part.project_saved(opened)
        self.saved.emit(opened)

    def _cancel(self) -> None:
        self._tasks.cancel(KEY)

    def _target(self, name: str) -> Path | None:
        """Return where to write, None: nowhere; asks again about what another program has changed meanwhile."""
        opened = self.opened
        path = opened.path if opened is not None and is_folder(opened.path) else self._ask_target(name)
        while path is not None and self._is_changed(path):
            answer = self._dialogs.changed_file(path)
            if answer is Overwrite.OVERWRITE:
                break
            path = self._ask_target(name) if answer is Overwrite.SAVE_AS else None
        return path

    def _ask_target(self, name: str) -> Path | None:
        suggested = self._folder() / f"{name}{PROJECT_ENDING}" if self.opened is None else self.opened.path
        path = self._dialogs.save_path(suggested, _filters())
        if path is not None and path.suffix.lower() != PROJECT_ENDING:
            path = path.with_name(path.name + PROJECT_ENDING)
        return None if path is None else path.absolute()

    def _is_changed(self, path: Path) -> bool:
        """Return whether another program has changed the project since it was read or written here."""
        if self.opened is None or path != self.opened.path or self._stamp is None:
            return False
        present = _stamp(path)
        return present is not None and not present.same_content(self._stamp)

    def _folder(self) -> Path:
        present = None if self.opened is None else self.opened.path
        return folder_beside(present, recent_projects().paths())


def _stamp(path: Path) -> FileStamp | None:
    return stamp_of(path / MANIFEST if is_folder(path) else path)


def _read(path: Path, progress: Progress) -> tuple[OpenedProject, FileStamp | None]:
    # The stamp first: a change in between is then asked about once too often, never lost.
    stamp = _stamp(path)
    progress(0.1, path.name)
    return open_project(path), stamp


def _filters() -> str:
    return tr("Projects") + f" (*{PROJECT_ENDING} {MANIFEST});;" + tr("All files (*)")


def _save(request: _Request, progress: Progress) -> tuple[OpenedProject, int]:
    names = save_project(
        request.project,
        request.path,
        collect=request.collect,
        folder=is_folder(request.path),
        unpacked=projects_folder(),
        progress=progress,
    )
    # Read again: what was collected is named in the project from now on.
    return (open_project(request.path) if names else as_opened(request.project, request.path)), len(names)

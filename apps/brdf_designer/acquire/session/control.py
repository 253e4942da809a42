"""Opens sessions, makes new ones, checks them, and writes the numbers of the rig that are edited."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

from brdf_qt.program.settings import settings, state_folder
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject

from brdf_designer.acquire.plots.tone import drawn
from brdf_designer.acquire.reconstruction.session import ReconstructionSession
from brdf_designer.acquire.session.page import SessionPage
from brdf_designer.acquire.states import Problem, Series
from brdf_suite.acquisition.session.session import SESSION_FILE, Session
from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report
from brdf_suite.regular_files import is_file, is_folder

_LAST = "acquire/folder"
_PAUSE_MS = 500
_SAMPLE, _SAMPLE_PAINT = "sample_session", "blue_metallic"
_SAMPLE_POSITIONS, _SAMPLE_EXPOSURES, _SAMPLE_PX = 24, 8, 160
_MOST_STEPS = 100
_SEVERITIES = {"fatal": "error", "position": "error", "exposure": "error", "warning": "warning"}


class SessionControl(QObject):
    """Joins the session's page to the workbench."""

    def __init__(self, bench: ReconstructionSession, page: SessionPage, dialogs: QtDialogs) -> None:
        super().__init__(bench)
        self._bench, self._page, self._dialogs = bench, page, dialogs
        self.problems: tuple[Problem, ...] | None = None
        self._undo: list[Session] = []
        self._redo: list[Session] = []
        self._pending: dict[str, float] = {}
        self._pause = make_timer(self, self.write_pending, _PAUSE_MS)
        page.open_requested.connect(self.ask)
        page.template_requested.connect(self.ask_new)
        page.check_requested.connect(self.check)
        page.number_edited.connect(self._edited)
        bench.window.folder_dropped.connect(lambda name: self.open(Path(name)))
        bench.opened.connect(self._opened)
        bench.edited.connect(self._show)

    # Opening.

    def ask(self) -> None:
        """Ask for a session, and open it."""
        path = self._dialogs.folder_path(tr("Open a Folder of Photographs"), self._last_folder())
        if path is not None:
            self.open(path)

    def ask_new(self) -> None:
        """Ask where a new session is to be, make its folder from the template, and open it."""
        path = self._dialogs.folder_path(tr("Choose or Make a Folder for Photographs"), self._last_folder())
        if path is not None:
            self.make(path)

    def open_sample(self) -> None:
        """Open photographs of a simulated rig; they are made where they are not there yet."""
        folder = sample_folder()
        if is_file(folder / SESSION_FILE):
            self.open(folder)
            return
        todo = tr("No session was opened.")
        self._bench.run("make", _simulate, folder, self.open, todo=todo)

    def make(self, folder: Path) -> None:
        """Make a folder from the template, and open it."""

        def refused(error: Exception) -> None:
            self._bench.say(message_of(error, "open", todo=tr("No file was written.")))

        # On a thread: it looks into every photograph that lies there.
        self._bench.run("make", _make, folder, self.open, failed=refused)

    def open(self, path: Path) -> None:
        """Read a session by its folder or its session.json, and check it."""
        self.write_pending()
        folder = path if is_folder(path) else path.parent
        todo = tr("The open session is unchanged.") if self._bench.session is not None else ""
        self._bench.run("open", _open, folder, self._taken, todo=todo)

    def check(self) -> None:
        """Read the session of the folder once more, and check it."""
        if self._bench.folder is not None:
            self.open(self._bench.folder)

    def _taken(self, answer: tuple[Path, Session, tuple[Problem, ...]]) -> None:
        folder, session, self.problems = answer
        settings().setValue(_LAST, str(folder))
        self._undo.clear()
        self._redo.clear()
        self._bench.open(folder, session)

    def _opened(self) -> None:
        self._show()
        session = self._bench.session
        if session is None:
            return
        self._page.keep_opened()
        self._page.show_problems(self.problems, len(session.files()))
        self._bench.window.show_title(session.name)
        self._bench.window.show_step(
            "session",
            "warning" if self.problems else "done",
            tr("{positions} × {exposures} photographs").format(
                positions=len(session.positions), exposures=len(session.exposures_s)
            ),
        )

    def show_series(self, series: Series) -> None:
        """Show the exposure of a position that shows most of the sphere."""
        if series.shots:
            bright = [shot for shot in series.shots if shot.clipped < 0.02]
            self._page.picture.show_image(drawn((bright or series.shots[:1])[-1].tones))
        else:
            self._page.picture.show_empty(tr("None of the photographs of this position can be read."))

    def _show(self) -> None:
        self._page.show_session(self._bench.folder, self._bench.session)

    # Editing.

    def _edited(self, key: str, value: float) -> None:
        self._pending[key] = value
        self._pause.start()

    def write_pending(self) -> None:
        """Write what was edited and is not yet written."""
        self._pause.stop()
        pending, self._pending = self._pending, {}
        if not pending or self._bench.session is None:
            return
        before = self._bench.session
        try:
            after = apply_edit(before, pending)
        except SuiteError as error:
            self._bench.say(message_of(error, "edit", todo=tr("session.json is unchanged.")))
            self._show()
            return
        if after != before and self._write(after):
            self._undo = [*self._undo, before][-_MOST_STEPS:]
            self._redo.clear()

    def undo(self) -> None:
        """Take the newest edit back."""
        self.write_pending()
        self._move(self._undo, self._redo)

    def redo(self) -> None:
        """Do again what was taken back last."""
        self._move(self._redo, self._undo)

    def _move(self, source: list[Session], target: list[Session]) -> None:
        if source and self._bench.session is not None:
            present, other = self._bench.session, source[-1]
            # Only the numbers are steps; a mask that was named meanwhile stays named.
            if self._write(replace(other, mask=present.mask)):
                source.pop()
                target.append(present)

    def _write(self, session: Session) -> bool:
        assert self._bench.folder is not None
        try:
            if read_session(self._bench.folder) != self._bench.session:
                self._bench.say(
                    Message(
                        "edit",
                        tr("session.json was changed by another program since it was opened here."),
                        todo=tr("Click Check Again to read it, then repeat the edit."),
                        severity="warning",
                    )
                )
                self._show()
                return False
            write_session(session, self._bench.folder)
        except SuiteError as error:
            self._bench.say(message_of(error, "edit", todo=tr("session.json is unchanged.")))
            self._show()
            return False
        self._bench.window.messages.dismiss("edit")
        self._bench.edit(session, forget="geometry")
        return True

    def _last_folder(self) -> Path:
        if self._bench.folder is not None:
            return self._bench.folder
        kept = Path(str(settings().value(_LAST, "", type=str)) or Path.home())
        return kept if is_folder(kept) else Path.home()


def sample_folder() -> Path:
    """Return where the photographs of the simulated rig are kept."""
    return state_folder("acquire") / _SAMPLE


def apply_edit(session: Session, values: dict[str, float]) -> Session:
    """Return the session with these numbers, in the units of the fields."""
    changed: dict[str, dict[str, Any]] = {}
    for key, value in values.items():
        part, name = key.split(".")
        changed.setdefault(part, {})[name] = value / 1e3 if name.endswith("_m") else value
    parts = {part: replace(getattr(session, part), **numbers) for part, numbers in changed.items()}
    return replace(session, **parts)


def _make(folder: Path, progress: Progress) -> Path:
    from brdf_suite.acquisition.session.template import write_template

    report(progress, 0.0, tr("Reading {folder}").format(folder=folder.name))
    write_template(folder)
    return folder


def _simulate(folder: Path, progress: Progress) -> Path:
    """Write a simulated session and return its folder; one that was not finished is made anew."""
    from brdf_suite.acquisition.simulator import SimulatorSettings, simulate
    from brdf_suite.pipeline.material import load_material

    shutil.rmtree(folder, ignore_errors=True)
    report(progress, 0.0, tr("Simulating photographs"))
    paint = load_material(_SAMPLE_PAINT)
    size = (_SAMPLE_PX, _SAMPLE_PX)
    chosen = SimulatorSettings(size=size, positions=_SAMPLE_POSITIONS, exposures=_SAMPLE_EXPOSURES)
    simulate(
        paint.reflectance,
        folder,
        chosen,
        paint.name,
        lambda share, _what: progress(share, tr("Simulating photographs")),
    )
    return folder


def _open(folder: Path, progress: Progress) -> tuple[Path, Session, tuple[Problem, ...]]:
    from brdf_suite.acquisition.session.check import check_session

    report(progress, 0.0, tr("Reading {folder}").format(folder=folder.name))
    session = read_session(folder)
    problems = []
    for finding in check_session(folder, session, progress):
        path = Path(str(finding.path))
        name = path.relative_to(folder) if path.is_relative_to(folder) else finding.path
        problems.append(Problem(_SEVERITIES.get(finding.severity, "info"), str(name), finding.reason))
    return folder, session, tuple(problems)

"""Opening what is looked at: read on a thread, with progress and cancel, shown in the legend, remembered as recent."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.documents.projects import is_project
from brdf_qt.documents.recent_files import RecentFiles
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import tr
from brdf_qt.window.late_progress import LateProgress
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import DASHES, LINE_COLOURS, Dash, PlottedMaterial, Srgb
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.pipeline.material import ENTRY_MARK
from brdf_suite.progress import Progress
from brdf_suite.reflectance.material import Material
from brdf_suite.regular_files import is_file

if TYPE_CHECKING:
    from brdf_lobe_visualizer.subjects.sources import Opened


class Sources(Feature, QObject):
    """Opens names and files, any number at a time.

    Signals:

    - ``opened(asked, keys)``: what was asked is in the session, as subjects of these keys.
    - ``failed(asked)``: it could not be opened; the message is shown.
    - ``recent_changed()``: the recent files are others.
    - ``idle()``: all that was asked for is in the session, or has failed.
    - ``palette_opened(title, entries)``: a palette was read; ``entries`` are pairs of name and origin, each of
      which can be opened.
    """

    opened = Signal(str, object)
    failed = Signal(str)
    recent_changed = Signal()
    idle = Signal()
    palette_opened = Signal(str, object)

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        # Its own, so that a long fit keeps no file waiting; files are read at once, two at a time.
        self.tasks = TaskRunner(self)
        self._progress = LateProgress(window.progress, self)
        self._recent = RecentFiles("recent/files")
        self._numbers = count(1)
        self._waiting: dict[str, str] = {}
        self._turn: dict[str, int] = {}
        self._lines: dict[int, tuple[Srgb, Dash]] = {}
        self.open_project: Callable[[Path], bool] = lambda _path: False
        """Takes projects, and reports what is wrong with them."""

    @property
    def is_idle(self) -> bool:
        return not self.tasks.busy

    def open(self, asked: str | Path, *, remember: bool = True, select: bool = True) -> str:
        """Begin to open a name or a file, to come after the subjects that are there; return the key of the job.

        With ``select`` it is the one in front then.
        """
        name = str(asked)
        turn = next(self._numbers)
        job = f"open {turn}"
        self._waiting[job] = name
        # Chosen now, so that lines follow the order of what was asked for and not that of what was read first.
        self._lines[turn] = self.next_line()
        shown = Path(name.partition(ENTRY_MARK)[0]).name
        text = tr("Reading {name}").format(name=shown)
        moved = self._progress.begin(job, text, lambda: self._cancelled(job))

        def done(found: Opened) -> None:
            self._ended(job)
            self._take(name, found, turn, remember=remember, select=select)

        def failed(error: Exception) -> None:
            self._ended(job)
            todo = tr("The previous picture stays.")
            self._window.show_message(message_of(error, f"open {name}", todo=todo))
            self.failed.emit(name)
            self._look_idle()

        self.tasks.submit(job, _read, name, done, failed, moved)
        return job

    def open_many(self, asked: Iterable[str | Path]) -> None:
        """Begin to open several; the first of them is in front where nothing was."""
        names = [one for one in asked if not (is_project(one) and self.open_project(Path(one)))]
        nothing = not self._session.subjects
        for place, one in enumerate(names):
            self.open(one, select=len(names) == 1 or (nothing and place == 0))

    def add_representations(self, subject: PlottedMaterial) -> None:
        """Begin to fit the three compact representations of a subject, which come after the subjects that are there.

        They are fitted to the part of it that ``brdf-suite represent`` fits; each has a name of its own.
        """
        job = f"represent {subject.key}"
        text = tr("Fitting the representations of {name}").format(name=subject.title)
        moved = self._progress.begin(job, text, lambda: self._cancelled(job))

        def done(found: Sequence[PlottedMaterial]) -> None:
            self._ended(job)
            self._window.dismiss_message(job)
            for one in found:
                title = tr(one.title).format(name=subject.title)
                self.add(replace(one, title=title, material=replace(one.material, name=title)))
            self._look_idle()

        def failed(error: Exception) -> None:
            self._ended(job)
            self._window.show_message(message_of(error, job, todo=tr("The previous picture stays.")))
            self._look_idle()

        self.tasks.submit(job, _represent, subject.material, done, failed, moved)

    def add(self, subject: PlottedMaterial, turn: int | None = None) -> str:
        """Put a subject in the session, with a key and a line of its own; return the key.

        It comes last, or, with the ``turn`` in which it was asked for, before those that were asked for later: a large
        file that is read for longer keeps its place.
        """
        key = f"subject {next(self._numbers)}"
        chosen = None if turn is None else self._lines.pop(turn, None)
        colour, dash = chosen or self.next_line()
        subjects = list(self._session.subjects)
        place = len(subjects)
        if turn is not None:
            self._turn[key] = turn
            later = [i for i, s in enumerate(subjects) if self._turn.get(s.key, 0) > turn]
            place = later[0] if later else place
        subjects.insert(place, replace(subject, key=key, colour=colour, dash=dash))
        self._session.set_subjects(subjects)
        return key

    def find_plugin_models(self, take: Callable[[Sequence[tuple[str, str]]], None]) -> None:
        """Load the plug-ins that add models, on a thread, and hand on their titles and names."""

        def failed(error: Exception) -> None:
            self._window.show_message(message_of(error, "plug-ins"))

        self.tasks.submit("plug-ins", _plugin_models, None, take, failed)

    def note_saved(self, path: Path, key: str) -> None:
        """Take the file that a subject was saved to for the one that it was opened from."""
        self._recent.add(str(path))
        self.recent_changed.emit()
        self.opened.emit(str(path), [key])

    def next_line(self) -> tuple[Srgb, Dash]:
        """Return colour and dash that the fewest subjects have: each colour with a dash of its own first."""
        used = [(s.colour, s.dash) for s in self._session.subjects] + list(self._lines.values())
        places = [(turn, place) for turn in range(len(DASHES)) for place in range(len(LINE_COLOURS))]
        lines = [(LINE_COLOURS[place], DASHES[(place + turn) % len(DASHES)]) for turn, place in places]
        return min(lines, key=used.count)

    def recent(self) -> Sequence[Path]:
        """Return the files that were opened last and are still there, newest first."""
        return [Path(path) for path in self._recent.paths()]

    def clear_recent(self) -> None:
        self._recent.clear()
        self.recent_changed.emit()

    def close(self) -> None:
        self.tasks.stop()

    def _take(self, name: str, found: Opened, turn: int, *, remember: bool, select: bool) -> None:
        keys = [self.add(subject, turn) for subject in found.subjects]
        if keys and select:
            self._session.set_front(keys[0])
        if remember and is_file(name):
            self._recent.add(name)
            self.recent_changed.emit()
        if found.entries:
            self.palette_opened.emit(found.title, found.entries)
        self._report(name, found, len(keys))
        self.opened.emit(name, keys)
        self._look_idle()

    def _report(self, name: str, found: Opened, shown: int) -> None:
        key = f"open {name}"
        self._window.dismiss_message(key)
        noted = " ".join(map(tr_core, found.notes))
        more = ""
        if shown + len(found.refused) < len(found.entries):
            more = tr("The others are listed in the panel Reflectances (Ctrl+Shift+B).")
        if found.refused:
            text = tr("{count} entries of {title} cannot be shown.")
            what = text.format(count=len(found.refused), title=found.title)
            where = " ".join(map(tr_core, (found.refused[0], *found.notes)))
            self._window.show_message(Message(key, what, where=where, todo=more, severity="warning"))
        elif shown < len(found.entries):
            text = tr("{title} has {count} paints; the first {shown} are shown.")
            what = text.format(title=found.title, count=len(found.entries), shown=shown)
            self._window.show_message(Message(key, what, where=noted, todo=more))
        elif noted:
            what = tr("{title} imported with notes.").format(title=found.title)
            self._window.show_message(Message(key, what, where=noted))

    def _cancelled(self, job: str) -> None:
        name = self._waiting.get(job, "")
        self._ended(job)
        self.tasks.cancel(job)
        self.failed.emit(name)
        self._look_idle()

    def _look_idle(self) -> None:
        if not self._waiting:
            self._lines.clear()
            self.idle.emit()

    def _ended(self, job: str) -> None:
        self._waiting.pop(job, None)
        self._progress.end(job)


def _represent(material: Material, progress: Progress) -> Sequence[PlottedMaterial]:
    # Deferred: with it come all the fits.
    from brdf_lobe_visualizer.subjects.representations import represent

    return represent(material, progress)


def _plugin_models(_request: None, _progress: Progress) -> Sequence[tuple[str, str]]:
    found: Sequence[tuple[str, str]] = _sources().plugin_models()
    return found


def _read(name: str, progress: Progress) -> Opened:
    found: Opened = _sources().open_source(name, progress)
    return found


def _sources() -> Any:
    # Deferred: with it come the tables and models, which the window does not need to be shown.
    from brdf_lobe_visualizer.subjects import sources

    return sources

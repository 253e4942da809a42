"""Joins the way between two paints to the paint session: from the paint as it was when the other one was chosen."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from pathlib import Path

from brdf_qt.choosing.thumbnails import USUAL_LOOK, thumbnail
from brdf_qt.program.feature import Feature
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.from_measurement.section import standard_patterns
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.variations.interpolation_section import FILE, STOPS, InterpolationSection
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError
from brdf_suite.paint_design.mix import mixed, second_end
from brdf_suite.paint_design.standard import Standard
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.pipeline.material import load_shipped_paint, paint_names
from brdf_suite.progress import Progress

KEY = "interpolation"
STEP = mark("Interpolate")
_TAB, _SHIPPED = "tab ", "shipped "
MOST_MADE = 2000


@dataclass
class _Way:
    """Both ends, read at the same angles; ``made`` are the paints that were put between them, by share."""

    first: Paint
    second: Paint
    made: deque[tuple[Paint, float]]
    share: float = 0.0


class InterpolationControl(Feature, QObject):
    """The way of the document in front; another document, or an edit of any other kind, begins it anew."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session = session
        self._pictures = window.pictures
        self._tasks = TaskRunner(self, threads=1)
        self._way: _Way | None = None
        self._chosen = ""
        self._file: Standard | None = None
        self.section = InterpolationSection()
        self.host = window.add_section(
            KEY, tr("Interpolate"), self.section, tab="compare", more=True, is_open=False
        )
        section = self.section
        section.other_chosen.connect(self.choose)
        section.share_edited.connect(self.set_share)
        section.gesture_started.connect(session.begin_gesture)
        section.gesture_finished.connect(session.end_gesture)
        section.stop_taken.connect(self.take)
        self.host.seen.connect(self._list_later)
        session.paint_changed.connect(self._paint_changed)
        session.document_switched.connect(self._forget)
        session.documents.row_changed.connect(self._list_later)
        self._pictures.arrived.connect(lambda _keys: self._show_pictures())
        self._list_later()

    @property
    def share(self) -> float | None:
        """How far on the way the paint is; ``None`` while there is no way."""
        return None if self._way is None else self._way.share

    def choose(self, key: str) -> None:
        """Take the paint of that key as the other end: an open tab, a shipped paint, or a file that is asked for."""
        if key == FILE:
            named = tr("Paints and measured files ({patterns})").format(patterns=standard_patterns())
            if (path := self._session.documents.ask(named)) is not None:
                self.load(path)
            else:
                self._list()
            return
        try:
            if key.startswith(_SHIPPED):
                other = load_shipped_paint(key.removeprefix(_SHIPPED))
            else:
                number = int(key.removeprefix(_TAB))
                other = next(one.store.value for one in self._session.documents.row if one.key == number)
            self._begin(key, other)
        except SuiteError as error:
            self._report(error)

    def load(self, name_or_path: str | Path) -> None:
        """Take the first paint in a file, or what is measured there, as the other end."""
        self._tasks.submit(KEY, _load, name_or_path, self._loaded, self._report)

    def set_share(self, share: float) -> None:
        """Make the paint the one at ``share`` of the way; part of the running gesture."""
        way = self._way
        if way is None:
            return
        paint = way.first if share == 0.0 else mixed(way.first, way.second, share, way.first.name)
        way.made.append((paint, share))
        self._session.set_paint(paint, tr(STEP))

    def take(self, share: float) -> None:
        """Go to ``share`` at once, as one step."""
        self.section.show_share(share)
        self.set_share(share)
        self._session.end_gesture()

    def close(self) -> None:
        """End the thread."""
        self._tasks.stop()

    def _begin(self, key: str, other: Paint | Standard) -> None:
        first = self._session.paint
        second = second_end(first, other)
        self._session.dismiss_message(KEY)
        self._chosen = key
        self._way = _Way(first, second, deque([(first, 0.0)], MOST_MADE))
        self.section.show_ends(first.name, second.name)
        self.section.show_share(0.0)
        self._pictures.request(KEY, self._stops(), USUAL_LOOK)
        self._show_pictures()

    def _loaded(self, found: Standard) -> None:
        self._file = found
        try:
            self._begin(FILE, found)
        except SuiteError as error:
            self._report(error)
        self._list()

    def _report(self, error: Exception) -> None:
        self._session.show_message(
            message_of(error, KEY, todo=tr("Choose a different paint for the other end."))
        )
        self._list()

    def _paint_changed(self, paint: Paint) -> None:
        way = self._way
        if way is None:
            return
        # The very objects: undo and redo put them back, and the slider goes with them.
        for made, share in reversed(way.made):
            if made is paint:
                way.share = share
                self.section.show_share(share)
                return
        self._forget()

    def _forget(self) -> None:
        if self._way is not None:
            self._way, self._chosen = None, ""
            self.section.show_ends(None)
            self._list_later()

    # Showing.

    def _list_later(self) -> None:
        if self.host.is_seen:
            self._session.at_idle(KEY, self._list)

    def _list(self) -> None:
        documents = self._session.documents
        tabs = [(f"{_TAB}{one.key}", one.title) for one in documents.row if one is not documents.front]
        shipped = [(f"{_SHIPPED}{name}", title_of(name)) for name in paint_names()]
        file_title = tr("From a file…")
        if self._chosen == FILE and self._file is not None:
            file_title = tr("{name}, from a file…").format(name=self._file.name)
        line = ("", "")
        entries = [*tabs, *([line] if tabs else []), (FILE, file_title), line, *shipped]
        self.section.show_others(entries, self._chosen)

    def _stops(self) -> list[Paint]:
        way = self._way
        return [] if way is None else [mixed(way.first, way.second, stop) for stop in STOPS]

    def _show_pictures(self) -> None:
        if self.host.is_seen:
            for place, paint in enumerate(self._stops()):
                self.section.stops[place].show_picture(thumbnail(self._pictures, paint))


def _load(name_or_path: str | Path, progress: Progress) -> Standard:
    return load_standards(name_or_path, progress)[0]

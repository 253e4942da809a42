"""What the paint can reach at the reading that is edited: worked out on a thread once the edits pause."""

from __future__ import annotations

from typing import NamedTuple

from brdf_qt.program.feature import Feature
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow
from brdf_suite.paint_design.colour_plane import ReachableBox, reachable_box
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.progress import Progress

KEY = "reachable colours"


class _Request(NamedTuple):
    fit: LobeFit
    reading: int


class ReachControl(Feature, QObject):
    """Hands the plane what is reachable; during a drag of the reading that stays as it was."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session, self._plane = session, window.editors.plane
        self._section = window.section("colour")
        self._tasks = TaskRunner(self, threads=1)
        session.fit_changed.connect(self._later)
        session.gesture_ended.connect(self._later)
        session.document_switched.connect(lambda: self._plane.show_reachable(None))
        session.refused.connect(lambda _error: self._plane.show_reachable(None))
        self._plane.index_chosen.connect(self._later)
        self._section.seen.connect(self._later)

    @property
    def is_idle(self) -> bool:
        """Whether the plane shows what is reachable, with all of it drawn."""
        return not self._tasks.busy and self._plane.is_idle

    def close(self) -> None:
        """End the thread."""
        self._tasks.stop()

    def _later(self, *_: object) -> None:
        if self._plane.isVisible():
            self._session.at_idle(KEY, self._search)

    def _search(self) -> None:
        fit = self._session.fit
        if fit is not None and not self._session.in_gesture:
            request = _Request(fit, self._plane.index)
            self._tasks.submit(KEY, _reach, request, self._plane.show_reachable, _raise)


def _reach(request: _Request, _progress: Progress) -> ReachableBox | None:
    return reachable_box(*request)


def _raise(error: Exception) -> None:
    raise error  # no file and no user's value is met there: a fault of ours, which the program reports

"""Reads one position's photographs at a time, for the pages that show them."""

from __future__ import annotations

from brdf_qt.program.translation import tr
from PySide6.QtCore import QObject

from brdf_designer.acquire.exposures.page import ExposuresPage
from brdf_designer.acquire.exposures.work import read_series_state
from brdf_designer.acquire.reconstruction_session import ReconstructionSession
from brdf_designer.acquire.session.control import SessionControl
from brdf_designer.acquire.states import Series

_KEPT = 2
"""Positions whose photographs stay in memory: 16 of a megapixel are about 110 MB."""


class SeriesControl(QObject):
    """Joins the page of the exposures to the workbench; the session's page shows one of them."""

    def __init__(self, bench: ReconstructionSession, page: ExposuresPage, sessions: SessionControl) -> None:
        super().__init__(bench)
        self._bench, self._page, self._sessions = bench, page, sessions
        self._kept: dict[int, Series] = {}
        page.position_chosen.connect(self.show)
        bench.opened.connect(self._opened)

    def show(self, position: int) -> None:
        """Read a position's photographs, and show them; nothing is read twice."""
        bench = self._bench
        if bench.session is None or bench.folder is None:
            return
        if position in self._kept:
            bench.cancel("series")
            self._page.show_series(self._kept[position])
            return
        bench.run(
            "series", read_series_state, (bench.folder, bench.session, position), self._read, beside=True
        )

    def _opened(self) -> None:
        self._kept.clear()
        session = self._bench.session
        if session is None:
            self._page.show_positions(())
            self._page.show_series(None)
            return
        angles = tuple(position.angle_deg for position in session.positions)
        # The position that stands for all: the highlight is on the sphere, and the flank is lit.
        first = min(range(len(angles)), key=lambda k: abs(angles[k] - 60.0))
        self._page.show_positions(angles, first)
        self.show(first)

    def _read(self, series: Series) -> None:
        self._kept[series.position] = series
        for old in list(self._kept)[:-_KEPT]:
            del self._kept[old]
        self._page.show_series(series)
        if len(self._kept) == 1:
            self._sessions.show_series(series)
        differing = self._page.differing
        text = tr("{count} times differ").format(count=differing) if differing else ""
        worst = bool(differing or series.problems)
        self._bench.window.show_step("exposures", "warning" if worst else "done", text)

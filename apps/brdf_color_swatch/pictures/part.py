"""Joins the panes with the pictures: requests pictures of visible swatches and paints those that arrive."""

from __future__ import annotations

from functools import partial

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import QTimer

from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import Look
from brdf_color_swatch.pictures.pictures import Pictures
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Entry

_SOON_MS = 30
"""After the last step of a scroll; what only flies by is not drawn."""


class PicturePart(SwatchFeature):
    """Owns the pictures."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self.is_started = False
        self.pictures = Pictures(window)
        self._soon = QTimer(window)
        self._soon.setSingleShot(True)
        self._soon.setInterval(_SOON_MS)
        self._soon.timeout.connect(self._request_visible)
        window.picture_of = self._picture
        for pane in window.panes:
            pane.grid.stale = partial(self._is_stale, pane.number)
            pane.seen_changed.connect(self._schedule_request)
        session.shown_changed.connect(lambda _pane: self._schedule_request())
        session.look_changed.connect(self._apply_look)
        self.pictures.arrived.connect(self._arrived)
        self.pictures.waiting_changed.connect(self._show_pending)
        self.pictures.unavailable.connect(self._unavailable)

    def start(self) -> None:
        """Begin to draw, once the window is there."""
        self.is_started = True
        self._apply_look(None, self._session.look)

    @property
    def is_idle(self) -> bool:
        """Whether the picture of everything that is seen is there."""
        return self.is_started and not self._soon.isActive() and not self.pictures.waiting

    def close(self) -> None:
        """End the process that draws."""
        self.pictures.close()

    def _entry(self, number: int, row: int) -> Entry:
        return self._window.panes[number].model.entry_at(row)

    def _picture(self, number: int, row: int) -> object:
        return self.pictures.picture(self._entry(number, row))

    def _is_stale(self, number: int, row: int) -> bool:
        return self.pictures.is_stale(self._entry(number, row))

    def _schedule_request(self) -> None:
        if self.is_started and not self._soon.isActive():
            self._soon.start()

    def _apply_look(self, _old: Look | None, look: Look) -> None:
        if not self.is_started or look.form == "chips" or look.as_list:
            return
        before = self.pictures.problem
        self.pictures.set_look(look.form, look.booth, look.size, self._window.devicePixelRatioF())
        if before and not self.pictures.problem:
            self._window.dismiss_message("pictures")
        self._soon.start()

    def _request_visible(self) -> None:
        look = self._session.look
        if look.form == "chips" or look.as_list:
            self.pictures.request([])
            return
        visible: list[Entry] = []
        margin: list[Entry] = []
        for pane in self._window.panes:
            if pane.isHidden() or pane.note:
                continue
            seen = pane.grid.seen()
            visible += [pane.model.entry_at(row) for row in seen]
            around = set(pane.grid.seen(pane.grid.viewport().height())) - set(seen)
            margin += [pane.model.entry_at(row) for row in sorted(around)]
        self.pictures.request([*visible, *margin])

    def _arrived(self, ids: set[str]) -> None:
        for pane in self._window.panes:
            if not pane.isHidden():
                rows = [row for row in pane.grid.seen() if pane.model.id_at(row) in ids]
                pane.grid.refresh_rows(rows)

    def _show_pending(self, count: int) -> None:
        cell = self._window.picture_cell
        cell.set(
            tr("{count} pictures pending").format(count=count) if count else "",
            state="stale" if count else "fresh",
        )

    def _unavailable(self, why: str) -> None:
        for pane in self._window.panes:
            pane.grid.viewport().update()
        self._window.show_message(
            Message(
                "pictures",
                tr("The swatches cannot be rendered here."),
                where=why,
                todo=tr("Measured colours are shown instead; everything else works."),
                severity="warning",
            )
        )

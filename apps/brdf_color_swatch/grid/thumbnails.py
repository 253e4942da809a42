"""Joins the panes with the pictures: requests pictures of visible swatches and paints those that arrive."""

from __future__ import annotations

from functools import partial

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message
from brdf_qt.work.timer import make_timer
from PySide6.QtGui import QPixmap

from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import Look
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.palettes.swatches.look import Content, SwatchLook

LADDER = (32, 48, 64, 96, 128, 192, 256, 320, 384, 512)
"""Sizes that are drawn: a drag of the size slider scales what is there, and draws at few of its steps."""
_SOON_MS = 30
"""After the last step of a scroll; what only flies by is not drawn."""


class VisiblePictures(SwatchFeature):
    """Requests the pictures of what is seen, and ends the process that draws them."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self.is_started = False
        self.pictures = window.pictures
        self.look: SwatchLook | None = None
        """What is drawn; None before the first form other than chips."""
        self._soon = make_timer(window, self._request_visible, _SOON_MS)
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

    def _content(self, number: int, row: int) -> Content:
        return self._window.panes[number].model.entry_at(row).content

    def _picture(self, number: int, row: int) -> QPixmap | None:
        """Return a picture; the one of the look before while the new one is not there."""
        if self.look is None:
            return None
        content = self._content(number, row)
        return self.pictures.picture(content, self.look) or self.pictures.latest(content)

    def _is_stale(self, number: int, row: int) -> bool:
        return self.look is None or not self.pictures.is_settled(self._content(number, row), self.look)

    def _schedule_request(self) -> None:
        if self.is_started and not self._soon.isActive():
            self._soon.start()

    def _apply_look(self, _old: Look | None, look: Look) -> None:
        if not self.is_started or look.form == "chips" or look.as_list:
            return
        wanted = round(look.size * self._window.devicePixelRatioF())
        drawn = next((step for step in LADDER if step >= wanted), LADDER[-1])
        new = SwatchLook(form=look.form, environment=look.booth, size=drawn)
        if new != self.look:
            before, self.look = self.look, new
            if before is None or (before.form, before.environment) != (new.form, new.environment):
                self._window.dismiss_message("pictures")
        self._soon.start()

    def _request_visible(self) -> None:
        look = self._session.look
        if self.look is None:
            return
        if look.form == "chips" or look.as_list:
            self.pictures.request("panes", [], self.look)
            return
        visible: list[Content] = []
        margin: list[Content] = []
        for pane in self._window.panes:
            if pane.isHidden() or pane.note:
                continue
            seen = pane.grid.seen()
            visible += [pane.model.entry_at(row).content for row in seen]
            around = set(pane.grid.seen(pane.grid.viewport().height())) - set(seen)
            margin += [pane.model.entry_at(row).content for row in sorted(around)]
        ratio = self._window.devicePixelRatioF()
        self.pictures.request("panes", [*visible, *margin], self.look, look.size, ratio)

    def _arrived(self, keys: set[str]) -> None:
        for pane in self._window.panes:
            if self.look is not None and not pane.isHidden():
                contents = ((row, self._content(pane.number, row)) for row in pane.grid.seen())
                rows = [row for row, content in contents if self.pictures.key(content, self.look) in keys]
                pane.grid.refresh_rows(rows)

    def _show_pending(self, count: int) -> None:
        cell = self._window.picture_cell
        cell.set(
            tr("{count} pictures pending").format(count=count) if count else "",
            state="stale" if count else "fresh",
        )

    def _unavailable(self, _look: SwatchLook, why: str) -> None:
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

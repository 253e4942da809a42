"""The live link: send a paint to the other programs, started where they are not there; take the paint being edited."""

from __future__ import annotations

import time
from dataclasses import replace
from functools import partial
from typing import Any

from brdf_qt.link.link import LiveLink
from brdf_qt.link.messages import OFFER
from brdf_qt.program.suite import MEMBERS, connected_words, start_member
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import Message, Severity

from brdf_color_swatch.editing.entry_edits import add_entries
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import Near
from brdf_color_swatch.search.colour_search import near_of
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Palette, new_id
from brdf_suite.documents.store import paint_from_json, paint_to_json

_SENT = {
    "designer": (mark("Send to &Designer"), "send_designer"),
    "viewer": (mark("Send to &Viewer"), "send_viewer"),
    "lobes": (mark("Send to &Lobe Visualizer"), "send_lobes"),
}


class PaintExchange(SwatchFeature):
    """Commands of the live link."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self.edited: Paint | None = None
        self.link = LiveLink("swatch", parent=window)
        self.start_program = start_member
        """Starts a program by its role; replaced where none is to be started."""
        add = window.add_command
        window.menus["paint"].addSeparator()
        self._sends = []
        for role, (text, keys) in _SENT.items():
            icon = MEMBERS[role].icon
            action = add("paint", text, keys, partial(self.send, role), f"to_{role}", icon=icon)
            self._sends.append(action)
        window.menus["paint"].addSeparator()
        self._take = add(
            "paint", mark("&Add Paint from Designer"), "take_paint", self.take, "take", icon="download-simple",
            tip=mark("Add the paint being edited in Designer to this palette"),
        )  # fmt: skip
        self._near = add(
            "paint", mark("Find Nearest to &Designer's Paint"), None, self.find, "nearest_edited"
        )
        window.toolbar.addAction(self._take)
        for pane in window.panes:
            pane.opened.connect(lambda _id: self.send("designer"))
            pane.action_requested.connect(lambda key: self.take() if key == "take" else None)
        self.link.received.connect(self._received)
        self.link.peers_changed.connect(lambda _count: self._show_peers())
        self._enable_always()
        self._show_peers()

    def send(self, role: str) -> None:
        """Send the selected paint to a program; it is started where it is not there."""
        entries = self._session.selected_entries
        if not entries:
            return
        paint = to_paint(entries[0].content)
        name = MEMBERS[role].name
        if not isinstance(paint, Paint):
            text = tr("“{paint}” consists of Cook-Torrance lobes; the live link sends designed paints only.")
            todo = tr("Open its file in {program}.").format(program=name)
            self._show_message("send", text.format(paint=paint.name), todo, "warning")
            return
        if role == "designer":
            # As a document of its own: what is edited there must not be replaced.
            self.link.publish(OFFER, {"to": role, "time": time.time(), "paint": paint_to_json(paint)})
        else:
            self.link.publish("paint", paint_to_json(paint))
        if role in self.link.peers:
            self._window.dismiss_message("send")
            return
        if self.start_program(role):
            text = tr("Starting {program} with “{paint}”.").format(program=name, paint=paint.name)
            self._show_message("send", text)
        else:
            text = tr("{program} could not be started.").format(program=name)
            todo = tr("Start it manually; the paint is then sent to it.")
            self._show_message("send", text, todo, "warning")

    def _show_message(self, key: str, text: str, todo: str = "", severity: Severity = "info") -> None:
        self._window.show_message(Message(key, text, todo=todo, severity=severity))

    def take(self) -> None:
        """Put the paint being edited into the palette in front."""
        if self.edited is None:
            self._report_no_paint()
            return
        if self._session.palette is None or self._session.is_read_only:
            self._session.show_new(Palette(tr("Untitled")))
        entry = Entry(self.edited, id=new_id())
        add_entries(self._session, tr("Add “{paint}”").format(paint=entry.name[:40]), [entry])

    def find(self) -> None:
        """Order the pane by the difference to the paint being edited."""
        if self.edited is None:
            self._report_no_paint()
            return
        near: Near = near_of(Entry(self.edited, id="edited"))
        self._session.set_state(replace(self._session.state, near=near, duplicates=None, sort="nearest"))

    def _report_no_paint(self) -> None:
        todo = tr("Open a paint in Designer, then try again.")
        self._show_message("take", tr("No paint is being edited."), todo)

    def _received(self, topic: str, value: dict[str, Any]) -> None:
        if topic == "paint":
            self.edited = paint_from_json(value, "the live link")
            self._window.dismiss_message("take")
            self._show_peers()

    def _show_peers(self) -> None:
        text = connected_words(self.link.peers)
        if self.edited is not None:
            text = tr("{link} · in Designer: {paint}").format(link=text, paint=self.edited.name[:40])
        self._window.link_cell.set(text)

    def _enable(self) -> None:
        one = bool(self._session.selected)
        for action in self._sends:
            action.setEnabled(one)

"""The history of the paint in front: shown as a strip, gone back to by a click; nothing of it is lost by going back."""

from __future__ import annotations

from functools import partial

from brdf_qt.choosing.thumbnails import USUAL_LOOK, thumbnail
from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QObject, QPoint
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QMenu

from brdf_designer.history.strip import HistoryState, HistoryStrip
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow

_OWNER = "history"
LOW_WINDOW = 760
"""Below this height of the window, pixels, the strip gives way to the plots."""


class HistoryControl(Feature, QObject):
    """Joins the strip to the paint session. Pictures are requested between gestures, the present state's first."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session = session
        self._pictures = window.pictures
        self.strip = HistoryStrip(partial(thumbnail, self._pictures))
        self.drawer = window.add_drawer(
            "history",
            tr("History"),
            self.strip,
            "bottom",
            "history",
            "clock-counter-clockwise",
            tr("Show or hide the history of this paint"),
        )
        self.drawer.toggled.connect(self._later)
        self.strip.chosen.connect(session.go_to)
        self.strip.menu_requested.connect(self._open_menu)
        session.paint_changed.connect(self._later)
        session.history_changed.connect(self._later)
        session.gesture_ended.connect(self._later)
        self._pictures.arrived.connect(lambda _keys: self.strip.redraw())
        window.installEventFilter(self)
        self._later()

    @property
    def is_idle(self) -> bool:
        """Whether every picture in sight is drawn, or none can be."""
        settled = (self._pictures.is_settled(state.paint, USUAL_LOOK) for state in self.strip.states.states)
        return not self.strip.isVisible() or all(settled)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Make the strip low in a low window."""
        if event.type() == QEvent.Type.Resize and isinstance(event, QResizeEvent):
            self.strip.set_compact(event.size().height() < LOW_WINDOW)
        return super().eventFilter(watched, event)

    def refresh(self) -> None:
        """Show the history as it is now; nothing while the strip is hidden, also where it was asked for before."""
        if not self.drawer.is_open:
            return
        store = self._session.documents.front.store
        states = [HistoryState(step, paint) for step, paint in store.states()]
        present = store.stack.index()
        self.strip.show_states(states, present)
        if not self._session.in_gesture:
            near = sorted(range(len(states)), key=lambda place: abs(place - present))
            self._pictures.request(_OWNER, [states[place].paint for place in near], USUAL_LOOK)

    def _later(self, *_: object) -> None:
        if self.drawer.is_open:
            self._session.at_idle(_OWNER, self.refresh)

    def _open_menu(self, place: int, where: QPoint) -> None:
        menu = self.menu_of(place)
        menu.exec(where)
        menu.deleteLater()

    def menu_of(self, place: int) -> QMenu:
        """Return what can be done with the state at ``place``."""
        paint = self.strip.states.states[place].paint
        menu = QMenu(self.strip)
        menu.addAction(tr("&Go to This State"), lambda: self._session.go_to(place))
        menu.addAction(
            tr("&Restore as New Step"), lambda: self._session.set_paint(paint, tr("Restore Earlier State"))
        )
        menu.addAction(tr("&Open in New Tab"), lambda: self._session.open_paint(paint))
        return menu

"""Which reflectances are open, kept while the program runs: after a kill they can be opened again."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from brdf_qt.documents.open_tabs import OpenTab, TabsLeft, TabsRecord
from brdf_qt.program.feature import Feature
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message
from PySide6.QtCore import QObject, Qt

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.sources_control import Sources
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.pipeline.material import ENTRY_MARK

_MOST_NAMED = 8


class Reopening(Feature, QObject):
    """Records what was opened by name or from a file, in the order of the legend, and offers it after a kill.

    ``drop_default`` takes the paint of an empty start away, whose origin is ``default``: alone it is no work.
    """

    def __init__(
        self, session: LobeSession, window: LobeWindow, sources: Sources, drop_default: Callable[[], object]
    ) -> None:
        super().__init__(window)
        self._session, self._window, self._sources = session, window, sources
        self._drop_default = drop_default
        self._origins: dict[str, str] = {}
        self.default = ""
        self.record = TabsRecord(self._open_tabs, self)
        sources.opened.connect(self._opened)
        for changed in (session.subjects_changed, session.front_changed):
            changed.connect(self.record.note)
        window.close_requested.connect(lambda _question: self.record.close(keep=False))

    def start(self) -> None:
        """Offer what was open when a run was ended."""
        left = self.record.left()
        if left is None:
            return
        asked = [tab.source for tab in left.tabs if tab.source]
        if not [one for one in asked if one != self.default]:
            self.record.drop(left)
            return
        names = [tr("“{name}”").format(name=title_of(one.partition(ENTRY_MARK)[0])) for one in asked]
        if len(names) > _MOST_NAMED:
            more = tr("{count} more").format(count=len(names) - _MOST_NAMED + 1)
            names = [*names[: _MOST_NAMED - 1], more]
        text = tr("Lobe Visualizer closed unexpectedly. Reopen the reflectances that were open: {names}?")
        actions = (
            (tr("Reopen"), lambda: self._reopen(left, asked)),
            (tr("Discard"), lambda: self.record.drop(left)),
        )
        self._window.show_message(Message("recovery", text.format(names=", ".join(names)), actions=actions))

    def close(self) -> None:
        """Leave the record for the next start, where the program has to end."""
        self.record.close(keep=True)

    def _reopen(self, left: TabsLeft, asked: Sequence[str]) -> None:
        self.record.drop(left)
        front = left.tabs[left.front].source if 0 <= left.front < len(left.tabs) else ""
        self._sources.idle.connect(lambda: self._show_front(front), Qt.ConnectionType.SingleShotConnection)
        self._sources.open_many(asked)

    def _show_front(self, origin: str) -> None:
        """Once all is read: the paint of the empty start too, which may have come last."""
        self._drop_default()
        key = next((key for key, known in self._origins.items() if known == origin), "")
        self._session.set_front(key)

    def _opened(self, asked: str, keys: Sequence[str]) -> None:
        for key in keys:
            subject = self._session.subject(key)
            origin = "" if subject is None else subject.material.origin
            self._origins[key] = origin if ENTRY_MARK in origin else asked
        self.record.note()

    def _open_tabs(self) -> tuple[list[OpenTab], int]:
        subjects = [one for one in self._session.subjects if one.key in self._origins]
        self._origins = {one.key: self._origins[one.key] for one in subjects}
        front = self._session.front
        place = next((place for place, one in enumerate(subjects) if one is front), 0)
        return [OpenTab(None, source=self._origins[one.key]) for one in subjects], place

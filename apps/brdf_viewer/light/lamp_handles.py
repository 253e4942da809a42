"""Lamps as handles in Viewer's picture: shown while the tab of the light is open, unless they are put away."""

from __future__ import annotations

from brdf_qt.gl.lamp_handles import LampHandles, SeenPlace
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.overlay.seen_parts import SeenParts
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

_KEY = "lamp_handles"


class LampControl(ViewerFeature):
    """The lamps of the view as a scene of handles: chosen in the tab, changed as steps of the history."""

    def __init__(self, state: ViewerState, window: ViewerWindow, seen: SeenParts) -> None:
        super().__init__(state, window)
        self._seen = seen
        self._fields = window.lighting.lamps
        self.handles = LampHandles(window.picture, self)
        kept = bool(settings().value(_KEY, True, type=bool))
        add = window.add_command
        tip = mark(
            "Lamps as handles in the picture while their settings are in sight; drag one to move its lamp"
        )
        self.shown = add(
            "view", mark("&Lamps in the Picture"), _KEY, self._toggle, _KEY, tip=tip, checked=kept
        )
        tip = mark("The next click on the surface moves the lamp to where its reflection is seen there")
        self.asking = add(
            "view",
            mark("Put the &Highlight Here"),
            "put_highlight",
            self.handles.ask,
            "put_highlight",
            tip=tip,
            checked=False,
        )
        for action in (self.shown, self.asking):
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            window.picture.addAction(action)
        self._fields.highlight.clicked.connect(self.handles.ask)
        self.handles.asking.connect(self.asking.setChecked)
        self.handles.asking.connect(self._fields.highlight.setChecked)
        self._fields.list.currentIndexChanged.connect(lambda _index: self.handles.show())
        window.panel.pages["light"].installEventFilter(self)
        state.view_changed.connect(self.handles.follow_view)
        state.contents_changed.connect(self.handles.show)
        self.handles.show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Show, QEvent.Type.Hide):
            self.handles.show()
        return super().eventFilter(watched, event)

    def _toggle(self, on: bool) -> None:
        settings().setValue(_KEY, on)
        self.handles.show()

    # The scene of the handles.

    @property
    def view(self) -> View:
        return self._state.view

    @property
    def chosen(self) -> int:
        return self._fields.list.currentIndex()

    @property
    def wants_handles(self) -> bool:
        in_sight = self._window.panel.pages["light"].isVisible()
        return self.shown.isChecked() and in_sight and self._state.surface is not None

    @property
    def box(self) -> QRectF:
        return self._seen.boxes[0]

    def seen_at(self, place: QPointF) -> SeenPlace | None:
        hit = self._seen.hit_at(place)
        return None if hit is None else SeenPlace(hit.position, hit.normal, self._seen.ray_at(place)[0])

    def choose(self, index: int) -> None:
        self._fields.choose(index)

    def begin_drag(self) -> None:
        self._state.history.begin()

    def end_drag(self) -> None:
        self._state.history.end()

    def set_lamps(self, lamps: tuple[Lamp, ...]) -> None:
        self._state.change_view(lamps=lamps)

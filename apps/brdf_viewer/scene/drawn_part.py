"""A part of the Viewer that works on the viewer state, on the window, and with what draws in it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject

from brdf_viewer.scene.drawing import SceneDrawer
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

FindDrawer = Callable[[], SceneDrawer | None]
"""Returns what draws at present; None while nothing does: a lost context gets a new one."""


class DrawnPart(QObject):
    """Keeps state, window and the way to what draws; a part connects itself in :meth:`_set_up`."""

    def __init__(
        self, state: ViewerState, window: ViewerWindow, drawer: FindDrawer, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._state, self._window, self._drawer = state, window, drawer
        self._set_up()

    def _set_up(self) -> None:
        raise NotImplementedError

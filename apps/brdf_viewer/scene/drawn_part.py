"""A part of the Viewer that works on the stage, on the window, and with what draws in it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject

from brdf_viewer.scene.drawing import StageDrawer
from brdf_viewer.scene.stage import Stage
from brdf_viewer.window import ViewerWindow

FindDrawer = Callable[[], StageDrawer | None]
"""Returns what draws at present; None while nothing does: a lost context gets a new one."""


class DrawnPart(QObject):
    """Keeps stage, window and the way to what draws; a part connects itself in :meth:`_set_up`."""

    def __init__(
        self, stage: Stage, window: ViewerWindow, drawer: FindDrawer, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._stage, self._window, self._drawer = stage, window, drawer
        self._set_up()

    def _set_up(self) -> None:
        raise NotImplementedError

"""What every feature of the Viewer has: its state and its window."""

from __future__ import annotations

from brdf_qt.program.feature import Feature
from PySide6.QtCore import QObject

from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow


class ViewerFeature(Feature, QObject):
    """One feature of the Viewer, which connects its part of the window with the viewer state when it is made."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(window)
        self._state, self._window = state, window

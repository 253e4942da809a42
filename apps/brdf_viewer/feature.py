"""The interface between the Viewer and its features."""

from __future__ import annotations

from PySide6.QtCore import QObject

from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow


class ViewerFeature(QObject):
    """One feature of the Viewer, which connects its part of the window with the viewer state when it is made."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(window)
        self._state, self._window = state, window

    def start(self) -> None:
        """Begin what needs the other features, as loading does; called once, when all are made."""

    @property
    def is_idle(self) -> bool:
        """Whether nothing that the picture shows is pending."""
        return True

    def run_script(self, _key: str, _value: str, /) -> bool:
        """Set an option by its key and value, for runs without a user; False where the feature has no such option."""
        return False

    def close(self) -> None:
        """End timers, threads and processes; called once, as the window closes."""

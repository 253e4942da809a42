"""The base of the program's features."""

from __future__ import annotations

from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow


class Feature:
    """Adds commands and panels to the window, and keeps them in step with the session."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        self._session, self._window = session, window

    def start(self) -> None:
        """Begin what can wait until the window is painted."""

    @property
    def is_idle(self) -> bool:
        """Whether no work of the feature is pending."""
        return True

    def run_script(self, key: str, value: str) -> bool:  # noqa: ARG002 - features override it
        """Set a value by a script; False where the feature does not know the key."""
        return False

    def close(self) -> None:
        """End threads, processes and connections."""

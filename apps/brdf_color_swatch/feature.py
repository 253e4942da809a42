"""The base of Color Swatch's features."""

from __future__ import annotations

from brdf_qt.program.feature import Feature

from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow


class SwatchFeature(Feature):
    """Adds commands and panels to the window, and keeps them in step with the session."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        self._session, self._window = session, window

    def _enable_always(self) -> None:
        """Call :meth:`_enable` now and whenever the session shows or selects something else."""
        session = self._session
        for signal in (session.shown_changed, session.selection_changed, session.state_changed):
            signal.connect(lambda _pane: self._enable())
        session.front_changed.connect(self._enable)
        self._enable()

    def _enable(self) -> None:
        """Enable the commands that can be done."""

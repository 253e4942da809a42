"""The base of Color Swatch's features."""

from __future__ import annotations

from brdf_qt.program.feature import Feature

from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow


class SwatchFeature(Feature):
    """Adds commands and panels to the window, and keeps them in step with the session."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        self._session, self._window = session, window

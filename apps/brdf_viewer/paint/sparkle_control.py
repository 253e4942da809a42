"""The sparkle section: its edits go into the view, and it shows the view's and the paint's values."""

from __future__ import annotations

import dataclasses
from typing import Any

from brdf_suite.documents.view import View
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow


class SparkleControl(ViewerFeature):
    """Keeps section, commands and view in step."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        self._section, self._commands = window.sparkle, window.commands
        section = self._section
        for signal in (section.mode.picked, window.commands.sparkle_requested):
            signal.connect(lambda mode: self._change(mode=mode))
        section.lights.edited.connect(lambda count: self._change(light_count=round(count)))
        section.strength.edited.connect(lambda strength: self._change(strength=strength))
        state.view_changed.connect(self._show_view)
        state.contents_changed.connect(self._show_flakes)
        self._show_view(None, state.view)
        self._show_flakes()

    def _change(self, **fields: Any) -> None:
        sparkle = dataclasses.replace(self._state.view.sparkle, **fields)
        self._state.change_view(sparkle=sparkle)

    def _show_view(self, _old: View | None, new: View) -> None:
        self._section.set_sparkle(new.sparkle)
        self._commands.show_sparkle(new.sparkle.mode)

    def _show_flakes(self) -> None:
        fit = self._state.fit
        self._section.set_flakes(None if fit is None else fit.flakes)

"""The sparkle section: its edits go into the view, and it shows the view's and the paint's values."""

from __future__ import annotations

from brdf_qt.fields.choices import set_note

from brdf_suite.documents.view import View
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.paint.sparkle_section import flake_facts
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow


class SparkleControl(ViewerFeature):
    """Keeps section and view in step."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        section = window.sparkle
        section.mode.picked.connect(lambda mode: state.change_part("sparkle", mode=mode))
        section.lights.edited.connect(lambda count: state.change_part("sparkle", light_count=round(count)))
        section.strength.edited.connect(lambda strength: state.change_part("sparkle", strength=strength))
        state.view_changed.connect(self._show_view)
        state.contents_changed.connect(self._show_flakes)
        self._show_view(None, state.view)
        self._show_flakes()

    def _show_view(self, _old: View | None, new: View) -> None:
        self._window.sparkle.set_sparkle(new.sparkle)

    def _show_flakes(self) -> None:
        fit = self._state.fit
        set_note(self._window.sparkle.facts, flake_facts(None if fit is None else fit.flakes))

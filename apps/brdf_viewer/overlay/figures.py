"""H: the figures over the picture, a heads-up display of what is drawn, how, and how fast."""

from __future__ import annotations

from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr

from brdf_suite.documents.view import View
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.overlay.frame_meter import FrameMeter
from brdf_viewer.overlay.readout import Readout
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.tone.section import TONE_TITLES
from brdf_viewer.window import ViewerWindow

_KEY = "figures"
SPARKLE_WORDS = {"off": mark("no sparkle"), "texture": mark("flake texture"), "glints": mark("glints")}
FRESNEL_WORDS = {
    "off": mark("no Fresnel"),
    "raised": mark("Fresnel raised"),
    "multi_angle": mark("Fresnel by angle"),
}


class FiguresOverlay(ViewerFeature):
    """Shows and hides the figures; remembers which."""

    def __init__(self, state: ViewerState, window: ViewerWindow, meter: FrameMeter, readout: Readout) -> None:
        super().__init__(state, window)
        self._meter, self._readout = meter, readout
        self._on = bool(settings().value(_KEY, False, type=bool))
        window.commands.figures.triggered.connect(self.set_on)
        window.commands.figures.setChecked(self._on)
        meter.shown.connect(self._show)
        readout.changed.connect(self._show)
        state.view_changed.connect(self._show)
        state.contents_changed.connect(self._show)

    def set_on(self, on: bool) -> None:
        """Show the figures, or hide them."""
        self._on = on
        settings().setValue(_KEY, on)
        self._window.commands.figures.setChecked(on)
        self._show()

    def _show(self, *_: object) -> None:
        lines = self._lines() if self._on and self._state.is_complete else []
        self._window.overlay.show_figures(tuple(lines))

    def _lines(self) -> list[str]:
        state, size = self._state, self._window.picture.device_size
        lines = [f"{self._meter.words or '–'}   {size[0]} × {size[1]}"]
        if state.fit is not None:
            lines[0] += "   " + tr("{count} lobes").format(count=len(state.fit.weights.exponents))
        return [*lines, how(state.exposed_view), *self._readout.lines]


def how(view: View) -> str:
    """Return in one line how a view is drawn.

    >>> how(View(fresnel="off"))
    'Faithful, soft highlights   +0.0 EV   no Fresnel   glints, 8 lights'
    """
    sparkle = tr(SPARKLE_WORDS[view.sparkle.mode])
    if view.sparkle.mode != "off":
        sparkle = tr("{sparkle}, {count} lights").format(sparkle=sparkle, count=view.sparkle.light_count)
    return "   ".join(
        [
            tr(TONE_TITLES[view.tone_curve]),
            f"{view.exposure_ev:+.1f} EV",
            tr(FRESNEL_WORDS[view.fresnel]),
            sparkle,
        ]
    )

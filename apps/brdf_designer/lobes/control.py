"""The drawer of the lobes: worked out at idle, and only while it is open."""

from __future__ import annotations

from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import tr
from PySide6.QtCore import QObject

from brdf_designer.lobes.plot import LobeLines, LobesPlot
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import layers_of
from brdf_designer.window.window import DesignerWindow
from brdf_suite.inspection.slices.cuts import plane_slice
from brdf_suite.inspection.slices.values import channel_of, evaluate, radius_of
from brdf_suite.pipeline.lobe_fit import LobeFit

_OWNER = "lobes"
_ROOM = 2.0
"""The end of the radius over the greatest value of the base."""


class LobesControl(Feature, QObject):
    """Joins the drawer to the paint session."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session = session
        self._of: LobeFit | None = None
        self.plot = LobesPlot()
        tip = tr("Show or hide the lobes in the plane of the light")
        self.drawer = window.add_drawer("lobes", tr("Lobes"), self.plot, "left", "lobes", "flower-lotus", tip)
        self.drawer.toggled.connect(self._later)
        session.fit_changed.connect(self._later)

    @property
    def is_idle(self) -> bool:
        """Whether the lobes of the newest fit are shown, or none are to be."""
        return not self.drawer.is_open or self._session.fit is None or self._of is self._session.fit

    def refresh(self) -> None:
        """Show the lobes of the newest fit."""
        fit = self._session.fit
        if fit is not None and fit is not self._of and self.drawer.is_open:
            self._of = fit
            self.plot.show_lines(lobe_lines(fit))

    def _later(self, *_: object) -> None:
        if self.drawer.is_open:
            self._session.at_idle(_OWNER, self.refresh)


def lobe_lines(fit: LobeFit) -> LobeLines:
    """Return model and lobes of a fit in the plane of the light that most readings have, the model's peak at 1."""
    light = fit.paint.main_light_deg
    cut = plane_slice(light, 0.0)
    layers = layers_of(fit)
    base, coat = (evaluate(part, [cut], cosine="none")[0] for part in (layers.base, layers.coat))
    fitted = evaluate(fit.weights, [cut], cosine="none")[0]
    model, lobes = (channel_of(value, "luminance") for value in (base + coat, fitted))
    # The coat's mirror peak is thousands of times the base: it is cut off where it would leave the base no room.
    outer = float(max(channel_of(base, "luminance").max(), 1e-6)) * _ROOM
    shares = [radius_of(value, "cbrt", outer).clip(0.0, 1.0) for value in (model, lobes)]
    return LobeLines(light, cut.angle_deg, *shares)

"""What coat and flakes make of a fit: haze and refusal, worked out at idle."""

from __future__ import annotations

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from PySide6.QtCore import QObject

from brdf_designer.coat_flakes.coat_section import CoatSection
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import layers_of
from brdf_designer.window.window import DesignerWindow
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.reflectance.instruments.glossmeter import total_gloss


class CoatControl(Feature, QObject):
    """Joins the section of the coat to the paint session."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session = session
        self._coat: CoatSection = window.coat
        session.fit_changed.connect(lambda _fit: session.at_idle("coat", self._show_gloss))
        session.refused.connect(self._refuse)
        self._coat.gloss_requested.connect(self._show_gloss)

    def _show_gloss(self) -> None:
        fit = self._session.fit
        if fit is not None and fit.paint.gloss.gu_60 is None:
            layers = layers_of(fit)
            self._coat.show_gloss(*total_gloss(layers.base, layers.coat))

    def _refuse(self, error: SuiteError) -> None:
        self._coat.show_refusal(tr_core(str(error)) if isinstance(error, UnreachableError) else "")

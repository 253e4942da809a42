"""A paint with spectra is fitted again, in the background, for the lamp that the view names."""

from __future__ import annotations

from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, Signal

from brdf_suite.documents.view_settings import LightColour
from brdf_suite.pipeline.lobe_fit import LobeFit, refit_under
from brdf_suite.progress import Progress
from brdf_suite.reflectance.protocol import has_spectra
from brdf_viewer.light.section import Spectra, is_tinted
from brdf_viewer.scene.viewer_state import ViewerState

_KEY = "relit"


class RelitPaint(QObject):
    """Keeps the viewer state's ``relit`` in step with its paint and its light; until it is there, the old one is drawn.

    With ``second`` it is the paint that is compared with. Signals: ``state_changed()``; see :attr:`state`.
    """

    state_changed = Signal()

    def __init__(self, state: ViewerState, parent: QObject | None = None, *, second: bool = False) -> None:
        super().__init__(parent)
        self._state = state
        self._second = second
        self._runner = TaskRunner(self, threads=1)
        self._requested: tuple[LobeFit, str] | None = None
        self._failed = False
        state.view_changed.connect(lambda *_: self._follow())
        state.contents_changed.connect(self._follow)
        self._follow()

    @property
    def state(self) -> Spectra:
        """Whether the paint's spectra are known, and in the picture."""
        if self._requested is None or self._failed:
            return "unknown"
        present = self._state.second_relit if self._second else self._state.relit
        return "used" if present is not None else "in work"

    def close(self) -> None:
        self._runner.stop()

    def _follow(self) -> None:
        wanted = self._spectral()
        if wanted == self._requested:
            return
        self._requested, self._failed = wanted, False
        if self._second:
            self._state.second_relit = None
        else:
            self._state.relit = None
        self._runner.cancel(_KEY)
        if wanted is not None:
            request = (wanted[0], LightColour(self._state.view.light_colour.illuminant))
            self._runner.submit(_KEY, _refit, request, done=self._done, failed=self._not_fitted)
        self.state_changed.emit()

    def _done(self, fit: LobeFit) -> None:
        self._state.set_relit(fit, second=self._second)
        self.state_changed.emit()

    def _not_fitted(self, _error: Exception) -> None:
        """The spectra cannot be fitted in this light: the colours are adapted, and the panel says so."""
        self._failed = True
        self.state_changed.emit()

    def _spectral(self) -> tuple[LobeFit, str] | None:
        """Return the fit and the lamp for which spectra matter; None for a paint without, or a neutral lamp."""
        state, colour = self._state, self._state.view.light_colour
        second = None if state.second is None else state.second.value
        fit = second if self._second else state.fit
        if fit is None or not is_tinted(colour):
            return None
        return (fit, colour.illuminant) if isinstance(fit, LobeFit) and has_spectra(fit.reflectance) else None


def _refit(request: tuple[LobeFit, LightColour], progress: Progress) -> LobeFit:
    return refit_under(*request, progress)

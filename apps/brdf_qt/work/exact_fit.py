"""Where the time limit of a fit came first: its optimum, brought to the main thread when it is there."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Qt, Signal

from brdf_suite.pipeline.lobe_fit import LobeFit, with_exact

if TYPE_CHECKING:
    from concurrent.futures import Future


class ExactFit(QObject):
    """Reports the exact fit of the paint that was watched last, once; it reports nothing of any other paint.

    Signals
    -------
    arrived(fit)
        The :class:`LobeFit` with the optimum.
    failed(fit, error)
        There is none: the solver gave up, and the answer at the limit, the :class:`LobeFit` that was watched, is all
        there is.
    """

    arrived = Signal(object)
    failed = Signal(object, object)
    _found = Signal(object, object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._watched: LobeFit | None = None
        # The future calls back on the fitter's thread.
        self._found.connect(self._take, Qt.ConnectionType.QueuedConnection)

    def watch(self, fit: LobeFit) -> None:
        """Wait for the optimum of ``fit``, if one is to come, and no more for an earlier one's."""
        self._watched = fit if fit.exact is not None else None
        if fit.exact is not None:
            fit.exact.add_done_callback(partial(self._relay, fit))

    def forget(self) -> None:
        """Wait for nothing: what is on show is of another paint, or none."""
        self._watched = None

    def _relay(self, fit: LobeFit, future: Future[Any]) -> None:
        # Cancelled is also what a fitter that was closed does; this object may be gone by then.
        if not future.cancelled():
            self._found.emit(fit, future)

    def _take(self, fit: LobeFit, future: Future[Any]) -> None:
        if fit is not self._watched:
            return
        self._watched = None
        error = future.exception()
        if error is not None:
            self.failed.emit(fit, error)
        else:
            self.arrived.emit(with_exact(fit, future.result()))

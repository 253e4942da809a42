"""Fits over the angle for a window: found on threads, and announced on the window's own."""

from __future__ import annotations

from PySide6.QtCore import QObject, Qt, Signal

from brdf_suite.pipeline.paint_angles import PaintAngles


class AngleFits(QObject):
    """Holds :class:`PaintAngles` for which the window does not wait.

    Signals
    -------
    arrived()
        The same paint is to be drawn anew: the fitter is ready, an optimum has come after the time limit, or weights
        for every angle of the view have been found.
    """

    arrived = Signal()
    _changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        # The fitters call on their own threads.
        self._changed.connect(self.arrived, Qt.ConnectionType.QueuedConnection)
        self.angles = PaintAngles(changed=self._changed.emit)

"""The light in motion: to and fro in polar angle, or round in azimuth, at a speed that no frame time changes."""

from __future__ import annotations

from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QElapsedTimer, QObject, Signal

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.view3d.options import SpaceState

LOW_DEG, HIGH_DEG = 0.0, 85.0
_STEP_MS = 16
_MOST_STEP_S = 0.2
"""After a pause of the machine the light goes on from where it was."""


class SweepControl(QObject):
    """Moves the session's incidence while it runs; ``running_changed(on)`` is emitted on start and stop."""

    running_changed = Signal(bool)

    def __init__(self, session: LobeSession, state: SpaceState, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._state = session, state
        self._rising = True
        self._clock = QElapsedTimer()
        self._timer = make_timer(self, self._tick, _STEP_MS, single_shot=False)

    @property
    def running(self) -> bool:
        return self._timer.isActive()

    def set_running(self, on: bool) -> None:
        if on == self.running:
            return
        if on:
            self._clock.start()
            self._timer.start()
        else:
            self._timer.stop()
        self.running_changed.emit(on)

    def toggle(self) -> None:
        self.set_running(not self.running)

    def advance(self, seconds: float) -> None:
        """Move the light as far as it goes in a time."""
        theta, phi = self._session.incidence
        options = self._state.options
        step = options.speed * seconds
        if options.sweep == "azimuth":
            self._session.set_incidence(theta, phi + step)
            return
        theta, self._rising = to_and_fro(theta, step, self._rising)
        self._session.set_incidence(theta, phi)

    def _tick(self) -> None:
        self.advance(min(self._clock.restart() / 1e3, _MOST_STEP_S))


def to_and_fro(theta: float, step: float, rising: bool) -> tuple[float, bool]:
    """Return the polar angle after a step, turned back at both ends, and whether it rises from there.

    >>> to_and_fro(84.0, 3.0, True)
    (83.0, False)
    """
    theta += step if rising else -step
    while not LOW_DEG <= theta <= HIGH_DEG:
        if theta > HIGH_DEG:
            # From beyond the end, where only a hand has put it, it comes back at once.
            theta, rising = max(2.0 * HIGH_DEG - theta, LOW_DEG), False
        else:
            theta, rising = min(2.0 * LOW_DEG - theta, HIGH_DEG), True
    return theta, rising

"""The section Incidence of the inspector: where the light stands, by number, and its sweep, to and fro or round."""

from __future__ import annotations

from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QElapsedTimer, QObject, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QPushButton, QWidget

from brdf_lobe_visualizer.option_form import OptionForm
from brdf_lobe_visualizer.options import INCIDENCE_DEG, MOST_THETA_DEG
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.view3d.section import SPEED_RANGE, SpaceState

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
        self._timer = make_timer(
            self,
            lambda: self.advance(min(self._clock.restart() / 1e3, _MOST_STEP_S)),
            _STEP_MS,
            single_shot=False,
        )

    @property
    def running(self) -> bool:
        return self._timer.isActive()

    def set_running(self, on: bool) -> None:
        if on != self.running:
            self._clock.start()
            self._timer.start() if on else self._timer.stop()
            self.running_changed.emit(on)

    def toggle(self) -> None:
        self.set_running(not self.running)

    def advance(self, seconds: float) -> None:
        theta, phi = self._session.incidence
        options = self._state.options
        step = options.speed * seconds
        if options.sweep == "azimuth":
            phi += step
        else:
            theta, self._rising = to_and_fro(theta, step, self._rising)
        self._session.set_incidence(theta, phi)


def to_and_fro(theta: float, step: float, rising: bool) -> tuple[float, bool]:
    """Return the polar angle after a step, turned back at both ends, and whether it rises from there.

    >>> to_and_fro(84.0, 3.0, True)
    (83.0, False)
    """
    theta += step if rising else -step
    while not LOW_DEG <= theta <= HIGH_DEG:
        # From beyond the end, where only a hand has put it, it comes back at once.
        rising = theta < LOW_DEG
        theta = min(2.0 * LOW_DEG - theta, HIGH_DEG) if rising else max(2.0 * HIGH_DEG - theta, LOW_DEG)
    return theta, rising


_SWEEPS = {"polar": mark("Polar angle"), "azimuth": mark("Azimuth")}


class IncidenceSection(QWidget):
    """Sets the session's incidence and the sweep, and shows them."""

    def __init__(
        self, session: LobeSession, state: SpaceState, sweep: SweepControl, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("incidence_section")
        self._session, self._state, self._sweep = session, state, sweep
        form = self._form = OptionForm(state)
        self.theta = NumberField(
            tr("Polar angle of the light"), "°", 0.0, MOST_THETA_DEG, 1.0, 1, INCIDENCE_DEG[0]
        )
        self.theta.edited.connect(lambda value: session.set_incidence(value, session.incidence[1]))
        tip = tr("Angle between the normal and the light. The yellow handle in the view sets it, too.")
        form.add_row(tr("Polar angle θi"), self.theta, tip)
        self.theta_slider = described(
            QuietSlider(Qt.Orientation.Horizontal), spoken=tr("Polar angle of the light, tenths of a degree")
        )
        self.theta_slider.setRange(0, 890)
        self.theta_slider.setPageStep(50)
        self.theta_slider.setSingleStep(10)
        self.theta_slider.valueChanged.connect(
            lambda value: session.set_incidence(value / 10.0, session.incidence[1])
        )
        form.add_wide(self.theta_slider)
        self.phi = NumberField(tr("Azimuth of the light"), "°", -180.0, 180.0, 1.0, 1, INCIDENCE_DEG[1])
        self.phi.setWrapping(True)
        self.phi.edited.connect(lambda value: session.set_incidence(session.incidence[0], value))
        tip = tr(
            "Azimuth of the plane of incidence. Affects only anisotropic reflectances, such as brushed metal."
        )
        form.add_row(tr("Azimuth φi"), self.phi, tip)
        form.choice("sweep", _SWEEPS, tr("Sweep"), tr("Angle that the sweep changes"))
        form.number("speed", tr("Speed"), tr("Speed of the sweep"), "°/s", (*SPEED_RANGE, 5.0), 0)
        self.run = described(
            QPushButton(icon("play"), tr("Sweep")), tip=tr("Move the light continuously (Space in the view)")
        )
        self.run.setCheckable(True)
        self.run.clicked.connect(sweep.set_running)
        self.reset = QPushButton(tr("Reset"))
        self.reset.clicked.connect(self._reset)
        fill_column(self, form, row_of(self.run, self.reset))
        session.incidence_changed.connect(lambda _theta, _phi: self.show_now())
        state.changed.connect(self.show_now)
        sweep.running_changed.connect(lambda _on: self.show_now())
        self.show_now()

    def show_now(self) -> None:
        theta, phi = self._session.incidence
        self.theta.set_value(theta)
        self.phi.set_value(phi)
        with QSignalBlocker(self.theta_slider):
            self.theta_slider.setValue(round(10.0 * theta))
        self._form.show_now()
        self.run.setChecked(self._sweep.running)

    def _reset(self) -> None:
        self._sweep.set_running(False)
        self._session.reset_incidence()
        self._state.reset("sweep", "speed")

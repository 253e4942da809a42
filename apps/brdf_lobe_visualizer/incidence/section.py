"""The section Incidence of the inspector: where the light stands, by number, and its sweep."""

from __future__ import annotations

from brdf_qt.fields.layouts import column_in, described, row_of
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QPushButton, QWidget

from brdf_lobe_visualizer.incidence.sweep import SweepControl
from brdf_lobe_visualizer.option_form import OptionForm
from brdf_lobe_visualizer.options import INCIDENCE_DEG, MOST_THETA_DEG
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.view3d.options import SPEED_RANGE, SpaceState

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
        form.add_row(
            tr("Polar angle θi"),
            self.theta,
            tr("Angle between the normal and the light. The yellow handle in the view sets it, too."),
        )
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
        column_in(self, form, row_of(self.run, self.reset))
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

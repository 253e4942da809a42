"""The section Incidence of the inspector: where the light stands, by number, and its sweep."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from brdf_lobe_visualizer.choice_field import ChoiceField
from brdf_lobe_visualizer.incidence.sweep import SweepControl
from brdf_lobe_visualizer.options import INCIDENCE_DEG, MOST_THETA_DEG
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.view3d.options import SPEED_RANGE, SpaceOptions, SpaceState

_SWEEPS = {"polar": mark("Polar angle"), "azimuth": mark("Azimuth")}


class IncidenceSection(QWidget):
    """Sets the session's incidence and the sweep, and shows them."""

    def __init__(
        self, session: LobeSession, state: SpaceState, sweep: SweepControl, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("incidence_section")
        self._session, self._state, self._sweep = session, state, sweep
        plain = SpaceOptions()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        form = Form()
        box.addWidget(form)
        self.theta = NumberField(
            tr("Polar angle of the light"), "°", 0.0, MOST_THETA_DEG, 1.0, 1, INCIDENCE_DEG[0]
        )
        self.theta.edited.connect(lambda value: session.set_incidence(value, session.incidence[1]))
        form.add_row(
            tr("Polar angle θi"),
            self.theta,
            tr("Angle between the normal and the light. The yellow handle in the view sets it, too."),
        )
        self.theta_slider = QuietSlider(Qt.Orientation.Horizontal)
        self.theta_slider.setRange(0, 890)
        self.theta_slider.setPageStep(50)
        self.theta_slider.setSingleStep(10)
        self.theta_slider.setAccessibleName(tr("Polar angle of the light, tenths of a degree"))
        self.theta_slider.valueChanged.connect(
            lambda value: session.set_incidence(value / 10.0, session.incidence[1])
        )
        form.add_wide(self.theta_slider)
        self.phi = NumberField(tr("Azimuth of the light"), "°", -180.0, 180.0, 1.0, 1, INCIDENCE_DEG[1])
        self.phi.setWrapping(True)
        self.phi.edited.connect(lambda value: session.set_incidence(session.incidence[0], value))
        form.add_row(
            tr("Azimuth φi"),
            self.phi,
            tr(
                "Azimuth of the plane of incidence. Affects only anisotropic reflectances, such as brushed metal."
            ),
        )
        self.kind = ChoiceField(_SWEEPS, plain.sweep)
        self.kind.chosen.connect(lambda key: state.set(sweep=key))
        form.add_row(tr("Sweep"), self.kind, tr("Angle that the sweep changes"))
        self.speed = NumberField(tr("Speed of the sweep"), "°/s", *SPEED_RANGE, 5.0, 0, plain.speed)
        self.speed.edited.connect(lambda value: state.set(speed=value))
        form.add_row(tr("Speed"), self.speed)
        row = QHBoxLayout()
        row.setSpacing(8)
        self.run = QPushButton(icon("play"), tr("Sweep"))
        self.run.setCheckable(True)
        self.run.setToolTip(tr("Move the light continuously (Space in the view)"))
        self.run.clicked.connect(sweep.set_running)
        self.reset = QPushButton(tr("Reset"))
        self.reset.clicked.connect(self._reset)
        row.addWidget(self.run)
        row.addWidget(self.reset)
        box.addLayout(row)
        session.incidence_changed.connect(lambda _theta, _phi: self.show_now())
        state.changed.connect(self.show_now)
        sweep.running_changed.connect(lambda _on: self.show_now())
        self.show_now()

    def show_now(self) -> None:
        """Show what is set, without a signal."""
        theta, phi = self._session.incidence
        self.theta.set_value(theta)
        self.phi.set_value(phi)
        self.theta_slider.blockSignals(True)
        self.theta_slider.setValue(round(10.0 * theta))
        self.theta_slider.blockSignals(False)
        self.kind.set_choice(self._state.options.sweep)
        self.speed.set_value(self._state.options.speed)
        self.run.setChecked(self._sweep.running)

    def _reset(self) -> None:
        self._sweep.set_running(False)
        self._session.reset_incidence()
        self._state.reset("sweep", "speed")

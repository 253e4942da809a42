"""The options of the slices, which are remembered, and their section of the inspector; every control has its reset."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QObject, QSignalBlocker, Qt
from PySide6.QtWidgets import QComboBox, QPushButton, QWidget

from brdf_lobe_visualizer.option_form import OptionForm
from brdf_lobe_visualizer.options import OptionState
from brdf_suite.inspection.slices.cuts import AXES, Axis
from brdf_suite.inspection.slices.images import SEED_INCIDENCES_DEG, TONES, Tone

Polar = Literal["range", "linear", "cbrt", "log"]
POLARS: tuple[Polar, ...] = ("range", "linear", "cbrt", "log")

EV_RANGE = (-10.0, 10.0)


@dataclass(frozen=True)
class SliceOptions:
    """The options; the defaults are what a reset goes back to. Angles are degrees.

    - ``axis``: the angle under the curves.
    - ``log_value``, ``log_angle``: logarithmic axes of the curves.
    - ``follow``: the cut over θh is at the θd of the mirror configuration, which is the incidence; else at
      ``theta_d_deg``.
    - ``theta_d_deg``, ``theta_h_deg``, ``phi_d_deg``: where the cuts over θh and θd, and the half-angle image, are.
    - ``incidences_deg``: those of the unrolled hemispheres.
    - ``tone``, ``ev``: how images become codes, and stops above the exposure that fits their values.
    - ``by_root``: θh of the half-angle image by its root, as measured tables have it.
    - ``polar``: the radius of the polar plot: ``"range"`` is that of the views, but logarithmic where values lie so
      far apart that nothing but their peak would be seen.
    - ``samples``: measured samples are drawn.
    """

    axis: Axis = "gamma"
    log_value: bool = True
    log_angle: bool = False
    follow: bool = True
    theta_d_deg: float = 45.0
    theta_h_deg: float = 0.0
    phi_d_deg: float = 90.0
    incidences_deg: tuple[float, float, float] = SEED_INCIDENCES_DEG
    tone: Tone = "log"
    ev: float = 0.0
    by_root: bool = True
    polar: Polar = "range"
    samples: bool = True


_CHOICES: dict[str, tuple[str, ...]] = {"axis": AXES, "tone": TONES, "polar": POLARS}
_RANGES = {
    "theta_d_deg": (0.0, 89.9),
    "theta_h_deg": (0.0, 89.9),
    "phi_d_deg": (0.0, 180.0),
    "incidences_deg": (0.0, 89.0),
    "ev": EV_RANGE,
}


class SliceState(OptionState[SliceOptions]):
    """Holds the options and remembers them."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__("lobes/slices", SliceOptions(), _CHOICES, _RANGES, parent)


_TONES: dict[Tone, str] = {"gamma": mark("Gamma (sRGB)"), "log": mark("Logarithmic, 4 decades")}
_POLARS: dict[Polar, str] = {
    "range": mark("Automatic"),
    "linear": mark("Linear"),
    "cbrt": mark("Cube root"),
    "log": mark("Logarithmic"),
}
_SPACING = {True: mark("Square root"), False: mark("Linear")}


class SlicesSection(QWidget):
    """Sets the options of a :class:`SliceState`, and shows them."""

    def __init__(self, state: SliceState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("slices_section")
        self._state = state
        form = self._form = OptionForm(state)
        tip = tr("θd of the cut over θh: that of the mirror configuration (the incidence), or a fixed value")
        form.add_row(tr("θd of the θh cut"), form.tick("follow", tr("At the incidence")), tip)
        angle = (0.0, 89.9, 1.0)
        self.theta_d = form.number("theta_d_deg", tr("θd"), tr("θd"), "°", angle, 1)
        name, tip = tr("θh of the θd cut"), tr("θh of the cut over θd")
        form.number("theta_h_deg", name, name, "°", angle, 1, tip)
        tip = tr(
            "Azimuth of the light about the half vector, for the cuts over θh and θd and the half-angle image"
        )
        form.number("phi_d_deg", tr("φd"), tr("φd"), "°", (0.0, 180.0, 1.0), 1, tip)
        self.phi_d_slider = described(QuietSlider(Qt.Orientation.Horizontal), spoken=tr("φd, degrees"))
        self.phi_d_slider.setRange(0, 180)
        self.phi_d_slider.setSingleStep(1)
        self.phi_d_slider.setPageStep(15)
        self.phi_d_slider.valueChanged.connect(lambda value: state.set(phi_d_deg=float(value)))
        form.add_wide(self.phi_d_slider)
        self.incidences = [
            NumberField(tr("Light"), "°", 0.0, 89.0, 1.0, 1, angle) for angle in state.plain.incidences_deg
        ]
        lights = QWidget()
        lights.setLayout(row_of(*self.incidences, spacing=4))
        for number, field in enumerate(self.incidences):
            field.edited.connect(lambda value, number=number: self._set_incidence(number, value))
            field.setAccessibleName(tr("Light of column {number}, degrees").format(number=number + 1))
        tip = tr("Incidences of the unrolled hemispheres (10°, 40° and 70° in the paper)")
        form.add_row(tr("Unrolled at"), lights, tip)
        tip = tr("Mapping from values to brightness, shown by the scale bar")
        tone = form.choice("tone", _TONES, tr("Images"), tip)
        tip = tr("Stops above the automatic exposure of the selected reflectance")
        form.number("ev", tr("Exposure"), tr("Exposure"), "EV", (*EV_RANGE, 0.5), 1, tip)
        tip = tr("Spacing of θh along the half-angle image")
        spacing = form.choice("by_root", _SPACING, tr("θh of images"), tip)
        tip = tr("Mapping from values to radii of the polar plot. Automatic: logarithmic for high peaks.")
        polar = form.choice("polar", _POLARS, tr("Polar radius"), tip)
        tip = tr("Draw samples near a cut as rings, and samples of an image's incidence as dots")
        form.add_wide(described(form.tick("samples", tr("Measured samples")), tip=tip))
        for choice in (tone, spacing, polar):
            choice.setMinimumContentsLength(0)
            choice.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContentsOnFirstShow)
        self.reset = described(QPushButton(tr("Reset Slices")), name="reset_slices")
        self.reset.clicked.connect(lambda: state.reset())
        fill_column(self, form, self.reset)
        state.changed.connect(self.show_options)
        self.show_options()

    def show_options(self) -> None:
        options = self._state.options
        self._form.show_now()
        self.theta_d.setEnabled(not options.follow)
        with QSignalBlocker(self.phi_d_slider):
            self.phi_d_slider.setValue(round(options.phi_d_deg))
        for field, angle in zip(self.incidences, options.incidences_deg, strict=True):
            field.set_value(angle)

    def _set_incidence(self, number: int, value: float) -> None:
        angles = list(self._state.options.incidences_deg)
        angles[number] = value
        self._state.set(incidences_deg=tuple(angles))

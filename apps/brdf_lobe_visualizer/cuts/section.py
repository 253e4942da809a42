"""The section Slices of the inspector: where the cuts are, the light of the images; every control has its reset."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietComboBox, QuietSlider
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QHBoxLayout,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from brdf_lobe_visualizer.cuts.options import EV_RANGE, POLARS, Polar, SliceOptions, SliceState
from brdf_suite.inspection.slices.images import TONES, Tone

_TONES: dict[Tone, str] = {
    "gamma": mark("Gamma (sRGB)"),
    "log": mark("Logarithmic, 4 decades"),
}
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
        plain = SliceOptions()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        form = Form()
        box.addWidget(form)
        self.follow = QCheckBox(tr("At the incidence"))
        self.follow.clicked.connect(lambda on: state.set(follow=on))
        form.add_row(
            tr("θd of the θh cut"),
            self.follow,
            tr("θd of the cut over θh: that of the mirror configuration (the incidence), or a fixed value"),
        )
        self.theta_d = self._angle(form, "theta_d_deg", tr("θd"), 89.9, plain.theta_d_deg, "")
        self.theta_h = self._angle(
            form,
            "theta_h_deg",
            tr("θh of the θd cut"),
            89.9,
            plain.theta_h_deg,
            tr("θh of the cut over θd"),
        )
        self.phi_d = self._angle(
            form,
            "phi_d_deg",
            tr("φd"),
            180.0,
            plain.phi_d_deg,
            tr(
                "Azimuth of the light about the half vector, for the cuts over θh and θd and the half-angle image"
            ),
        )
        self.phi_d_slider = QuietSlider(Qt.Orientation.Horizontal)
        self.phi_d_slider.setRange(0, 180)
        self.phi_d_slider.setSingleStep(1)
        self.phi_d_slider.setPageStep(15)
        self.phi_d_slider.setAccessibleName(tr("φd, degrees"))
        self.phi_d_slider.valueChanged.connect(lambda value: state.set(phi_d_deg=float(value)))
        form.add_wide(self.phi_d_slider)
        self.incidences = [
            NumberField(tr("Light"), "°", 0.0, 89.0, 1.0, 1, angle) for angle in plain.incidences_deg
        ]
        lights, row = QWidget(), QHBoxLayout()
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        lights.setLayout(row)
        for number, field in enumerate(self.incidences):
            field.edited.connect(lambda value, number=number: self._set_incidence(number, value))
            field.setAccessibleName(tr("Light of column {number}, degrees").format(number=number + 1))
            row.addWidget(field)
        form.add_row(
            tr("Unrolled at"),
            lights,
            tr("Incidences of the unrolled hemispheres (10°, 40° and 70° in the paper)"),
        )
        self.tone = QuietComboBox()
        for tone in TONES:
            self.tone.addItem(tr(_TONES[tone]), tone)
        self.tone.activated.connect(lambda index: state.set(tone=self.tone.itemData(index)))
        form.add_row(tr("Images"), self.tone, tr("Mapping from values to brightness, shown by the scale bar"))
        self.ev = NumberField(tr("Exposure"), "EV", *EV_RANGE, 0.5, 1, 0.0)
        self.ev.edited.connect(lambda value: state.set(ev=value))
        form.add_row(
            tr("Exposure"),
            self.ev,
            tr("Stops above the automatic exposure of the selected reflectance"),
        )
        self.spacing = QuietComboBox()
        for by_root, title in _SPACING.items():
            self.spacing.addItem(tr(title), by_root)
        self.spacing.activated.connect(lambda index: state.set(by_root=bool(self.spacing.itemData(index))))
        form.add_row(tr("θh of images"), self.spacing, tr("Spacing of θh along the half-angle image"))
        self.polar = QuietComboBox()
        for polar in POLARS:
            self.polar.addItem(tr(_POLARS[polar]), polar)
        self.polar.activated.connect(lambda index: state.set(polar=self.polar.itemData(index)))
        form.add_row(
            tr("Polar radius"),
            self.polar,
            tr("Mapping from values to radii of the polar plot. Automatic: logarithmic for high peaks."),
        )
        self.samples = QCheckBox(tr("Measured samples"))
        self.samples.setToolTip(
            tr("Draw samples near a cut as rings, and samples of an image's incidence as dots")
        )
        self.samples.clicked.connect(lambda on: state.set(samples=on))
        form.add_wide(self.samples)
        self.reset = QPushButton(tr("Reset Slices"))
        self.reset.setObjectName("reset_slices")
        self.reset.clicked.connect(lambda: state.reset())
        box.addWidget(self.reset)
        state.changed.connect(self.show_options)
        self.show_options()

    def show_options(self) -> None:
        """Show the options as they are, without a signal."""
        options = self._state.options
        self.follow.setChecked(options.follow)
        self.theta_d.setEnabled(not options.follow)
        self.theta_d.set_value(options.theta_d_deg)
        self.theta_h.set_value(options.theta_h_deg)
        self.phi_d.set_value(options.phi_d_deg)
        self.phi_d_slider.blockSignals(True)
        self.phi_d_slider.setValue(round(options.phi_d_deg))
        self.phi_d_slider.blockSignals(False)
        for field, angle in zip(self.incidences, options.incidences_deg, strict=True):
            field.set_value(angle)
        self.tone.setCurrentIndex(self.tone.findData(options.tone))
        self.ev.set_value(options.ev)
        self.samples.setChecked(options.samples)
        self.polar.setCurrentIndex(self.polar.findData(options.polar))
        self.spacing.setCurrentIndex(self.spacing.findData(options.by_root))

    def _angle(self, form: Form, key: str, name: str, most: float, default: float, tip: str) -> NumberField:
        field = NumberField(name, "°", 0.0, most, 1.0, 1, default)
        field.edited.connect(lambda value: self._state.set(**{key: value}))
        form.add_row(name, field, tip)
        return field

    def _set_incidence(self, number: int, value: float) -> None:
        angles = list(self._state.options.incidences_deg)
        angles[number] = value
        self._state.set(incidences_deg=tuple(angles))

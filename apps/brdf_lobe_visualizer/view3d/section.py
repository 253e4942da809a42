"""The section Radius of the inspector: how values become a surface, its colours, and the frame about it."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QCheckBox, QGridLayout, QPushButton, QVBoxLayout, QWidget

from brdf_lobe_visualizer.choice_field import ChoiceField
from brdf_lobe_visualizer.options import Options
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.view3d.options import FULL_RANGE, SpaceOptions, SpaceState
from brdf_suite.inspection.lobe_surface.surface import LEAST_DECADES, MOST_DECADES

_RADII = {"linear": mark("Linear"), "cbrt": mark("Cube root"), "log": mark("Logarithm")}
_COSINES = {
    "none": mark("f_r"),
    "light": mark("f_r·cosθi"),
    "both": mark("f_r·cosθi·cosθo"),
}
_CHANNELS = {
    "colour": mark("Luminance"),
    "r": mark("Red"),
    "g": mark("Green"),
    "b": mark("Blue"),
    "luminance": mark("Luminance, grey"),
}
_COLOURINGS = {
    "light": mark("Reflected light"),
    "line": mark("Legend colour"),
    "values": mark("False colour"),
}
_FILLS = {
    "auto": mark("Automatic"),
    "greatest": mark("Maximum"),
    "body": mark("Maximum away from R"),
    "value": mark("Fixed value"),
}
_ARRANGEMENTS = {"overlay": mark("Overlay"), "panels": mark("Side by side")}
_FLAGS = {
    "hemisphere": mark("Hemisphere"),
    "labels": mark("Labels"),
    "arrows": mark("Arrows"),
    "rings": mark("Rings"),
}


class SurfaceSection(QWidget):
    """Sets the options of the session and of the view that make a surface, and shows them."""

    def __init__(self, session: LobeSession, state: SpaceState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("surface_section")
        self._session, self._state = session, state
        shared, plain = Options(), SpaceOptions()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        form = Form()
        box.addWidget(form)
        self.radius = ChoiceField(_RADII, shared.radius)
        self.radius.chosen.connect(lambda key: session.set_options(radius=key))
        form.add_row(tr("Radius"), self.radius, tr("Mapping from values to distances from the centre"))
        self.decades = NumberField(tr("Decades"), "", LEAST_DECADES, MOST_DECADES, 1.0, 1, plain.decades)
        self.decades.edited.connect(lambda value: state.set(decades=value))
        form.add_row(tr("Decades"), self.decades, tr("Range of the logarithmic radius below its maximum"))
        self.fill = ChoiceField(_FILLS, plain.fill)
        self.fill.chosen.connect(self._choose_fill)
        form.add_row(
            tr("Scale"),
            self.fill,
            tr(
                "Value at the hemisphere; larger values are cut off. Automatic: the maximum, "
                "or less if the body would be shorter than half a radius. "
                "Away from R: more than 5° from the mirror direction."
            ),
        )
        self.full = NumberField(tr("Value of radius 1"), "1/sr", *FULL_RANGE, 0.1, 4, plain.full)
        self.full.edited.connect(lambda value: state.set(full=value, fill="value"))
        form.add_row(tr("Value"), self.full, tr("Stays fixed while the light moves"))
        self.cosine = ChoiceField(_COSINES, shared.cosine)
        self.cosine.chosen.connect(lambda key: session.set_options(cosine=key))
        form.add_row(
            tr("Quantity"),
            self.cosine,
            tr("Quantity in all views: f_r, reflected radiance f_r·cosθi, or intensity f_r·cosθi·cosθo"),
        )
        self.channel = ChoiceField(_CHANNELS, shared.channel)
        self.channel.chosen.connect(lambda key: session.set_options(channel=key))
        form.add_row(tr("Channel"), self.channel, tr("Channel that the radius shows (linear Rec. 2020)"))
        self.colouring = ChoiceField(_COLOURINGS, plain.colouring)
        self.colouring.chosen.connect(lambda key: state.set(colouring=key))
        form.add_row(
            tr("Colour"), self.colouring, tr("Reflected light is shown in its colour at full brightness")
        )
        self.arrangement = ChoiceField(_ARRANGEMENTS, plain.arrangement)
        self.arrangement.chosen.connect(lambda key: state.set(arrangement=key))
        form.add_row(tr("Multiple"), self.arrangement, tr("Arrangement of several reflectances"))
        self.own_scale = QCheckBox(tr("Separate scale for each panel"))
        self.own_scale.clicked.connect(lambda on: state.set(own_scale=on))
        box.addWidget(self.own_scale)
        grid = QGridLayout()
        grid.setHorizontalSpacing(16)
        self.flags: dict[str, QCheckBox] = {}
        for number, (key, title) in enumerate(_FLAGS.items()):
            flag = self.flags[key] = QCheckBox(tr(title))
            flag.clicked.connect(lambda on, key=key: state.set(**{key: on}))
            grid.addWidget(flag, number // 2, number % 2)
        box.addLayout(grid)
        samples = Form()
        box.addWidget(samples)
        self.samples = QCheckBox(tr("Measured samples"))
        self.samples.clicked.connect(lambda on: state.set(samples=on))
        samples.add_wide(self.samples)
        self.within = NumberField(tr("Maximum distance of samples"), "°", 0.1, 90.0, 0.5, 1, plain.within_deg)
        self.within.edited.connect(lambda value: state.set(within_deg=value))
        samples.add_row(
            tr("Within"),
            self.within,
            tr("Maximum angle between a sample's incidence and the current incidence"),
        )
        self.reset = QPushButton(tr("Reset Radius"))
        self.reset.clicked.connect(self._reset)
        box.addWidget(self.reset)
        session.options_changed.connect(self.show_now)
        state.changed.connect(self.show_now)
        self.show_now()

    def show_now(self) -> None:
        """Show what is set, without a signal."""
        shared, own = self._session.options, self._state.options
        self.radius.set_choice(shared.radius)
        self.cosine.set_choice(shared.cosine)
        self.channel.set_choice(shared.channel)
        self.fill.set_choice(own.fill)
        self.colouring.set_choice(own.colouring)
        self.arrangement.set_choice(own.arrangement)
        self.decades.set_value(own.decades)
        self.decades.setEnabled(shared.radius == "log")
        self.full.set_value(own.full)
        self.full.setEnabled(own.fill == "value")
        self.own_scale.setChecked(own.own_scale)
        self.own_scale.setEnabled(own.fill != "value")
        self.samples.setChecked(own.samples)
        self.within.set_value(own.within_deg)
        self.within.setEnabled(own.samples)
        for key, flag in self.flags.items():
            flag.setChecked(bool(getattr(own, key)))

    def hold(self, value: float) -> None:
        """Offer the value that radius 1 has now as the one to be held."""
        if self._state.options.fill != "value" and value > 0.0:
            self.full.set_value(value)
            self.full.set_default(value)

    def _choose_fill(self, key: str) -> None:
        # What is held first is what was shown.
        if key == "value":
            self._state.set(fill=key, full=self.full.value())
        else:
            self._state.set(fill=key)

    def _reset(self) -> None:
        self._session.reset_options("radius", "cosine", "channel")
        kept = ("fit_style", "lobes", "sweep", "speed")
        self._state.reset(*(name for name in vars(SpaceOptions()) if name not in kept))

"""The options of the view in three dimensions, which are remembered, and the section Radius of the inspector."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from brdf_qt.fields.form import fill_column
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QGridLayout, QPushButton, QWidget

from brdf_lobe_visualizer.option_form import OptionForm
from brdf_lobe_visualizer.options import OptionState
from brdf_lobe_visualizer.session import LobeSession
from brdf_suite.inspection.lobe_surface.surface import COLOURINGS, LEAST_DECADES, MOST_DECADES, Colouring

FitStyle = Literal["lines", "glass", "solid"]
Arrangement = Literal["overlay", "panels"]
LobeView = Literal["sum", "parts", "stacked", "apart"]
Fill = Literal["auto", "greatest", "body", "value"]
Sweep = Literal["polar", "azimuth"]

BODY_DEG = 5.0
"""Farther than this from the mirror direction is the body of a lobe; the reflection of a coat lies within."""

FULL_RANGE = (1e-6, 1e9)
SPEED_RANGE = (1.0, 180.0)


@dataclass(frozen=True)
class SpaceOptions:
    """The options; the defaults are what a reset goes back to.

    - ``colouring``: light's colour, the legend's, or the map of values.
    - ``fit_style``: how a fit is drawn over its target.
    - ``arrangement``: several reflectances over one another, or each in a panel of its own.
    - ``lobes``: a fit as its sum, as its three parts, its lobes stacked, or each lobe alone.
    - ``fill``, ``full``: what has radius 1: a value by which peak and body are both seen, the greatest that is
      shown, the greatest of the bodies (:data:`BODY_DEG`), or the value ``full`` in 1/sr.
    - ``own_scale``: each panel has a scale of its own.
    - ``decades``: what a logarithmic radius shows.
    - ``hemisphere``, ``labels``, ``arrows``, ``rings``: what of the frame is drawn.
    - ``samples``, ``within_deg``: whether measured samples are drawn, and how far their incidence may be from the
      one that is shown.
    - ``sweep``, ``speed``: whether the light moves in polar angle or goes round, and its degrees a second.
    """

    colouring: Colouring = "light"
    fit_style: FitStyle = "lines"
    arrangement: Arrangement = "overlay"
    lobes: LobeView = "sum"
    fill: Fill = "auto"
    full: float = 1.0
    own_scale: bool = False
    decades: float = 6.0
    hemisphere: bool = True
    labels: bool = True
    arrows: bool = True
    rings: bool = True
    samples: bool = True
    within_deg: float = 2.5
    sweep: Sweep = "polar"
    speed: float = 20.0


_CHOICES: dict[str, tuple[str, ...]] = {
    "colouring": COLOURINGS,
    "fit_style": get_args(FitStyle),
    "arrangement": get_args(Arrangement),
    "lobes": get_args(LobeView),
    "fill": get_args(Fill),
    "sweep": get_args(Sweep),
}
_RANGES = {
    "decades": (LEAST_DECADES, MOST_DECADES),
    "within_deg": (0.1, 90.0),
    "speed": SPEED_RANGE,
    "full": FULL_RANGE,
}


class SpaceState(OptionState[SpaceOptions]):
    """Holds the options and remembers them."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__("lobes/space", SpaceOptions(), _CHOICES, _RANGES, parent)


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
    "body": mark("Maximum off R"),
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
        form = self._form = OptionForm(state, session)
        form.choice("radius", _RADII, tr("Radius"), tr("Mapping from values to distances from the centre"))
        tip = tr("Range of the logarithmic radius below its maximum")
        decades = (LEAST_DECADES, MOST_DECADES, 1.0)
        self.decades = form.number("decades", tr("Decades"), tr("Decades"), "", decades, 1, tip)
        tip = tr(
            "Value at the hemisphere; larger values are cut off. Automatic: the maximum, "
            "or less if all but 2 % of the directions would be shorter than half a radius. "
            "Away from R: more than 5° from the mirror direction."
        )
        form.choice("fill", _FILLS, tr("Scale"), tip, self._choose_fill)
        tip = tr("Stays fixed while the light moves")
        full = (*FULL_RANGE, 0.1)
        self.full = form.number(
            "full",
            tr("Value"),
            tr("Value of radius 1"),
            "1/sr",
            full,
            4,
            tip,
            lambda value: self._state.set(full=value, fill="value"),
        )
        tip = tr("Quantity in all views: f_r, reflected radiance f_r·cosθi, or intensity f_r·cosθi·cosθo")
        form.choice("cosine", _COSINES, tr("Quantity"), tip)
        form.choice(
            "channel", _CHANNELS, tr("Channel"), tr("Channel that the radius shows (linear Rec. 2020)")
        )
        tip = tr("Reflected light is shown in its colour at full brightness")
        form.choice("colouring", _COLOURINGS, tr("Colour"), tip)
        form.choice("arrangement", _ARRANGEMENTS, tr("Multiple"), tr("Arrangement of several reflectances"))
        self.own_scale = form.tick("own_scale", tr("Separate scale for each panel"))
        grid = QGridLayout()
        grid.setHorizontalSpacing(16)
        for number, (key, title) in enumerate(_FLAGS.items()):
            grid.addWidget(form.tick(key, tr(title)), number // 2, number % 2)
        samples = self._samples = OptionForm(state)
        samples.add_wide(samples.tick("samples", tr("Measured samples")))
        tip = tr("Maximum angle between a sample's incidence and the current incidence")
        within, spoken = (0.1, 90.0, 0.5), tr("Maximum distance of samples")
        self.within = samples.number("within_deg", tr("Within"), spoken, "°", within, 1, tip)
        self.reset = QPushButton(tr("Reset Radius"))
        self.reset.clicked.connect(self._reset)
        fill_column(self, form, self.own_scale, grid, samples, self.reset)
        session.options_changed.connect(self.show_now)
        state.changed.connect(self.show_now)
        self.show_now()

    def show_now(self) -> None:
        own = self._state.options
        self._form.show_now()
        self._samples.show_now()
        self.decades.setEnabled(self._session.options.radius == "log")
        self.full.setEnabled(own.fill == "value")
        self.own_scale.setEnabled(own.fill != "value")
        self.within.setEnabled(own.samples)

    def hold(self, value: float) -> None:
        """Offer the value that radius 1 has now as the one to be held."""
        if self._state.options.fill != "value" and value > 0.0:
            self.full.set_value(value)
            self.full.set_default(value)

    def _choose_fill(self, key: str) -> None:
        # What is held first is what was shown.
        held = {"full": self.full.value()} if key == "value" else {}
        self._state.set(remember=True, **{"fill": key, **held})

    def _reset(self) -> None:
        self._session.reset_options("radius", "cosine", "channel")
        kept = ("fit_style", "lobes", "sweep", "speed")
        self._state.reset(*(name for name in vars(SpaceOptions()) if name not in kept))

"""How the view in three dimensions shows what it shows, beyond the options that all views share; remembered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from PySide6.QtCore import QObject

from brdf_lobe_visualizer.options import OptionState
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

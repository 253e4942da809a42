"""How the view in three dimensions shows what it shows, beyond the options that all views share; remembered."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal, get_args

from brdf_qt.program.settings import settings
from PySide6.QtCore import QObject, Signal

from brdf_suite.inspection.lobe_surface.scale import LEAST_DECADES, MOST_DECADES
from brdf_suite.inspection.lobe_surface.surface import COLOURINGS, Colouring

_KEY = "lobes/space"

FitStyle = Literal["lines", "glass", "solid"]
Arrangement = Literal["overlay", "panels"]
LobeView = Literal["sum", "parts", "stacked", "apart"]
FIT_STYLES: tuple[FitStyle, ...] = get_args(FitStyle)
ARRANGEMENTS: tuple[Arrangement, ...] = get_args(Arrangement)
LOBE_VIEWS: tuple[LobeView, ...] = get_args(LobeView)
Fill = Literal["auto", "greatest", "body", "value"]
Sweep = Literal["polar", "azimuth"]
FILLS: tuple[Fill, ...] = get_args(Fill)
SWEEPS: tuple[Sweep, ...] = get_args(Sweep)

BODY_DEG = 5.0
"""Farther than this from the mirror direction is the body of a lobe; the reflection of a coat lies within."""

FULL_RANGE = (1e-6, 1e9)
SPEED_RANGE = (1.0, 180.0)


@dataclass(frozen=True)
class SpaceOptions:
    """The options; the defaults are what a reset goes back to.

    Attributes
    ----------
    colouring
        Light's colour, the legend's, or the map of values.
    fit_style
        How a fit is drawn over its target.
    arrangement
        Several reflectances over one another, or each in a panel of its own.
    lobes
        A fit as its sum, as its three parts, its lobes stacked, or each lobe alone.
    fill, full
        What has radius 1: a value by which peak and body are both seen, the greatest that is shown, the greatest of the
        bodies (:data:`BODY_DEG`), or the value ``full`` in 1/sr.
    own_scale
        Each panel has a scale of its own.
    decades
        What a logarithmic radius shows.
    hemisphere, labels, arrows, rings
        What of the frame is drawn.
    samples, within_deg
        Whether measured samples are drawn, and how far their incidence may be from the one that is shown.
    sweep, speed
        Whether the light moves in polar angle or goes round, and its degrees a second.
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
    "fit_style": FIT_STYLES,
    "arrangement": ARRANGEMENTS,
    "lobes": LOBE_VIEWS,
    "fill": FILLS,
    "sweep": SWEEPS,
}
_RANGES = {
    "decades": (LEAST_DECADES, MOST_DECADES),
    "within_deg": (0.1, 90.0),
    "speed": SPEED_RANGE,
    "full": FULL_RANGE,
}


class SpaceState(QObject):
    """Holds the options; ``changed()`` is emitted when they change."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._options = _remembered()

    @property
    def options(self) -> SpaceOptions:
        """The options as they are."""
        return self._options

    def set(self, *, remember: bool = True, **fields: Any) -> None:
        """Set options by name; numbers are brought into their range."""
        options = _sound(replace(self._options, **fields))
        if options != self._options:
            self._options = options
            if remember:
                settings().setValue(_KEY, json.dumps(asdict(options)))
            self.changed.emit()

    def reset(self, *names: str) -> None:
        """Set options back, all where none is named."""
        plain = SpaceOptions()
        self.set(**{name: getattr(plain, name) for name in names or vars(plain)})

    def set_from_text(self, name: str, text: str) -> bool:
        """Set an option by words for this run, as a script does; False where there is no such option or value."""
        plain = vars(SpaceOptions()).get(name)
        if plain is None:
            return False
        try:
            value: Any = text in ("1", "on", "yes", "true") if isinstance(plain, bool) else type(plain)(text)
        except ValueError:
            return False
        if name in _CHOICES and value not in _CHOICES[name]:
            return False
        self.set(remember=False, **{name: value})
        return True


def _sound(options: SpaceOptions) -> SpaceOptions:
    for name, choices in _CHOICES.items():
        if getattr(options, name) not in choices:
            raise ValueError(f"{name} is one of {', '.join(choices)}")

    def hold(name: str, value: float) -> float:
        low, high = _RANGES[name]
        return min(max(float(value), low), high)

    return replace(
        options,
        decades=hold("decades", options.decades),
        within_deg=hold("within_deg", options.within_deg),
        speed=hold("speed", options.speed),
        full=hold("full", options.full),
    )


def _remembered() -> SpaceOptions:
    """Return the options of the last time; the defaults where there is none, or it is of another version."""
    plain = SpaceOptions()
    try:
        kept = json.loads(str(settings().value(_KEY, "{}")))
        known = {name: type(value)(kept[name]) for name, value in vars(plain).items() if name in kept}
        return _sound(replace(plain, **known))
    except (ValueError, TypeError, KeyError):
        return plain  # a settings file that another version or another hand wrote

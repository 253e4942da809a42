"""How the slices are shown: which angle, at which others, log axes, the light of the images; remembered."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

from brdf_qt.program.settings import settings
from PySide6.QtCore import QObject, Signal

from brdf_suite.inspection.slices.cuts import AXES, Axis
from brdf_suite.inspection.slices.images import SEED_INCIDENCES_DEG
from brdf_suite.inspection.slices.tone import TONES, Tone

Polar = Literal["range", "linear", "cbrt", "log"]
POLARS: tuple[Polar, ...] = ("range", "linear", "cbrt", "log")

_KEY = "lobes/slices"
EV_RANGE = (-10.0, 10.0)


@dataclass(frozen=True)
class SliceOptions:
    """The options; the defaults are what a reset goes back to. Angles are degrees.

    Attributes
    ----------
    axis
        The angle under the curves.
    log_value, log_angle
        Logarithmic axes of the curves.
    follow
        The cut over θh is at the θd of the mirror configuration, which is the incidence; else at ``theta_d_deg``.
    theta_d_deg, theta_h_deg, phi_d_deg
        Where the cuts over θh and θd, and the half-angle image, are.
    incidences_deg
        Those of the unrolled hemispheres.
    tone, ev
        How images become codes, and stops above the exposure that fits their values.
    by_root
        θh of the half-angle image by its root, as measured tables have it.
    polar
        The radius of the polar plot: ``"range"`` is that of the views, but logarithmic where values lie so far apart
        that nothing but their peak would be seen.
    samples
        Measured samples are drawn.
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


_RANGES = {
    "theta_d_deg": (0.0, 89.9),
    "theta_h_deg": (0.0, 89.9),
    "phi_d_deg": (0.0, 180.0),
    "ev": EV_RANGE,
}


class SliceState(QObject):
    """Holds the options; ``changed()`` is emitted when they change."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._options = _remembered()

    @property
    def options(self) -> SliceOptions:
        """The options as they are."""
        return self._options

    def set(self, **fields: Any) -> None:
        """Set options by name; angles are brought into their range."""
        options = _sound(replace(self._options, **fields))
        if options != self._options:
            self._options = options
            settings().setValue(_KEY, json.dumps(asdict(options)))
            self.changed.emit()

    def set_from_text(self, name: str, text: str) -> bool:
        """Set an option from words: numbers, ``true`` or ``false``, three numbers with commas; False: it cannot be."""
        plain = getattr(SliceOptions(), name, None)
        try:
            if isinstance(plain, bool):
                value: Any = {"true": True, "false": False}[text]
            elif isinstance(plain, float):
                value = float(text)
            elif isinstance(plain, tuple):
                value = tuple(float(part) for part in text.split(","))
            else:
                value = text
            options = _sound(replace(self._options, **{name: value}))
        except (KeyError, ValueError, TypeError):
            return False
        if not _is_known(options):
            return False
        self.set(**{name: value})
        return True

    def reset(self, *names: str) -> None:
        """Set options back, all where none is named."""
        plain = SliceOptions()
        self.set(**{name: getattr(plain, name) for name in names or vars(plain)})


def _sound(options: SliceOptions) -> SliceOptions:
    held: dict[str, Any] = {
        name: min(max(float(getattr(options, name)), low), high) for name, (low, high) in _RANGES.items()
    }
    lights: Any = tuple(min(max(float(angle), 0.0), 89.0) for angle in options.incidences_deg)
    return replace(options, **held, incidences_deg=lights)


def _remembered() -> SliceOptions:
    """Return the options of the last time; the defaults where there is none, or it is of another version."""
    try:
        kept = json.loads(str(settings().value(_KEY, "{}")))
        plain = SliceOptions()
        known = {name: kept[name] for name in vars(plain) if name in kept}
        options = _sound(replace(plain, **known))
        return options if _is_known(options) else plain
    except (ValueError, TypeError, KeyError):
        return SliceOptions()  # a settings file that another version or another hand wrote


def _is_known(options: SliceOptions) -> bool:
    flags = (options.log_value, options.log_angle, options.follow, options.by_root, options.samples)
    numbers = (*(getattr(options, name) for name in _RANGES), *options.incidences_deg)
    return (
        options.axis in AXES
        and options.tone in TONES
        and options.polar in POLARS
        and len(options.incidences_deg) == 3
        and all(isinstance(flag, bool) for flag in flags)
        and all(math.isfinite(number) for number in numbers)
    )

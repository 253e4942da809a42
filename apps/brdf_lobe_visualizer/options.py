"""What all views share: channel, radius, cosine, what is shown, which lobes are off; and how options are kept."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar

from brdf_qt.program.settings import settings
from PySide6.QtCore import QObject, Signal

from brdf_suite.inspection.lobe_surface.parts import FitPart
from brdf_suite.inspection.lobe_surface.surface import RadiusKind
from brdf_suite.inspection.slices.values import Channel, Cosine

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

T = TypeVar("T", bound="DataclassInstance")
Shown = Literal["target", "fit", "both", "side by side", "difference"]

CHANNELS: tuple[Channel, ...] = ("colour", "r", "g", "b", "luminance")
RADII: tuple[RadiusKind, ...] = ("linear", "cbrt", "log")
COSINES: tuple[Cosine, ...] = ("none", "light", "both")
"""What f_r is multiplied with: nothing (1/sr), N·L (reflected radiance), N·L and N·V (intensity)."""
SHOWN: tuple[Shown, ...] = ("target", "fit", "both", "side by side", "difference")

INCIDENCE_DEG = (45.0, 0.0)
"""Polar angle and azimuth of the light at a first start, and after a reset."""
MOST_THETA_DEG = 89.9
_TRUE, _FALSE = (True, "1", "on", "yes", "true"), (False, "0", "off", "no", "false")


@dataclass(frozen=True)
class Options:
    """The options; the defaults are what a reset goes back to.

    ``lobes_off`` holds ``(part, index)`` of the lobes of a fit that are switched off, the index into its exponents;
    the diffuse part has the index 0. Without ``gloss`` the coat is left out of targets and fits, where a reflectance
    has one that can be left out.
    """

    channel: Channel = "colour"
    radius: RadiusKind = "cbrt"
    cosine: Cosine = "light"
    shown: Shown = "target"
    lobes_off: frozenset[tuple[FitPart, int]] = frozenset()
    gloss: bool = True


class OptionState(QObject, Generic[T]):
    """Holds the options of one view, and remembers them under ``key``; ``changed()`` is emitted when they change.

    ``plain`` are the defaults; ``choices`` are the values that a text may have, ``ranges`` those that a number, or
    each number of a tuple, is brought into.
    """

    changed = Signal()

    def __init__(
        self,
        key: str,
        plain: T,
        choices: Mapping[str, tuple[str, ...]],
        ranges: Mapping[str, tuple[float, float]],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._key, self.plain, self._choices, self._ranges = key, plain, choices, ranges
        self.options = self._remembered()

    def set(self, *, remember: bool = True, **fields: Any) -> None:
        """Set options by name; numbers are brought into their range, other values raise :class:`ValueError`."""
        sound = {name: self._sound(name, value) for name, value in fields.items()}
        options = replace(self.options, **sound)
        if options != self.options:
            self.options = options
            if remember:
                settings().setValue(self._key, json.dumps(asdict(options)))
            self.changed.emit()

    def reset(self, *names: str) -> None:
        """Set options back, all where none is named."""
        self.set(**{name: getattr(self.plain, name) for name in names or vars(self.plain)})

    def set_from_text(self, name: str, text: str) -> bool:
        """Set an option by words for this run, as a script does; False where there is no such option or value."""
        plain = vars(self.plain).get(name)
        try:
            self.set(remember=False, **{name: text.split(",") if isinstance(plain, tuple) else text})
        except (AttributeError, ValueError, TypeError):
            return False
        return True

    def _sound(self, name: str, value: Any) -> Any:
        plain = getattr(self.plain, name)
        if isinstance(plain, str):
            if value not in self._choices[name]:
                raise ValueError(f"{name} is one of {', '.join(self._choices[name])}")
            return value
        if isinstance(plain, tuple):
            return tuple(self._held(name, one) for one, _ in zip(value, plain, strict=True))
        if isinstance(plain, bool):
            if value not in _TRUE and value not in _FALSE:
                raise ValueError(f"{name} is on or off")
            return value in _TRUE
        return self._held(name, value)

    def _held(self, name: str, value: Any) -> float:
        number, (low, high) = float(value), self._ranges[name]
        if not math.isfinite(number):
            raise ValueError(f"{name} is a number")
        return min(max(number, low), high)

    def _remembered(self) -> T:
        """Return the options of the last time; the defaults where there is none, or it is of another version."""
        try:
            kept = json.loads(str(settings().value(self._key, "{}")))
            known = {name: self._sound(name, kept[name]) for name in vars(self.plain) if name in kept}
            return replace(self.plain, **known)
        except (ValueError, TypeError, KeyError, RecursionError):
            return self.plain  # a settings file that another version or another hand wrote

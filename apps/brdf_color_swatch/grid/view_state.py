"""What a pane shows of the library, and how: frozen values, remembered between runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal, get_args

from brdf_suite.resources import resource_names

Form = Literal["sphere", "panel", "flop_strip", "chips"]
SIZES = (32, 320)
"""The smallest and the largest swatch of a grid, pixels of the window."""
RANGES: dict[str, tuple[float, float]] = {
    "hue": (0.0, 360.0),
    "lightness": (0.0, 150.0),
    "chroma": (0.0, 120.0),
    "flop": (0.0, 30.0),
    "gloss": (0.0, 120.0),
}
"""The ends of the filters' sliders: degrees, L* at 45°, C* at 45°, flop index, GU at 20°. The ends let all pass."""


@dataclass(frozen=True)
class Scope:
    """Which swatches: of one palette of the library, all of it, one group with those within, or one tag."""

    palette: str = ""
    group: tuple[str, ...] = ()
    tag: str = ""


@dataclass(frozen=True)
class Near:
    """The paint that the nearest are wanted of: its name, and L*a*b* at 15, 45 and 110°; NaN where not known."""

    name: str
    lab: tuple[tuple[float, float, float], ...]


@dataclass(frozen=True)
class PaneState:
    """A scope with what narrows and orders it. ``ranges`` holds those alone that are narrower than :data:`RANGES`.

    ``sort`` is ``own`` (the user's order), ``hue``, ``lightness``, ``nearest`` or a column of the list (``L_15``, …).
    """

    scope: Scope = Scope()
    text: str = ""
    ranges: tuple[tuple[str, float, float], ...] = ()
    sort: str = "own"
    descending: bool = False
    duplicates: float | None = None
    near: Near | None = None

    @property
    def is_filtered(self) -> bool:
        """Whether some of the scope may be hidden."""
        return bool(self.text.strip() or self.ranges or self.duplicates is not None)

    @property
    def keeps_order(self) -> bool:
        """Whether it shows the user's own order, in which swatches can be put elsewhere by hand."""
        return self.sort == "own" and self.near is None and self.duplicates is None

    def range_of(self, key: str) -> tuple[float, float]:
        return next(((low, high) for name, low, high in self.ranges if name == key), RANGES[key])

    def with_range(self, key: str, low: float, high: float) -> PaneState:
        """Return this state with other ends of a filter; the whole range takes the filter away."""
        kept = [one for one in self.ranges if one[0] != key]
        if (low, high) != RANGES[key]:
            kept.append((key, low, high))
        return replace(self, ranges=tuple(sorted(kept)))

    def cleared(self) -> PaneState:
        """Return this state with nothing that hides a swatch."""
        sort = "own" if self.sort == "nearest" else self.sort
        return replace(self, text="", ranges=(), duplicates=None, near=None, sort=sort)


@dataclass(frozen=True)
class Look:
    """How all panes show their swatches."""

    form: Form = "sphere"
    size: int = 112
    booth: str = "booth"
    as_list: bool = False

    def to_json(self) -> dict[str, Any]:
        return asdict(self)

    @staticmethod
    def from_json(value: dict[str, Any]) -> Look:
        """Return the look of plain values; each that is damaged or not known is as it is at a first start."""
        return Look(**{key: value[key] for key, good in _GOOD.items() if key in value and good(value[key])})


_GOOD: dict[str, Callable[[Any], bool]] = {
    "form": lambda value: isinstance(value, str) and value in get_args(Form),
    # A bool is an int as well.
    "size": lambda value: type(value) is int and SIZES[0] <= value <= SIZES[1],
    "booth": lambda value: isinstance(value, str) and value in resource_names("environments", ".exr"),
    "as_list": lambda value: isinstance(value, bool),
}

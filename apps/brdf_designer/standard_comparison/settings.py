"""The user's formula and tolerances, kept between runs; the same for every document."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from brdf_qt.program.settings import settings

from brdf_suite.appearance.difference.tolerance import Limits, Tolerances
from brdf_suite.errors import SuiteError

_KEY = "standard/tolerances"
USUAL = Limits(difference=1.0)
PARTS = ("difference", "lightness", "chroma", "hue")


@dataclass(frozen=True)
class ToleranceSettings:
    """What the user judges by.

    ``difference`` names the formula. ``everywhere`` are the limits at every angle that has none of its own in
    ``by_angle`` (degrees). ``ellipsoid``: ΔL*, ΔC* and ΔH* are judged together.
    """

    difference: str = "2000"
    everywhere: Limits = USUAL
    by_angle: dict[float, Limits] = field(default_factory=dict)
    ellipsoid: bool = False

    def tolerances(self) -> Tolerances:
        """Return them as the core takes them. At an angle, what it has no own limit for is judged as everywhere."""
        everywhere, merged = replace(self.everywhere, ellipsoid=self.ellipsoid), {}
        for angle, own in self.by_angle.items():
            given: dict[str, Any] = {
                part: value for part in PARTS if (value := getattr(own, part)) is not None
            }
            merged[angle] = replace(everywhere, **given)
        return Tolerances(merged, everywhere, self.difference)

    def limits(self, angle: float | None) -> Limits:
        """Return the limits set for an angle; ``None`` for those everywhere."""
        return self.everywhere if angle is None else self.by_angle.get(angle, Limits())

    def with_limit(self, angle: float | None, part: str, value: float | None) -> ToleranceSettings:
        """Return them with one limit set or taken away; ValueRangeError for a value that is no size."""
        change: dict[str, Any] = {part: value}
        changed = replace(self.limits(angle), **change)
        if angle is None:
            return replace(self, everywhere=changed)
        by_angle = {**self.by_angle, angle: changed}
        if not changed.judges:
            del by_angle[angle]
        return replace(self, by_angle=by_angle)


def load() -> ToleranceSettings:
    """Return what was kept; the usual ones where there is nothing, or nothing that can be used."""
    text = str(settings().value(_KEY, "", type=str))
    try:
        plain = json.loads(text)
        found = ToleranceSettings(
            str(plain["difference"]),
            _limits(plain["everywhere"]),
            {float(angle): _limits(limits) for angle, limits in plain["by_angle"].items()},
            bool(plain["ellipsoid"]),
        )
        found.tolerances()
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError, SuiteError):
        # Another version's, or edited by hand: the usual ones are as good a start as any.
        return ToleranceSettings()
    return found


def save(chosen: ToleranceSettings) -> None:
    """Keep them for the next run."""
    plain = {
        "difference": chosen.difference,
        "everywhere": asdict(chosen.everywhere),
        "by_angle": {str(angle): asdict(limits) for angle, limits in chosen.by_angle.items()},
        "ellipsoid": chosen.ellipsoid,
    }
    settings().setValue(_KEY, json.dumps(plain))


def _limits(plain: dict[str, object]) -> Limits:
    known: dict[str, Any] = {part: float(str(plain[part])) for part in PARTS if plain.get(part) is not None}
    return Limits(**known)

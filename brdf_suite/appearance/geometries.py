"""Named sets of measurement geometries of multi-angle instruments.

Angles are those of :mod:`brdf_suite.geometry.directions`: light on one side, aspecular angle from its mirror direction
towards the normal and past it. With the light at 45° the view is at the polar angle 45° - γ.

The three angles are those of ASTM E2194. The five- and six-angle sets and the eight geometries of ASTM E2539 (two
lights, for interference pigments) are from expert memory of the standards and of the instruments in use.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from brdf_suite.errors import ValueRangeError

_MOST = 100
_NUMBER = r"[+-]?\d+(?:\.\d*)?"
_GROUP = re.compile(rf"\s*({_NUMBER})\s*:\s*({_NUMBER}(?:\s*,\s*{_NUMBER})*)\s*")


@dataclass(frozen=True)
class Geometry:
    """One light and one view in the plane of incidence, degrees."""

    illumination_deg: float
    aspecular_deg: float

    def __post_init__(self) -> None:
        for name in ("illumination_deg", "aspecular_deg"):
            if not math.isfinite(getattr(self, name)):
                raise ValueRangeError(name, "expected a finite angle in degrees")
        if not 0.0 <= self.illumination_deg < 90.0:
            raise ValueRangeError(
                "illumination_deg",
                f"expected a polar angle from 0 to below 90°, not {self.illumination_deg:g}°",
            )
        if not -90.0 < self.view_deg < 90.0:
            raise ValueRangeError(
                "aspecular_deg",
                f"with the light at {self.illumination_deg:g}°, {self.aspecular_deg:g}° would look from below the "
                f"surface (polar angle {self.view_deg:g}°)",
            )

    @property
    def view_deg(self) -> float:
        """Polar angle of the view, positive on the mirror direction's side."""
        return self.illumination_deg - self.aspecular_deg

    @property
    def name(self) -> str:
        """Return the trade's short name, as in ``45as15``."""
        return f"{self.illumination_deg:g}as{self.aspecular_deg:g}"

    @property
    def label(self) -> str:
        """The aspecular angle, with its light where that is not at 45°."""
        text = f"{self.aspecular_deg:g}°"
        return text if self.illumination_deg == 45.0 else f"{text}, light {self.illumination_deg:g}°"


@dataclass(frozen=True)
class GeometrySet:
    """The geometries of an instrument, in its own order."""

    name: str
    title: str
    geometries: tuple[Geometry, ...]

    def __post_init__(self) -> None:
        if not 1 <= len(self.geometries) <= _MOST:
            raise ValueRangeError("geometries", f"expected 1 to {_MOST} geometries")
        if len(set(self.geometries)) < len(self.geometries):
            raise ValueRangeError("geometries", "a geometry is named twice")


def _set(name: str, title: str, *groups: tuple[float, tuple[float, ...]]) -> GeometrySet:
    return GeometrySet(
        name, title, tuple(Geometry(light, angle) for light, angles in groups for angle in angles)
    )


_FIVE = (15.0, 25.0, 45.0, 75.0, 110.0)
_SIX = (-15.0, *_FIVE)

GEOMETRY_SETS: dict[str, GeometrySet] = {
    entry.name: entry
    for entry in (
        _set("e2194", "three angles, ASTM E2194", (45.0, (15.0, 45.0, 110.0))),
        _set("five", "five angles", (45.0, _FIVE)),
        _set("six", "six angles, one beyond the mirror direction", (45.0, _SIX)),
        _set("e2539", "interference pigments, ASTM E2539", (45.0, _SIX), (15.0, (-15.0, 15.0))),
    )
}
"""Every named set, by its name."""

DEFAULT_SET = "six"


def geometry_set(name: str) -> GeometrySet:
    """Return a named set, or one that the name itself spells out: ``LIGHT:ANGLE,ANGLE…[;LIGHT:…]``, degrees.

    >>> [geometry.name for geometry in geometry_set("45:15,110;20:15").geometries]
    ['45as15', '45as110', '20as15']

    Raises
    ------
    ValueRangeError
        It is neither; or an angle would look from below the surface.
    """
    if name in GEOMETRY_SETS:
        return GEOMETRY_SETS[name]
    groups = [_GROUP.fullmatch(part) for part in name.split(";")]
    geometries: list[Geometry] = []
    for group in groups:
        if group is None:
            raise ValueRangeError(
                "geometry",
                f"{name!r} is neither a named set ({', '.join(GEOMETRY_SETS)}) nor angles like 45:15,45,110;15:15",
            )
        geometries += [Geometry(float(group[1]), float(angle)) for angle in group[2].split(",")]
    return GeometrySet(name, "user-defined", tuple(geometries))


def measured_set(pairs: Sequence[tuple[float, float]], name: str = "measured") -> GeometrySet:
    """Return the set of (illumination, aspecular) angles, degrees, that a paint was measured at."""
    return GeometrySet(name, "the paint's own angles", tuple(Geometry(*pair) for pair in pairs))

"""Virtual spectrophotometer: colours per angle, gloss, haze, flop and travel of any reflectance.

Colours are of D65 and the 10° observer. A multi-angle spectrophotometer with the geometry set and aperture stated reads
the colours, a glossmeter of the standard's three angles the gloss; both see the whole paint, coat and base.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.clearcoat_gloss import haze_units
from brdf_suite.appearance.colour.colorimetry import lab_to_xyz, working_to_lab
from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.flop.travel import FIRST_DEG, LAST_DEG, FlopIndex, Travel, flop_index, travel
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS, Geometry, GeometrySet
from brdf_suite.arrays import Floats, Triple, triple
from brdf_suite.errors import FittingError
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.instruments.aperture import POINT, Aperture, reflectance_factor
from brdf_suite.reflectance.instruments.glossmeter import GLOSS_ANGLES_DEG, gloss_reading
from brdf_suite.reflectance.protocol import Reflectance

_FLOP_DEG = (15.0, 45.0, 110.0)
_FLOP_LIGHT_DEG = 45.0
_SAME_DEG = 1e-6
# Relative change between the last two refinements above which a reading is called uncertain.
_UNCERTAIN = 5e-3


@dataclass(frozen=True)
class Reading:
    """One geometry: ρ in the working space, XYZ and L*a*b* (D65, 10°; the white's Y = 100)."""

    geometry: Geometry
    rho: Triple
    xyz: Triple
    lab: Triple

    @property
    def factor(self) -> float:
        """The luminous reflectance factor: 1 for a perfect diffuser."""
        return self.xyz[1] / 100.0

    @property
    def lch(self) -> Triple:
        """L*, C*ab and hue in degrees."""
        return triple(lab_to_lch(self.lab))


@dataclass(frozen=True)
class InstrumentReport:
    """Readings of the virtual instruments. ``flop`` and ``travel`` are ``None`` where their angles are not read."""

    geometry_set: GeometrySet
    aperture: Aperture
    readings: tuple[Reading, ...]
    gloss: dict[int, float]
    flop: FlopIndex | None
    travel: Travel | None
    notices: tuple[str, ...]

    @property
    def haze(self) -> float:
        """Haze index G60 - G20, gloss units."""
        return haze_units(self.gloss[20], self.gloss[60])

    @property
    def lab(self) -> Floats:
        """L*a*b* (k, 3) of the readings."""
        return np.array([reading.lab for reading in self.readings])


def measure(
    reflectance: Reflectance,
    geometry_set: GeometrySet = GEOMETRY_SETS[DEFAULT_SET],
    aperture: Aperture = POINT,
) -> InstrumentReport:
    """Return what the instruments read of ``reflectance``.

    Raises
    ------
    FittingError
        The reflectance gives values that are not finite numbers.
    """
    notices: list[str] = []
    readings = tuple(_read(reflectance, geometry, aperture, notices) for geometry in geometry_set.geometries)
    gloss = {angle: gloss_reading(reflectance, angle) for angle in GLOSS_ANGLES_DEG}
    if not all(np.isfinite(value) for value in gloss.values()):
        raise FittingError("The reflectance gives values that are not finite numbers at a gloss angle.")
    flop, path = _flop(readings), _travel(readings)
    for item in (flop, path):
        if item is not None and item.notice:
            notices.append(item.notice[0].upper() + item.notice[1:] + ".")
    return InstrumentReport(geometry_set, aperture, readings, gloss, flop, path, tuple(notices))


def _read(reflectance: Reflectance, geometry: Geometry, aperture: Aperture, notices: list[str]) -> Reading:
    wi = illumination(geometry.illumination_deg)
    wo = aspecular_view(geometry.illumination_deg, geometry.aspecular_deg)
    rho, change = reflectance_factor(reflectance, wi, wo, aperture)
    if not np.all(np.isfinite(rho)):
        raise FittingError(f"The reflectance gives values that are not finite numbers at {geometry.name}.")
    reach = aperture.light_deg + aperture.receptor_deg
    if reach > 0.0 and abs(geometry.aspecular_deg) <= reach:
        notices.append(f"At {geometry.name} the aperture reaches into the mirror direction.")
    if change > _UNCERTAIN:
        notices.append(
            f"At {geometry.name} the integral over the aperture is uncertain by {100.0 * change:.1f} %."
        )
    lab = working_to_lab(rho)
    return Reading(geometry, triple(rho), triple(lab_to_xyz(lab)), triple(lab))


def _flop(readings: tuple[Reading, ...]) -> FlopIndex | None:
    lightness = []
    for angle in _FLOP_DEG:
        found = [r.lab[0] for r in readings if _is_at(r.geometry, angle)]
        if not found:
            return None
        lightness.append(found[0])
    return flop_index(*lightness)


def _travel(readings: tuple[Reading, ...]) -> Travel | None:
    used = [r for r in readings if abs(r.geometry.illumination_deg - _FLOP_LIGHT_DEG) <= _SAME_DEG]
    if not all(any(_is_at(r.geometry, end) for r in used) for end in (FIRST_DEG, LAST_DEG)):
        return None
    return travel([r.geometry.aspecular_deg for r in used], [r.lab for r in used])


def _is_at(geometry: Geometry, aspecular_deg: float) -> bool:
    return (
        abs(geometry.illumination_deg - _FLOP_LIGHT_DEG) <= _SAME_DEG
        and abs(geometry.aspecular_deg - aspecular_deg) <= _SAME_DEG
    )

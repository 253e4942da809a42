"""Virtual spectrophotometer: colours per angle, gloss, haze, flop and travel of any reflectance.

Colours are of D65 and the 10° observer. A multi-angle spectrophotometer with the geometry set and aperture stated reads
the colours, a glossmeter of the standard's three angles the gloss; both see the whole paint, coat and base.

Scattered samples can be read anywhere, because they are interpolated. A reading therefore says how far the nearest
sample is. It is supported by samples within 10°, which no place between samples on a grid of 10° exceeds; gloss is
supported by a sample within half the receptor's width of the mirror direction.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.appearance.clearcoat_gloss import half_widths, haze_units
from brdf_suite.appearance.colour.colorimetry import lab_to_xyz, working_to_lab
from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.flop.travel import FIRST_DEG, LAST_DEG, FlopIndex, Travel, flop_index, travel
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS, Geometry, GeometrySet
from brdf_suite.appearance.texture import TextureReadings
from brdf_suite.arrays import Floats, Triple, triple
from brdf_suite.errors import FittingError
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.instruments.aperture import POINT, Aperture, reflectance_factor
from brdf_suite.reflectance.instruments.glossmeter import GLOSS_ANGLES_DEG, gloss_reading
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

SUPPORT_DEG = 10.0
"""The angle to the nearest sample up to which a reading of scattered samples is supported."""

_FLOP_DEG = (15.0, 45.0, 110.0)
_FLOP_LIGHT_DEG = 45.0
_SAME_DEG = 1e-6
# Relative change between the last two refinements above which a reading is called uncertain.
_UNCERTAIN = 5e-3


@dataclass(frozen=True)
class Reading:
    """One geometry: ρ in the working space, XYZ and L*a*b* (D65, 10°; the white's Y = 100).

    ``sample_deg`` is the angle to the nearest sample, degrees; 0 where the reflectance is known everywhere.
    """

    geometry: Geometry
    rho: Triple
    xyz: Triple
    lab: Triple
    sample_deg: float = 0.0

    @property
    def supported(self) -> bool:
        """Whether a sample lies near enough."""
        return self.sample_deg <= SUPPORT_DEG

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
    """Readings of the virtual instruments.

    Attributes
    ----------
    readings
        One for each geometry, with ``lab``, ``lch``, ``xyz`` and the reflectance ``factor``.
    gloss
        Gloss units by 20, 60 and 85°; ``gloss_sample_deg``: the angle from each mirror direction to the nearest sample,
        as of a :class:`Reading`.
    flop, travel
        ``None`` where their angles are not read.
    texture
        ``sparkle`` in light from 15, 45 and 75°, and ``graininess``, on the suite's own scale; zeros of a paint without
        flakes, ``None`` where texture was not read.
    notices
        Sentences about what was read.
    """

    geometry_set: GeometrySet
    aperture: Aperture
    readings: tuple[Reading, ...]
    gloss: dict[int, float]
    gloss_sample_deg: Mapping[int, float]
    flop: FlopIndex | None
    travel: Travel | None
    notices: tuple[str, ...]
    texture: TextureReadings | None = None

    @property
    def haze(self) -> float:
        """Haze index G60 - G20, gloss units."""
        return haze_units(self.gloss[20], self.gloss[60])

    def gloss_supported(self, angle_deg: int) -> bool:
        """Return whether the nearest sample lies in the receptor at ``angle_deg``: 20, 60 or 85.

        >>> import brdf_suite as bs
        >>> bs.measure("blue").gloss_supported(20)
        True
        """
        return math.radians(self.gloss_sample_deg[angle_deg]) <= half_widths(angle_deg)[0][0]

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
    mirrors = {angle: nearest_sample_deg(reflectance, Geometry(angle, 0.0)) for angle in GLOSS_ANGLES_DEG}
    flop, path = _flop(readings), _travel(readings)
    for item in (flop, path):
        if item is not None and item.notice:
            notices.append(item.notice[0].upper() + item.notice[1:] + ".")
    notices += support_notice((reading.geometry, reading.sample_deg) for reading in readings)
    report = InstrumentReport(geometry_set, aperture, readings, gloss, mirrors, flop, path, tuple(notices))
    far = [
        f"{angle}° (nearest {mirrors[angle]:.1f}°)" for angle in gloss if not report.gloss_supported(angle)
    ]
    if not far:
        return report
    return replace(
        report, notices=(*report.notices, f"No sample lies in the glossmeter's receptor at {', '.join(far)}.")
    )


def nearest_sample_deg(reflectance: Reflectance, geometry: Geometry) -> float:
    """Return the angle from a geometry to the nearest sample, degrees; 0 where the reflectance has no samples."""
    if not isinstance(reflectance, ScatteredSamples):
        return 0.0
    wi = illumination(geometry.illumination_deg)
    wo = aspecular_view(geometry.illumination_deg, geometry.aspecular_deg)
    return float(reflectance.nearest_sample_deg(wi, wo))


def support_notice(distances: Iterable[tuple[Geometry, float]]) -> tuple[str, ...]:
    """Return the sentence that names the readings without a sample near them, with its angle; or nothing."""
    far = [f"{geometry.label} (nearest {angle:.0f}°)" for geometry, angle in distances if angle > SUPPORT_DEG]
    return (f"No sample lies within {SUPPORT_DEG:g}° of the readings at {', '.join(far)}.",) if far else ()


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
    distance = nearest_sample_deg(reflectance, geometry)
    return Reading(geometry, triple(rho), triple(lab_to_xyz(lab)), triple(lab), distance)


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

"""The sun: direction, brightness, colour, and its disc on a map.

Illuminance on a surface that faces the sun: ``127.5 klx · exp(-c/sin h)`` with c = 0.21 for a clear day (IES
Lighting Handbook, 8th edition, daylight availability). Colour: the CIE daylight locus (CIE 15) at 5,300 K, about
that of the direct beam at a solar height of 40°. The disc is 0.53° across.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.panorama import colour_from_chromaticity, directions, solid_angles

DIAMETER_DEG = 0.53
SOLID_ANGLE = 2.0 * np.pi * (1.0 - np.cos(np.radians(0.5 * DIAMETER_DEG)))
_OUTSIDE_KLX, _EXTINCTION = 127.5, 0.21
_KELVIN = 5300.0


@dataclass(frozen=True)
class Sun:
    """A sun at a height above the horizon and an azimuth from +z towards +x, degrees."""

    height_deg: float
    azimuth_deg: float

    @property
    def direction(self) -> Floats:
        """Unit vector (3,) towards the sun."""
        height, azimuth = np.radians([self.height_deg, self.azimuth_deg])
        ground = np.cos(height)
        return np.array([ground * np.sin(azimuth), np.sin(height), ground * np.cos(azimuth)])

    @property
    def normal_illuminance(self) -> float:
        """Kilolux on a surface that faces the sun, from the disc alone."""
        return float(_OUTSIDE_KLX * np.exp(-_EXTINCTION / np.sin(np.radians(self.height_deg))))

    @property
    def colour(self) -> Floats:
        """Working-space colour (3,) of unit luminance."""
        k = _KELVIN
        x = -4.6070e9 / k**3 + 2.9678e6 / k**2 + 0.09911e3 / k + 0.244063
        return colour_from_chromaticity(x, -3.0 * x * x + 2.870 * x - 0.275)

    @property
    def radiance(self) -> Floats:
        """Working-space radiance (3,) of the disc, kcd/m²."""
        return np.asarray(self.colour * (self.normal_illuminance / SOLID_ANGLE))


def add_disc(picture: Floats, sun: Sun, samples: int = 64) -> Floats:
    """Return the map with the disc on it, each pixel by the share of it that the disc covers.

    The shares are scaled so that the disc has its true solid angle: what the sun gives is exact at any size of map.
    """
    height, width = picture.shape[:2]
    x, y, z = sun.direction
    row = np.arccos(y) / np.pi * height
    column = (0.5 + np.arctan2(-x, z) / (2.0 * np.pi)) * width
    reach = np.radians(DIAMETER_DEG) / np.pi * height + 1.0
    rows = np.arange(max(0, int(row - reach)), min(height, int(row + reach) + 1))
    wide = reach / np.sqrt(1.0 - y * y)
    columns = np.arange(int(column - wide), int(column + wide) + 1)
    offsets = (np.arange(samples) + 0.5) / samples
    fine_rows = (rows[:, None] + offsets).reshape(-1) / height
    fine_columns = (columns[:, None] + offsets).reshape(-1) / width
    toward = directions(fine_rows, fine_columns)
    # 1 - cos = |difference|²/2 keeps its digits where a dot product near 1 would not.
    apart = ((toward - sun.direction) ** 2).sum(axis=-1)
    inside = apart <= (2.0 * np.sin(np.radians(0.25 * DIAMETER_DEG))) ** 2
    share = inside.reshape(len(rows), samples, len(columns), samples).mean(axis=(1, 3))
    share *= SOLID_ANGLE / (share * solid_angles(height)[rows]).sum()
    result = picture.copy()
    place = np.ix_(rows, columns % width)
    covered = np.minimum(share, 1.0)[..., None]
    result[place] = result[place] * (1.0 - covered) + share[..., None] * sun.radiance
    return result

"""The sun: direction, brightness, colour, and its disc on a map.

Illuminance on a surface that faces the sun: ``127.5 klx · exp(-c/sin h)`` with c = 0.21 for a clear day (IES
Lighting Handbook, 8th edition, daylight availability). Colour: the CIE daylight locus (CIE 15) at 5,300 K, about
that of the direct beam at a solar height of 40°. The disc is 0.53° across.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import from_horizon
from brdf_suite.lighting.procedural.hosek_wilkie import spectrum_to_working, sun_spectral
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
        return from_horizon(self.azimuth_deg, self.height_deg)

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


_RADIUS = np.radians(0.5 * DIAMETER_DEG)
_SAMPLES, _LEAST_SAMPLES = 64, 4


class LimbDisc:
    """The disc of a sun under a haze, 0.53° across, darker and redder towards its limb."""

    def __init__(self, sun: Sun, turbidity: float) -> None:
        self.sun = sun
        self._elevation = float(np.radians(sun.height_deg))
        self._turbidity = turbidity

    def radiance(self, share: Floats) -> Floats:
        """Return radiance (..., 3), kcd/m², at ``share`` (...) of the way from the middle (0) to the limb (1)."""
        cos_psi = np.sqrt(np.maximum(1.0 - share**2, 0.0))
        spectrum = sun_spectral(self._elevation, self._turbidity, DIAMETER_DEG, cos_psi)
        return np.maximum(spectrum @ spectrum_to_working(), 0.0)

    def illuminance(self) -> Floats:
        """Return the illuminance (3,), klx, of a surface that faces the sun."""
        nodes, weights = np.polynomial.legendre.leggauss(48)
        share = 0.5 * (nodes + 1.0)
        # sin(γ) grows evenly from the middle to the limb, and so does the part of it that share is.
        rings = np.pi * share * weights * np.sin(_RADIUS) ** 2
        return np.asarray(rings @ self.radiance(share))

    def add_to(self, picture: Floats) -> Floats:
        """Return the map (h, 2h, 3) with the disc before it; what the disc gives is exact at any size of map."""
        height, width = picture.shape[:2]
        x, y, z = self.sun.direction
        row = np.arccos(y) / np.pi * height
        column = (0.5 + np.arctan2(-x, z) / (2.0 * np.pi)) * width
        reach = _RADIUS / np.pi * height + 1.0
        across = np.sqrt(1.0 - y * y)
        rows = np.arange(max(0, int(row - reach)), min(height, int(row + reach) + 1))
        wide = min(reach / max(across - _RADIUS, 1e-6), 0.5 * width)
        columns = np.arange(int(column - wide), min(int(column + wide) + 1, int(column - wide) + width))
        # Near the zenith pixels are narrow slices: fewer samples across each.
        fine_across = max(_LEAST_SAMPLES, int(_SAMPLES * min(1.0, across)))
        down = (rows[:, None] + (np.arange(_SAMPLES) + 0.5) / _SAMPLES).reshape(-1) / height
        sideways = (columns[:, None] + (np.arange(fine_across) + 0.5) / fine_across).reshape(-1) / width
        light = np.zeros((len(rows), len(columns), 3))
        covered = np.zeros((len(rows), len(columns)))
        for i, strip in enumerate(down.reshape(len(rows), _SAMPLES)):
            # |difference|²/4 = sin²(γ/2) keeps its digits where a dot product near 1 would not.
            apart = ((directions(strip, sideways) - self.sun.direction) ** 2).sum(axis=-1)
            inside = apart <= (2.0 * np.sin(0.5 * _RADIUS)) ** 2
            share = np.sqrt(apart * (1.0 - 0.25 * apart)) / np.sin(_RADIUS)
            bright = np.zeros((*share.shape, 3))
            bright[inside] = self.radiance(np.minimum(share[inside], 1.0))
            shape = (_SAMPLES, len(columns), fine_across)
            covered[i] = inside.reshape(shape).mean(axis=(0, 2))
            light[i] = bright.reshape(*shape, 3).mean(axis=(0, 2))
        total = (light * solid_angles(height)[rows][..., None]).sum(axis=(0, 1))
        light *= np.where(total > 0.0, self.illuminance() / np.maximum(total, 1e-300), 0.0)
        result = picture.copy()
        place = np.ix_(rows, columns % width)
        result[place] = result[place] * (1.0 - covered)[..., None] + light
        return result

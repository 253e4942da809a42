"""Ground around the object, a paved yard and grass beyond it, and the skyline of the horizon.

The skyline has distant hills, a row of trees, a few plain buildings.

A paint without a horizon to mirror looks like nothing. The shapes are drawn once from a fixed seed, as heights
over the azimuth; their light is albedo times the illuminance of a wall that faces the viewer, over π, with haze
that grows with distance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.panorama import edge, mix

_EYE_M = 1.0
_YARD_M, _YARD_EDGE_M = 11.0, 0.8
_SLAB_M = 3.0
# Albedos, given in Rec. 709 as references have them.
_PAVING = REC709_TO_WORKING @ [0.235, 0.230, 0.222]
_GRASS = REC709_TO_WORKING @ [0.072, 0.090, 0.042]


def ground_radiance(toward: Floats, light: Floats, haze: Floats) -> Floats:
    """Return the ground's radiance (..., 3) for directions below the horizon.

    Parameters
    ----------
    toward
        Unit directions (..., 3).
    light
        (3,) illuminance of the ground over π, working space.
    haze
        (..., 3) radiance of the horizon above each place.
    """
    down = np.maximum(-toward[..., 1], 1e-4)
    x, z = toward[..., 0] / down * _EYE_M, toward[..., 2] / down * _EYE_M
    distance = np.hypot(x, z)
    tone = 1.0 + 0.06 * np.sin(0.9 * x + 0.4 * z) * np.sin(0.7 * z - 0.3 * x) / (1.0 + 0.02 * distance**2)
    # Joints between slabs, which blur out with distance.
    fine = np.exp(-((distance / 5.0) ** 2))
    joint = np.maximum(_joint(x), _joint(z)) * fine
    paving = _PAVING * (tone * (1.0 - 0.35 * joint))[..., None]
    grass = _GRASS * (1.0 + 0.12 * np.sin(0.23 * x) * np.sin(0.31 * z))[..., None]
    albedo = mix(paving, grass, edge(distance - _YARD_M, _YARD_EDGE_M))
    far = 0.10 * (1.0 - np.exp(-distance / 400.0))
    return mix(albedo * light, haze, far)


def _joint(place: Floats) -> Floats:
    off = np.abs((place / _SLAB_M) % 1.0 - 0.5) * _SLAB_M
    return np.asarray(1.0 - edge(off - 0.012, 0.02))


_SOFT = np.radians(0.35)
_TALLEST = np.radians(14.0)
# Albedos, given in Rec. 709 as references have them.
_HILL = REC709_TO_WORKING @ [0.060, 0.075, 0.055]
_TREE_DARK = REC709_TO_WORKING @ [0.030, 0.037, 0.022]
_TREE_LIGHT = REC709_TO_WORKING @ [0.085, 0.108, 0.052]


@dataclass(frozen=True, eq=False)
class Skyline:
    """Fixed silhouettes; azimuths and heights in radians."""

    waves: Floats  # (w, 3): amplitude, whole periods around, phase
    crowns: Floats  # (t, 4): azimuth, half width, height, tone 0…1
    buildings: Floats  # (b, 5): azimuth, half width, height, albedo, warmth

    @classmethod
    def grown(cls, seed: int) -> Skyline:
        """Return the skyline of a seed."""
        rng = np.random.default_rng(seed)
        periods = np.array([2, 3, 5, 7, 11, 17, 29])
        waves = np.stack([0.9 / periods, periods, rng.uniform(0.0, 2.0 * np.pi, 7)], axis=1)
        count = 90
        azimuth = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False) + rng.uniform(-0.04, 0.04, count)
        # Groves and gaps: the row's height follows a slow wave.
        grove = 0.62 + 0.38 * np.sin(2.0 * azimuth + rng.uniform(0.0, 6.0)) * np.sin(3.0 * azimuth)
        height = np.radians(rng.uniform(3.2, 7.5, count)) * grove
        width = np.radians(rng.uniform(2.0, 5.0, count))
        crowns = np.stack([azimuth, width, height, rng.uniform(0.0, 1.0, count)], axis=1)
        sides = np.radians([-142.0, -78.0, -18.0, 48.0, 118.0]) + rng.uniform(-0.1, 0.1, 5)
        blocks = [
            [side, np.radians(rng.uniform(6.0, 14.0)), np.radians(rng.uniform(6.0, 11.5)), albedo, warmth]
            for side, albedo, warmth in zip(
                sides, rng.uniform(0.22, 0.5, 5), rng.uniform(0, 1, 5), strict=True
            )
        ]
        return cls(waves, crowns, np.array(blocks))

    def over(self, sky: Floats, toward: Floats, wall_light: Floats) -> Floats:
        """Return ``sky`` (..., 3) with the skyline in front of it.

        Parameters
        ----------
        sky
            Radiance behind, (..., 3); at the horizon it is also the colour of the haze.
        toward
            Unit directions (..., 3).
        wall_light
            (..., 3) illuminance over π on an upright wall that faces the viewer, per azimuth.
        """
        elevation = np.arcsin(np.clip(toward[..., 1], -1.0, 1.0))
        if elevation.min() > _TALLEST or elevation.max() < -_SOFT:
            return sky
        azimuth = np.arctan2(toward[..., 0], toward[..., 2])
        picture = sky
        amplitude, periods, phase = self.waves.T
        ridge = np.sin(azimuth[..., None] * periods + phase) @ amplitude
        hill = np.radians(3.0 + 1.3 * ridge)
        far = mix(_HILL * wall_light, sky, np.full(azimuth.shape, 0.72))
        picture = mix(picture, far, edge(hill - elevation, _SOFT))
        for place, width, height, albedo, warmth in self.buildings:
            picture = self._building(
                picture, azimuth - place, elevation, (width, height, albedo, warmth), wall_light
            )
        for place, width, height, tone in self.crowns:
            beside = _wrapped(azimuth - place) / width
            top = height * np.sqrt(np.maximum(1.0 - beside**2, 0.0))
            # Crowns are lit from above: dark below, light at the top.
            up = np.clip(elevation / np.maximum(top, 1e-6), 0.0, 1.0) ** 1.5
            leaf = mix(_TREE_DARK, _TREE_LIGHT * (0.7 + 0.6 * tone), up)
            near = mix(leaf * wall_light, sky, np.full(azimuth.shape, 0.06))
            picture = mix(picture, near, edge(top - elevation, _SOFT) * (np.abs(beside) < 1.0))
        return picture

    @staticmethod
    def _building(
        picture: Floats,
        beside: Floats,
        elevation: Floats,
        shape: tuple[float, float, float, float],
        wall_light: Floats,
    ) -> Floats:
        width, height, albedo, warmth = shape
        beside = _wrapped(beside)
        inside = edge(width - np.abs(beside), _SOFT) * edge(height - elevation, _SOFT)
        wall = albedo * mix(np.array([0.97, 1.0, 1.03]), np.array([1.10, 1.0, 0.86]), np.array(warmth))
        # Window bands, drawn soft: floors of 1.5°, glass at two thirds of the wall's light.
        floors = 0.5 + 0.5 * np.cos(2.0 * np.pi * elevation / np.radians(1.5))
        bays = edge(0.5 + 0.5 * np.cos(2.0 * np.pi * beside / np.radians(2.6)) - 0.35, 0.5)
        glass = edge(floors - 0.45, 0.5) * bays * edge(height - np.radians(0.8) - elevation, _SOFT)
        facade = mix(wall * wall_light, 0.32 * wall * wall_light, glass)
        return mix(picture, facade, inside)


def _wrapped(angle: Floats) -> Floats:
    """Return angles brought into -π…π."""
    return np.asarray((angle + np.pi) % (2.0 * np.pi) - np.pi)

"""A virtual sphere in a fixed light: its pixels, and how far two paints are apart on it.

The light is grey: a CIE overcast sky over a dark ground, and a sun of 5° radius, 45° high and 45° to the left of the
viewer, that gives three times the sky's illuminance. The view is orthographic along the horizon. A sphere sees no part
of itself, so a pixel is one integral,

    L_o = ∫ L(ω) f_r(ω, wo) cosθ dω,

which is a sum over fixed directions: those of a mixture of a matt part, a wide and a narrow facet lobe for the sky, and
even ones on the disc of the sun. All paints are summed over the same directions, so their differences hold less noise
than their values. Exposure sets the median luminance of the first paint to 0.18; light above 1 is white.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import from_horizon
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.protocol import Reflectance

SUN_RADIUS_DEG = 5.0
SUN_SHARE = 3.0
"""Illuminance of the sun across its direction, per illuminance of the level ground by the sky."""
SUN_PLACE = (-45.0, 45.0)
"""Azimuth from the viewer, positive to the right, and elevation, degrees."""
GROUND = 0.15
MEDIAN = 0.18

_POINTS, _SKY, _SUN = 240, 256, 24
_LOBES = ((1.0, 0.4), (0.5, 0.1), (0.3, 0.02), (0.6, 0.003))
# Shares, of 1 for a matt part, and widths of facet lobes that directions are drawn from.


def sky_light(directions: Floats) -> Floats:
    """Return the radiance (...) without the sun at world directions (..., 3), y up; 1 at the zenith."""
    up = directions[..., 1]
    share = np.clip((up + 0.04) / 0.08, 0.0, 1.0)
    return np.asarray(
        GROUND + (share * share * (3.0 - 2.0 * share)) * ((1.0 + 2.0 * up.clip(0.0)) / 3.0 - GROUND)
    )


def sun_direction(place: tuple[float, float] = SUN_PLACE) -> Floats:
    """Return the direction (3,) to the sun's middle; the viewer is at +z."""
    return from_horizon(*place)


def sun_radiance() -> float:
    """Return the radiance of the sun's disc."""
    # The CIE overcast sky of zenith 1 gives 7π/9.
    solid = 2.0 * math.pi * (1.0 - math.cos(math.radians(SUN_RADIUS_DEG)))
    return SUN_SHARE * 7.0 * math.pi / 9.0 / solid


def light_map(height: int) -> Floats:
    """Return the light as a latitude-longitude map (height, 2 height), y up, as environment maps are laid out."""
    rows, columns = np.meshgrid(np.arange(4 * height), np.arange(8 * height), indexing="ij")
    theta = (rows + 0.5) / (4 * height) * math.pi
    # The centre column looks along +z and u grows towards -x.
    phi = ((columns + 0.5) / (8 * height) - 0.5) * 2.0 * math.pi
    where = np.stack((-np.sin(theta) * np.sin(phi), np.cos(theta), np.sin(theta) * np.cos(phi)), axis=-1)
    light = sky_light(where)
    light[where @ sun_direction() > math.cos(math.radians(SUN_RADIUS_DEG))] += sun_radiance()
    return np.asarray(light.reshape(height, 4, 2 * height, 4).mean(axis=(1, 3)))


@dataclass(frozen=True, eq=False)
class RenderedSphere:
    """Directions (n, 3) that the pixels are summed over, local frame, pixel by pixel.

    ``weight`` (n,) is L cosθ / pdf per direction; ``first`` (points,) where each pixel's begin; ``cos_o`` (points,) the
    cosine of the view from the normal.
    """

    wi: Floats
    wo: Floats
    weight: Floats
    first: NDArray[np.intp]
    cos_o: Floats

    def pixels(self, paint: Reflectance) -> Floats:
        """Return the radiance (points, 3), working space."""
        return self.summed(paint.eval)

    def summed(self, value: Callable[[Floats, Floats], Floats]) -> Floats:
        """Return ∫ value(wi, wo) L cosθ dω (points, ...) of a function (n, ...) of directions (n, 3)."""
        found = value(self.wi, self.wo)
        weight = self.weight if found.ndim == 1 else self.weight[:, None]
        return np.asarray(np.add.reduceat(found * weight, self.first, axis=0))


def exposure(pixels: Floats) -> float:
    """Return the factor that brings the median luminance of ``pixels`` (points, 3) to 0.18."""
    return MEDIAN / max(float(np.median(pixels @ LUMINANCE)), 1e-12)


def shown_lab(pixels: Floats, factor: float) -> Floats:
    """Return L*a*b* (points, 3) of radiance (points, 3), working space, as a screen of white 1 shows it."""
    return working_to_lab(np.clip(pixels * factor, 0.0, 1.0))


def sphere_difference(paint: Reflectance, other: Reflectance) -> float:
    """Return the mean ΔE00 between spheres in two paints, exposed for the first."""
    sphere = rendered_sphere()
    first = sphere.pixels(paint)
    factor = exposure(first)
    return float(delta_e_2000(shown_lab(first, factor), shown_lab(sphere.pixels(other), factor)).mean())


@lru_cache(maxsize=8)
def rendered_sphere(
    sun: tuple[float, float] = SUN_PLACE, points: int = _POINTS, sky: int = _SKY
) -> RenderedSphere:
    """Return the sphere in the light with the sun at ``sun`` (azimuth, elevation, degrees)."""
    place = np.arange(points) + 0.5
    # Sunflower points cover the disc evenly.
    radius, turn = np.sqrt(place / points), place * math.pi * (3.0 - math.sqrt(5.0))
    normal = np.stack((radius * np.cos(turn), radius * np.sin(turn), np.sqrt(1.0 - radius**2)), axis=-1)
    view = np.array([0.0, 0.0, 1.0])
    along = view - normal * normal[:, 2:]
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    frame = np.stack((along, np.cross(normal, along), normal), axis=1)
    wo = frame @ view
    u = _even(points, sky)
    sampler = _Sampler()
    many = np.broadcast_to(wo[:, None], (points, sky, 3))
    wi = sampler.sample(many, u)
    density = sampler.pdf(wi, many)
    world = np.einsum("pij,pki->pkj", frame, wi)
    weight = np.where(density > 0.0, sky_light(world) * wi[..., 2] / np.maximum(density, 1e-12) / sky, 0.0)
    disc = _sun_disc(sun)
    to_sun = np.einsum("pij,kj->pki", frame, disc)
    solid = 2.0 * math.pi * (1.0 - math.cos(math.radians(SUN_RADIUS_DEG)))
    bright = sun_radiance() * solid / len(disc) * to_sun[..., 2].clip(0.0)
    wi = np.concatenate((wi, to_sun), axis=1)
    weight = np.concatenate((weight, bright), axis=1)
    counted = weight > 0.0
    ends = counted.sum(axis=1).cumsum()
    if (np.diff(ends, prepend=0) == 0).any():
        raise ValueRangeError("points", "a pixel sees no light: too few directions")
    return RenderedSphere(
        wi[counted],
        np.broadcast_to(wo[:, None], wi.shape)[counted],
        weight[counted],
        np.concatenate(([0], ends[:-1])),
        wo[:, 2],
    )


class _Sampler(mixture.MixtureSampled):
    """Directions for whatever a paint may be made of."""

    @property
    def _parts(self) -> list[mixture.MixturePart]:
        return [mixture.diffuse(1.0), *(mixture.ggx(share, alpha) for share, alpha in _LOBES)]


def _even(points: int, count: int) -> Floats:
    """Return numbers (points, count, 3) in [0, 1): one lattice, shifted by another at each point."""
    steps = np.array([0.8191725133961645, 0.6710436067037893, 0.5497004779019703])
    shift = np.array([0.7548776662466927, 0.5698402909980532, 0.4301597090019468])
    lattice = np.arange(count)[:, None] * steps
    return np.asarray((lattice + (np.arange(points)[:, None] * shift)[:, None]) % 1.0)


def _sun_disc(sun: tuple[float, float]) -> Floats:
    """Return directions (k, 3), even on the disc of the sun."""
    middle = sun_direction(sun)
    across = np.cross(middle, [0.0, 1.0, 0.0])
    across /= np.linalg.norm(across)
    place = np.arange(_SUN) + 0.5
    cosine = 1.0 - place / _SUN * (1.0 - math.cos(math.radians(SUN_RADIUS_DEG)))
    sine, turn = np.sqrt(1.0 - cosine**2), place * math.pi * (3.0 - math.sqrt(5.0))
    return np.asarray(
        cosine[:, None] * middle
        + (sine * np.cos(turn))[:, None] * across
        + (sine * np.sin(turn))[:, None] * np.cross(across, middle)
    )

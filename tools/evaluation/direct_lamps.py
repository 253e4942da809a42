"""Lamps on a surface by the reflectance itself, pixel by pixel in numpy: what a real-time picture is compared with."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.progress import Progress, report
from brdf_suite.realtime.pictures.probe import GeometryPicture
from brdf_suite.reflectance.protocol import Reflectance


def lamp_radiance(
    reflectance: Reflectance,
    seen: GeometryPicture,
    lamps: Sequence[Lamp],
    progress: Progress | None = None,
) -> Floats:
    """Return the radiance (h, w, 3) that lamps make the surface send, working space; 0 past the surface.

    Σ E f_r(wi, wo) cosθi, as the shaders have it: no shadows, one sample in the middle of a pixel. The tangent is any
    that stands still on the surface, so only what looks alike from all sides is right.
    """
    there = seen.parts >= 0
    place, normal = seen.positions[there].astype(np.float64), seen.normals[there].astype(np.float64)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    to_local = np.stack(_frame(normal), axis=1)
    wo = np.einsum("nij,nj->ni", to_local, _unit(seen.eye - place))
    total = np.zeros_like(place)
    for number, lamp in enumerate(lamps):
        report(progress, number / len(lamps), "evaluating the reflectance")
        way, irradiance = _arriving(lamp, place)
        wi = np.einsum("nij,nj->ni", to_local, way)
        lit = wi[:, 2] > 0.0
        f = reflectance.eval(wi[lit], wo[lit])
        total[lit] += f * irradiance[lit] * wi[lit, 2:]
    found = np.zeros((*there.shape, 3))
    found[there] = total
    return found


def half_angles_deg(seen: GeometryPicture, lamps: Sequence[Lamp]) -> Floats:
    """Return the least angle (h, w) between the normal and a lamp's half vector, degrees; 90 where none is there."""
    there = seen.parts >= 0
    place = seen.positions[there].astype(np.float64)
    normal = _unit(seen.normals[there].astype(np.float64))
    least = np.full(len(place), 90.0)
    for lamp in lamps:
        way, _ = _arriving(lamp, place)
        h = _unit(way + _unit(seen.eye - place))
        angle = np.degrees(np.arccos(np.clip((h * normal).sum(axis=-1), -1.0, 1.0)))
        least = np.where((way * normal).sum(axis=-1) > 0.0, np.minimum(least, angle), least)
    found = np.full(there.shape, 90.0)
    found[there] = least
    return found


def _arriving(lamp: Lamp, place: Floats) -> tuple[Floats, Floats]:
    """Return unit directions (n, 3) to a lamp and the irradiance (n, 3) on what faces it."""
    power = math.pi * lamp.strength * lamp_colour(lamp.temperature_k)
    if lamp.kind == "point":
        way = np.asarray(lamp.position) - place
        return _unit(way), power / (way**2).sum(axis=-1, keepdims=True)
    azimuth, elevation = math.radians(lamp.azimuth_deg), math.radians(lamp.elevation_deg)
    level = math.cos(elevation)
    towards = np.array([level * math.sin(azimuth), math.sin(elevation), level * math.cos(azimuth)])
    return np.broadcast_to(towards, place.shape), np.broadcast_to(power, place.shape)


def _frame(n: Floats) -> tuple[Floats, Floats, Floats]:
    """Return tangent, bitangent and normal (n, 3) each (Duff et al., JCGT 6(1), 2017)."""
    side = np.where(n[:, 2] >= 0.0, 1.0, -1.0)
    a = -1.0 / (side + n[:, 2])
    b = n[:, 0] * n[:, 1] * a
    t = np.stack((1.0 + side * n[:, 0] ** 2 * a, side * b, -side * n[:, 0]), axis=-1)
    return t, np.stack((b, side + n[:, 1] ** 2 * a, -n[:, 1]), axis=-1), n


def _unit(v: Floats) -> Floats:
    return np.asarray(v / np.linalg.norm(v, axis=-1, keepdims=True))

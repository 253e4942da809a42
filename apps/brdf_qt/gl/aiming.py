"""Lamps by hand: a map of all directions around the object, and where a lamp must be for its mirror image."""

from __future__ import annotations

import math
from dataclasses import replace
from math import hypot

import numpy as np

from brdf_suite.arrays import Floats, triple
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.geometry.polar import point_at, polar

_FARTHEST = 2.0 * 175.0 / 180.0
NEW_LAMP = Lamp("directional", strength=1.0, angle_deg=2.0)
"""What is added where a highlight is wanted and there is no lamp: a small bright disc."""


def polar_of(lamp: Lamp) -> tuple[float, float, float]:
    """Return azimuth and elevation in degrees and the distance in metres of where a lamp's light comes from.

    >>> [round(value, 3) for value in polar_of(Lamp(position=(0.0, 3.0, 3.0)))]
    [0.0, 45.0, 4.243]
    """
    if lamp.kind == "directional":
        return (lamp.azimuth_deg + 180.0) % 360.0 - 180.0, lamp.elevation_deg, hypot(*lamp.position)
    azimuth, elevation, distance = polar(lamp.position)
    return azimuth, elevation, max(0.05, distance)


def placed(lamp: Lamp, azimuth_deg: float, elevation_deg: float, distance: float) -> Lamp:
    """Return the lamp at another place; both forms of it are kept in step, so that a change of kind keeps it."""
    position = point_at(azimuth_deg, elevation_deg, distance)
    return replace(lamp, position=position, azimuth_deg=azimuth_deg, elevation_deg=elevation_deg)


def map_place(direction: Floats, axes: Floats) -> Floats:
    """Return where a direction (3,) lies on the map (2,), right and up.

    ``axes`` has the camera's right, up and backward as columns. The camera's own direction is in the middle, what is
    at a right angle to it on the unit circle, and what is behind the object outside, up to 2: the azimuthal
    equidistant projection, in which every direction has a place.
    """
    right, up, back = direction @ axes / np.linalg.norm(direction)
    aside = math.hypot(right, up)
    far = min(math.atan2(aside, back) / (0.5 * math.pi), _FARTHEST)
    if aside < 1e-9:
        return np.array([0.0, 0.0 if back > 0.0 else far])
    return np.array([right, up]) * (far / aside)


def map_direction(place: Floats, axes: Floats) -> Floats:
    """Return the unit direction (3,) of a place of the map; the inverse of :func:`map_place`."""
    far = float(np.hypot(*place))
    angle = 0.5 * math.pi * min(far, _FARTHEST)
    right, up = (0.0, 0.0) if far < 1e-9 else place / far
    local = np.array([math.sin(angle) * right, math.sin(angle) * up, math.cos(angle)])
    return np.asarray(axes @ local)


def direction_of(lamp: Lamp) -> Floats:
    """Return the unit direction (3,) in which a lamp lies, seen from the middle of the scene."""
    azimuth, elevation, _ = polar_of(lamp)
    return np.array(point_at(azimuth, elevation, 1.0))


def turned_to(lamp: Lamp, direction: Floats) -> Lamp:
    """Return the lamp in another direction, as far away as it was."""
    azimuth, elevation, _ = polar(triple(direction))
    return placed(lamp, azimuth, elevation, polar_of(lamp)[2])


def mirror_direction(normal: Floats, to_eye: Floats) -> Floats:
    """Return the unit direction (3,) of what an eye sees mirrored: ``to_eye`` reflected about the unit ``normal``.

    The side of the surface that the eye sees is the one that mirrors.
    """
    seen = normal if normal @ to_eye >= 0.0 else -normal
    return np.asarray(2.0 * (seen @ to_eye) * seen - to_eye)


def lamp_for_highlight(lamp: Lamp, position: Floats, normal: Floats, to_eye: Floats) -> Lamp:
    """Return the lamp where its mirror image is seen at ``position`` (3,) m of the surface.

    A point lamp stays as far from the middle of the scene as it was, where a place on the mirrored ray is so far.
    """
    direction = mirror_direction(normal, to_eye)
    if lamp.kind == "directional":
        return turned_to(lamp, direction)
    # |position + t direction| = distance, for the t > 0.
    distance, along = polar_of(lamp)[2], float(position @ direction)
    root = along * along - float(position @ position) + distance * distance
    way = math.sqrt(root) - along if root > 0.0 else -1.0
    place = position + direction * (way if way > 0.0 else distance)
    azimuth, elevation, _ = polar(triple(place))
    return replace(lamp, position=triple(place), azimuth_deg=azimuth, elevation_deg=elevation)

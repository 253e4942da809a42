"""Where a lamp is and how large it looks, in degrees as one thinks of it, beside metres as the document has it.

Azimuth counts from +z (in front) towards +x, elevation from the horizon; sizes are the angles that a lamp takes up
in the middle of the scene.
"""

from __future__ import annotations

import dataclasses
from math import asin, atan, atan2, cos, degrees, radians, sin, sqrt, tan

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.studio import BoothRoom, Point, StudioLamp
from brdf_suite.geometry.polar import polar
from brdf_suite.lighting.procedural.lamps import LampSurface

_LARGEST_ANGLE_DEG = 175.0


def angle_of(size_m: float, distance: float) -> float:
    """Return the angle (°) that a length seen squarely at a distance takes up."""
    return degrees(2.0 * atan(0.5 * size_m / distance))


def size_at(angle_deg: float, distance: float) -> float:
    """Return the length (m) that takes up an angle at a distance; the inverse of :func:`angle_of`."""
    return 2.0 * distance * tan(radians(0.5 * min(angle_deg, _LARGEST_ANGLE_DEG)))


def held_in(room: BoothRoom | None, position: Point) -> Point:
    """Return the position, drawn nearer along its direction where it lies outside of the room."""
    if room is None or room.holds(position):
        return position
    x, y, z = (abs(value) for value in position)
    height = room.height_m - room.eye_height_m if position[1] > 0.0 else room.eye_height_m
    share = min(
        limit / value
        for limit, value in ((0.5 * room.width_m, x), (height, y), (0.5 * room.length_m, z))
        if value > 0.0
    )
    # A hair nearer than the wall, where rounding cannot put it outside.
    share = min(1.0, share * (1.0 - 1e-9))
    return (position[0] * share, position[1] * share, position[2] * share)


def moved(lamp: StudioLamp, position: Point) -> StudioLamp:
    """Return the lamp at another position, its size in metres kept, turned so that it faces the same way from there."""
    facing = lamp.facing
    if facing is not None:
        turned = rotation(np.array(lamp.position_m), np.array(position)) @ np.array(facing)
        facing = (float(turned[0]), float(turned[1]), float(turned[2]))
    return dataclasses.replace(lamp, position_m=position, facing=facing)


def rotation(start: NDArray[np.float64], end: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the turn (3, 3) that brings one direction to another the way of a camera: about y, then up or down."""

    def frame(toward: NDArray[np.float64]) -> NDArray[np.float64]:
        azimuth = atan2(float(toward[0]), float(toward[2]))
        elevation = asin(float(np.clip(toward[1] / np.linalg.norm(toward), -1.0, 1.0)))
        (c, s), (up_c, up_s) = (cos(azimuth), sin(azimuth)), (cos(elevation), sin(elevation))
        about_y = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
        about_x = np.array([[1.0, 0.0, 0.0], [0.0, up_c, up_s], [0.0, -up_s, up_c]])
        return np.asarray(about_y @ about_x)

    return np.asarray(frame(end) @ frame(start).T)


def facing_deg(lamp: StudioLamp) -> tuple[float, float]:
    """Return the azimuth and elevation (°) towards which a lamp shines."""
    facing = lamp.facing if lamp.facing is not None else tuple(-value for value in lamp.position_m)
    azimuth, elevation, _ = polar((facing[0], facing[1], facing[2]))
    return azimuth, elevation


def panorama_place(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return where in a latitude-longitude picture (0…1 across and down) directions (..., 3) lie."""
    unit = direction / np.linalg.norm(direction, axis=-1, keepdims=True)
    across = 0.5 + np.arctan2(-unit[..., 0], unit[..., 2]) / (2.0 * np.pi)
    down = np.arccos(np.clip(unit[..., 1], -1.0, 1.0)) / np.pi
    return np.stack([across, down], axis=-1)


def panorama_direction(across: float, down: float) -> NDArray[np.float64]:
    """Return the unit direction (3,) at a place of the picture; the inverse of :func:`panorama_place`."""
    theta, phi = np.pi * down, 2.0 * np.pi * (across - 0.5)
    return np.array([-sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi)])


def outline(lamp: StudioLamp, points: int = 64) -> NDArray[np.float64]:
    """Return directions (n, 3) around a lamp's edge as seen from the middle of the scene."""
    surface = LampSurface.of(lamp)
    if lamp.shape == "ring":
        turn = np.linspace(0.0, 2.0 * np.pi, points, endpoint=False)
        u, v = np.cos(turn), np.sin(turn)
    else:
        side = np.linspace(-1.0, 1.0, points // 4, endpoint=False)
        ones = np.ones_like(side)
        u = np.concatenate([side, ones, -side, -ones])
        v = np.concatenate([-ones, side, ones, -side])
    along, across = np.outer(u * surface.wide, surface.first), np.outer(v * surface.high, surface.second)
    places = surface.centre + along + across
    return np.asarray(places / np.linalg.norm(places, axis=1, keepdims=True))


def covers(lamp: StudioLamp, direction: NDArray[np.float64]) -> bool:
    """Whether a lamp is seen in a direction from the middle of the scene, its ring's hole included."""
    surface = LampSurface.of(lamp)
    along, reach = float(direction @ surface.facing), float(surface.centre @ surface.facing)
    if along * reach <= 0.0 or abs(along) < 1e-6:
        return False
    place = direction * (reach / along) - surface.centre
    u, v = float(place @ surface.first) / surface.wide, float(place @ surface.second) / surface.high
    return sqrt(u * u + v * v) <= 1.0 if lamp.shape == "ring" else max(abs(u), abs(v)) <= 1.0

"""Studio lamps and the closed room that they light.

A lamp has an appearance from the middle of the scene, and gives light to surfaces. Light on a side of the room is what
the lamps give there, integrated over each lamp, plus one even share for what the room reflects. Lamps cast no shadows
on the walls.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.studio import BoothRoom, StudioLamp

_UP = np.array([0.0, 1.0, 0.0])
_FORWARD = np.array([0.0, 0.0, 1.0])
_BOX_FALL = 0.15  # of the luminance, from the middle to an edge along each axis
_BOX_MEAN = 1.0 - 2.0 * _BOX_FALL / 3.0
_MOST_PATCHES = 256
_CLOSEST_M2 = 0.05  # a wall touches a lamp nowhere: nearer patches would outshine the rest of the grid


@dataclass(frozen=True, eq=False)
class LampSurface:
    """A lamp as geometry: its centre, unit axes (3,), the direction in which it shines and its half sides, metres."""

    lamp: StudioLamp
    centre: Floats
    first: Floats
    second: Floats
    facing: Floats
    wide: float
    high: float
    colour: Floats

    @classmethod
    def of(cls, lamp: StudioLamp) -> LampSurface:
        """Return the geometry of a lamp."""
        centre = np.array(lamp.position_m)
        facing = -centre if lamp.facing is None else np.array(lamp.facing)
        facing = facing / np.linalg.norm(facing)
        across = np.cross(_UP, facing)
        if np.linalg.norm(across) < 1e-6:
            across = np.cross(facing, _FORWARD)  # straight up or down: the first side lies along x
        across = across / np.linalg.norm(across)
        along = np.cross(facing, across)
        roll = np.radians(lamp.roll_deg)
        first = np.cos(roll) * across + np.sin(roll) * along
        second = np.cos(roll) * along - np.sin(roll) * across
        wide, high = 0.5 * lamp.size_m[0], 0.5 * lamp.size_m[1]
        if lamp.shape == "ring":
            high = wide
        colour = np.ones(3) if lamp.colour_temperature_k is None else lamp_colour(lamp.colour_temperature_k)
        return cls(lamp, centre, first, second, facing, wide, high, colour)

    def seen(self, toward: Floats) -> tuple[Floats, Floats]:
        """Return coverage 0…1 and luminance (...) of the lamp in directions (..., 3) from the middle of the scene.

        Seen from behind it covers what is there and gives no light.
        """
        along = toward @ self.facing
        reach = self.centre @ self.facing
        # In front of the lamp, both are negative; behind it, both positive; otherwise the plane is not met.
        met = (along * reach > 0.0) & (np.abs(along) > 1e-6)
        distance = reach / np.where(met, along, np.inf)
        place = toward * distance[..., None] - self.centre
        u, v = place @ self.first / self.wide, place @ self.second / self.high
        fall = np.ones(u.shape)
        if self.lamp.shape == "box":
            fall = 1.0 - _BOX_FALL * np.minimum(u * u, 1.0) - _BOX_FALL * np.minimum(v * v, 1.0)
        lit = self.lamp.luminance if reach < 0.0 else 0.0
        return self.coverage(u, v) * met, lit * fall

    def cone_cosine(self) -> float:
        """Return the cosine of the angle about its centre within which all of the lamp is seen; -1: anywhere."""
        corners = [
            self.centre + u * self.wide * self.first + v * self.high * self.second
            for u in (-1.0, 1.0)
            for v in (-1.0, 1.0)
        ]
        middle = self.centre / np.linalg.norm(self.centre)
        least = min(float(corner @ middle / np.linalg.norm(corner)) for corner in corners)
        # The corners are the farthest of what is less than 90° away.
        return least - 1e-6 if least > 0.0 else -1.0

    def coverage(self, u: Floats, v: Floats) -> Floats:
        """Return by how much (0…1) the lamp covers places (...) of its plane, in half sides from its middle."""
        soft = self.lamp.softness_m
        if self.lamp.shape == "box":
            return np.asarray(
                smooth((1.0 - np.abs(u)) * self.wide / soft) * smooth((1.0 - np.abs(v)) * self.high / soft)
            )
        return smooth(self._depth(u, v) / soft)

    def _depth(self, u: Floats, v: Floats) -> Floats:
        """Return how far (...) within the outline of a strip or ring places are, metres; negative outside."""
        x, y = np.abs(u) * self.wide, np.abs(v) * self.high
        if self.lamp.shape == "strip":
            beyond = np.maximum(x - (self.wide - self.high), 0.0)  # of the round end
            return np.asarray(self.high - np.hypot(beyond, y))
        radius, band = np.hypot(x, y), self.lamp.size_m[1]
        return np.asarray(np.minimum(self.wide - radius, radius - (self.wide - band)))

    def patches(self) -> tuple[Floats, Floats]:
        """Return places (n, 3) on the lamp and the area (n,) that each represents; the areas sum to the lamp's."""
        count_u, count_v = (max(3, round(4 * side)) for side in (self.wide, self.high))
        if self.lamp.shape != "box":
            count_u, count_v = max(count_u, 9), max(count_v, 9 if self.lamp.shape == "ring" else 3)
        shrink = np.sqrt(min(1.0, _MOST_PATCHES / (count_u * count_v)))
        count_u, count_v = max(3, int(count_u * shrink)), max(3, int(count_v * shrink))
        grid_u = (2.0 * (np.arange(count_u) + 0.5) / count_u - 1.0) * self.wide
        grid_v = (2.0 * (np.arange(count_v) + 0.5) / count_v - 1.0) * self.high
        places = np.array([self.centre + u * self.first + v * self.second for u in grid_u for v in grid_v])
        patch = 4.0 * self.wide * self.high / (count_u * count_v)
        if self.lamp.shape == "box":
            return places, np.full(len(places), patch)
        # Of a grid only what lies within the outline; a narrow band may hold none, then its middle line does.
        u, v = np.repeat(grid_u / self.wide, count_v), np.tile(grid_v / self.high, count_u)
        inside = self._depth(u, v) >= 0.0
        if self.lamp.shape == "ring":
            turns = 2.0 * np.pi * (np.arange(32) + 0.5) / 32.0
            radius = self.wide - 0.5 * self.lamp.size_m[1]
            ring = np.cos(turns)[:, None] * self.first + np.sin(turns)[:, None] * self.second
            places, inside = self.centre + radius * ring, np.ones(32, bool)
        return places[inside], np.full(int(inside.sum()), self._area() / int(inside.sum()))

    def _area(self) -> float:
        """Return the area of a strip or a ring, m²."""
        if self.lamp.shape == "strip":
            return 4.0 * (self.wide - self.high) * self.high + np.pi * self.high**2
        return np.pi * (self.wide**2 - (self.wide - self.lamp.size_m[1]) ** 2)

    def illuminance(self, places: Floats, normals: Floats) -> Floats:
        """Return the illuminance (...) on surface places (..., 3) with ``normals`` (..., 3), over the lamp's unit."""
        total = np.zeros(places.shape[:-1])
        on_lamp, areas = self.patches()
        for place in on_lamp:
            ray = place - places
            square = np.maximum((ray**2).sum(axis=-1), _CLOSEST_M2)
            arriving = np.maximum(np.einsum("...k,...k->...", ray, normals), 0.0)
            leaving = np.maximum(-(ray @ self.facing), 0.0)
            total += arriving * leaving / square**2
        mean = _BOX_MEAN if self.lamp.shape == "box" else 1.0
        return np.asarray(total * float(areas[0]) * mean * self.lamp.luminance)


def smooth(x: Floats) -> Floats:
    """Return a soft step: 0 below 0, 1 above 1."""
    t = np.clip(x, 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


class LitRoom:
    """The room's six sides as maps of luminance (cells, cells, 3), or of one channel, in the lamps' unit."""

    def __init__(self, room: BoothRoom, lamps: Sequence[LampSurface], cells: int = 48) -> None:
        low_y = -room.eye_height_m
        self._low = np.array([-0.5 * room.width_m, low_y, -0.5 * room.length_m])
        self._high = np.array([0.5 * room.width_m, room.height_m + low_y, 0.5 * room.length_m])
        low, high = self._low, self._high
        maps: list[Floats] = []
        areas: list[tuple[float, float]] = []
        light, weight = np.zeros(3), 0.0
        steps = (np.arange(cells) + 0.5) / cells
        for axis in range(3):
            first, second = ((axis + 1) % 3, (axis + 2) % 3)
            area = float((high - low)[first] * (high - low)[second])
            for end, sign in ((low, 1.0), (high, -1.0)):
                places = np.empty((cells, cells, 3))
                places[..., axis] = end[axis]
                places[..., first] = (low[first] + (high - low)[first] * steps)[:, None]
                places[..., second] = (low[second] + (high - low)[second] * steps)[None, :]
                normals = np.zeros_like(places)
                normals[..., axis] = sign
                direct = np.zeros((cells, cells, 3))
                for lamp in lamps:
                    direct += lamp.illuminance(places, normals)[..., None] * lamp.colour
                upright = room.floor_albedo if sign > 0 else room.ceiling_albedo
                albedo = upright if axis == 1 else room.wall_albedo
                maps.append(direct * albedo / np.pi)
                areas.append((area, albedo))
                light += area * direct.mean(axis=(0, 1)) * albedo
                weight += area
        # What is reflected is spread evenly and reflected again: a geometric series in the mean albedo.
        mean_albedo = sum(area * albedo for area, albedo in areas) / weight
        even = light / weight / (1.0 - mean_albedo)
        maps = [one + even * albedo / np.pi for one, (_, albedo) in zip(maps, areas, strict=True)]
        # Neutral lamps make a neutral room, whose three channels are one.
        neutral = all(bool((lamp.colour == 1.0).all()) for lamp in lamps)
        self._maps = [one[..., :1] for one in maps] if neutral else maps

    def radiance(self, toward: Floats) -> Floats:
        """Return the luminance (..., 3) of floor, walls and ceiling in directions from the middle of the scene."""
        shape = toward.shape
        toward = toward.reshape(-1, 3)
        with_sign = np.where(toward >= 0.0, self._high, self._low)
        reach = with_sign / np.where(np.abs(toward) < 1e-9, 1e-9, toward)
        distance = np.abs(reach)
        axis = distance.argmin(axis=-1)
        nearest = np.minimum(np.minimum(distance[:, 0], distance[:, 1]), distance[:, 2])
        place = (toward * nearest[..., None] - self._low) / (self._high - self._low)
        channels = self._maps[0].shape[-1]
        result = np.zeros((len(axis), channels))
        for side in range(3):
            first, second = (side + 1) % 3, (side + 2) % 3
            for upper in (0, 1):
                here = np.flatnonzero((axis == side) & ((toward[:, side] >= 0.0) == bool(upper)))
                seen = place[here]
                result[here] = _bilinear(self._maps[2 * side + upper], seen[:, first], seen[:, second])
        return np.repeat(result, 3 // channels, axis=-1).reshape(shape)


def _bilinear(values: Floats, u: Floats, v: Floats) -> Floats:
    size = values.shape[0]
    x, y = (np.clip(w * size - 0.5, 0.0, size - 1.0) for w in (u, v))
    i, j = (np.minimum(w.astype(np.int64), size - 2) for w in (x, y))
    s, t = (x - i)[:, None], (y - j)[:, None]
    low = values[i, j] * (1.0 - t) + values[i, j + 1] * t
    high = values[i + 1, j] * (1.0 - t) + values[i + 1, j + 1] * t
    return np.asarray(low * (1.0 - s) + high * s)

"""A closed room lit by lamps: the luminance of its floor, walls and ceiling.

Light on a surface is what the lamps give there, integrated over each lamp, plus one even share for what the room
reflects. Lamps cast no shadows on the walls.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.studio import BoothRoom
from brdf_suite.lighting.procedural.lamps import LampSurface


class LitRoom:
    """The room's six sides as maps of luminance (cells, cells, 3), or of one channel, in the lamps' unit."""

    def __init__(self, room: BoothRoom, lamps: Sequence[LampSurface], cells: int = 48) -> None:
        low_y = -room.eye_height_m
        self._low = np.array([-0.5 * room.width_m, low_y, -0.5 * room.length_m])
        self._high = np.array([0.5 * room.width_m, room.height_m + low_y, 0.5 * room.length_m])
        self._maps = self._lit(room, lamps, cells)

    def _lit(self, room: BoothRoom, lamps: Sequence[LampSurface], cells: int) -> list[Floats]:
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
        return [one[..., :1] for one in maps] if neutral else maps

    def radiance(self, toward: Floats) -> Floats:
        """Return the luminance (..., 3) of floor, walls and ceiling in directions from the middle of the scene."""
        with_sign = np.where(toward >= 0.0, self._high, self._low)
        reach = with_sign / np.where(np.abs(toward) < 1e-9, 1e-9, toward)
        axis = np.abs(reach).argmin(axis=-1)
        nearest = np.abs(reach).min(axis=-1)
        place = (toward * nearest[..., None] - self._low) / (self._high - self._low)
        channels = self._maps[0].shape[-1]
        result = np.zeros((*axis.shape, channels))
        for side in range(3):
            first, second = (side + 1) % 3, (side + 2) % 3
            for upper in (0, 1):
                here = (axis == side) & ((toward[..., side] >= 0.0) == bool(upper))
                result[here] = _bilinear(
                    self._maps[2 * side + upper], place[here][:, first], place[here][:, second]
                )
        return np.repeat(result, 3 // channels, axis=-1)


def _bilinear(values: Floats, u: Floats, v: Floats) -> Floats:
    size = values.shape[0]
    x, y = (np.clip(w * size - 0.5, 0.0, size - 1.0) for w in (u, v))
    i, j = (np.minimum(w.astype(np.int64), size - 2) for w in (x, y))
    s, t = (x - i)[:, None], (y - j)[:, None]
    low = values[i, j] * (1.0 - t) + values[i, j + 1] * t
    high = values[i + 1, j] * (1.0 - t) + values[i + 1, j + 1] * t
    return np.asarray(low * (1.0 - s) + high * s)

"""A light booth: a neutral room with large soft boxes, as paint is judged and photographed in.

A closed room, 9 × 14 m and 4.2 m high, seen from 0.9 m above the middle of its floor. All lamps and surfaces are
neutral (D65). Long strips along the room draw the lines that show a form; a broad box above gives the flop its
highlight, and two tall ones at the sides and one in front separate the flanks. Light on walls and floor is what
the boxes give there, integrated over each box, plus one even share for what the room reflects.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment, draw, finish

Float64 = NDArray[np.float64]

_LOW = np.array([-4.5, -0.9, -7.0])
_HIGH = np.array([4.5, 3.3, 7.0])
_FLOOR_ALBEDO, _WALL_ALBEDO, _CEILING_ALBEDO = 0.26, 0.43, 0.30  # walls: Munsell N7


@dataclass(frozen=True)
class SoftBox:
    """A lamp: centre, half sides along two axes (metres, from the middle of the room at eye height), kcd/m²."""

    centre: tuple[float, float, float]
    first: tuple[float, float, float]
    second: tuple[float, float, float]
    luminance: float
    softness: float = 0.06

    @property
    def sides(self) -> tuple[Float64, Float64, Float64, float, float]:
        """Unit axes, the side that shines, and the half lengths."""
        first, second = np.array(self.first), np.array(self.second)
        wide, high = float(np.linalg.norm(first)), float(np.linalg.norm(second))
        first, second = first / wide, second / high
        facing = np.cross(first, second)
        if facing @ np.array(self.centre) > 0.0:
            facing = -facing
        return first, second, facing, wide, high

    def seen(self, toward: Float64) -> tuple[Float64, Float64]:
        """Return coverage 0…1 and luminance (kcd/m²) of the box in directions (..., 3) from the middle.

        The cloth is brightest in the middle and falls off to 70 % at its edge.
        """
        first, second, facing, wide, high = self.sides
        toward_box = toward @ facing
        distance = (np.array(self.centre) @ facing) / np.where(toward_box < -1e-6, toward_box, np.inf)
        place = toward * distance[..., None] - np.array(self.centre)
        u, v = place @ first / wide, place @ second / high
        inside_u = _side((1.0 - np.abs(u)) * wide / self.softness)
        inside_v = _side((1.0 - np.abs(v)) * high / self.softness)
        fall = 1.0 - 0.15 * np.minimum(u * u, 1.0) - 0.15 * np.minimum(v * v, 1.0)
        return inside_u * inside_v * (toward_box < -1e-6), self.luminance * fall

    def illuminance(self, places: Float64, normals: Float64) -> Float64:
        """Return klx (...) on surface places (..., 3) with ``normals`` (..., 3), from a grid over the box."""
        first, second, facing, wide, high = self.sides
        count_u, count_v = max(3, round(4 * wide)), max(3, round(4 * high))
        grid_u = (2.0 * (np.arange(count_u) + 0.5) / count_u - 1.0) * wide
        grid_v = (2.0 * (np.arange(count_v) + 0.5) / count_v - 1.0) * high
        patch = 4.0 * wide * high / (count_u * count_v)
        total = np.zeros(places.shape[:-1])
        for u in grid_u:
            for v in grid_v:
                lamp = np.array(self.centre) + u * first + v * second
                ray = lamp - places
                square = np.maximum((ray**2).sum(axis=-1), 0.05)
                arriving = np.maximum(np.einsum("...k,...k->...", ray, normals), 0.0)
                leaving = np.maximum(-(ray @ facing), 0.0)
                total += arriving * leaving / square**2
        return np.asarray(total * patch * 0.9 * self.luminance)


BOXES = (
    # Above: one broad box, and two long strips on either side of it.
    SoftBox((0.0, 2.6, 0.6), (0.75, 0.0, 0.0), (0.0, 0.0, 1.9), 4.5, 0.15),
    SoftBox((2.3, 2.5, 0.0), (0.25, 0.08, 0.0), (0.0, 0.0, 5.0), 6.0),
    SoftBox((-2.3, 2.5, 0.0), (0.25, -0.08, 0.0), (0.0, 0.0, 5.0), 6.0),
    # Sides: tall banks, the right one larger, so that a form has a light side and a dark one.
    SoftBox((4.1, 0.95, 1.7), (0.0, 0.0, 2.0), (0.0, 1.25, 0.0), 4.5, 0.12),
    SoftBox((-4.1, 1.1, 1.6), (0.0, 0.0, 0.45), (0.0, 1.3, 0.0), 5.5),
    SoftBox((-4.1, 1.1, -2.6), (0.0, 0.0, 0.45), (0.0, 1.3, 0.0), 5.5),
    # In front and behind: low strips across the room.
    SoftBox((0.0, 1.5, 6.6), (2.6, 0.0, 0.0), (0.0, 0.40, 0.0), 5.0),
    SoftBox((0.0, 1.7, -6.6), (1.6, 0.0, 0.0), (0.0, 0.22, 0.0), 4.0),
)


def _side(x: Float64) -> Float64:
    t = np.clip(x, 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


def _wall_maps(cells: int = 48) -> tuple[list[Float64], float]:
    """Return luminance (cells, cells) of the six sides (-x, +x, -y, +y, -z, +z), and its mean over the room."""
    maps: list[Float64] = []
    light = weight = 0.0
    steps = (np.arange(cells) + 0.5) / cells
    areas = []
    for axis in range(3):
        first, second = ((axis + 1) % 3, (axis + 2) % 3)
        area = float((_HIGH - _LOW)[first] * (_HIGH - _LOW)[second])
        for end, sign in ((_LOW, 1.0), (_HIGH, -1.0)):
            places = np.empty((cells, cells, 3))
            places[..., axis] = end[axis]
            places[..., first] = (_LOW[first] + (_HIGH - _LOW)[first] * steps)[:, None]
            places[..., second] = (_LOW[second] + (_HIGH - _LOW)[second] * steps)[None, :]
            normals = np.zeros_like(places)
            normals[..., axis] = sign
            direct = sum((box.illuminance(places, normals) for box in BOXES), np.zeros((cells, cells)))
            albedo = _WALL_ALBEDO if axis != 1 else (_FLOOR_ALBEDO if sign > 0 else _CEILING_ALBEDO)
            maps.append(direct * albedo / np.pi)
            areas.append((area, albedo))
            light += area * float(direct.mean()) * albedo
            weight += area
    # What is reflected is spread evenly and reflected again: a geometric series in the mean albedo.
    mean_albedo = sum(area * albedo for area, albedo in areas) / weight
    even = light / weight / (1.0 - mean_albedo)
    maps = [one + even * albedo / np.pi for one, (_, albedo) in zip(maps, areas, strict=True)]
    return maps, even


def _room(toward: Float64, maps: list[Float64]) -> Float64:
    """Return the luminance (...) of floor, walls and ceiling in directions from the middle."""
    with_sign = np.where(toward >= 0.0, _HIGH, _LOW)
    reach = with_sign / np.where(np.abs(toward) < 1e-9, 1e-9, toward)
    axis = np.abs(reach).argmin(axis=-1)
    nearest = np.abs(reach).min(axis=-1)
    place = (toward * nearest[..., None] - _LOW) / (_HIGH - _LOW)
    result = np.zeros(axis.shape)
    for side in range(3):
        first, second = (side + 1) % 3, (side + 2) % 3
        for upper in (0, 1):
            here = (axis == side) & ((toward[..., side] >= 0.0) == bool(upper))
            result[here] = _bilinear(maps[2 * side + upper], place[here][:, first], place[here][:, second])
    return result


def _bilinear(values: Float64, u: Float64, v: Float64) -> Float64:
    size = values.shape[0]
    x, y = (np.clip(w * size - 0.5, 0.0, size - 1.0) for w in (u, v))
    i, j = (np.minimum(w.astype(np.int64), size - 2) for w in (x, y))
    s, t = x - i, y - j
    low = values[i, j] * (1.0 - t) + values[i, j + 1] * t
    high = values[i + 1, j] * (1.0 - t) + values[i + 1, j + 1] * t
    return np.asarray(low * (1.0 - s) + high * s)


def booth(height: int = 512, samples: int = 4) -> ProceduralEnvironment:
    """Return the light booth; ``height`` rows, everything in it neutral."""
    maps, _ = _wall_maps()

    def radiance(toward: Float64) -> Float64:
        luminance = _room(toward, maps)
        for box in BOXES:
            covered, bright = box.seen(toward)
            luminance = luminance * (1.0 - covered) + bright * covered
        return np.repeat(luminance[..., None], 3, axis=-1)

    description = (
        "A light booth: a grey room, 9 × 14 × 4.2 m, with soft boxes of 4 to 6 kcd/m², all neutral (D65)."
    )
    return finish("booth", draw(radiance, height, samples), description)

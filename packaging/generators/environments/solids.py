"""Procedural geometry: triangles with places on their texture in metres and a colour each, and ways to make them.

Lengths are metres, y is up. Every function returns a :class:`Solid` in coordinates of its own, to be turned and moved.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, srgb_decode
from brdf_suite.arrays import Floats, Integers

WHITE = (1.0, 1.0, 1.0)


def srgb(code: str) -> Floats:
    """Return the working-space colour (3,) of a code such as ``"#d8c7a0"``, to be taken as a reflectance."""
    encoded = np.array([int(code[i : i + 2], 16) for i in (1, 3, 5)]) / 255.0
    return np.asarray(np.clip(REC709_TO_WORKING @ srgb_decode(encoded), 0.0, 1.0))


@dataclass(frozen=True, eq=False)
class Solid:
    """Triangles ``faces`` (m, 3) over ``points`` (n, 3) with ``uv`` (n, 2), and ``colours`` (m, 3), reflectances."""

    points: Floats
    faces: Integers
    uv: Floats
    colours: Floats
    smooth: bool = False

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Solid:
        """Return it elsewhere."""
        return replace(self, points=self.points + np.array([x, y, z]))

    def scaled(self, x: float, y: float, z: float) -> Solid:
        """Return it stretched along the axes, by positive factors."""
        return replace(self, points=self.points * np.array([x, y, z]))

    def turned(self, degrees: float, axis: str = "y") -> Solid:
        """Return it turned about an axis through the origin, counter-clockwise seen against the axis."""
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        matrix = {
            "x": [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
            "y": [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
            "z": [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
        }[axis]
        return replace(self, points=self.points @ np.array(matrix).T)

    def painted(self, colour: ArrayLike) -> Solid:
        """Return it in one colour (3,)."""
        return replace(self, colours=np.broadcast_to(np.asarray(colour, float), self.colours.shape).copy())


def join(parts: Iterable[Solid]) -> Solid:
    """Return all parts as one; it is smooth where the first one is."""
    solids = list(parts)
    starts = np.cumsum([0] + [len(s.points) for s in solids[:-1]])
    return Solid(
        np.concatenate([s.points for s in solids]),
        np.concatenate([s.faces + start for s, start in zip(solids, starts, strict=True)]),
        np.concatenate([s.uv for s in solids]),
        np.concatenate([s.colours for s in solids]),
        solids[0].smooth,
    )


def net(points: Floats, uv: Floats, colour: ArrayLike = WHITE, *, smooth: bool = True) -> Solid:
    """Return the surface through a grid of points (rows, columns, 3) with ``uv`` (rows, columns, 2).

    It faces the side from which columns run to the right while rows run up.
    """
    rows, columns = points.shape[:2]
    r, c = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (r * columns + c).ravel()
    faces = np.concatenate(
        [np.stack([a, a + 1, a + columns + 1], 1), np.stack([a, a + columns + 1, a + columns], 1)]
    )
    colours = np.broadcast_to(np.asarray(colour, float), (len(faces), 3)).copy()
    return Solid(points.reshape(-1, 3), faces.astype(np.int64), uv.reshape(-1, 2), colours, smooth)


def quad(corner: ArrayLike, along: ArrayLike, up: ArrayLike, colour: ArrayLike = WHITE) -> Solid:
    """Return a rectangle from its corner and two sides, facing along × up; uv in metres from the corner."""
    start, first, second = (np.asarray(v, float) for v in (corner, along, up))
    grid = np.array([[start, start + first], [start + second, start + first + second]])
    wide, high = np.linalg.norm(first), np.linalg.norm(second)
    return net(grid, np.array([[[0.0, 0.0], [wide, 0.0]], [[0.0, high], [wide, high]]]), colour, smooth=False)


def _box_faces() -> tuple[Floats, Integers]:
    """Return signs (24, 3) and axes (24,) of the corners of a box with cut edges, in the order of :func:`box`."""
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    return np.repeat(signs, 3, axis=0), np.tile(np.arange(3), 8)


def box(size: Sequence[float], colour: ArrayLike = WHITE, bevel: float = 0.0) -> Solid:
    """Return a box that stands on y = 0 about the origin, its edges cut off by ``bevel``."""
    half = 0.5 * np.asarray(size, float)
    cut = min(bevel, 0.45 * float(half.min()))
    pieces: list[Solid] = []
    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1.0, 1.0):
            corner = np.zeros(3)
            corner[axis] = sign * half[axis]
            along, up = np.zeros(3), np.zeros(3)
            along[first], up[second] = 2.0 * (half[first] - cut), 2.0 * (half[second] - cut)
            corner -= 0.5 * (along + up)
            if sign < 0.0:
                along, up = up, along
            # The texture stands upright on the sides.
            pieces.append(
                quad(corner, along, up, colour) if along[1] == 0.0 else _swapped(corner, along, up, colour)
            )
    if cut > 0.0:
        signs, axes = _box_faces()
        points = signs * half - signs * cut * (np.arange(3)[None, :] != axes[:, None])
        index = {(*map(int, s), int(a)): i for i, (s, a) in enumerate(zip(signs, axes, strict=True))}
        faces: list[tuple[int, int, int]] = []
        for axis in range(3):  # the edges that run along an axis
            first, second = (axis + 1) % 3, (axis + 2) % 3
            for i in (-1, 1):
                for j in (-1, 1):
                    low, high = np.zeros(3, int), np.zeros(3, int)
                    low[[axis, first, second]] = -1, i, j
                    high[[axis, first, second]] = 1, i, j
                    a, b = index[(*low, first)], index[(*low, second)]
                    c, d = index[(*high, first)], index[(*high, second)]
                    faces += [(a, c, d), (a, d, b)]
        faces += [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(8)]
        triangles = np.array(faces)
        corners = points[triangles]
        outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        inside = (outward * corners.mean(axis=1)).sum(axis=1) < 0.0
        triangles[inside] = triangles[inside][:, ::-1]
        colours = np.broadcast_to(np.asarray(colour, float), (len(triangles), 3)).copy()
        pieces.append(Solid(points, triangles, points[:, [0, 1]], colours))
    return join(pieces).moved(y=half[1])


def _swapped(corner: Floats, along: Floats, up: Floats, colour: ArrayLike) -> Solid:
    made = quad(corner, along, up, colour)
    return replace(made, uv=made.uv[:, ::-1])


def bar(
    x: tuple[float, float],
    y: tuple[float, float],
    z: tuple[float, float],
    colour: ArrayLike = WHITE,
    bevel: float = 0.0,
) -> Solid:
    """Return the box between two places on each axis."""
    solid = box((x[1] - x[0], y[1] - y[0], z[1] - z[0]), colour, bevel)
    return solid.moved(0.5 * (x[0] + x[1]), y[0], 0.5 * (z[0] + z[1]))


def revolved(profile: ArrayLike, colour: ArrayLike = WHITE, around: int = 24) -> Solid:
    """Return a solid of revolution about y of a profile (n, 2) of radii and heights, rising."""
    radius, height = np.asarray(profile, float).T
    angle = np.linspace(0.0, 2.0 * np.pi, around + 1)
    points = np.stack(
        [
            radius[:, None] * np.sin(angle),
            np.broadcast_to(height[:, None], (len(height), around + 1)),
            radius[:, None] * np.cos(angle),
        ],
        axis=-1,
    )
    uv = np.stack(np.broadcast_arrays(angle * max(float(radius.max()), 1e-3), height[:, None]), axis=-1)
    return net(points, uv, colour)


def tube(path: ArrayLike, radius: ArrayLike, colour: ArrayLike = WHITE, around: int = 10) -> Solid:
    """Return a round rod along a path (n, 3), of one radius or one at each point."""
    places = np.asarray(path, float)
    radii = np.broadcast_to(np.asarray(radius, float), len(places))
    along = np.gradient(places, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    helper = np.array([1.0, 0.0, 0.0]) if np.abs(along[:, 0]).mean() < 0.7 else np.array([0.0, 0.0, 1.0])
    first = np.cross(helper, along)
    first /= np.maximum(np.linalg.norm(first, axis=1, keepdims=True), 1e-9)
    second = np.cross(along, first)
    angle = np.linspace(0.0, 2.0 * np.pi, around + 1)
    ring = first[:, None] * np.cos(angle)[:, None] + second[:, None] * np.sin(angle)[:, None]
    points = places[:, None] + radii[:, None, None] * ring
    reach = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1))])
    uv = np.stack(np.broadcast_arrays(angle * float(radii.mean()), reach[:, None]), axis=-1)
    return net(points, uv, colour)


def swept(profile: ArrayLike, length: float, colour: ArrayLike = WHITE, *, smooth: bool = False) -> Solid:
    """Return a moulding: a profile (n, 2) of z and y, from below, drawn out along x about the origin."""
    z, y = np.asarray(profile, float).T
    steps = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(z), np.diff(y)))])
    x = np.array([-0.5, 0.5]) * length
    if smooth:
        points = np.stack(np.broadcast_arrays(x[None, :], y[:, None], z[:, None]), axis=-1)
        return net(points, np.stack(np.broadcast_arrays(x[None, :], steps[:, None]), axis=-1), colour)
    strips = []
    for i in range(len(z) - 1):
        points = np.array([[[a, y[j], z[j]] for a in x] for j in (i, i + 1)])
        uv = np.array([[[a, steps[j]] for a in x] for j in (i, i + 1)])
        strips.append(net(points, uv, colour, smooth=False))
    return join(strips)

"""Wheel wells and underbody: the dark surfaces that close the body where the paint ends."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from meshes.car.body import FLOOR, body
from meshes.car.cutting import at_points, cut
from meshes.car.lathe import grid_triangles
from meshes.car.nets import Soup, normals
from meshes.car.outlines import FLOOR_EDGE, arch
from meshes.car.pieces import Piece
from meshes.car.proportions import ARCH_DEPTH_X, ARCH_RADIUS, AXLES, WHEEL_RADIUS

_SEGMENTS = 52


def wells() -> list[Piece]:
    """Return the liners of the half x ≥ 0: a cylinder and its end, as far as they lie inside the body."""
    pieces = []
    for axle in AXLES:
        across = np.array([ARCH_DEPTH_X, 0.70, 0.86, 1.02])
        tube = _rings(across, np.full(len(across), ARCH_RADIUS), axle)
        radii = np.linspace(1e-3, ARCH_RADIUS, 3)
        end = _rings(np.full(len(radii), ARCH_DEPTH_X), radii, axle)
        for soup, is_end in ((tube, False), (end, True)):
            soup = cut(soup, lambda p: at_points(body)(p) + 0.008)
            middle = soup.points[soup.triangles].mean(axis=1)
            soup = soup.keep(at_points(body)(middle) < -0.008)
            facing = (
                np.tile([1.0, 0.0, 0.0], (len(soup.points), 1)) if is_end else _to_axle(soup.points, axle)
            )
            pieces.append(Piece("wheel_wells", "cavity", soup, facing))
    return pieces


def _rings(across: Floats, radii: Floats, axle: float) -> Soup:
    """Return circles about an axle joined to a surface that faces the axle, or outwards where it is flat."""
    angle = 2.0 * np.pi * np.arange(_SEGMENTS) / _SEGMENTS
    y = WHEEL_RADIUS + radii[:, None] * np.sin(angle)
    z = axle + radii[:, None] * np.cos(angle)
    x = np.broadcast_to(across[:, None], y.shape)
    points = np.stack([x, y, z], axis=2).reshape(-1, 3)
    return Soup(points, grid_triangles(len(across), _SEGMENTS, True))


def _to_axle(points: Floats, axle: float) -> Floats:
    inwards = np.stack([0.0 * points[:, 0], WHEEL_RADIUS - points[:, 1], axle - points[:, 2]], axis=1)
    result: Floats = inwards / np.linalg.norm(inwards, axis=1, keepdims=True)
    return result


def floor() -> list[Piece]:
    """Return the underbody of the half x ≥ 0, a sheet at the height where the body's skin ends.

    It has two sides, since its upper one shows through the wheel openings.
    """
    x, z = np.meshgrid(np.linspace(0.0, 1.0, 8), np.arange(-2.5, 2.5, 0.15), indexing="ij")
    points = np.stack([x, FLOOR(z) + FLOOR_EDGE, z], axis=2).reshape(-1, 3)
    soup = Soup(points, grid_triangles(x.shape[0], x.shape[1], False)[:, ::-1])
    soup = cut(cut(soup, lambda p: at_points(body)(p) + 0.007), at_points(arch))
    middle = soup.points[soup.triangles].mean(axis=1)
    soup = soup.keep((at_points(body)(middle) < -0.007) & (at_points(arch)(middle) > 0.0))
    down = normals(lambda x, y, z: FLOOR(z) - y + 0.0 * x, soup.points)
    upper = Soup(soup.points + np.array([0.0, 0.004, 0.0]), soup.triangles[:, ::-1])
    return [Piece("underbody", "cavity", soup, down), Piece("underbody", "cavity", upper, -down)]

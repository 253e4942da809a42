"""Solids of revolution and lofts, for wheels, tips and bars."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from brdf_suite.arrays import Floats, Integers
from meshes.car.nets import Soup


def grid_triangles(rows: int, columns: int, closed: bool) -> Integers:
    """Return triangles over a grid of points (row-major); ``closed`` joins the last column to the first."""
    r, c = np.meshgrid(np.arange(rows - 1), np.arange(columns if closed else columns - 1), indexing="ij")
    a = (r * columns + c).ravel()
    b = (r * columns + (c + 1) % columns).ravel()
    d, e = a + columns, b + columns
    return np.concatenate([np.stack([a, b, e], 1), np.stack([a, e, d], 1)]).astype(np.int64)


def smooth_normals(points: Floats, triangles: Integers) -> Floats:
    """Return area-weighted vertex normals (n, 3), unit length."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    facing = np.cross(b - a, c - a)
    total = np.zeros_like(points)
    for i in range(3):
        np.add.at(total, triangles[:, i], facing)
    result: Floats = total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12)
    return result


def loft(sections: Floats, closed: bool = True) -> tuple[Soup, Floats]:
    """Return a surface through sections (rows, columns, 3) with normals from neighbours, outwards.

    Columns run clockwise when seen along the direction of the rows.
    """
    rows, columns = sections.shape[:2]
    points = sections.reshape(-1, 3)
    triangles = grid_triangles(rows, columns, closed)
    normals = smooth_normals(points, triangles)
    return Soup(points, triangles), normals


def lathe(
    profile: Sequence[tuple[float, float]], segments: int, crease_deg: float = 35.0
) -> tuple[Soup, Floats]:
    """Return a profile of (axial x, radius r) turned about the x axis, m.

    The visible side is on the left when walking along the profile, x drawn to the right and r up. Corners of
    the profile that turn by more than ``crease_deg`` are sharp. One point of each ring is lowest exactly.
    """
    line = np.asarray(profile, dtype=np.float64)
    angle = -0.5 * np.pi + 2.0 * np.pi * np.arange(segments) / segments
    step = np.diff(line, axis=0)
    facing = np.stack([-step[:, 1], step[:, 0]], axis=1)
    facing /= np.linalg.norm(facing, axis=1, keepdims=True)
    ends = np.stack([facing, facing], axis=1)  # the normal at both ends of each segment
    smooth = np.einsum("ij,ij->i", facing[:-1], facing[1:]) > np.cos(np.radians(crease_deg))
    weight = np.linalg.norm(step, axis=1)
    mean = facing[:-1] / weight[:-1, None] + facing[1:] / weight[1:, None]
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    ends[:-1, 1][smooth] = mean[smooth]
    ends[1:, 0][smooth] = mean[smooth]
    corners = [(line[0], ends[0, 0])]  # (point, normal); a sharp corner has two
    pairs = []
    for segment in range(len(step)):
        if segment and not smooth[segment - 1]:
            corners.append((line[segment], ends[segment, 0]))
        pairs.append(len(corners) - 1)
        corners.append((line[segment + 1], ends[segment, 1]))
    points, normals = (
        np.concatenate([_turned(np.asarray(corner[which]), angle) for corner in corners]) for which in (0, 1)
    )
    ring = grid_triangles(2, segments, True)[:, ::-1]
    return Soup(points, np.concatenate([ring + segments * pair for pair in pairs])), normals


def _turned(pair: Floats, angle: Floats) -> Floats:
    """Return (x, r) turned to (n, 3) round the x axis."""
    return np.stack([np.full_like(angle, pair[0]), pair[1] * np.sin(angle), pair[1] * np.cos(angle)], axis=1)
